"""Which report is meant: the project's folder, an edition and a profile."""

import re
import shlex
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

from measured_report.editions.label import Label, read_label
from measured_report.editions.manifest import Manifest, read_manifest
from measured_report.files.atomic import RecordError
from measured_report.files.config import config
from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT

PROFILES = ("full", "quick")
INPUTS = ("packages", "experiments", "report", "templates", "assets", "results")
"""Folders that the site is made from."""


@dataclass(frozen=True)
class Project:
    """One report of one checkout."""

    release: str
    """Label of the edition whose results are shown: mostly a release."""
    profile: str = "full"
    """``full``, or ``quick`` for small grids and short runs, which are kept apart."""
    root: Path = ROOT
    own_release: str | None = None
    """The release that is meant where none is named; None: this one."""
    aside: str = ""
    """The folder below ``results`` that has what was measured on the way to something else; empty: none."""

    @property
    def is_own(self) -> bool:
        return self.own_release in (None, self.release)

    @property
    def site(self) -> Path:
        return self.root / "site"

    @property
    def inputs(self) -> list[Path]:
        """Folders that the site is made from."""
        return [self.root / name for name in INPUTS]

    @property
    def results(self) -> Path:
        """The folder of the edition's records; only those of the full profile are tracked."""
        parts = [self.aside] if self.aside else []
        parts += [self.profile] if self.aside or self.profile != "full" else []
        return self.root.joinpath("results", *parts, config().edition_folder(self.release))

    @property
    def templates(self) -> Path:
        return self.root / "templates"

    @property
    def label(self) -> Label:
        return read_label(self.release)

    @property
    def manifest(self) -> Manifest | None:
        """What is known of the edition besides its records; None where nothing says, or nothing that can be read."""
        with suppress(RecordError):
            return read_manifest(self.results)

    @property
    def releases(self) -> list[str]:
        """The editions that have results, and this one, by version and date."""
        there = {path.parent.name for path in self.results.parent.glob(config().edition_folder("*/*.json"))}
        found = filter(read_label, map(config().edition_in, there))
        return sorted({self.release, *found}, key=lambda release: self.of(release).order)

    @property
    def order(self) -> tuple:
        """Sorts editions by version, those of one version by date, and what is pinned after the same without."""
        label, manifest = self.label, self.manifest
        # A release has its place by its version; a commit that was not measured yet is taken for the newest.
        date = ((manifest and manifest.date) or "9999") if label.source else ""
        return label.order, date, label.source, label.pins, label.machine

    def of(self, release: str) -> "Project":
        """The report of another edition."""
        return replace(self, release=release, own_release=self.own_release or self.release)

    def record_path(self, section: str) -> Path:
        return self.results / f"{section}.json"

    def rerun(self, section: str, device: str | None = None) -> str:
        """The command that measures a section, on ``device`` where one is named, or on a CPU where these are of one."""
        options = {
            "SECTION": section,
            "DEVICE": device or ("cpu" if self.label.machine == "cpu" else None),
            config().option: None if self.is_own else self.asked,
            "PROFILE": None if self.profile == "full" else self.profile,
        }
        told = (shlex.quote(f"{name}={value}") for name, value in options.items() if value)
        return " ".join(["make rerun", *told])

    @property
    def asked(self) -> str:
        """What names this edition to make: its label, unless that does not say where its code is."""
        manifest = self.manifest if self.label.source else None
        return manifest.asked if manifest else self.release


def own_release(root: Path = ROOT) -> str:
    """The project's own release, which is meant where none is named: the one that pyproject.toml asks for."""
    requirement = config().requirement_of(config().package)
    text = (root / "pyproject.toml").read_text(encoding="utf-8")
    found = re.search(rf'"{re.escape(requirement)}==([0-9.]+)"', text)
    if not found:
        line = f'a line "{requirement}==1.4.0" does'
        raise ReportError(f"pyproject.toml asks for no {config().edition_name} release; {line}")
    return found[1]
