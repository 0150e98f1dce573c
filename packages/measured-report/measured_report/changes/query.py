"""Queries: a claim or a value that one edition after the other is asked for."""

from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any

from measured_report.files.config import config
from measured_report.pages.editions import Chapters
from measured_report.parts.claim import Claim
from measured_report.records.columns import column_of
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row

Answer = str | float


@dataclass(frozen=True)
class Query:
    """Ask each edition for a claim, or a value, of the page or of a row."""

    text: str
    """As CLAIM= or VALUE= says it: ``section.claim``, ``section.value`` or ``section.case.column``."""
    is_claim: bool = False
    label: str = ""
    device: str = ""
    """For a section that has the case on several devices, and with one or more worlds: of which to take that of one."""

    @property
    def section(self) -> str:
        return self.text.partition(".")[0]

    @property
    def case(self) -> str:
        """Name the case of a number of a row; empty for others."""
        return self.text.partition(".")[2].rpartition(".")[0]

    @property
    def column(self) -> str:
        return self.text.rpartition(".")[2]

    @property
    def unit(self) -> str:
        return column_of(self.column).unit

    def answer(self, chapters: Chapters) -> Answer | None:
        """Return what the chapters of an edition say; None where they can't tell."""
        if self.is_claim:
            claim = self.claim(chapters)
            return claim.outcome.name if claim and claim.outcome.name != "unknown" else None
        found = self.quantity(chapters)
        value: Any = getattr(found, "value", found)  # yes and no are plain, and so are texts, which nothing is told of
        return None if isinstance(value, str) else value

    def quantity(self, chapters: Chapters) -> Quantity | bool | str | None:
        """Return the value that is asked for, or what a row has in its place; None where there is none."""
        if self.case:
            return self.cell(chapters)
        chapter = chapters.get(self.section)
        return chapter.results.derived.get(self.column) if chapter else None

    def cell(self, chapters: Chapters, release: str = "") -> Quantity:
        """Return what a row of the edition ``release`` has; no number, and a reason, when that has nothing."""
        same = config().changes.same_runs
        sections = (self.section, *(same if self.section in same else ()))
        rows = (self._row(chapters[section].results) for section in sections if section in chapters)
        row = next(filter(None, rows), None)
        if row and self.column in row:
            return row[self.column]
        return absent(self.unit, f"{self.section} has not been measured so with {config().edition_name} {release}")

    def _row(self, results: Results) -> Row | None:
        if not self.device:
            return results.row[self.case]
        rows = (row for row in results.rows if "device" in row and row.worlds.value == 1)
        return next((row for row in rows if (row.case, row.device) == (self.case, self.device)), None)

    def claim(self, chapters: Chapters) -> Claim | None:
        """Return the claim that is asked for; None where there is none."""
        chapter = chapters.get(self.section)
        claims = chapter.section.claims if chapter else ()
        return next((claim for claim in claims if f"{self.section}.{claim.name}" == self.text), None)

    def names(self, chapters: Chapters) -> Iterator[str]:
        """Yield what an edition can be asked: claims, or else values and, of the section meant, numbers of rows."""
        for name, chapter in chapters.items():
            found = [claim.name for claim in chapter.section.claims] if self.is_claim else chapter.results.derived
            yield from (f"{name}.{each}" for each in found)
        for name in [] if self.is_claim else get_close_matches(self.section, chapters, n=1):
            for case, row in chapters[name].results.row.items():
                numbers = (column for column in row.columns if isinstance(row[column], Quantity))
                yield from (f"{name}.{case}.{column}" for column in numbers)

    def is_first(self, answer: Answer, first: Answer, last: Answer) -> bool:
        """Tell whether an answer is the first one rather than the last; of numbers, whether it is nearer."""
        if self.is_claim:
            return answer == first
        return abs(float(answer) - float(first)) < abs(float(answer) - float(last))
