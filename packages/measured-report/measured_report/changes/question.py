"""Questions: a claim or a value, asked of one edition after the other."""

from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any

from measured_report.changes.releases import Headline, cell
from measured_report.claims.claims import Claim
from measured_report.deriving.chapters import Chapters
from measured_report.values.quantities import Quantity

Answer = str | float


@dataclass(frozen=True)
class Question:
    """What is asked of each edition: a claim, ``section.claim``, or a value, of the page or of a row."""

    text: str
    """As CLAIM= or VALUE= said it: ``section.claim``, ``section.value`` or ``section.case.column``."""
    is_claim: bool

    @property
    def section(self) -> str:
        return self.text.partition(".")[0]

    def answer(self, chapters: Chapters) -> Answer | None:
        """What the chapters of an edition say; None where they can't tell."""
        name = self.text.partition(".")[2]
        case, _, column = name.rpartition(".")
        if case and not self.is_claim:
            found: Any = cell({"": chapters}, "", Headline("", self.section, case, column, ""))
            value = getattr(found, "value", found)  # yes and no are plain, and so are texts, which nothing is told of
            return None if isinstance(value, str) else value
        if self.is_claim:
            claim = self.claim(chapters)
            return claim.outcome.name if claim and claim.outcome.name != "unknown" else None
        chapter = chapters.get(self.section)
        return chapter.results.derived[name].value if chapter and name in chapter.results.derived else None

    def claim(self, chapters: Chapters) -> Claim | None:
        """The claim that is asked for; None where there is none."""
        chapter = chapters.get(self.section)
        claims = chapter.section.claims if chapter else ()
        return next((claim for claim in claims if f"{self.section}.{claim.name}" == self.text), None)

    def names(self, chapters: Chapters) -> Iterator[str]:
        """What an edition can be asked: claims, or else values and, of the section that is meant, numbers of rows."""
        for name, chapter in chapters.items():
            found = [claim.name for claim in chapter.section.claims] if self.is_claim else chapter.results.derived
            yield from (f"{name}.{each}" for each in found)
        for name in [] if self.is_claim else get_close_matches(self.section, chapters, n=1):
            for case, row in chapters[name].results.row.items():
                numbers = (column for column in row.columns if isinstance(row[column], Quantity))
                yield from (f"{name}.{case}.{column}" for column in numbers)

    def is_as(self, answer: Answer, first: Answer, last: Answer) -> bool:
        """Whether an answer is the first one rather than the last; of numbers, whether it is nearer."""
        if self.is_claim:
            return answer == first
        return abs(float(answer) - float(first)) < abs(float(answer) - float(last))
