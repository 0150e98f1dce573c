"""Moves: values that editions have differently, and whether by more than runs of one edition differ."""

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from measured_report.files.config import config
from measured_report.pages.editions import Chapter
from measured_report.parts.claim import NEAR_NOISE
from measured_report.records.columns import REASON, column_of, is_number, parameters
from measured_report.records.record import Record
from measured_report.values.noise import EDGES, NOISE, PAIRS, Floor, cell_noise, is_beyond, is_lost
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row
from measured_report.values.scatter import Apart, chance_of, key_of

NAMED = 4
"""Chosen: so many claims, and twice as many settings, are named in a line."""
CHOSEN_SHARE = 0.1
"""Chosen: the share of a value that counts as noise where none was measured."""
Cells = tuple[Mapping[str, Any], Mapping[str, Any]]


@dataclass(frozen=True)
class Move:
    """Hold a value of two editions, and how far apart runs of one edition come out."""

    column: str
    before: Any
    after: Any
    """A number, a text, or yes and no, as the other; None where an edition lacks it."""
    noise: float | None = None
    """None for what is no number."""
    is_chosen: bool = False
    section: str = ""
    place: Mapping[str, Any] = field(default_factory=dict)
    chance: float | None = None
    """How often measurements of one edition come out as far apart; None where there are no replicas."""
    rows: tuple[Row, ...] = ()
    """Its row in both."""
    limit: float = 1 - PAIRS

    @property
    def sides(self) -> list[Any]:
        """Return before and after as their rows have them, numbers with units."""
        return [row[self.column] for row in self.rows] or [self.before, self.after]

    @property
    def name(self) -> str:
        """Name it as VALUE= does."""
        return ".".join(filter(None, (self.section, self.place.get("case", ""), self.column)))

    @property
    def is_setting(self) -> bool:
        """Tell whether it is a default or an option, which is compared exactly."""
        return self.place.get("kind") in config().changes.settings

    @property
    def least(self) -> float:
        """Return what a difference has to exceed: the noise, or what the column resolves."""
        return max(self.noise or 0.0, column_of(self.column).resolution)

    def is_beyond(self, times: float) -> bool:
        """Tell whether the values differ; numbers by more than so many times the noise, and than rounding."""
        before, after = self.before, self.after
        if self.chance is not None and self.chance > self.limit:
            return False
        if self.is_setting or None in (self.noise, before, after):
            return before != after
        return is_beyond(times * self.least, before, after)

    @property
    def is_real(self) -> bool:
        return self.is_beyond(1.0)

    @property
    def is_inconclusive(self) -> bool:
        """Tell whether another measurement of the same may differ as much: by less than NEAR_NOISE times its noise."""
        return self.is_real and not self.is_chosen and not self.is_beyond(NEAR_NOISE)

    @property
    def share(self) -> float | None:
        """Return the change as a share of the older value; None for what is no number."""
        before, after = self.before, self.after
        if None in (self.noise, before, after):
            return None
        return (after - before) / abs(before) if before else math.copysign(math.inf, after) if after else 0.0

    @property
    def exceeds_threshold(self) -> bool:
        """Tell whether a setting, or a number that report.toml names, moved by more than its threshold, or is lost."""
        rules, run = config().changes, self.name.rpartition(".")[0]
        if "loss" in column_of(self.column).kinds:
            return any(name.rpartition(".")[0] == run for name in rules.thresholds)
        threshold = rules.setting_threshold if self.is_setting else rules.thresholds.get(self.name)
        if threshold is None or self.share is None:
            return threshold is not None and self.is_gone
        return abs(self.share) > threshold and self.is_beyond(NEAR_NOISE)

    @property
    def is_gone(self) -> bool:
        """Tell whether it is a number that was asked for in both editions and is there in one."""
        is_one = (self.before is None) != (self.after is None)
        return is_one and all(isinstance(side, Quantity) for side in self.sides)

    @property
    def direction(self) -> str:
        """Say ``better`` or ``worse``, where one can."""
        better = column_of(self.column).better
        if None in (self.before, self.after) or not better:
            return ""
        return "better" if (abs(self.after) > abs(self.before)) == (better == "more") else "worse"

    @property
    def mark(self) -> str:
        """Say ``better``, ``worse`` or ``moved`` where it is clearly more than the noise."""
        return (self.direction or "moved") if self.is_real and not self.is_inconclusive else ""

    @property
    def ends(self) -> str:
        """Write before and after; of a setting as many digits as tell them apart."""
        if self.is_setting:
            return " → ".join("none" if value is None else f"{value:.7g}" for value in (self.before, self.after))
        return " → ".join(map(_said, self.sides))


def cells_between(before: Chapter, after: Chapter) -> Iterator[Move]:
    """Yield the values of a section that compare between two editions, moved or not, and settings that one lacks."""
    floors = [one.results.floors or other.results.floors for one, other in ((before, after), (after, before))]
    measured = [chapter.results.apart for chapter in (before, after)]
    edge = measured[0].edge | measured[1].edge
    rules, records = config().changes, (before.results.record, after.results.record)
    old, new = _rows_by_key(before), _rows_by_key(after)
    for key in dict.fromkeys((*old, *new)):
        place, a, b = dict(key), old.get(key), new.get(key)
        if a is None or b is None:
            if place.get("kind") in rules.settings:
                values = a and a.plain["value"], b and b.plain["value"]
                yield Move("value", *values, section=before.name, place=place)
        # Where repeats of a run end in different classes it is chance which one the row is about.
        elif key_of(a.plain) not in edge and not any(
            len(set(row.plain[rules.classes].split(", "))) > 1 for row in (a, b) if rules.classes in row
        ):
            cells = a.plain, b.plain
            for column in _comparable(cells, records):
                noise, is_chosen, seen = _doubt(column, cells, floors, measured)
                values = a.plain[column], b.plain[column]
                yield Move(column, *values, noise, is_chosen, before.name, place, seen, (a, b))


def _doubt(
    column: str, cells: Cells, floors: Sequence[Mapping[str, Floor]], measured: Sequence[Apart]
) -> tuple[float | None, bool, float | None]:
    """Return the noise of a number, whether it is a chosen one, and how often chance has it as far apart."""
    if not all(is_number(cell[column]) for cell in cells):
        return None, False, None
    noise, is_chosen = _noise(column, cells, floors)
    told = [(each.of(column, cell), cell) for each, cell in zip(measured, cells, strict=True)]
    known = [(scatter, cell) for scatter, cell in told if scatter]
    noises = [scatter.noise(key_of(cell), cell[column]) for scatter, cell in known]
    if not any(noises):
        return noise, is_chosen, None
    noise, freedom = max(*noises, 0.0 if is_chosen else noise), min(scatter.all_freedom for scatter, _ in known)
    return noise, False, chance_of(abs(cells[0][column] - cells[1][column]) / noise, freedom)


def cost_terms(record: Record, row: Mapping[str, Any]) -> tuple:
    """Return what two costs must share to be compared: the machine, and how many frames and worlds."""
    return record.machine_for_speed, *(row.get(column) for column in config().cost_terms)


def _unlike(a: Mapping[str, Any], b: Mapping[str, Any]) -> list[frozenset[str]]:
    """Return the kinds of columns in which two runs were not set alike."""
    names = (name for name in a if None not in (a[name], b.get(name)) and a[name] != b[name])
    return [kinds for name in names if "setting" in (kinds := column_of(name).kinds) or name in parameters()]


def _comparable(cells: Cells, records: Sequence[Record]) -> Iterator[str]:
    has_same_terms = len(set(map(cost_terms, records, cells))) == 1
    lost, unlike = [is_lost(cell) for cell in cells], _unlike(*cells)
    for column in (name for name in cells[0] if name in cells[1] and name not in config().changes.keys):
        about = column_of(column)
        if "chance" in about.kinds or column.endswith((REASON, *EDGES)):
            continue
        if any(isinstance(cell[column], str | bool) for cell in cells):
            is_so = not (all(lost) and "loss" in about.kinds)
        elif any(lost) or ("cost" in about.kinds and not has_same_terms):
            is_so = False
        else:  # of runs that were not set alike nothing, and of those that ran for longer or shorter rates alone
            is_rate = about.unit.endswith(("/s", "/cycle"))
            is_so = not unlike or about.is_setting or (is_rate and all("setting" in kinds for kinds in unlike))
        if is_so:
            yield column


def _noise(column: str, cells: Cells, floors: Sequence[Mapping[str, Floor]]) -> tuple[float, bool]:
    """Return the noise of a number, which is the larger of both editions', and whether it is a chosen one."""
    edges = [column + edge for edge in EDGES]
    chosen = CHOSEN_SHARE * max(abs(cell[column]) for cell in cells)
    if all(cell.get(edge) is not None for edge in edges for cell in cells):
        measured = max(cell[edges[1]] - cell[edges[0]] for cell in cells)
        # Of two machines of one kind one may be faster, and nothing in a record tells one from the other.
        return (chosen, True) if chosen > NEAR_NOISE * measured else (measured, False)
    found = [cell_noise(column, cell, each) for cell, each in zip(cells, floors, strict=True)]
    known = [noise for noise in found if noise is not None]
    is_cost = "cost" in column_of(column).kinds and any(known)  # what was counted is exact
    return (chosen, True) if known != found or is_cost else (max(known), False)


def few(names: Sequence[str], count: int = NAMED) -> str:
    """Name no more than so many, and say how many more there are."""
    more = f"; and {len(names) - count} more" if len(names) > count else ""
    return "; ".join(names[:count]) + more


def _rows_by_key(chapter: Chapter) -> dict[tuple[tuple[str, Any], ...], Row]:
    """Return rows by what tells them apart; those that nothing does are left out, and repeats, which are the noise."""
    names = config().changes.keys
    rows = [row for row in chapter.results.rows if not (chapter.name == NOISE and "of" in row)]
    keys = [tuple((name, row.plain[name]) for name in names if row.plain.get(name) is not None) for row in rows]
    counts = Counter(keys)
    return {key: row for key, row in zip(keys, rows, strict=True) if counts[key] == 1}


def _said(cell: Any) -> str:
    if isinstance(cell, Quantity):
        return f"{cell} ({cell.reason})" if cell.value is None else str(cell)
    return {True: "yes", False: "no", None: "none"}.get(cell, str(cell))
