"""What several sections share."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from markupsafe import Markup

from measured_report.parts.claim import FAILS, Outcome, at_most
from measured_report.parts.section import Section, Table
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row

Column = str | Callable[[Row], Any] | Sequence
"""A column of a table: a column of the record, what makes a cell of a row, or the cells."""
NAMED_COUNT = 6
"""Cases that a sentence names at most."""
CASES = {"as-shipped": "shipped pads", "stiff-pads": "stiff pads"}
"""Cases that many sections measure, and what they are called."""
DEVICES = {"cuda": "GPU", "cpu": "CPU"}

SETTLES = ("a change that settles the matter", 10.0)
"""Why, and how many times less a slip has to be, for a bound that several sections choose."""


def _of_two(function: Callable[[float, float], float], unit: str = "") -> Callable[..., Value]:
    """Make what derives a value of two quantities, in the unit of the first where none is given."""

    def derive(results: Results, name: str, formula: str, a: Quantity, b: Quantity) -> Value:
        return results.value(name, formula, function, a, b, unit=unit or a.unit)

    return derive


ratio = _of_two(lambda a, b: a / b, "1")
share = _of_two(lambda a, b: 100 * a / b, "%")
size_share = _of_two(lambda a, b: 100 * abs(a / b), "%")
departure = _of_two(lambda a, b: 100 * abs(a / b - 1), "%")
"""Size of the difference, of the second."""
excess = _of_two(lambda a, b: 100 * (a / b - 1), "%")
"""How much more than the second the first is, of that; negative where it is less."""
difference = _of_two(lambda a, b: a - b)
size_difference = _of_two(lambda a, b: abs(a - b))


def largest_size(results: Results, name: str, formula: str, cells: Iterable[Quantity], *, unit: str = "1") -> Value:
    """Derive the largest of the cells, signs left out; without a number when one of them has none."""
    return results.value(name, formula, lambda *found: max(map(abs, found)), *cells, unit=unit)


def total(results: Results, name: str, formula: str, cells: Iterable[Quantity]) -> Value:
    """Derive the sum of the cells, which are counts."""
    return results.value(name, formula, lambda *counts: sum(counts), *cells)


def spread(results: Results, name: str, formula: str, cells: Sequence[Quantity]) -> Value:
    """Derive the largest less the smallest."""
    return results.value(name, formula, lambda *found: max(found) - min(found), *cells, unit=cells[0].unit)


def extreme(
    results: Results, name: str, formula: str, choose: Callable[..., float], cells: Sequence[Quantity]
) -> Value:
    """Return ``choose``, max or min, of the cells that there are; without a number when there is none."""
    there = [cell for cell in cells if cell.value is not None]
    unit = there[0].unit if there else "1"
    return results.value(name, formula, choose, *there, unit=unit)


def quantile(share: float, *found: float) -> float:
    """Return the number that so large a share of these do not exceed; which run is the farthest of many is chance."""
    return sorted(found)[math.ceil(share * len(found)) - 1]


def cell_count(results: Results, name: str, formula: str, cells: Sequence[Quantity]) -> Value:
    """Say how many cells there are, as a value that points to them."""
    return results.value(name, formula, lambda *found: len(found), *cells)


def noise_floor(results: Results, name: str) -> Quantity:
    """Return ``slip_floor`` [mm] or ``drift_floor`` [mm/s]: how far apart identical runs may come out."""
    return other_value(results, "noise", name, unit={"slip_floor": "mm", "drift_floor": "mm/s"}[name])


def resolved(noise: Quantity, bound: Quantity | float, *, why: str = "") -> Outcome:
    """Tell whether the noise is small enough to see whether a bound is kept; otherwise that can't be told."""
    found = at_most(noise, bound, why=why)
    reason = "the noise is larger than what is looked for"
    return replace(found, name="unknown", reason=reason) if found == FAILS else found


@dataclass(frozen=True)
class Found:
    """What sections of one release found; without a number, and with a reason, where a release lacks it."""

    results: Mapping[str, Results]

    def value(self, section: str, name: str, unit: str = "1") -> Quantity:
        derived = self.results[section].derived if section in self.results else {}
        return derived.get(name) or absent(unit, self._reason(section))

    def cell(self, section: str, case: str, column: str, unit: str = "1") -> Quantity:
        row = self.results[section].row.get(case) if section in self.results else None
        return cell_or_absent(row, column, unit, self._reason(section))

    def _reason(self, section: str) -> str:
        return f"section {section} {'does not say' if section in self.results else 'has no results here'}"


def other_value(results: Results, section: str, name: str, *, unit: str = "1") -> Quantity:
    """Return a value that an earlier section derived."""
    return Found(results.others).value(section, name, unit)


def by_case(rows: Sequence[Row], columns: Mapping[str, Column], **numbers: Quantity | str | bool) -> Table:
    """Make a table with a line for each row, under the name of its case."""
    return table_of("case", [case_html(row) for row in rows], columns, rows, **numbers)


def case_html(row: Row) -> Markup:
    """Return the label of a row's case, its code name in the title."""
    return Markup('<span class="case" title="{}">{}</span>').format(row["case"], row.label)


def some_html(names: Sequence[Markup]) -> Markup:
    """Name as many as a sentence can hold, and that there are others."""
    return Markup("; ").join(names[:NAMED_COUNT]) + (" and others" if len(names) > NAMED_COUNT else "")


def table_of(
    heading: str,
    names: Iterable[Any],
    columns: Mapping[str, Column],
    rows: Iterable[Row] = (),
    **numbers: Quantity | str | bool,
) -> Table:
    """Make a table with a line for each name.

    Args:
        heading: Stands above the names.
        columns: By what stands above it, a column of the record, what makes a cell of a row, or the cells.
        rows: A row for each name, for columns that are not given by their cells.
        numbers: What the caption can name.
    """
    import pandas as pd  # it takes long, and what is kept from before needs none of it

    rows = list(rows)

    def cells(column: Column) -> list:
        if isinstance(column, str):
            return [cell_or_lost(row, column) for row in rows]
        return list(map(column, rows) if callable(column) else column)

    found = {above: cells(column) for above, column in columns.items()}
    return Table(pd.DataFrame(found, index=pd.Index(list(names), name=heading), dtype=object), numbers)


def cell_or_lost(row: Row, column: str) -> Any:
    """Return a cell of a table, in words where the cube was lost."""
    cell = row[column]
    return "lost" if row.plain.get("dropped") and getattr(cell, "value", cell) is None else cell


def creep_or_unseen(row: Row) -> Any:
    """Return the creep of a row for a table, in words where its slip is not seen."""
    is_seen = row.slip_mm.value is None or row.slip_mm.value > (row.slip_mm.noise or 0.0)
    return cell_or_lost(row, "creep_mm_per_cycle") if is_seen else "not seen"


def rows_with(results: Results, *columns: str) -> list[Row]:
    """Return list the rows that have something in each of these columns, by which the parts of a section tell their
    rows."""
    return [row for row in results.rows if all(row.plain.get(column) not in (None, "") for column in columns)]


def cell_or_absent(row: Row | None, column: str, unit: str, reason: str = "it was not measured") -> Quantity:
    """Return a cell that not every record has; without a number, and with the reason, when it isn't there."""
    return row[column] if row and column in row else absent(unit, reason)


def is_held(row: Row) -> bool:
    """Tell whether a run keeps the cube. One that comes to its shake too late to go through a cycle of it has shown
    nothing: a hand that trembles takes seconds longer to close and to lift."""
    return None not in (row.slip_mm.value, row.cycle_count.value)


def joined(parts: Sequence[Section]) -> Section:
    """Make one section of its parts, in their order."""
    return Section(
        tables={name: table for part in parts for name, table in part.tables.items()},
        figures={name: figure for part in parts for name, figure in part.figures.items()},
        claims=[claim for part in parts for claim in part.claims],
    )
