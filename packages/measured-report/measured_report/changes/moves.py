"""Moves: numbers and texts that two editions have, and which differ beyond the noise."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

from measured_report.files.columns import REASON, Column, Schema, is_number
from measured_report.files.groups import single
from measured_report.files.settings import Changes
from measured_report.findings.chapters import Chapter
from measured_report.records.record import Record
from measured_report.values.evidence import (
    EDGES,
    Cells,
    Key,
    is_absolute,
    is_lost,
    key_of,
)
from measured_report.values.noise import (
    FALSE_SHARE,
    ROUNDED_SHARE,
    Estimate,
    chance_of,
    t_quantile,
    welch,
)
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row

NAMED = 4  # chosen: so many claims, and twice as many settings, are named in a line
CHOSEN_SHARE = 0.1  # chosen: the noise of a value, as a share, where none was measured


@dataclass(frozen=True)
class Move:
    """Holds a value of two editions, and how often chance makes it differ as much."""

    column: Column
    before: Any
    after: Any  # a number, a text, yes or no; None if an edition lacks it
    chance: float | None = None  # None for what is not a number
    error: float = 0.0  # standard error of the difference, and its degrees of freedom
    freedom: float = math.inf
    least: float = 0.0  # what a difference has to exceed in any case
    is_chosen: bool = False  # whether a share of the value stands for an unknown noise
    section: str = ""
    place: Mapping[str, Any] = field(default_factory=dict)  # the key of its row
    rows: Sequence[Row] = ()  # its row in both; none if it is the mean of many
    rules: Changes = field(default_factory=Changes, repr=False)
    limit: float = FALSE_SHARE  # the largest chance that counts as none

    @property
    def sides(self) -> list[Any]:
        """Return before and after with their units, as their rows have them."""
        if self.rows:
            return [row[self.column.name] for row in self.rows]
        ends = [self.before, self.after]
        if self.chance is None:
            return ends
        return [Quantity(end, self.column.unit, "") for end in ends]

    @property
    def name(self) -> str:
        """Return the name that VALUE= takes."""
        names = self.section, self.place.get("case"), self.column.name
        return ".".join(filter(None, names))

    @property
    def is_setting(self) -> bool:
        """Return whether it is a default or an option, which is compared exactly."""
        return self.place.get("kind") in self.rules.settings

    @property
    def is_real(self) -> bool:
        """Return whether the values differ, numbers beyond the noise."""
        if self.is_setting or self.chance is None:
            return bool(self.before != self.after)
        return self.chance <= self.limit

    @property
    def noise(self) -> float | None:
        """Return the least difference that would count; None for what is not a number."""
        if self.chance is None:
            return None
        return self.least + t_quantile(1 - self.limit, self.freedom) * self.error

    @property
    def share(self) -> float | None:
        """Return the change as a share of the older value; None without two numbers."""
        if None in (self.chance, self.before, self.after):
            return None
        if self.before:
            return (self.after - self.before) / abs(self.before)
        return math.copysign(math.inf, self.after) if self.after else 0.0

    @property
    def sure_share(self) -> float:
        """Return the share of the change that is beyond chance."""
        if not self.share or self.noise is None:
            return 0.0
        certainty = max(0.0, 1 - self.noise / abs(self.after - self.before))
        return certainty * abs(self.share)

    @property
    def exceeds_threshold(self) -> bool:
        """Return whether a setting, or a number that report.toml names, moved by more
        than its threshold, or is lost."""
        named = self.rules.thresholds
        if "failure" in self.column.kinds:
            run = self.name.rpartition(".")[0]
            return self.is_real and any(
                name.rpartition(".")[0] == run for name in named
            )
        threshold = named.get(self.name)
        if self.is_setting:
            threshold = self.rules.setting_threshold
        if threshold is None or self.share is None:
            return threshold is not None and self.is_gone
        return self.is_real and abs(self.share) > threshold

    @property
    def is_gone(self) -> bool:
        """Return whether only one edition has the number, which both measured."""
        is_one_sided = (self.before is None) != (self.after is None)
        return is_one_sided and all(isinstance(side, Quantity) for side in self.sides)

    @property
    def direction(self) -> str:
        """Return ``better`` or ``worse``, or nothing if neither can be said."""
        return direction(self.column, self.before, self.after)

    @property
    def ends(self) -> str:
        """Return before and after in words, with enough digits to tell them apart."""
        ends = self.before, self.after
        if self.is_setting:
            return " → ".join("none" if end is None else f"{end:.7g}" for end in ends)
        sides = self.sides
        if self.chance is not None and not self.column.is_exact:
            sizes = [abs(number) for number in (*ends, self.after - self.before)]
            noise = max(self.error, min(filter(None, sizes), default=0.0) / 10)
            pairs = zip(sides, ends, strict=True)
            sides = [replace(side, value=end, noise=noise) for side, end in pairs]
        return " → ".join(map(_text, sides))


def direction(column: Column, before: Any, after: Any) -> str:
    """Return ``better`` or ``worse``, or nothing if neither can be said."""
    if None in (before, after) or not column.better:
        return ""
    is_more = abs(after) > abs(before)
    return "better" if is_more == (column.better == "more") else "worse"


def few(names: Sequence[str], count: int = NAMED) -> str:
    """Return at most so many names in words, and how many more there are."""
    more = f"; and {len(names) - count} more" if len(names) > count else ""
    return "; ".join(names[:count]) + more


def _text(cell: Any) -> str:
    if isinstance(cell, Quantity):
        return f"{cell} ({cell.reason})" if cell.value is None else str(cell)
    return {True: "yes", False: "no", None: "none"}.get(cell, str(cell))


Estimates = Sequence[Estimate | None]  # of a number in both editions; None: unknown
Pair = tuple[Move, Estimates, float]
"""A number that is not judged yet, its estimates, and the least chance that it has."""


def moves_between(before: Chapter, after: Chapter) -> list[Move]:
    """Return the values of a section that compare between two editions, moved or not,
    and the settings that only one of them has."""
    sides = before.results, after.results
    columns = after.results.columns
    rules = columns.settings.changes
    edges = sides[0].evidence.edges | sides[1].evidence.edges
    edge_share = max(side.evidence.edge_share for side in sides)
    is_other_card = sides[0].record.card != sides[1].record.card
    pairs = list(_means_between(sides, is_other_card))
    means = {(move.place["case"], move.column) for move, *_ in pairs}
    old, new = map(_rows_by_key, sides)
    moves = []
    for key in dict.fromkeys((*old, *new)):
        cells = zip(rules.keys, key, strict=True)
        place = {name: cell for name, cell in cells if cell is not None}
        move_of = partial(Move, section=before.name, place=place, rules=rules)
        if key not in old or key not in new:
            a, b = ((side[key].plain if key in side else {}) for side in (old, new))
            if place.get("kind") in rules.settings:
                moves.append(move_of(columns["value"], a.get("value"), b.get("value")))
            continue
        rows = old[key], new[key]
        # If repeats of a run ended in different classes, it is chance which one counts.
        endings = [row.plain[rules.endings] for row in rows if rules.endings in row]
        is_mixed = any(len(set(classes.split(", "))) > 1 for classes in endings)
        if is_mixed or key in edges:
            continue
        for column in _comparable([row.plain for row in rows], sides):
            ends = [row.plain[column.name] for row in rows]
            move = move_of(column, *ends, rows=rows)
            if not all(map(is_number, ends)):
                moves.append(move)
            elif (place["case"], column) not in means:
                estimates = [row.estimate(column.name) for row in rows]
                if is_absolute(column):
                    if is_other_card and not _knows_cards(estimates):
                        continue
                    # How far a time of another process would be is not known.
                    estimates = [
                        time._replace(count=1.0, least=CHOSEN_SHARE * abs(time.value))
                        if time and not time.is_again
                        else time
                        for time in estimates
                    ]
                pairs.append((move, estimates, edge_share))
    return [*judged(pairs), *moves]


def _rows_by_key(results: Results) -> dict[Key, Row]:
    """Return rows by key, without rows that share one, and on noise without the runs,
    which are compared by their means."""
    is_noise = results.record.section == results.columns.settings.noise_section
    rows = [row for row in results.rows if not (is_noise and "of" in row)]
    return single((key_of(row.plain, results.columns), row) for row in rows)


def _knows_cards(estimates: Estimates) -> bool:
    """Return whether it is known how far absolute times of two cards are apart."""
    return any(estimate and estimate.is_of_cards for estimate in estimates)


def _means_between(sides: Sequence[Results], is_other_card: bool) -> Iterator[Pair]:
    """Yield the means of runs of one case, of the section on noise."""
    columns = sides[1].columns
    rules = columns.settings.changes
    section = sides[1].record.section
    if section != columns.settings.noise_section:
        return
    old, new = (side.evidence.means() for side in sides)
    for case, name in (key for key in old if key in new):
        means = old[case, name], new[case, name]
        if not (is_absolute(columns[name]) and is_other_card) or _knows_cards(means):
            of_case = partial(Move, section=section, place={"case": case}, rules=rules)
            yield of_case(columns[name], means[0].value, means[1].value), means, 0.0


def cost_terms(record: Record, row: Cells, columns: Schema) -> tuple[Any, ...]:
    """Return what two costs must share to be compared: the machine and the amount of work."""
    work = [row.get(name) for name in columns.settings.cost_terms]
    return record.machine_for_speed, *work


def _comparable(rows: Sequence[Cells], sides: Sequence[Results]) -> Iterator[Column]:
    """Yield the columns whose cells in two rows can be compared."""
    a, b = rows
    columns = sides[1].columns
    lost = [is_lost(row, columns) for row in rows]
    terms = [
        cost_terms(side.record, row, columns)
        for side, row in zip(sides, rows, strict=True)
    ]
    changed = [
        columns[name]
        for name in a
        if None not in (a[name], b.get(name)) and a[name] != b[name]
        if "setting" in columns[name].kinds or name in columns.parameters
    ]
    is_longer = all("setting" in column.kinds for column in changed)
    ignored = (*columns.settings.changes.keys, "")
    for name in a:
        column = columns[name]
        if name not in b or name in ignored or name.endswith((REASON, *EDGES)):
            continue
        if "uncompared" in column.kinds:
            continue
        if isinstance(a[name], str | bool) or isinstance(b[name], str | bool):
            if not all(lost) or "failure" not in column.kinds:
                yield column
        elif any(lost) or (column.is_cost and terms[0] != terms[1]):
            continue
        elif not changed or column.is_setting:
            yield column
        elif is_longer and column.unit.endswith(("/s", "/cycle")):
            yield column  # a rate, of runs that only took longer or shorter


def judged(pairs: Sequence[Pair]) -> list[Move]:
    """Return numbers with the chance that they differ as much by noise alone."""
    import numpy as np  # most commands that import this module judge no move

    if not pairs:
        return []
    known = [_known(move, estimates) for move, estimates, _ in pairs]
    values = np.array([[side.value for side in sides] for sides, *_ in known])
    variances = [[side.variance / side.count for side in sides] for sides, *_ in known]
    freedoms = [[side.freedom for side in sides] for sides, *_ in known]
    errors, freedoms = welch(np.array(variances), np.array(freedoms))
    leasts = np.array([least for _, least, _ in known])
    distances = np.maximum(0.0, abs(np.diff(values)[:, 0]) - leasts)
    chances = chance_of(distances, errors, freedoms)
    moves = []
    difference = zip(chances, errors.tolist(), freedoms.tolist(), strict=True)
    for index, (chance, error, freedom) in enumerate(difference):
        move, _, least_chance = pairs[index]
        (before, after), least, is_chosen = known[index]
        judged_move = replace(
            move,
            before=before.value,
            after=after.value,
            chance=max(chance, least_chance),
            error=error,
            freedom=freedom,
            least=least,
            is_chosen=is_chosen,
        )
        moves.append(judged_move)
    return moves


def _known(move: Move, estimates: Estimates) -> tuple[list[Estimate], float, bool]:
    """Return the estimates of both sides, the least difference that counts, and whether
    that is chosen because no noise is known.

    If only one side was measured several times, its scatter counts for the other side.
    A noise that is known of one side only counts for both.
    """
    ends = move.before, move.after
    bare = [each or Estimate(end) for each, end in zip(estimates, ends, strict=True)]
    size = max(abs(each.value) for each in bare)
    resolution = move.column.resolution
    if not any(estimates):
        return bare, max(resolution, CHOSEN_SHARE * size), True
    teacher = max(filter(None, estimates), key=lambda each: each.is_again)
    sides = []
    for side, each in zip(bare, estimates, strict=True):
        if each is None or each.is_again < teacher.is_again:
            side = Estimate(side.value, teacher.variance, teacher.freedom)
        sides.append(side)
    return sides, max(resolution, ROUNDED_SHARE * size, teacher.least), False
