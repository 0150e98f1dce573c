"""Project: one report of one checkout, of an edition and in a profile, and what ``edition.toml`` says of that."""

import json
import os
import re
import shlex
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from msgspec import Struct, convert

from measured_report.editions.release import Release, read_label
from measured_report.files.atomic import (
    RecordError,
    folder_fault,
    read_file,
    short_path,
    write_file,
)
from measured_report.files.columns import name_problem
from measured_report.files.config import FILE, Config, Report, report_in, tomllib
from measured_report.files.config import report as current
from measured_report.files.errors import ReportError
from measured_report.records.identity import full_version

PROFILES = ("full", "quick")
INPUTS = (
    "packages",
    "experiments",
    "report",
    "templates",
    "assets",
    "static",
    "results",
)
MANIFEST = "edition.toml"
BYTE_LIMIT = 1 << 20


class Manifest(Struct, frozen=True, forbid_unknown_fields=True):
    """Holds what is known of an edition besides its records."""

    asked: str  # the release or address that was measured, as the command named it
    date: str
    sections: tuple[str, ...]


def read_manifest(results: Path) -> Manifest | None:
    """Return the manifest in a folder of results, or None; raise RecordError if it is damaged."""
    path = results / MANIFEST
    if not os.path.lexists(path):
        return None
    content = read_file(path, BYTE_LIMIT)
    try:
        fields = tomllib.loads(content.decode("utf-8"))
        for text in (*fields.values(), *fields.get("sections", ())):
            if name_problem(str(text)):
                raise ValueError("it has a text that cannot be printed")
        asked = fields.pop(current().settings.edition)
        return convert({"asked": asked, **fields}, Manifest)
    except (KeyError, ValueError, RecursionError) as error:
        message = " ".join(str(error).split())
        raise RecordError(
            f"{short_path(path)} is no whole manifest: {message:.200}"
        ) from None


def write_manifest(results: Path, manifest: Manifest) -> None:
    fields = {
        current().settings.edition: manifest.asked,
        "date": manifest.date,
        "sections": manifest.sections,
    }
    lines = [
        f"{name} = {json.dumps(value, ensure_ascii=False)}\n"
        for name, value in fields.items()
    ]
    write_file(results / MANIFEST, "".join(lines))


@dataclass(frozen=True)
class Project:
    """Names the folders, editions and commands of a report in one checkout."""

    release: str
    profile: str = (
        "full"  # or `quick`: small grids and short runs, which are kept apart
    )
    root: Path = field(default_factory=lambda: current().root)
    own_release: str | None = None
    """The release that is meant if none is named; None: this one."""
    aside: str = (
        ""  # a folder below `results` for what only a search or a comparison measures
    )

    @property
    def is_own(self) -> bool:
        return self.own_release in (None, self.release)

    @property
    def report(self) -> Report:
        """Return the report in its folder, or the current one if that has, or links, no other ``report.toml``."""
        file = (self.root / FILE).resolve()
        return report_in(file.parent) if file.is_file() else current()

    @property
    def settings(self) -> Config:
        return self.report.settings

    @property
    def site(self) -> Path:
        return self.root / "site"

    @property
    def results(self) -> Path:
        """Return the folder of the edition's records; only those of the full profile are tracked."""
        parts = [self.aside] if self.aside else []
        if self.aside or self.profile != "full":
            parts.append(self.profile)
        folder = self.settings.edition_folder(self.release)
        return self.root.joinpath("results", *parts, folder)

    @property
    def templates(self) -> Path:
        return self.root / "templates"

    @property
    def named(self) -> Release:
        release = read_label(self.release, self.settings)
        assert release, f"{self.release} is no label"
        return release

    @property
    def manifest(self) -> Manifest | None:
        """Return the edition's manifest; None if there is none that can be read."""
        try:
            return read_manifest(self.results)
        except RecordError:
            return None

    @property
    def releases(self) -> list[str]:
        """Return this edition and those that have results, by version and date.

        One whose folder cannot be read is among them, so that it is named.
        """
        folders = [
            folder
            for folder in self.results.parent.glob(self.settings.edition_folder("*"))
            if folder_fault(folder) or any(folder.glob("*.json"))
        ]
        labels = {self.settings.edition_in(folder.name) for folder in folders}
        releases = {label for label in labels if read_label(label, self.settings)}
        return sorted(
            {self.release, *releases}, key=lambda release: self.of(release).order
        )

    @property
    def order(self) -> tuple[Any, ...]:
        """Return a key that sorts editions by version, commits by date, and what is pinned after the same without."""
        named = self.named
        date = ""
        if named.source:  # a commit that was not measured yet counts as the newest
            manifest = self.manifest
            date = manifest.date if manifest and manifest.date else "9999"
        return named.order, date, named.source, named.pins, named.machine

    def of(self, release: str) -> "Project":
        own = self.own_release or self.release
        return replace(self, release=release, own_release=own)

    def record_path(self, section: str) -> Path:
        return self.results / f"{section}.json"

    def rerun(self, section: str, device: str | None = None) -> str:
        """Return the command that measures a section, on ``device`` if one is named, or on a CPU if these are of one."""
        options = {
            "SECTION": section,
            "DEVICE": device or ("cpu" if self.named.machine == "cpu" else ""),
            self.settings.option: "" if self.is_own else self.asked,
            "PROFILE": "" if self.profile == "full" else self.profile,
        }
        set_options = [f"{name}={value}" for name, value in options.items() if value]
        return shlex.join(["make", "rerun", *set_options])

    @property
    def asked(self) -> str:
        """Return how a command names this edition: by its label, or by the address of a commit."""
        manifest = self.manifest if self.named.source else None
        return manifest.asked if manifest else self.release


def own_release(root: Path | None = None, report: Report | None = None) -> str:
    """Return the project's own release, which is meant if none is named: the one that pyproject.toml asks for."""
    report = report or current()
    requirement = report.settings.requirement_of(report.settings.edition)
    text = ((root or report.root) / "pyproject.toml").read_text(encoding="utf-8")
    match = re.search(rf'"{re.escape(requirement)}==([0-9.]+)"', text)
    if not match:
        line = (
            f'"{requirement}==1.2.3"'
            if requirement
            else 'of its edition, and report.toml has no edition = "NAME"'
        )
        raise ReportError(f"pyproject.toml has no line {line}")
    return full_version(match[1])
