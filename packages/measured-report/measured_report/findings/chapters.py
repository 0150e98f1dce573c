"""Define chapters: one section of one edition, from its record to its words."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import takewhile
from typing import Any

from measured_report.editions.status import State
from measured_report.files.settings import Page
from measured_report.findings.sections import PACKAGE, Outline, file_of
from measured_report.parts.prose import Prose
from measured_report.parts.section import Section
from measured_report.records.identity import files_digest
from measured_report.records.record import traces_of
from measured_report.values.results import Results


@dataclass(frozen=True)
class Chapter:
    """Holds a section of one edition. Each stage of a build adds its fields."""

    state: State  # whether its record is fresh, stale or damaged
    outline: Outline
    results: Results
    key: str = ""  # digest of the inputs that it is derived from
    section: Section = field(default_factory=Section)  # the derived section
    names: Mapping[str, Any] = field(default_factory=dict)  # the names for templates
    prose: Prose | None = None  # its text, once it is rendered

    @property
    def name(self) -> str:
        return self.state.section

    @property
    def page(self) -> Page:
        return self.outline.page

    @property
    def code(self) -> Iterator[tuple[str, int]]:
        """Yield the file and the line of its functions ``measure`` and ``derive``."""
        packages = {"experiments": "measure", PACKAGE: "derive"}
        for package, function in packages.items():
            if file := file_of(package, self.name):
                lines = file.read_text(encoding="utf-8").splitlines()
                starts = [line.startswith(f"def {function}(") for line in lines]
                parts = file.parts[-2 if file.name == "__init__.py" else -1 :]
                name = "/".join([*package.split("."), *parts])
                yield name, 1 + starts.index(True) if any(starts) else 1

    @property
    def compares(self) -> bool:
        """Return whether the chapter compares releases, so that each edition has its
        own chapter.
        """
        return self.outline.compares


Chapters = Mapping[str, Chapter]
Releases = Mapping[str, Chapters]  # by release, oldest first


def before(name: str, chapters: Chapters) -> Chapters:
    """Return the chapters before the one with this name."""
    return dict(takewhile(lambda pair: pair[0] != name, chapters.items()))


def results_digest(results: Results) -> str:
    """Return a digest of a record, its traces and the name of its edition."""
    folder = results.path.parent
    files = [results.path, *traces_of(results.path, results.record)]
    return files_digest(files, folder) + folder.name
