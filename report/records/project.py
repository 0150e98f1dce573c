"""Which report is meant: the project's folder, a Newton release and a profile."""

import re
from dataclasses import dataclass, replace
from pathlib import Path

from report import ROOT, ReportError
from report.records.record import record_path, results_folder

PROFILES = ("full", "quick")
INPUTS = ("experiments", "report", "templates", "assets", "results")
FOLDER = re.compile(r"newton-([0-9]+(?:\.[0-9]+)*)")
REQUIREMENT = re.compile(r'"newton\[sim\]==([0-9.]+)"')


@dataclass(frozen=True)
class Project:
    """One report of one checkout."""

    release: str
    """Newton release whose results are shown."""
    profile: str = "full"
    """``full``, or ``quick`` for small grids and short runs, which are kept apart."""
    root: Path = ROOT
    own_release: str | None = None
    """The release that is meant where none is named; None: this one."""

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
        return results_folder(self.release, self.profile, self.root)

    @property
    def templates(self) -> Path:
        return self.root / "templates"

    @property
    def releases(self) -> list[str]:
        """The releases that have results, and this one, oldest first."""
        found = {FOLDER.fullmatch(path.parent.name) for path in self.results.parent.glob("newton-*/*.json")}
        return sorted({self.release, *(name[1] for name in found if name)}, key=_version)

    def of(self, release: str) -> "Project":
        """The report of another release."""
        return replace(self, release=release, own_release=self.own_release or self.release)

    def record_path(self, section: str) -> Path:
        return record_path(section, self.release, self.profile, self.root)

    def rerun(self, section: str, device: str | None = None) -> str:
        """The command that measures a section, on ``device`` where one is named."""
        options = {
            "SECTION": section,
            "DEVICE": device,
            "NEWTON": None if self.is_own else self.release,
            "PROFILE": None if self.profile == "full" else self.profile,
        }
        return " ".join(["make rerun", *(f"{name}={value}" for name, value in options.items() if value)])


def own_release(root: Path = ROOT) -> str:
    """The project's own Newton release, which is meant where none is named: the one that pyproject.toml asks for."""
    found = REQUIREMENT.search((root / "pyproject.toml").read_text(encoding="utf-8"))
    if not found:
        raise ReportError('pyproject.toml asks for no Newton release; a line "newton[sim]==1.4.0" does')
    return found[1]


def _version(release: str) -> tuple[int, ...]:
    return tuple(map(int, release.split(".")))
