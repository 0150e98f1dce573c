"""Chapters: what a section of one release makes of its record."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import takewhile

from measured_report.editions.status import State
from measured_report.files.config import Page
from measured_report.parts.section import Section
from measured_report.records.identity import files_digest
from measured_report.records.record import traces_of
from measured_report.values.results import Results


@dataclass(frozen=True)
class Chapter:
    state: State
    results: Results
    section: Section
    page: Page
    compares: bool  # set where it compares releases, so that what it derives is of one page alone
    digest: str  # covers all that it was made from, where that is kept

    @property
    def name(self) -> str:
        return self.state.section


Chapters = Mapping[str, Chapter]
Releases = Mapping[str, Chapters]  # the chapters of every release that has results, oldest first


def before(name: str, chapters: Chapters) -> Chapters:
    """Return the chapters that stand before one."""
    return dict(takewhile(lambda item: item[0] != name, chapters.items()))


def digests_of(releases: Releases) -> list[str]:
    """Name chapters by all that they were made from."""
    return [f"{name} {chapter.name} {chapter.digest}" for name, group in releases.items() for chapter in group.values()]


def results_digest(results: Results) -> str:
    folder = results.path.parent
    return files_digest([results.path, *traces_of(results.path, results.record)], folder) + folder.name
