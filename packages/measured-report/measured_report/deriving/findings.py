"""Findings: what the sections of a release found, for texts that retell it; what it lacks is said and not left out."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from measured_report.claims.claims import HOLDS, Claim
from measured_report.deriving.chapters import Chapters
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Series


@dataclass(frozen=True)
class Findings:
    """What the chapters of one release say."""

    chapters: Chapters

    def holds(self, section: str, name: str) -> bool:
        """Tell whether there is that claim, and it holds."""
        told = self.claim(section, name)
        return told is not None and told.outcome == HOLDS

    def claim(self, section: str, name: str) -> Claim | None:
        """Return a claim of a section; None where there is none."""
        chapter = self.chapters.get(section)
        claims = chapter.section.claims if chapter else ()
        return next((claim for claim in claims if claim.name == name), None)

    def value(self, section: str, name: str, unit: str = "1") -> Quantity:
        """Return a value that a section derived."""
        chapter = self.chapters.get(section)
        derived = chapter.results.derived if chapter else {}
        return derived.get(name) or self._absent(section, unit)

    def cell(self, section: str, case: str, column: str, unit: str = "1") -> Quantity:
        """Return what a section measured."""
        chapter = self.chapters.get(section)
        row = chapter.results.row.get(case) if chapter else None
        return row[column] if row and column in row else self._absent(section, unit)

    def trace(self, section: str, case: str) -> Series:
        """Return a trace of a section."""
        chapter = self.chapters.get(section)
        return chapter.results.trace(case) if chapter else Series(None, "", self._reason(section))

    def retold(self, name: str, section: str, claim: str, numbers: Mapping[str, Any] | None = None) -> Claim:
        """Return a section's claim, which has to be there, for other words: its outcome, and what these can name.

        Args:
            numbers: What they can name besides.
        """
        told = self.claim(section, claim)
        assert told, f"there is no claim {section}.{claim}"
        return Claim(name, told.outcome, {**told.numbers, **(numbers or {})})

    def stale_mark(self, reads: frozenset[str]) -> Markup:
        """Return a link to the section that was measured before its code changed, where pointers lead into one.

        It is no stop of the keyboard, which the section's own mark and the contents lead to as well.
        """
        stale = [chapter for chapter in self.chapters.values() if chapter.state.notes]
        for chapter in stale:
            place = chapter.results.source.removesuffix("json")  # its traces begin with it as well
            if any(pointer.startswith(place) for pointer in reads):
                return Markup(' <a class="badge" href="#{}" tabindex="-1">stale</a>').format(chapter.name)
        return Markup("")

    def html(self, claim: Claim, text: str) -> Markup:
        """Return a claim of a text, with a mark where it rests on a stale section; the claim ``title`` has none."""
        mark = Markup("") if claim.name == "title" else self.stale_mark(claim.outcome.reads)
        return claim.html(text) + mark

    def _absent(self, section: str, unit: str) -> Quantity:
        return absent(unit, self._reason(section))

    def _reason(self, section: str) -> str:
        return f"section {section} {'does not say' if section in self.chapters else 'has no results here'}"
