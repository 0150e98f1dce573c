"""Compute with quantities, and give access to the findings of other sections."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from experiments.facts.case import AS_SHIPPED
from measured_report.files.columns import PLAIN
from measured_report.files.settings import Config
from measured_report.findings.chapters import Releases
from measured_report.parts.claim import Outcome, decided
from measured_report.parts.section import Section
from measured_report.values.quantities import (
    PERCENT,
    Quantity,
    Term,
    Value,
    absent,
    combined,
    constant,
)
from measured_report.values.results import Results, Row

# Cases that many sections measure, by label.
CASES = {"as-shipped": "shipped pads", "stiff-pads": "stiff pads"}
# The formula of all numbers that come from the literature.
AS_PUBLISHED = "published by others, not measured here"
DEVICES = {"cuda": "GPU", "cpu": "CPU"}

MS_PER_S = constant(1e3, "ms/s")
MM_PER_M = constant(1e3, "mm/m")
FRAME_RATE = 60  # of the scene [1/s]
SUBSTEP_S = constant(1 / FRAME_RATE / AS_SHIPPED.substeps, "s")
# A bound and its reason: the smallest change of a slip or drift that matters, relative
# to shipped pads [%].
RELEVANT = ("a smaller change makes no difference to a grasp", 1.0)
# The smallest change of a slip that matters in absolute terms [mm].
VISIBLE = ("no gripper is positioned more precisely", 0.01)
# Bounds that several sections use: the reason, the bound and its unit.
SLIP_BOUND = ("a slip that can be seen", 1.0, "mm")
CAUSE_BOUND = ("a cause would change the slip by more", 10.0, "%")
SHARED_BOUNDS = ("slip_bound", "cause_bound")
# The factor by which a solution has to reduce the slip.
SETTLES = (10.0, "a change that settles the matter")


def departure(a: Quantity, b: Quantity) -> Term:
    """Return the absolute difference of ``a`` and ``b``, relative to ``b`` [%]."""
    return PERCENT * abs(a / b - 1)


def largest_size(cells: Iterable[Quantity]) -> Term:
    return combined(max, *map(abs, cells))


def spread(cells: Sequence[Quantity]) -> Term:
    return combined(max, *cells) - combined(min, *cells)


def gathered(
    function: Callable[[Sequence[float]], float],
    cells: Iterable[Quantity],
    unit: str = "",
) -> Term:
    """Apply a function of a whole sequence, such as ``sum`` or ``fmean``, to cells."""
    return combined(lambda *numbers: function(numbers), *cells, unit=unit)


def cell_count(cells: Iterable[Quantity]) -> Term:
    """Return the number of cells, with these cells as its sources."""
    return gathered(len, cells, PLAIN)


def extreme(choose: Callable[..., float], cells: Iterable[Quantity]) -> Term:
    """Return the largest or smallest cell that has a number.

    If there is no such cell, the result has no number either.
    """
    return combined(choose, *(cell for cell in cells if cell.value is not None))


def quantile(share: float, *numbers: float) -> float:
    """Return the smallest number that is at least as large as this share of the cells.

    Claims test a quantile, because the most extreme of many runs depends on chance.
    """
    return sorted(numbers)[math.ceil(share * len(numbers)) - 1]


@dataclass(frozen=True)
class Sections:
    """Holds the findings of one release by section. A missing number has a reason."""

    results: Mapping[str, Results]

    def value(self, section: str, name: str) -> Quantity:
        derived = self.results[section].derived if section in self.results else {}
        if name not in derived and name in SHARED_BOUNDS:
            # All sections that use a shared bound choose the same number.
            sections = (results.derived for results in self.results.values())
            derived = next((values for values in sections if name in values), {})
        return derived.get(name) or absent(PLAIN, self._reason(section))

    def cell(self, section: str, case: str, column: str) -> Quantity:
        reason = self._reason(section)
        if section in self.results:
            return cell_or_absent(self.results[section].row[case], column, reason)
        schemas = [results.columns for results in self.results.values()]
        return absent(schemas[0][column].unit if schemas else PLAIN, reason)

    def rows(self, section: str) -> list[Row]:
        return self.results[section].rows if section in self.results else []

    def _reason(self, section: str) -> str:
        if section in self.results:
            return f"section {section} has no such number"
        return f"section {section} was not measured: make rerun SECTION={section}"


def sections_of(chapters: Mapping[str, Any]) -> Sections:
    """Return the findings of an edition's chapters."""
    return Sections({name: chapter.results for name, chapter in chapters.items()})


def relevance(results: Results, slip: Quantity | None = None) -> Value:
    """Return the smallest change of a slip or drift that matters [%].

    If the slip is given, the change is at least ``VISIBLE`` millimetres.
    """
    name = "relevance"
    if name in results.derived:
        return results.derived[name]
    if slip is None:
        return results.chosen(name, *RELEVANT, "%")
    share = results.chosen(f"{name}_share", *RELEVANT, "%")
    visible = results.chosen(f"{name}_least", *VISIBLE, "mm")
    return results.value(
        name,
        f"{share.written} % of the slip, and at least {visible}",
        combined(max, share, PERCENT * visible / abs(slip)),
        is_noise=True,
    )


def rows_with(results: Results, *columns: str) -> list[Row]:
    """Return the rows that have a value in each of these columns."""
    return [
        row
        for row in results.rows
        if all(row.plain.get(column) not in (None, "") for column in columns)
    ]


def cell_or_absent(
    row: Row, column: str, reason: str = "it was not measured"
) -> Quantity:
    """Return a cell, or a missing number with the reason if the record lacks the column."""
    if row and column in row:
        return row[column]
    return absent(row.columns[column].unit, reason)


def is_held(row: Row) -> bool:
    """Return whether a run keeps the cube and completes at least one cycle.

    If the hand trembles, the shake may begin too late for a cycle.
    """
    return None not in (row.slip_mm.value, row.cycle_count.value)


def settings_of(releases: Releases) -> Config:
    """Return the settings of the report, which all chapters share."""
    for chapters in releases.values():
        for chapter in chapters.values():
            return chapter.results.columns.settings
    return Config()


def joined(parts: Sequence[Section]) -> Section:
    """Combine the parts of a section, in their order."""
    tables: dict[str, Any] = {}
    figures: dict[str, Any] = {}
    for part in parts:
        tables |= part.tables
        figures |= part.figures
    return Section(tables, figures, [claim for part in parts for claim in part.claims])


def contiguous(flags: Sequence[bool], *quantities: Quantity) -> Outcome:
    """Test whether the true flags, which depend on these quantities, are adjacent."""
    return decided(sum(flag for flag, _ in groupby(flags)) == 1, *quantities)
