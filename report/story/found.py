"""What sections found, for pages that retell it; what a release lacks is said and not left out."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from measured_report.claims.claim import FAILS, HOLDS, Claim
from measured_report.deriving.chapters import Chapters
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Series


@dataclass(frozen=True)
class Found:
    """The chapters of one release."""

    chapters: Chapters

    @property
    def does_slip(self) -> bool:
        """Whether the cube slips as shipped."""
        return self._holds("slips")

    @property
    def does_hold(self) -> bool:
        """Whether stiff pads hold it better."""
        return self._holds("stiff_pads_hold")

    def _holds(self, name: str) -> bool:
        told = self.claim("reproduction", name)
        return told is not None and told.outcome == HOLDS

    def claim(self, section: str, name: str) -> Claim | None:
        """Return a claim of a section; None where there is none."""
        claims = self.chapters[section].section.claims if section in self.chapters else ()
        return next((claim for claim in claims if claim.name == name), None)

    def value(self, section: str, name: str, unit: str = "1") -> Quantity:
        """Return a value that a section derived."""
        derived = self.chapters[section].results.derived if section in self.chapters else {}
        return derived.get(name) or absent(unit, self._reason(section))

    def cell(self, section: str, case: str, column: str, unit: str = "1") -> Quantity:
        """Return what a section measured."""
        row = self.chapters[section].results.row.get(case) if section in self.chapters else None
        return row[column] if row and column in row else absent(unit, self._reason(section))

    def titled(self, name: str) -> Claim:
        """Return whether the cube slips, and stiff pads hold it better."""
        slips, held = self.claim("reproduction", "slips").outcome, self.claim("reproduction", "stiff_pads_hold").outcome
        both = HOLDS if held == HOLDS else FAILS
        outcome = both if slips == HOLDS else slips
        return Claim(name, replace(outcome, reads=slips.reads | held.reads), {"slips": self.does_slip})

    def trace(self, section: str, case: str) -> Series:
        """Return a trace of a section."""
        chapter = self.chapters.get(section)
        return chapter.results.trace(case) if chapter else Series(None, "", self._reason(section))

    def retold(self, name: str, section: str, claim: str, numbers: Mapping[str, Any] | None = None) -> Claim:
        """Return a section's claim, which has to be there, for other words; these can name ``numbers`` besides."""
        told = self.claim(section, claim)
        assert told, f"there is no claim {section}.{claim}"
        return Claim(name, told.outcome, {**told.numbers, **(numbers or {})})

    def _reason(self, section: str) -> str:
        return f"section {section} {'does not say' if section in self.chapters else 'has no results here'}"
