"""Chapters: one section of one edition, from its record to its words."""

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
    """Hold all of a section in one edition: each stage of a build adds its fields."""

    state: State  # how its record stands to the code
    outline: Outline
    results: Results
    key: str = ""  # digest of all that it is derived from
    section: Section = field(default_factory=Section)  # what is derived
    names: Mapping[str, Any] = field(default_factory=dict)  # what templates can name
    prose: Prose | None = None  # its words, once they are said

    @property
    def name(self) -> str:
        return self.state.section

    @property
    def page(self) -> Page:
        return self.outline.page

    @property
    def code(self) -> Iterator[tuple[str, int]]:
        """Yield the file and the line of what measures it and of what derives it."""
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
        """Tell whether it compares releases, so that it is of one page alone."""
        return self.outline.compares


Chapters = Mapping[str, Chapter]
Releases = Mapping[str, Chapters]  # of every release that has results, oldest first


def before(name: str, chapters: Chapters) -> Chapters:
    """Return the chapters that stand before one."""
    return dict(takewhile(lambda item: item[0] != name, chapters.items()))


def results_digest(results: Results) -> str:
    """Digest a record with its traces, and the edition that it is of."""
    folder = results.path.parent
    files = [results.path, *traces_of(results.path, results.record)]
    return files_digest(files, folder) + folder.name
