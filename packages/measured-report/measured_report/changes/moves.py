"""Compare pairs of values of two editions, and test whether they differ."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from statistics import median
from typing import Any

from measured_report.files.columns import REASON, Column, Schema, is_number
from measured_report.files.groups import grouped, single
from measured_report.files.settings import Changes
from measured_report.findings.chapters import Chapter
from measured_report.records.record import Record
from measured_report.values.evidence import (
    EDGES,
    MEDIAN,
    Cells,
    RowKey,
    is_absolute,
    is_lost,
    key_of,
    split_repeats,
)
from measured_report.values.noise import (
    FALSE_SHARE,
    ROUNDED_SHARE,
    TO_DEVIATION,
    Estimate,
    chance_of,
    discoveries,
    exceeds_chance,
    exceeds_share,
    t_quantile,
)
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row

NAMED = 4  # chosen: the largest number of claims in a line; twice as many settings fit
CHOSEN_SHARE = 0.1  # chosen: the relative noise of a number whose noise is not known
SUSPICIOUS_FACTOR = 100.0  # chosen: a real improvement is seldom as large
NEAR_ZERO = 0.01
"""Chosen: a number below this share of the median of its column is close to zero."""
ODD_SHARE = 0.4
"""Chosen: at most this share of the rows of a section may differ by chance if no row
was measured twice, because a single run can end in either of two ways.
"""
LEAST_SWEEP = 6
"""Chosen: in a section with fewer rows, each row that changed counts as a change."""
COST_SHARE = 1e-3
"""Chosen: a smaller relative difference of costs does not count, because clocks are not
more precise and times are rounded."""
LEAST_SHIFTED = 3  # chosen: fewer times do not show a common shift


@dataclass(frozen=True)
class Move:
    """A value of two editions, and the probability that it differs by chance."""

    column: Column
    before: Any  # a number, a text or a flag; None if the edition lacks it
    after: Any
    chance: float | None = None  # the probability; None for a text or a flag
    error: float = 0.0  # standard error of the difference
    freedom: float = math.inf  # degrees of freedom of that error
    least: float = 0.0  # a difference below this does not count
    is_chosen: bool = False  # whether CHOSEN_SHARE is used because the noise is unknown
    section: str = ""
    place: Mapping[str, Any] = field(default_factory=dict)  # the key of its row
    rows: Sequence[Row] = ()  # its row in both editions; empty for a mean or a median
    rules: Changes = field(default_factory=Changes, repr=False)
    limit: float = FALSE_SHARE  # the largest probability that counts as a change
    scale: float = 0.0  # a number below this size is close to zero
    is_single: bool = False  # whether one edition has measured it only once
    is_odd: bool = False  # whether it may be due to a run that ended oddly by chance
    row_count: int = 1  # the number of rows that this change has in common

    @property
    def sides(self) -> list[Any]:
        """Return both values, as quantities if they are numbers."""
        if self.rows:
            return [row[self.column.name] for row in self.rows]
        ends = [self.before, self.after]
        if self.chance is None:
            return ends
        return [Quantity(end, self.column.unit, "") for end in ends]

    @property
    def name(self) -> str:
        """Return the name of the value, as the option VALUE= takes it."""
        names = self.section, self.place.get("case"), self.column.name
        return ".".join(filter(None, names))

    @property
    def is_setting(self) -> bool:
        """Return whether it is a default or an option, which is compared exactly."""
        return self.place.get("kind") in self.rules.settings

    @property
    def is_real(self) -> bool:
        """Return whether the value changed; a number must change beyond its noise."""
        if self.is_odd:
            return False
        if self.is_setting or self.chance is None:
            return bool(self.before != self.after)
        return self.chance <= self.limit

    @property
    def may_be_odd(self) -> bool:
        """Return whether a single run that ended differently by chance might explain
        it.
        """
        return self.is_single and bool(self.rows) and not self.is_setting

    @property
    def noise(self) -> float | None:
        """Return the smallest difference that counts as a change, or None without numbers."""
        if self.chance is None:
            return None
        return self.least + t_quantile(1 - self.limit, self.freedom) * self.error

    @property
    def share(self) -> float | None:
        """Return the change as a share of the older value, or None without two numbers."""
        if None in (self.chance, self.before, self.after):
            return None
        difference: float = self.after - self.before
        if size := max(abs(self.before), self.scale):
            return difference / size
        return math.copysign(math.inf, difference) if difference else 0.0

    @property
    def is_named(self) -> bool:
        """Return whether ``report.toml`` has a threshold or a headline for it.

        For the outcome of a run, return whether it has one for any number of the run.
        """
        names = self.rules.named
        if "failure" in self.column.kinds:
            run = self.name.rpartition(".")[0]
            return any(name.rpartition(".")[0] == run for name in names)
        return self.name in names

    @property
    def threshold(self) -> float:
        """Return the largest relative change that does not raise an alarm."""
        if self.is_setting:
            return self.rules.setting_threshold
        default = self.rules.threshold
        if self.column.is_cost:
            default = self.rules.cost_threshold
        return self.rules.thresholds.get(self.name, default)

    @property
    def is_alarm(self) -> bool:
        """Return whether the change raises an alarm.

        It is large, and not better. A number that became better by an implausible
        factor, or that changed its sign, raises one too.
        """
        is_good = self.direction == "better" and not self.is_suspicious
        return self.exceeds_threshold and not is_good

    @property
    def is_suspicious(self) -> bool:
        """Return whether the change may show a fault of the measurement.

        The number changed its sign, or by more than ``SUSPICIOUS_FACTOR``.
        """
        if not isinstance(self.after, float):
            return False  # a flag, a text or a count
        smaller, larger = sorted(map(abs, (self.before, self.after)))
        return self.before * self.after < 0 or larger > SUSPICIOUS_FACTOR * smaller

    @property
    def relevance(self) -> float:
        """Return the change divided by its threshold; a change of 1 or more is large.

        It is infinite if a run newly fails or no longer fails, and if a setting or a
        named number exists in only one of the editions.
        """
        if "failure" in self.column.kinds:
            return math.inf
        if self.share is None:
            is_missed = self.is_gone and (self.is_setting or self.is_named)
            return math.inf if is_missed else 0.0
        return abs(self.share) / self.threshold

    @property
    def exceeds_threshold(self) -> bool:
        """Return whether the change is large."""
        # A change of exactly the threshold counts, even if it is rounded down.
        return self.is_real and self.relevance >= 1 - 1e-6

    @property
    def is_gone(self) -> bool:
        """Return whether both editions measured the number, and only one has a result."""
        is_one_sided = (self.before is None) != (self.after is None)
        return is_one_sided and all(isinstance(side, Quantity) for side in self.sides)

    @property
    def direction(self) -> str:
        """Return ``better`` or ``worse``, or an empty string if neither applies."""
        return direction(self.column, self.before, self.after)

    @property
    def ends(self) -> str:
        """Return the text "before → after", with enough digits to show the change."""
        return " → ".join(self._texts)

    @property
    def cells(self) -> list[Any]:
        """Return both values for a table, numbers with their interval."""
        pairs = zip(self.sides, self._texts, strict=True)
        return [
            side.interval if getattr(side, "source", "") else text
            for side, text in pairs
        ]

    @property
    def _texts(self) -> list[str]:
        ends = self.before, self.after
        if self.is_setting:
            return ["none" if end is None else f"{end:.7g}" for end in ends]
        sides = self.sides
        if self.chance is not None and not self.column.is_exact:
            sizes = [abs(number) for number in (*ends, self.after - self.before)]
            noise = max(self.error, min(filter(None, sizes), default=0.0) / 10)
            pairs = zip(sides, ends, strict=True)
            # The noise of a large number would hide all digits of a small one.
            sides = [
                replace(side, value=end, noise=min(noise, abs(end) / 2 or noise))
                for side, end in pairs
            ]
        return [*map(_text, sides)]


def direction(column: Column, before: Any, after: Any) -> str:
    """Return ``better`` or ``worse``, or an empty string if neither applies."""
    if None in (before, after) or not column.better:
        return ""
    is_more = abs(after) > abs(before)
    return "better" if is_more == (column.better == "more") else "worse"


def few(names: Sequence[str], count: int = NAMED) -> str:
    """Return a text with at most ``count`` names and the number of the others."""
    suffix = f"; and {len(names) - count} more" if len(names) > count else ""
    return "; ".join(names[:count]) + suffix


def _text(cell: Any) -> str:
    if isinstance(cell, Quantity):
        return f"{cell} ({cell.reason})" if cell.value is None else str(cell)
    return {True: "yes", False: "no", None: "none"}.get(cell, str(cell))


Pair = tuple[Move, Sequence[Estimate | None]]
"""A number that has not been tested yet, and its estimates in both editions."""


def moves_between(before: Chapter, after: Chapter) -> list[Move]:
    """Return all values of a section that can be compared between two editions.

    Settings that only one edition has are included.
    """
    sides = before.results, after.results
    columns = after.results.columns
    rules = columns.settings.changes
    edges = sides[0].evidence.edges | sides[1].evidence.edges
    pairs = list(_means_between(sides))
    with_means = {(move.place["case"], move.column) for move, _ in pairs}
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
        # If the repeats of a run ended in different classes, chance decides the class.
        endings = [row.plain[rules.endings] for row in rows if rules.endings in row]
        is_mixed = any(len(set(classes.split(", "))) > 1 for classes in endings)
        if is_mixed or key in edges:
            continue
        for column in _comparable([row.plain for row in rows], sides):
            ends = [columns.number_of(column.name, row.plain) for row in rows]
            move = move_of(column, *ends, rows=rows)
            if not all(map(is_number, ends)):
                moves.append(move)
            elif (place["case"], column) not in with_means:
                pairs.append((move, [row.estimate(column.name) for row in rows]))
    numbers = _judged(pairs)
    shifts = _shifts(numbers, sides)
    is_single = any(side.evidence.count < 2 for side in sides)
    texts = [replace(move, is_single=is_single) for move in moves]
    return [*_without_chance([*numbers, *texts], sides), *shifts]


def _rows_by_key(results: Results) -> dict[RowKey, Row]:
    """Return the rows whose key is unique, by key.

    Repeated runs are left out, because the number of their case counts all of them.
    """
    section = results.record.section
    columns = results.columns
    _, repeats = split_repeats(results.record.rows, section, columns)
    rows = [row for row in results.rows if row.plain not in repeats]
    return single((key_of(row.plain, columns), row) for row in rows)


def _means_between(sides: Sequence[Results]) -> Iterator[Pair]:
    """Yield the means over the runs of each case if this is the section on noise."""
    columns = sides[1].columns
    rules = columns.settings.changes
    section = sides[1].record.section
    if section != columns.settings.noise_section:
        return
    old, new = (side.evidence.means() for side in sides)
    for case, name in (key for key in old if key in new):
        if is_absolute(columns[name]) and not _are_timed_alike(sides):
            continue
        means = old[case, name], new[case, name]
        of_case = partial(Move, section=section, place={"case": case}, rules=rules)
        yield of_case(columns[name], means[0].value, means[1].value), means


def cost_terms(record: Record, row: Cells, columns: Schema) -> tuple[Any, ...]:
    """Return the machine and the amount of work, which must agree to compare two costs."""
    work = [row.get(name) for name in columns.settings.cost_terms]
    return record.machine_for_speed, *work


def _are_timed_alike(sides: Sequence[Results]) -> bool:
    a, b = (side.record.machine_for_speed for side in sides)
    return a == b


def _comparable(rows: Sequence[Cells], sides: Sequence[Results]) -> Iterator[Column]:
    """Yield the columns whose cells in two rows can be compared."""
    a, b = rows
    columns = sides[1].columns
    are_lost = [is_lost(row, columns) for row in rows]
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
    only_settings_changed = all("setting" in column.kinds for column in changed)
    ignored = (*columns.settings.changes.keys, "")
    for name in a:
        column = columns[name]
        if name not in b or name in ignored or name.endswith((REASON, *EDGES)):
            continue
        if "uncompared" in column.kinds:
            continue
        if isinstance(a[name], str | bool) or isinstance(b[name], str | bool):
            if not all(are_lost) or "failure" not in column.kinds:
                yield column
        elif any(are_lost) or (column.is_cost and terms[0] != terms[1]):
            continue
        elif not changed or column.is_setting:
            yield column
        elif only_settings_changed and column.unit.endswith(("/s", "/cycle")):
            yield column  # a rate does not depend on the length of the run


def _judged(pairs: Sequence[Pair]) -> list[Move]:
    """Return numbers with the probability that only noise causes a difference as
    large. At most the share ``FALSE_SHARE`` of the changes listed in a section is
    false.
    """
    import numpy as np  # slow to import, and most commands do not compare editions

    if not pairs:
        return []
    tested = [_with_both_sides(move, estimates) for move, estimates in pairs]
    values = np.array([[side.value for side in sides] for sides, *_ in tested])
    errors = np.array([[side.error for side in sides] for sides, *_ in tested])
    # Both variances come from the same scatter, so their degrees of freedom do not add.
    freedoms = np.array([min(side.freedom for side in sides) for sides, *_ in tested])
    leasts = np.array([least for _, least, _ in tested])
    distances = np.maximum(0.0, abs(np.diff(values)[:, 0]) - leasts)
    errors = np.hypot(*errors.T)
    chances = chance_of(distances, errors, freedoms)
    # Numbers that report.toml names are few, and are tested by themselves.
    groups = grouped(
        (move.is_named, chance)
        for (move, _), chance in zip(pairs, chances, strict=True)
    )
    limits = {
        is_named: max(discoveries(group), FALSE_SHARE / len(group))
        for is_named, group in groups.items()
    }
    scales = _scales(pairs)
    moves = []
    for index, chance in enumerate(chances):
        move, _ = pairs[index]
        sides, least, is_chosen = tested[index]
        judged_move = replace(
            move,
            before=sides[0].value,
            after=sides[1].value,
            chance=chance,
            error=float(errors[index]),
            freedom=float(freedoms[index]),
            least=least,
            is_chosen=is_chosen,
            limit=limits[move.is_named],
            scale=scales[move.column],
            is_single=any(side.count < 2 for side in sides),
        )
        moves.append(judged_move)
    return moves


def _scales(pairs: Sequence[Pair]) -> dict[Column, float]:
    """Return by column the size below which a number is close to zero.

    A percentage of such a number has no meaning, so its change is divided by this size.
    """
    sizes: dict[Column, list[float]] = {}
    for move, _ in pairs:
        sizes.setdefault(move.column, []).append(abs(move.before))
    return {column: NEAR_ZERO * median(numbers) for column, numbers in sizes.items()}


def _with_both_sides(
    move: Move, estimates: Sequence[Estimate | None]
) -> tuple[list[Estimate], float, bool]:
    """Return the estimates of both editions and the smallest difference that counts.

    Also return whether this difference is chosen because the noise is not known. If the
    scatter of only one side is known, it is used for both.
    """
    ends = move.before, move.after
    size = max(map(abs, ends))
    resolution = move.column.resolution
    existing = [estimate for estimate in estimates if estimate]
    if not existing:
        exact = [Estimate(end) for end in ends]
        return exact, max(resolution, CHOSEN_SHARE * size), True
    sides = [
        estimate or Estimate(end, existing[0].variance, existing[0].freedom)
        for estimate, end in zip(estimates, ends, strict=True)
    ]
    rounding = size * (COST_SHARE if move.column.is_cost else ROUNDED_SHARE)
    least = max(estimate.least for estimate in existing)
    return sides, max(resolution, rounding, least), False


def _without_chance(moves: Sequence[Move], sides: Sequence[Results]) -> list[Move]:
    """Return the moves; a move is marked as odd if one unusual run may explain it.

    Occasionally a run ends differently although nothing changed. If one edition
    measured a number only once, this looks like a change. Such rows therefore count
    only if there are more of them than the measurements of this section explain, or if
    ``report.toml`` names the number.
    """
    single_rows = {
        move.rows[0].source for move in moves if move.may_be_odd and move.is_real
    }
    numbers = [move for move in moves if move.rows and move.chance is not None]
    row_count = len({move.rows[0].source for move in numbers})
    odd_rows = [side.evidence.odd_rows for side in sides]
    if 1 < row_count <= len(single_rows):
        is_change = True  # chance does not change all rows at once
    elif None not in odd_rows:
        is_change = exceeds_chance(len(single_rows), sum(filter(None, odd_rows)))
    elif row_count < LEAST_SWEEP:
        is_change = True
    else:
        is_change = exceeds_share(len(single_rows), row_count, ODD_SHARE)
    if is_change:
        return list(moves)
    return [
        replace(move, is_odd=True) if move.may_be_odd and not move.is_named else move
        for move in moves
    ]


def _shifts(moves: Sequence[Move], sides: Sequence[Results]) -> list[Move]:
    """Return the change that all rows of a column of times have in common, by column.

    All times of one measurement share the error of its host and card. The median of
    their changes is therefore compared with the scatter between hosts. This common
    change can be significant although no single row changes by more than its noise.
    """
    by_column: dict[Column, list[Move]] = {}
    for move in moves:
        is_positive = min(move.before or 0.0, move.after or 0.0) > 0
        if is_absolute(move.column) and move.rows and is_positive:
            by_column.setdefault(move.column, []).append(move)
    counts = [max(1, side.evidence.count) for side in sides]
    shifts = []
    for column_moves in by_column.values():
        if len(column_moves) < LEAST_SHIFTED:
            continue
        logs = [math.log(move.after / move.before) for move in column_moves]
        middle = median(logs)
        residual = TO_DEVIATION * median(abs(log - middle) for log in logs)
        variance, freedom = sides[0].evidence.host
        error = math.sqrt(
            # The first term is the scatter between hosts, the second that of the rows.
            variance * sum(1 / count for count in counts)
            + MEDIAN**2 * residual**2 / len(logs)
        )
        before = median(move.before for move in column_moves)
        after = before * math.exp(middle)
        [chance] = chance_of([abs(middle)], [error], [freedom])
        shifts.append(
            replace(
                column_moves[0],
                before=before,
                after=after,
                chance=chance,
                error=error * before,
                freedom=freedom,
                least=0.0,
                place={},
                rows=(),
                # Bonferroni: the columns are few, so this costs little power.
                limit=FALSE_SHARE / len(by_column),
                row_count=len(column_moves),
            )
        )
    return shifts
