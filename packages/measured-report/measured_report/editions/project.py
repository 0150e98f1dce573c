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
from measured_report.files.atomic import RecordError, read_file, short_path, write_file
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
    """Keep what is known of an edition besides its records."""

    asked: str  # as the command that measured it named its package: a release, a path or an address
    date: str
    sections: tuple[str, ...]


def read_manifest(results: Path, settings: Config | None = None) -> Manifest | None:
    """Read the manifest in a folder of results; None where there is none, RecordError for one that is damaged."""
    path = results / MANIFEST
    if not os.path.lexists(path):
        return None
    content = read_file(path, BYTE_LIMIT)
    try:
        fields = tomllib.loads(content.decode("utf-8"))
        if any(
            name_problem(str(text))
            for text in (*fields.values(), *fields.get("sections", ()))
        ):
            raise ValueError("it has a text with what can't be printed")
        package = (settings or current().settings).edition
        return convert({"asked": fields.pop(package), **fields}, Manifest)
    except (KeyError, ValueError, RecursionError) as error:
        raise RecordError(
            f"{short_path(path)} is no whole manifest: {' '.join(str(error).split()):.200}"
        ) from None


def write_manifest(
    results: Path, manifest: Manifest, settings: Config | None = None
) -> None:
    package = (settings or current().settings).edition
    fields = {
        package: manifest.asked,
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
    """Name the folders, editions and commands of a report in one checkout."""

    release: str
    profile: str = "full"  # `full`, or `quick` for small grids and short runs, which are kept apart
    root: Path = field(default_factory=lambda: current().root)
    own_release: str | None = None
    """The release that is meant where none is named; None: this one."""
    aside: str = ""  # the folder below `results` that has what was measured on the way to something else; empty: none

    @property
    def is_own(self) -> bool:
        return self.own_release in (None, self.release)

    @property
    def report(self) -> Report:
        """Return the report that it is of: the current one where its folder has, or links, no other ``report.toml``."""
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
        """Name the folder of the edition's records; only those of the full profile are tracked."""
        parts = [self.aside] if self.aside else []
        parts += [self.profile] if self.aside or self.profile != "full" else []
        return self.root.joinpath(
            "results", *parts, self.settings.edition_folder(self.release)
        )

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
        """Read the edition's manifest; None where there is none, or none that can be read."""
        try:
            return read_manifest(self.results, self.settings)
        except RecordError:
            return None

    @property
    def releases(self) -> list[str]:
        """List the editions that have results, and this one, by version and date."""
        folders = {
            path.parent.name
            for path in self.results.parent.glob(
                self.settings.edition_folder("*/*.json")
            )
        }
        labels = {
            label
            for label in map(self.settings.edition_in, folders)
            if read_label(label, self.settings)
        }
        return sorted(
            {self.release, *labels}, key=lambda release: self.of(release).order
        )

    @property
    def order(self) -> tuple[Any, ...]:
        """Sort editions by version, those of one version by date, and what is pinned after the same without."""
        named, manifest = self.named, self.manifest
        # A release has its place by its version; a commit that was not measured yet is taken for the newest.
        date = ((manifest and manifest.date) or "9999") if named.source else ""
        return named.order, date, named.source, named.pins, named.machine

    def of(self, release: str) -> "Project":
        return replace(
            self, release=release, own_release=self.own_release or self.release
        )

    def record_path(self, section: str) -> Path:
        return self.results / f"{section}.json"

    def rerun(self, section: str, device: str | None = None) -> str:
        """Say the command that measures a section, on ``device`` if one is named, or on a CPU if these are of one."""
        device = device or ("cpu" if self.named.machine == "cpu" else "")
        edition = "" if self.is_own else self.asked
        profile = "" if self.profile == "full" else self.profile
        options = {
            "SECTION": section,
            "DEVICE": device,
            self.settings.option: edition,
            "PROFILE": profile,
        }
        return " ".join(
            [
                "make rerun",
                *(
                    shlex.quote(f"{name}={value}")
                    for name, value in options.items()
                    if value
                ),
            ]
        )

    @property
    def asked(self) -> str:
        """Name this edition to make: by its label, unless that does not say where its code is."""
        manifest = self.manifest if self.named.source else None
        return manifest.asked if manifest else self.release


def own_release(root: Path | None = None, report: Report | None = None) -> str:
    """Find the project's own release, which is meant where none is named: the one that pyproject.toml asks for."""
    report = report or current()
    requirement = report.settings.requirement_of(report.settings.edition)
    text = ((root or report.root) / "pyproject.toml").read_text(encoding="utf-8")
    if not (match := re.search(rf'"{re.escape(requirement)}==([0-9.]+)"', text)):
        line = (
            f'"{requirement}==1.2.3"'
            if requirement
            else 'of its edition, and report.toml has no edition = "NAME"'
        )
        raise ReportError(f"pyproject.toml has no line {line}")
    return full_version(match[1])
