"""Moves: values that editions have differently, and whether beyond the noise of both."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from measured_report.files.config import cached_in_report, config
from measured_report.files.groups import single
from measured_report.findings.chapters import Chapter
from measured_report.records.columns import REASON, column_of, is_number, parameters
from measured_report.records.record import Record
from measured_report.values.evidence import EDGES, Cells, is_absolute, is_lost, key_of
from measured_report.values.noise import (
    FALSE_SHARE,
    ROUNDED_SHARE,
    Estimate,
    chance_of,
    t_quantile,
    welch,
)
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
        if self.rows:
            return [row[self.column] for row in self.rows]
        ends = [self.before, self.after]
        return ends if self.chance is None else [Quantity(end, self.unit, "") for end in ends]

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
        """Tell whether the values differ, numbers beyond the noise."""
        return self.before != self.after if self.is_setting or self.chance is None else self.chance <= self.limit

    @property
    def noise(self) -> float | None:
        """Return the least difference that would count; None for what is no number."""
        return None if self.chance is None else self.least + t_quantile(1 - self.limit, self.freedom) * self.error

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
        if "failure" in column_of(self.column).kinds:
            return self.is_real and any(name.rpartition(".")[0] == run for name in rules.thresholds)
        threshold = rules.setting_threshold if self.is_setting else rules.thresholds.get(self.name)
        if threshold is None or self.share is None:
            return threshold is not None and self.is_gone
        return self.is_real and abs(self.share) > threshold

    @property
    def is_gone(self) -> bool:
        """Tell whether it is a number that was asked for in both editions and is there in one."""
        return (self.before is None) != (self.after is None) and all(isinstance(side, Quantity) for side in self.sides)

    @property
    def direction(self) -> str:
        """Say ``better`` or ``worse``, where one can."""
        better = column_of(self.column).better
        if None in (self.before, self.after) or not better:
            return ""
        return "better" if (abs(self.after) > abs(self.before)) == (better == "more") else "worse"

    @property
    def mark(self) -> str:
        """Say ``better``, ``worse`` or ``moved`` where it is beyond the noise."""
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


Estimates = Sequence[Estimate | None]  # of a number in both editions; None where nobody knows how it scatters
Pair = tuple[Move, Estimates, float]  # a move that is not yet judged, with the share of edges: no chance is less


def cells_between(before: Chapter, after: Chapter) -> list[Move]:
    """Return the values of a section that compare between two editions, moved or not, and settings that one lacks."""
    records = before.results.record, after.results.record
    edges = before.results.evidence.edges | after.results.evidence.edges
    edge_share = max(chapter.results.evidence.edge_share for chapter in (before, after))
    rules, old, new = config().changes, _rows_by_key(before), _rows_by_key(after)
    pairs = list(_means_between(before, after))
    is_other_card = records[0].card != records[1].card
    moves, mean_cells = [], {(move.place["case"], move.column) for move, *_ in pairs}
    for key in dict.fromkeys((*old, *new)):
        row_key, a, b = dict(key), old.get(key), new.get(key)
        if a is None or b is None:
            if row_key.get("kind") in rules.settings:
                values = a and a.plain["value"], b and b.plain["value"]
                moves.append(Move("value", *values, section=before.name, place=row_key))
            continue
        # Where repeats of a run end in different classes it is chance which one the row is about.
        endings = [row.plain[rules.endings].split(", ") for row in (a, b) if rules.endings in row]
        if key_of(a.plain) in edges or any(len(set(classes)) > 1 for classes in endings):
            continue
        for column in _comparable((a.plain, b.plain), records):
            ends = a.plain[column], b.plain[column]
            move = Move(column, *ends, section=before.name, place=row_key, rows=(a, b))
            if not all(map(is_number, ends)):
                moves.append(move)
            elif (row_key["case"], column) not in mean_cells:
                estimates = [a.estimate(column), b.estimate(column)]
                if is_absolute(column):
                    if is_other_card and not _knows_cards(estimates):
                        continue
                    # Of a time of one process nobody knows how far another of the same card would be.
                    estimates = [
                        replace(time, count=1.0, least=CHOSEN_SHARE * abs(time.value))
                        if time and not time.is_again
                        else time
                        for time in estimates
                    ]
                pairs.append((move, estimates, edge_share))
    return [*judged(pairs), *moves]


def _knows_cards(estimates: Sequence[Estimate | None]) -> bool:
    """Tell whether somebody knows how far absolute times of two cards of one kind are apart."""
    return any(estimate and estimate.is_of_cards for estimate in estimates)


def _means_between(before: Chapter, after: Chapter) -> Iterator[Pair]:
    """Yield the means of what the section on noise has many runs of, by case and column."""
    if before.name != config().noise_section:
        return
    old, new = (chapter.results.evidence.means() for chapter in (before, after))
    is_other_card = before.results.record.card != after.results.record.card
    for case, column in (key for key in old if key in new):
        means = old[case, column], new[case, column]
        if not (is_absolute(column) and is_other_card) or _knows_cards(means):
            ends, unit = [mean.value for mean in means], before.results.record.units[column]
            yield Move(column, ends[0], ends[1], section=before.name, place={"case": case}, unit=unit), means, 0.0


def judged(pairs: Sequence[Pair]) -> list[Move]:
    """Say of numbers how often chance makes such a move, by what is known of both sides; all at once.

    What was measured again tells of a number that was measured once how far its own other measurements would be, and
    what is known of one side alone stands for both.
    """
    import numpy as np  # most commands that know what a move is judge none

    if not pairs:
        return []
    estimated = [_estimates_of(move, estimates) for move, estimates, _ in pairs]
    ends = np.array([[side.value for side in sides] for sides, _, _ in estimated])
    sides = np.array([[(side.variance / side.count, side.freedom) for side in sides] for sides, _, _ in estimated])
    errors, freedoms = welch(sides[:, :, 0], sides[:, :, 1])
    leasts = np.array([least for _, least, _ in estimated])
    distance = np.maximum(0.0, abs(np.diff(ends)[:, 0]) - leasts)
    arrays = chance_of(distance, errors, freedoms), errors.tolist(), freedoms.tolist(), leasts.tolist()
    judgements, moves = zip(pairs, estimated, *arrays, strict=True), []
    for (move, _, edge_share), ((before, after), _, is_chosen), chance, error, freedom, least in judgements:
        difference = {"chance": max(chance, edge_share), "error": error, "freedom": freedom, "least": least}
        moves.append(replace(move, before=before.value, after=after.value, is_chosen=is_chosen, **difference))
    return moves


def _estimates_of(move: Move, estimates: Estimates) -> tuple[list[Estimate], float, bool]:
    """Return what is known of both sides, the least difference that counts, and whether nobody knows any of that."""
    bare = [each or Estimate(end) for each, end in zip(estimates, (move.before, move.after), strict=True)]
    size, resolution = max(abs(each.value) for each in bare), column_of(move.column).resolution
    if (teacher := max(filter(None, estimates), key=lambda each: each.is_again, default=None)) is None:
        return bare, max(resolution, CHOSEN_SHARE * size), True
    sides = [
        side if each and each.is_again >= teacher.is_again else Estimate(side.value, teacher.variance, teacher.freedom)
        for side, each in zip(bare, estimates, strict=True)
    ]
    return sides, max(resolution, ROUNDED_SHARE * size, teacher.least), False


def cost_terms(record: Record, row: Mapping[str, Any]) -> tuple[Any, ...]:
    """Return what two costs must share to be compared: the machine, and how much was run."""
    return record.machine_for_speed, *(row.get(column) for column in config().cost_terms)


def _comparable(cells: tuple[Cells, Cells], records: Sequence[Record]) -> Iterator[str]:
    has_same_terms = len(set(map(cost_terms, records, cells))) == 1
    lost, (a, b) = [is_lost(cell) for cell in cells], cells
    unlike = [name for name in a if None not in (a[name], b.get(name)) and a[name] != b[name]]
    changed = [kinds for name in unlike if "setting" in (kinds := column_of(name).kinds) or name in parameters()]
    for column in (name for name in a if name in b and _may_differ(name)):
        about = column_of(column)
        if isinstance(a[column], str | bool) or isinstance(b[column], str | bool):
            is_so = not (all(lost) and "failure" in about.kinds)
        elif any(lost) or ("cost" in about.kinds and not has_same_terms):
            is_so = False
        else:  # of runs that were not set alike nothing, and of those that ran for longer or shorter rates alone
            is_rate = about.unit.endswith(("/s", "/cycle"))
            is_so = not changed or about.is_setting or (is_rate and all("setting" in kinds for kinds in changed))
        if is_so:
            yield column


@cached_in_report
def _may_differ(column: str) -> bool:
    """Tell whether a column says something of a run, which is no chance and of no other column."""
    is_key = column in config().changes.keys
    return not (is_key or "uncompared" in column_of(column).kinds or column.endswith((REASON, *EDGES)))


def few(names: Sequence[str], count: int = NAMED) -> str:
    """Name no more than so many, and say how many more there are."""
    return "; ".join(names[:count]) + (f"; and {len(names) - count} more" if len(names) > count else "")


def _rows_by_key(chapter: Chapter) -> dict[tuple[tuple[str, Any], ...], Row]:
    """Return rows by what tells them apart; those that nothing does are left out, and repeats, which are the noise."""
    names = config().changes.keys
    rows = [row for row in chapter.results.rows if not (chapter.name == config().noise_section and "of" in row)]
    keys = (tuple((name, row.plain[name]) for name in names if row.plain.get(name) is not None) for row in rows)
    return single(zip(keys, rows, strict=True))


def _text(cell: Any) -> str:
    if isinstance(cell, Quantity):
        return f"{cell} ({cell.reason})" if cell.value is None else str(cell)
    return {True: "yes", False: "no", None: "none"}.get(cell, str(cell))
