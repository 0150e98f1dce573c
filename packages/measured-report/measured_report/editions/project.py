"""Describe the report of a checkout, for one edition in one profile."""

import json
import os
import re
import shlex
from dataclasses import dataclass, field, replace
from operator import attrgetter
from pathlib import Path
from typing import Any

from msgspec import Struct, convert

from measured_report.editions.release import Release, read_label
from measured_report.files.atomic import (
    RecordError,
    files_in,
    folder_fault,
    read_file,
    read_text,
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
BYTE_LIMIT = 1 << 20  # of a manifest


class Manifest(Struct, frozen=True, forbid_unknown_fields=True):
    """The contents of ``edition.toml``, which describes an edition."""

    spec: str  # the release or address that was measured, as the command named it
    date: str
    sections: tuple[str, ...]


def read_manifest(results: Path) -> Manifest | None:
    """Return the manifest in a folder of results, or None if there is none.

    Raise RecordError if it is damaged.
    """
    path = results / MANIFEST
    if not os.path.lexists(path):
        return None
    content = read_file(path, BYTE_LIMIT)
    try:
        fields = tomllib.loads(content.decode("utf-8"))
        for text in (*fields.values(), *fields.get("sections", ())):
            if name_problem(str(text)):
                raise ValueError("it contains text that cannot be printed")
        spec = fields.pop(current().settings.edition)
        return convert({"spec": spec, **fields}, Manifest)
    except (KeyError, ValueError, RecursionError) as error:
        message = " ".join(str(error).split())
        raise RecordError(
            f"{short_path(path)} is not a valid manifest: {message:.200}"
        ) from None


def write_manifest(results: Path, manifest: Manifest) -> None:
    fields = {
        current().settings.edition: manifest.spec,
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
    """Describe the folders, editions and commands of a report in one checkout."""

    release: str
    profile: str = "full"
    """``full``, or ``quick`` for small grids and short runs, which are kept apart."""
    root: Path = field(default_factory=lambda: current().root)
    own_release: str | None = None
    """The default release of the project; None means this release."""
    aside: str = ""
    """A folder below ``results`` for measurements of a search or a comparison."""

    @property
    def is_own(self) -> bool:
        return self.own_release in (None, self.release)

    @property
    def report(self) -> Report:
        """Return the report in the project's folder.

        If ``report.toml`` is a link, it is the report that the link leads to. Without
        ``report.toml`` it is the current report.
        """
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
        """Return the folder of the edition's records; git tracks the full profile."""
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
        assert release, f"{self.release} is not a label"
        return release

    @property
    def manifest(self) -> Manifest | None:
        """Return the edition's manifest, or None if it is missing or damaged."""
        try:
            return read_manifest(self.results)
        except RecordError:
            return None

    @property
    def releases(self) -> list[str]:
        """Return this edition and all editions with results, by version and date.

        An edition whose folder cannot be read is included, so that messages can name
        it.
        """
        folders = [
            folder
            for folder in files_in(
                self.results.parent, self.settings.edition_folder("*")
            )
            if folder_fault(folder) or files_in(folder, "*.json")
        ]
        labels = {self.settings.edition_in(folder.name) for folder in folders}
        releases = {label for label in labels if read_label(label, self.settings)}
        editions = [self.of(release) for release in {self.release, *releases}]
        return [
            edition.release for edition in sorted(editions, key=attrgetter("order"))
        ]

    @property
    def order(self) -> tuple[Any, ...]:
        """Return a key that sorts editions.

        Editions are sorted by version, and commits by date. An edition with pinned
        packages follows the same edition without them.
        """
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
        """Return the command that measures a section of this edition.

        The command names ``device`` if it is given, and the CPU if this edition was
        measured on a CPU.
        """
        options = {
            "SECTION": section,
            "DEVICE": device or ("cpu" if self.named.machine == "cpu" else ""),
            self.settings.option: "" if self.is_own else self.spec,
            "PROFILE": "" if self.profile == "full" else self.profile,
        }
        set_options = [f"{name}={value}" for name, value in options.items() if value]
        return shlex.join(["make", "rerun", *set_options])

    @property
    def spec(self) -> str:
        """Return the edition's name in commands: its label or a commit's address."""
        manifest = self.manifest if self.named.source else None
        return manifest.spec if manifest else self.release


def own_release(root: Path | None = None, report: Report | None = None) -> str:
    """Return the project's default release, which pyproject.toml requires."""
    report = report or current()
    requirement = report.settings.requirement_of(report.settings.edition)
    text = read_text((root or report.root) / "pyproject.toml")
    match = re.search(rf'"{re.escape(requirement)}==([0-9.]+)"', text)
    if not match:
        if not requirement:
            raise ReportError(
                f"{FILE} and pyproject.toml do not name the package of the editions: "
                'add edition = "NAME" and the requirement "NAME==1.2.3"'
            )
        raise ReportError(
            f"pyproject.toml does not require {requirement} with a version: add "
            f'"{requirement}==1.2.3"'
        )
    return full_version(match[1])
