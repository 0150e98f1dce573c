"""Arithmetic on quantities, and what other sections found."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

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
AS_PUBLISHED = "published, and not measured here"  # formula of a constant
DEVICES = {"cuda": "GPU", "cpu": "CPU"}

MS_PER_S = constant(1e3, "ms/s")
MM_PER_M = constant(1e3, "mm/m")
# From which share of the slip or drift of shipped pads on a change matters, and why [%].
RELEVANT = ("a smaller change makes no difference to a grasp", 1.0)
# No smaller change of a slip matters, and why [mm].
VISIBLE = ("less than any gripper is positioned to", 0.01)
# Bounds that several sections choose: why, how much, and the unit.
SLIP_BOUND = ("a slip that can be seen", 1.0, "mm")
CAUSE_BOUND = ("a cause would change the slip by more", 10.0, "%")
SHARED_BOUNDS = ("slip_bound", "cause_bound")
# A bound that sections choose: why, and how many times less.
SETTLES = ("a change that settles the matter", 10.0)


def departure(a: Quantity, b: Quantity) -> Term:
    """Return the size of a difference, of the second [%]."""
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
    """Return a function of a sequence, as ``sum`` or ``fmean`` are."""
    return combined(lambda *numbers: function(numbers), *cells, unit=unit)


def cell_count(cells: Iterable[Quantity]) -> Term:
    """Count cells, in a value that points to them."""
    return gathered(len, cells, PLAIN)


def extreme(choose: Callable[..., float], cells: Iterable[Quantity]) -> Term:
    """Return max or min of the cells that have a number; there may be none."""
    return combined(choose, *(cell for cell in cells if cell.value is not None))


def quantile(share: float, *numbers: float) -> float:
    """Return the number that so large a share of these do not exceed.

    It says more than the largest: which run is the farthest of many is chance.
    """
    return sorted(numbers)[math.ceil(share * len(numbers)) - 1]


@dataclass(frozen=True)
class Sections:
    """What sections of one release found; a number that is missing has a reason."""

    results: Mapping[str, Results]

    def value(self, section: str, name: str) -> Quantity:
        derived = self.results[section].derived if section in self.results else {}
        if name not in derived and name in SHARED_BOUNDS:
            # Every section that compares with it has chosen the same bound.
            others = (other.derived for other in self.results.values())
            derived = next((each for each in others if name in each), {})
        return derived.get(name) or absent(PLAIN, self._reason(section))

    def cell(self, section: str, case: str, column: str) -> Quantity:
        reason = self._reason(section)
        if section in self.results:
            return cell_or_absent(self.results[section].row[case], column, reason)
        others = [results.columns for results in self.results.values()]
        return absent(others[0][column].unit if others else PLAIN, reason)

    def rows(self, section: str) -> list[Row]:
        return self.results[section].rows if section in self.results else []

    def _reason(self, section: str) -> str:
        if section in self.results:
            return f"section {section} has no such number"
        return f"section {section} was not measured: make rerun SECTION={section}"


def sections_of(chapters: Mapping[str, Any]) -> Sections:
    """Return what the chapters of an edition found."""
    return Sections({name: chapter.results for name, chapter in chapters.items()})


def other_value(results: Results, section: str, name: str) -> Quantity:
    """Return a value that an earlier section derived."""
    return Sections(results.others).value(section, name)


def relevance(results: Results, slip: Quantity | None = None) -> Value:
    """Return from which change of slip or drift on it matters [%].

    It is a share of the slip, and never less than ``VISIBLE`` millimetres of it.
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
    """Return the rows that have something in each of these columns."""
    return [
        row
        for row in results.rows
        if all(row.plain.get(column) not in (None, "") for column in columns)
    ]


def cell_or_absent(
    row: Row, column: str, reason: str = "it was not measured"
) -> Quantity:
    """Return a cell that not every record has, or a missing number with the reason."""
    if row and column in row:
        return row[column]
    return absent(row.columns[column].unit, reason)


def is_held(row: Row) -> bool:
    """Tell whether a run keeps the cube through a cycle at least.

    A hand that trembles may shake too late.
    """
    return None not in (row.slip_mm.value, row.cycle_count.value)


def settings_of(releases: Releases) -> Config:
    """Return the settings of the report that these releases are of."""
    for chapters in releases.values():
        for chapter in chapters.values():
            return chapter.results.columns.settings
    return Config()


def joined(parts: Sequence[Section]) -> Section:
    """Make one section of its parts, in their order."""
    tables: dict[str, Any] = {}
    figures: dict[str, Any] = {}
    for part in parts:
        tables |= part.tables
        figures |= part.figures
    return Section(tables, figures, [claim for part in parts for claim in part.claims])


def contiguous(flags: Sequence[bool], *quantities: Quantity) -> Outcome:
    """Test whether the true flags stand together, in the order given; they were decided by the quantities."""
    return decided(sum(flag for flag, _ in groupby(flags)) == 1, *quantities)
