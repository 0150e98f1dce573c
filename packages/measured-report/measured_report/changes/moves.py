"""Moves: values that editions have differently, and whether by more than chance makes of what was measured of both."""

import math
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from measured_report.files.config import config
from measured_report.findings.chapters import Chapter
from measured_report.records.columns import REASON, column_of, is_number, parameters
from measured_report.records.record import Record
from measured_report.values.evidence import EDGES, Cells, is_absolute, is_lost
from measured_report.values.noise import FALSE_SHARE, ROUNDED_SHARE, Estimate, chance_of, t_quantile, welch
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row

NAMED = 4  # chosen: so many claims, and twice as many settings, are named in a line
CHOSEN_SHARE = 0.1  # chosen: the share of a value that counts as noise where none was measured


@dataclass(frozen=True)
class Move:
    """Hold a value of two editions, and how often chance has it as far apart."""

    column: str
    before: Any
    after: Any  # a number, a text, or yes and no, as the other; None where an edition lacks it
    chance: float | None = None  # None for what is no number
    error: float = 0.0  # standard error of the difference, and its degrees of freedom
    freedom: float = math.inf
    least: float = 0.0  # what a difference has to exceed in any case
    is_chosen: bool = False  # set where nobody knows the noise, and a share of the value stands for it
    section: str = ""
    place: Mapping[str, Any] = field(default_factory=dict)
    rows: Sequence[Row] = ()  # its row in both; none where it is of many
    unit: str = "1"
    limit: float = FALSE_SHARE  # the largest chance that counts as none

    @property
    def sides(self) -> list[Any]:
        """Return before and after with their units, as their rows have them."""
        ends = self.before, self.after
        if self.rows:
            return [row[self.column] for row in self.rows]
        return list(ends) if self.chance is None else [Quantity(end, self.unit, "") for end in ends]

    @property
    def name(self) -> str:
        """Name it as VALUE= does."""
        return ".".join(filter(None, (self.section, self.place.get("case", ""), self.column)))

    @property
    def is_setting(self) -> bool:
        """Tell whether it is a default or an option, which is compared exactly."""
        return self.place.get("kind") in config().changes.settings

    @cached_property
    def is_real(self) -> bool:
        """Tell whether the values differ, numbers by more than chance would have it."""
        if self.is_setting or self.chance is None:
            return self.before != self.after
        return self.chance <= self.limit

    @property
    def noise(self) -> float | None:
        """Return the least difference that would count; None for what is no number."""
        if self.chance is None:
            return None
        return self.least + t_quantile(1 - self.limit, self.freedom) * self.error

    @property
    def share(self) -> float | None:
        """Return the change as a share of the older value; None for what is no number."""
        before, after = self.before, self.after
        if None in (self.chance, before, after):
            return None
        return (after - before) / abs(before) if before else math.copysign(math.inf, after) if after else 0.0

    @property
    def sure_share(self) -> float:
        """Return the share of the change that is beyond chance."""
        if not self.share or self.noise is None:
            return 0.0
        return max(0.0, 1 - self.noise / abs(self.after - self.before)) * abs(self.share)

    @property
    def exceeds_threshold(self) -> bool:
        """Tell whether a setting, or a number that report.toml names, moved by more than its threshold, or is lost."""
        rules, run = config().changes, self.name.rpartition(".")[0]
        if "loss" in column_of(self.column).kinds:
            return self.is_real and any(name.rpartition(".")[0] == run for name in rules.thresholds)
        threshold = rules.setting_threshold if self.is_setting else rules.thresholds.get(self.name)
        if threshold is None or self.share is None:
            return threshold is not None and self.is_gone
        return self.is_real and abs(self.share) > threshold

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
        """Say ``better``, ``worse`` or ``moved`` where it is more than chance."""
        return (self.direction or "moved") if self.is_real else ""

    @property
    def ends(self) -> str:
        """Write before and after; of numbers as many digits as tell them apart."""
        ends = self.before, self.after
        if self.is_setting:
            return " → ".join("none" if value is None else f"{value:.7g}" for value in ends)
        sides = self.sides
        if self.chance is not None and not column_of(self.column).is_exact:  # each by what is known of both
            noise = max(self.error, min(filter(None, map(abs, (*ends, self.after - self.before))), default=0.0) / 10)
            sides = [replace(side, value=value, noise=noise) for side, value in zip(sides, ends, strict=True)]
        return " → ".join(map(_text, sides))


def cells_between(before: Chapter, after: Chapter) -> Iterator[Move]:
    """Yield the values of a section that compare between two editions, moved or not, and settings that one lacks."""
    records = before.results.record, after.results.record
    edges = before.results.evidence.edges | after.results.evidence.edges
    rules, old, new = config().changes, _rows_by_key(before), _rows_by_key(after)
    means = {move.name: move for move in _means_between(before, after)}
    yield from means.values()
    for key in dict.fromkeys((*old, *new)):
        place, a, b = dict(key), old.get(key), new.get(key)
        if a is None or b is None:
            if place.get("kind") in rules.settings:
                values = a and a.plain["value"], b and b.plain["value"]
                yield Move("value", *values, section=before.name, place=place)
        # Where repeats of a run end in different classes it is chance which one the row is about.
        elif a.key not in edges and not any(
            len(set(row.plain[rules.classes].split(", "))) > 1 for row in (a, b) if rules.classes in row
        ):
            for column in _comparable((a.plain, b.plain), records):
                move = _move(column, (a, b), before.name, place)
                if move and move.name not in means:
                    yield move


def _move(column: str, rows: tuple[Row, Row], section: str, place: Mapping[str, Any]) -> Move | None:
    """Compare a cell of two rows; None for absolute times of two cards where nobody knows how far cards are apart."""
    before, after = (row.plain[column] for row in rows)
    if not (is_number(before) and is_number(after)):
        return Move(column, before, after, section=section, place=place, rows=rows)
    estimates = [row.estimate(column) for row in rows]
    if is_absolute(column):
        if _are_apart(column, {row.card for row in rows}, estimates):
            return None
        estimates = [each and (each if each.is_again else _of_process(each)) for each in estimates]
    edge_share = max(row.evidence.edge_share for row in rows)
    move = Move(column, before, after, edge_share, section=section, place=place, rows=rows)
    return judged(move, estimates)


def _are_apart(column: str, cards: Collection[str], estimates: Sequence[Estimate | None]) -> bool:
    """Tell whether these are absolute times of two cards, and nobody knows how far cards of one kind are apart."""
    return is_absolute(column) and len(cards) > 1 and not any(each and each.is_of_cards for each in estimates)


def _of_process(time: Estimate) -> Estimate:
    """Return a time of one process, of which nobody knows how far another of the same card would be."""
    return replace(time, count=1.0, least=CHOSEN_SHARE * abs(time.value))


def _means_between(before: Chapter, after: Chapter) -> Iterator[Move]:
    """Yield the means of what the section on noise has many runs of, by case and column."""
    if before.name != config().noise_section:
        return
    old, new = (chapter.results.evidence.means() for chapter in (before, after))
    for case, column in (key for key in old if key in new):
        pair, unit = (old[case, column], new[case, column]), before.results.record.units[column]
        if _are_apart(column, {chapter.results.record.card for chapter in (before, after)}, pair):
            continue
        yield judged(Move(column, 0.0, 0.0, section=before.name, place={"case": case}, unit=unit), pair)


def judged(move: Move, estimates: Sequence[Estimate | None]) -> Move:
    """Say how often chance makes such a move, by what is known of both sides, and no less often than the move says.

    What was measured again tells of a number that was measured once how far its own other measurements would be, and
    what is known of one side alone stands for both.
    """
    values = [each.value if each else end for each, end in zip(estimates, (move.before, move.after), strict=True)]
    size, teacher = max(map(abs, values)), max(filter(None, estimates), key=lambda each: each.is_again, default=None)
    least, error, freedom = max(column_of(move.column).resolution, CHOSEN_SHARE * size), 0.0, math.inf
    if teacher:
        least = max(column_of(move.column).resolution, ROUNDED_SHARE * size, teacher.least)
        taught = Estimate(teacher.value, teacher.variance, teacher.freedom)
        error, freedom = welch(*(each if each and each.is_again >= teacher.is_again else taught for each in estimates))
    chance = max(chance_of(max(0.0, abs(values[1] - values[0]) - least), error, freedom), move.chance or 0.0)
    known = {"error": error, "freedom": freedom, "least": least, "is_chosen": not teacher}
    return replace(move, before=values[0], after=values[1], chance=chance, **known)


def cost_terms(record: Record, row: Mapping[str, Any]) -> tuple:
    """Return what two costs must share to be compared: the machine, and how many frames and worlds."""
    return record.machine_for_speed, *(row.get(column) for column in config().cost_terms)


def _unlike(a: Mapping[str, Any], b: Mapping[str, Any]) -> list[frozenset[str]]:
    """Return the kinds of columns in which two runs were not set alike."""
    names = (name for name in a if None not in (a[name], b.get(name)) and a[name] != b[name])
    return [kinds for name in names if "setting" in (kinds := column_of(name).kinds) or name in parameters()]


def _comparable(cells: tuple[Cells, Cells], records: Sequence[Record]) -> Iterator[str]:
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


def few(names: Sequence[str], count: int = NAMED) -> str:
    """Name no more than so many, and say how many more there are."""
    more = f"; and {len(names) - count} more" if len(names) > count else ""
    return "; ".join(names[:count]) + more


def _rows_by_key(chapter: Chapter) -> dict[tuple[tuple[str, Any], ...], Row]:
    """Return rows by what tells them apart; those that nothing does are left out, and repeats, which are the noise."""
    names = config().changes.keys
    rows = [row for row in chapter.results.rows if not (chapter.name == config().noise_section and "of" in row)]
    keys = [tuple((name, row.plain[name]) for name in names if row.plain.get(name) is not None) for row in rows]
    counts = Counter(keys)
    return {key: row for key, row in zip(keys, rows, strict=True) if counts[key] == 1}


def _text(cell: Any) -> str:
    if isinstance(cell, Quantity):
        return f"{cell} ({cell.reason})" if cell.value is None else str(cell)
    return {True: "yes", False: "no", None: "none"}.get(cell, str(cell))
