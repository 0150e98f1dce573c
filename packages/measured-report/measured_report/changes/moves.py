"""Moves: values that editions have differently, and whether by more than runs of one edition differ."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from measured_report.changes.costs import cost_terms
from measured_report.claims.claim import NEAR_NOISE
from measured_report.deriving.chapters import Chapter
from measured_report.files.config import config
from measured_report.records.columns import REASON, column_of
from measured_report.records.record import Record
from measured_report.values.noise import EDGES, Floor, is_beyond
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row

CHOSEN_SHARE, CHOSEN_RANGE = 0.1, 0.01
"""What counts as noise where none was measured: this share of a value, and this one of the column's largest."""


@dataclass(frozen=True)
class Move:
    """A value of two editions, and how far apart runs of one edition come out."""

    column: str
    before: Any
    after: Any
    """Each a number, a Quantity, a text, or yes and no."""
    noise: float | None = None
    """None for what is no number."""
    is_chosen: bool = False
    """Whether that noise was not measured."""
    section: str = ""
    place: Mapping[str, Any] = field(default_factory=dict)
    """What tells its row apart, by column."""

    @property
    def values(self) -> tuple[Any, Any]:
        return _plain(self.before), _plain(self.after)

    @property
    def is_real(self) -> bool:
        """Whether the values differ by more than the noise."""
        before, after = self.values
        return before != after if None in (self.noise, before, after) else is_beyond(self.noise, before, after)

    @property
    def is_near(self) -> bool:
        """Whether by less than NEAR_NOISE times a measured noise, which another measurement of the same may do too."""
        if self.is_chosen or self.noise is None or not self.is_real:
            return False
        return not is_beyond(NEAR_NOISE * self.noise, *self.values)

    @property
    def direction(self) -> str:
        """``better`` or ``worse``, where one can say so."""
        (before, after), better = self.values, column_of(self.column).better
        if None in (before, after) or not better:
            return ""
        return "better" if (abs(after) > abs(before)) == (better == "more") else "worse"

    @property
    def mark(self) -> str:
        """``better``, ``worse`` or ``moved`` where it is clearly more than the noise; otherwise empty."""
        return (self.direction or "moved") if self.is_real and not self.is_near else ""

    @property
    def text(self) -> str:
        untold = config().changes.untold_keys
        name = " ".join(str(part) for column, part in self.place.items() if column not in untold)
        noise = "" if self.noise is None else f"  (noise {self.noise:.2g}{', chosen' if self.is_chosen else ''})"
        words = ["near the noise"] if self.is_near else [self.direction] if self.direction else []
        return "  ".join([f"{name}  {self.column}: {_said(self.before)} → {_said(self.after)}{noise}", *words])


def moves_between(before: Chapter, after: Chapter, floors: Mapping[str, Floor]) -> Iterator[Move]:
    """Yield the values of a section that two editions have differently, by more than the noise of their columns."""
    old, new = _rows_by_key(before), _rows_by_key(after)
    records = before.results.record, after.results.record
    ranges = _ranges(records)
    classes = config().changes.classes
    for key in (key for key in old if key in new):
        rows = old[key], new[key]
        # Where repeats of a run end in different classes it is chance which one the row is about.
        if not any(len(set(row[classes].split(", "))) > 1 for row in rows if classes in row):
            cells = ({column: _plain(row[column]) for column in row.columns} for row in rows)
            found = _moves_of_rows(rows, floors, ranges, has_same_terms=len(set(map(cost_terms, records, cells))) == 1)
            yield from (replace(move, section=before.name, place=dict(key)) for move in found)


def _moves_of_rows(
    rows: tuple[Row, Row], floors: Mapping[str, Floor], ranges: Mapping[str, float], *, has_same_terms: bool
) -> Iterator[Move]:
    """Yield what moved in a row; ``has_same_terms`` says whether costs in it compare."""
    rules = config().changes
    # The run of a row may be lost, which makes its numbers chance.
    lost = [any("loss" in column_of(name).kinds and bool(row[name]) for name in row.columns) for row in rows]
    for column in rows[0].columns:
        kinds = column_of(column).kinds
        is_key = column in (*rules.keys, *rules.untold_keys)
        if column not in rows[1] or is_key or "chance" in kinds or column.endswith((REASON, *EDGES)):
            continue
        cells = rows[0][column], rows[1][column]
        noise: tuple[float | None, bool] = None, False
        if all(isinstance(cell, Quantity) for cell in cells):
            if any(lost) or ("cost" in kinds and not has_same_terms):
                continue
            values = [cell.value for cell in cells]
            noise = noise if None in values else _noise(column, rows, values, floors, ranges)
        elif all(lost) and "loss" in kinds:
            continue
        move = Move(column, *cells, *noise)
        if move.is_real:
            yield move


def _noise(
    column: str, rows: tuple[Row, Row], values: list[float], floors: Mapping[str, Floor], ranges: Mapping[str, float]
) -> tuple[float, bool]:
    """Return the noise of a value, and whether it is a chosen one."""
    chosen = max(CHOSEN_SHARE * max(map(abs, values)), CHOSEN_RANGE * ranges[column])
    edges = [column + edge for edge in EDGES]
    if all(edge in row and row[edge].value is not None for row in rows for edge in edges):
        measured = max(row[edges[1]].value - row[edges[0]].value for row in rows)
        # Of two machines of one kind one may be faster, and nothing in a record tells one from the other.
        return (chosen, True) if chosen > NEAR_NOISE * measured else (measured, False)
    if column.endswith("_count"):
        return max(1.0, chosen), True
    return (floors[column].at(*values), False) if column in floors else (chosen, True)


def _ranges(records: Iterable[Record]) -> dict[str, float]:
    """Return the largest size of each column's numbers."""
    ranges: dict[str, float] = {}
    cells = ((column, row.get(column)) for record in records for row in record.rows for column in record.units)
    for column, cell in cells:
        if isinstance(cell, int | float):
            ranges[column] = max(ranges.get(column, 0.0), abs(cell))
    return ranges


def _rows_by_key(chapter: Chapter) -> dict[tuple[tuple[str, Any], ...], Row]:
    """Return rows by what tells them apart; those that nothing tells apart are left out."""
    rules = config().changes
    names = (*rules.keys, *rules.untold_keys)
    keys = [
        tuple((name, part) for name in names if name in row and (part := _plain(row[name])) is not None)
        for row in chapter.results.rows
    ]
    counts = Counter(keys)
    return {key: row for key, row in zip(keys, chapter.results.rows, strict=True) if counts[key] == 1}


def _plain(cell: Any) -> Any:
    return cell.value if isinstance(cell, Quantity) else cell


def _said(cell: Any) -> str:
    if isinstance(cell, Quantity):
        return f"{cell} ({cell.reason})" if cell.value is None else str(cell)
    return {True: "yes", False: "no", None: "none"}.get(cell, str(cell))
