"""What sections found, for the words of pages; what a release lacks has its reason."""

from dataclasses import dataclass

from measured_report.pages.editions import Chapters
from measured_report.values.quantities import Quantity, absent

CASES = {"as-shipped": "shipped pads", "stiff-pads": "stiff pads"}
"""The cases that the first page shows, and what it calls them."""
FIX = "the pads' ke and kd"


@dataclass(frozen=True)
class Found:
    """The chapters of one release."""

    chapters: Chapters

    def value(self, section: str, name: str, unit: str = "1") -> Quantity:
        derived = self.chapters[section].results.derived if section in self.chapters else {}
        return derived.get(name) or absent(unit, self._reason(section))

    def cell(self, section: str, case: str, column: str, unit: str = "1") -> Quantity:
        row = self.chapters[section].results.row.get(case) if section in self.chapters else None
        return row[column] if row and column in row else absent(unit, self._reason(section))

    def _reason(self, section: str) -> str:
        return f"section {section} {'does not say' if section in self.chapters else 'has no results here'}"
