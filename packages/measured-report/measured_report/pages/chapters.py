"""Chapters: what a section of a release makes of its record, and the words for it; nothing is drawn yet."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from measured_report.editions.status import State
from measured_report.pages.prose import Prose
from measured_report.pages.sections import Page
from measured_report.parts.macros import macros
from measured_report.parts.section import Section
from measured_report.values.results import Results


@dataclass(frozen=True)
class Chapter:
    """Hold what a section of one release makes."""

    state: State
    results: Results
    section: Section
    names: Mapping[str, Any]
    """What its template can name, and other templates through ``sections``."""
    prose: Prose | None
    """None for a section that compares releases until it has them."""
    page: Page
    compares: bool = False
    """Set where it compares releases, so that what it derives is of one page alone."""
    digest: str = ""
    """Covers all that it was made from, as far as others read it; empty where nothing is kept."""

    @property
    def name(self) -> str:
        return self.state.section


def stale_mark(chapters: Iterable[Chapter], reads: frozenset[str]) -> Markup:
    """Link to the section that was measured before its code changed, where pointers lead into one.

    The link is no stop of the keyboard, which the section's own mark and the contents lead to as well.
    """
    for chapter in chapters:
        place = chapter.results.source.removesuffix("json")  # its traces begin with it as well
        if chapter.state.notes and any(pointer.startswith(place) for pointer in reads):
            return macros().stale(chapter)
    return Markup("")


Chapters = Mapping[str, Chapter]
"""The chapters of one release by name, in the order of the page."""
Releases = Mapping[str, Chapters]
"""The chapters of every release that has results, oldest first."""
