"""Comparison of two editions: what can't be trusted, which claims flipped, and which values moved beyond the noise."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from measured_report.changes.costs import cost_terms, is_cost, terms_of
from measured_report.changes.faults import Fault, faults_between, faults_of
from measured_report.claims.claims import NEAR_NOISE, Claim
from measured_report.deriving.chapters import Chapter, Chapters
from measured_report.deriving.editions import Edition
from measured_report.records.columns import REASON, column_of
from measured_report.records.record import Record
from measured_report.values.noise import EDGES, NOISE, Floor, is_beyond, noise_floors, verdict
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row

KEYS = ("case", "kind", "device", "worlds", "substeps")
"""Columns that tell the rows of one section apart, where they are there; a search may end at other substeps."""
CHOSEN_SHARE, CHOSEN_RANGE = 0.1, 0.01
"""What counts as noise where none was measured: this share of a value, and this one of the column's largest."""
Key = tuple[Any, ...]


@dataclass(frozen=True)
class Move:
    """A value that two releases have differently, by more than runs of one release differ."""

    section: str
    key: Key
    column: str
    before: Any
    after: Any
    """Each a Quantity, a text, or yes and no."""
    noise: float | None
    """None for what is no number."""
    is_chosen: bool
    """Whether that noise was not measured."""
    is_near: bool = False
    """Whether it is by less than NEAR_NOISE times the noise, which another measurement of the same may do as well."""

    @property
    def verdict(self) -> str:
        """``better`` or ``worse``, where one can say so."""
        return verdict(self.column, _plain(self.before), _plain(self.after))

    @property
    def place(self) -> dict[str, Any]:
        """What tells the row apart, by column."""
        return {column: part for column, part in zip(KEYS, self.key, strict=True) if part is not None}

    @property
    def text(self) -> str:
        name = " ".join(str(part) for column, part in self.place.items() if column != "substeps")
        noise = "" if self.noise is None else f"  (noise {self.noise:.2g}{', chosen' if self.is_chosen else ''})"
        words = ["near the noise"] if self.is_near else [self.verdict] if self.verdict else []
        return "  ".join([f"{name}  {self.column}: {_said(self.before)} → {_said(self.after)}{noise}", *words])


@dataclass(frozen=True)
class Flip:
    """A claim whose outcome two releases have differently."""

    section: str
    before: Claim
    after: Claim

    @property
    def text(self) -> str:
        outcomes = f"{self.before.outcome.said} → {self.after.outcome.said}"
        return f"{self.section}.{self.before.name}: {outcomes}\n  {self.before.text}\n  {self.after.text}"


@dataclass(frozen=True)
class Comparison:
    """All that differs between two editions."""

    releases: tuple[str, str]
    faults: list[Fault]
    """What can't be trusted, so that no more can be said of it."""
    flips: list[Flip]
    moves: list[Move]
    notes: list[str]
    """What could not be compared, and why."""

    @property
    def is_alarm(self) -> bool:
        """Whether somebody has to look at it."""
        return bool(self.faults or self.flips)


def compare(before: Edition, after: Edition) -> Comparison:
    """Compare the results of two editions."""
    sides = before.chapters, after.chapters
    floors = noise_floors(side[NOISE].results.record for side in sides if NOISE in side)
    shared = [section for section in before.chapters if section in after.chapters]
    return Comparison(
        releases=(before.project.release, after.project.release),
        faults=list(dict.fromkeys([*faults_between(before, after), *faults_of(before), *faults_of(after)])),
        flips=flips(*sides),
        moves=[
            move
            for section in shared
            if section != NOISE
            for move in _moves(before.chapters[section], after.chapters[section], floors)
        ],
        notes=[*_unshared(before, after), *_costs_apart(*sides), *_near_claims(*sides)],
    )


def _unshared(*sides: Edition) -> list[str]:
    """Sections that only one has; that the other's are gone is a fault, and is said as one."""
    names = dict.fromkeys(section for side in sides for section in side.chapters)
    return [
        f"{section}: newton {side.project.release} has no results of it"
        for section in names
        for side in sides
        if any(state.section == section and state.kind == "missing" for state in side.left_out)
    ]


def _costs_apart(before: Chapters, after: Chapters) -> list[str]:
    """Where costs are not compared: once for each pair of machines, with the sections."""
    sections: dict[tuple[str, str], list[str]] = {}
    for section in before:
        if section in after and _has_costs(before[section]):
            sides = before[section].results.record, after[section].results.record
            if sides[0].machine_for_speed != sides[1].machine_for_speed:
                machines = sides[0].machine_in_full, sides[1].machine_in_full
                sections.setdefault(machines, []).append(section)
    return [
        f"speed and cost in {', '.join(names)}: measured on {' and on '.join(machines)}"
        for machines, names in sections.items()
    ]


def _has_costs(chapter: Chapter) -> bool:
    return any(map(is_cost, chapter.results.record.units))


def _near_claims(*sides: Chapters) -> list[str]:
    """Claims that are no flips only because one of the releases has them near the noise."""
    near = (
        f"{section}.{claim.name}: near the noise"
        for side in sides
        for section, chapter in side.items()
        for claim in chapter.section.claims
        if claim.outcome.is_near
    )
    return list(dict.fromkeys(near))


def flips(before: Chapters, after: Chapters) -> list[Flip]:
    """Claims that one edition upholds and the other doesn't.

    One that can't be told any more, or can be told now, is among them unless that is for want of a section, or for
    being near the noise. What is of the machine and not of the release, a cost or the noise itself, is left out where
    that differs.
    """
    whole = set(before) == set(after)
    found = []
    for section in before:
        if section in after:
            old, new = ({claim.name: claim for claim in side[section].section.claims} for side in (before, after))
            found += [
                Flip(section, old[name], new[name])
                for name in old
                if name in new and terms_of(section, old[name], before) == terms_of(section, new[name], after)
            ]
    return [flip for flip in found if is_flip(flip.before, flip.after, whole=whole)]


def is_flip(before: Claim, after: Claim, *, whole: bool) -> bool:
    """Whether a claim's outcome changed; ``whole`` says that no section is missing that it may need."""
    outcomes = before.outcome, after.outcome
    if any(outcome.is_near for outcome in outcomes):
        return False
    told = "unknown" not in (outcome.name for outcome in outcomes)
    return before.outcome.name != after.outcome.name and (told or whole)


def _moves(before: Chapter, after: Chapter, floors: Mapping[str, Floor]) -> Iterator[Move]:
    old, new = _rows_by_key(before), _rows_by_key(after)
    records = before.results.record, after.results.record
    ranges = _ranges(records)
    for key in old:
        if key not in new:
            continue
        rows = old[key], new[key]
        if any(_is_split(row) for row in rows):
            continue
        lost = any(_is_lost(row) for row in rows)
        terms = [_terms(record, row) for record, row in zip(records, rows, strict=True)]
        for column in rows[0].columns:
            if (
                column not in rows[1]
                or column in KEYS
                or "chance" in column_of(column).kinds
                or column.endswith((REASON, *EDGES))
            ):
                continue
            cells = rows[0][column], rows[1][column]
            if not all(isinstance(cell, Quantity) for cell in cells):
                if cells[0] != cells[1] and not ("loss" in column_of(column).kinds and all(map(_is_lost, rows))):
                    yield Move(before.name, key, column, *cells, None, False)
                continue
            if lost or (is_cost(column) and terms[0] != terms[1]):
                continue
            values = [cell.value for cell in cells]
            if None in values:
                if values != [None, None]:
                    yield Move(before.name, key, column, *cells, None, False)
                continue
            noise, is_chosen = _noise(column, rows, values, floors, ranges)
            if is_beyond(noise, *values):
                is_near = not is_chosen and not is_beyond(NEAR_NOISE * noise, *values)
                yield Move(before.name, key, column, *cells, noise, is_chosen, is_near)


def _noise(
    column: str, rows: tuple[Row, Row], values: list[float], floors: Mapping[str, Floor], ranges: Mapping[str, float]
) -> tuple[float, bool]:
    """The noise of a value, and whether it is a chosen one."""
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
    """The largest size of each column's numbers."""
    ranges: dict[str, float] = {}
    for record in records:
        for row in record.rows:
            for column in record.units:
                value = row.get(column)
                if isinstance(value, int | float):
                    ranges[column] = max(ranges.get(column, 0.0), abs(value))
    return ranges


def _rows_by_key(chapter: Chapter) -> dict[Key, Row]:
    """Rows by what tells them apart; those that nothing tells apart are left out."""
    keys = [tuple(_plain(row[name]) if name in row else None for name in KEYS) for row in chapter.results.rows]
    counts = Counter(keys)
    return {key: row for key, row in zip(keys, chapter.results.rows, strict=True) if counts[key] == 1}


def _is_lost(row: Row) -> bool:
    """Whether the cube was dropped or the run broke down, which makes its numbers chance."""
    return any("loss" in column_of(name).kinds and bool(row[name]) for name in row.columns)


def _is_split(row: Row) -> bool:
    """Whether repeats of a run end in different classes: at the edge of what holds it is chance which one is worst."""
    return "classes" in row and len(set(row["classes"].split(", "))) > 1


def _terms(record: Record, row: Row) -> tuple:
    return cost_terms(record, {column: _plain(row[column]) for column in row.columns})


def _plain(cell: Any) -> Any:
    return cell.value if isinstance(cell, Quantity) else cell


def _said(cell: Any) -> str:
    if isinstance(cell, Quantity):
        return f"{cell} ({cell.reason})" if cell.value is None else str(cell)
    return {True: "yes", False: "no", None: "none"}.get(cell, str(cell))
