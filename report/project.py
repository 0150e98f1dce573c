"""Which report is meant: the project's folder, a Newton release and a profile."""

from dataclasses import dataclass
from pathlib import Path

from report import ROOT
from report.records import record_path, results_folder

PROFILES = ("full", "quick")


@dataclass(frozen=True)
class Project:
    """One report of one checkout."""

    release: str
    """Newton release whose results are shown."""
    profile: str = "full"
    """``full``, or ``quick`` for small grids and short runs, which are kept apart."""
    root: Path = ROOT

    @property
    def site(self) -> Path:
        return self.root / "site"

    @property
    def results(self) -> Path:
        return results_folder(self.release, self.profile, self.root)

    @property
    def templates(self) -> Path:
        return self.root / "templates"

    def record_path(self, section: str) -> Path:
        return record_path(section, self.release, self.profile, self.root)
