"""Questions: a claim or a value, asked of one edition after the other."""

from dataclasses import dataclass
from typing import Any

from report.chapters import Chapters
from report.deriving.releases import Headline, cell

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
        chapter = chapters.get(self.section)
        if chapter is None:
            return None
        if self.is_claim:
            outcomes = [claim.outcome.name for claim in chapter.section.claims if claim.name == name]
            return next((outcome for outcome in outcomes if outcome != "unknown"), None)
        return chapter.results.derived[name].value if name in chapter.results.derived else None

    def is_as(self, answer: Answer, first: Answer, last: Answer) -> bool:
        """Whether an answer is the first one rather than the last; of numbers, whether it is nearer."""
        if self.is_claim:
            return answer == first
        return abs(float(answer) - float(first)) < abs(float(answer) - float(last))
