"""Evidence: all that was measured of the numbers of a section, and what that says of each.

A measurement gives the truth, with a part of its host and card, one of its process and one of its run. What was
measured more than once scatters by all of them. Absolute times have the part of their card in common: no more is known
of it than there are cards. What was measured once has what runs of one case say of its column, or what it says itself.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from statistics import NormalDist, fmean, median
from typing import Any, NamedTuple

from measured_report.files.config import cached_in_report, config
from measured_report.files.errors import ReportError
from measured_report.files.groups import grouped, single
from measured_report.records.columns import REASON, column_of, is_cost, is_number
from measured_report.records.record import Record
from measured_report.values.noise import (
    ROUNDED_SHARE,
    Estimate,
    Z,
    binomial_noise,
    discoveries,
    fenced,
    variance_of,
)

REPEATED_SHARE = 1e-3  # chosen: what repeats to the last bit here may round otherwise elsewhere, by this share
EDGES = ("_p5", "_p95")  # ends of columns that say how far the numbers spread of which a column has the median
MEDIAN = math.sqrt(math.pi / 2)  # ratio of the spreads of the median of many numbers and of their mean
AT_EDGE = 4.4  # chosen: a number so many normal deviations from all others, which is one in 100,000, is no chance
CARDS_APART = 0.02  # chosen: no less do cards of one kind scatter for sections that tell each other; four did by 3 %
MEAN = "mean of"  # begins the key of what the section on noise has many runs of
Key = tuple[Any, ...]
Cells = Mapping[str, Any]


def is_lost(row: Cells) -> bool:
    """Tell whether the run of a row was lost, which makes its numbers chance."""
    return any(row[name] for name in row if "failure" in column_of(name).kinds)


def is_absolute(column: str) -> bool:
    """Tell whether a column has times or rates, of which each card has its own; ratios have none of that."""
    about = column_of(column)
    return is_cost(column) and (about.unit not in ("1", "B") or bool(about.rate_of))


def key_of(row: Cells) -> Key:
    """Return what tells a row from the others of its section, in any measurement."""
    return tuple(row.get(name) for name in config().changes.keys)


def engine_of(row: Cells) -> Key:
    """Return what tells whose numbers a row has, as to how well they repeat."""
    return tuple(row.get(name) for name in config().repeating)


class Repeats(NamedTuple):
    """Hold what runs of one case, of one measurement, say of a column."""

    mean: float
    variance: float
    run_count: int
    length: float = 0.0  # of the longest of them, in the column that it grows with; 0 where it does not

    def variance_at(self, value: float, length: float | None) -> float:
        """Return the variance of a run with such a number: larger and longer ones have more, in proportion."""
        scale = abs(value / self.mean) if self.mean else 1.0
        longer = (length or 0.0) / self.length if self.length else 1.0
        return self.variance * max(1.0, scale, longer) ** 2


Repeated = Mapping[str, Mapping[str, Repeats]]  # runs of one case, by case and column


def repeats_of(rows: Iterable[Cells]) -> Repeated:
    """Gather the runs of one case of a record, by the case, as ``of`` says, and the column; outliers are fenced in."""
    runs = grouped((row["of"], row) for row in rows if "of" in row)
    repeats: dict[str, dict[str, Repeats]] = {case: {} for case in runs}
    for case, column in ((case, column) for case, rows in runs.items() for column in rows[0]):
        numbers = fenced([row[column] for row in runs[case] if is_number(row.get(column))] or [0.0])
        if len(numbers) > 1 and scatters(column):
            length = max(row.get(column_of(column).grows_with) or 0.0 for row in runs[case])
            repeats[case][column] = Repeats(fmean(numbers), variance_of(numbers), len(numbers), length)
    return repeats


class Cell(NamedTuple):
    """Hold a number of a row in all measurements, NaN where there is none, and how it scatters."""

    samples: list[float]
    scale: float = 1.0  # what its deviation would be if runs alone were apart; 1 where nobody knows
    variance: float = 0.0
    freedom: float = math.inf
    mean_count: float = 1.0  # measurements, or cards, that the mean is of
    is_of_cards: bool = False  # set where it has the part that cards of one kind have

    def estimate(self, value: float | int, is_edge: bool) -> Estimate:
        """Return what is known of the number, which is ``value`` where it is shown."""
        samples = [number if number == number else None for number in self.samples]
        present = [number for number in samples if number is not None]
        least, largest = min(present), max(present)
        if is_edge and least < largest:
            middle = median(present)
            return Estimate(middle, least=max(largest - middle, middle - least), samples=samples, is_edge=True)
        if least < largest:
            value = fmean(present)
        # A count, or nothing at all, of which all say the same, has none.
        variance = self.variance if least < largest or (isinstance(value, float) and value) else 0.0
        return Estimate(value, variance, self.freedom, self.mean_count, 0.0, samples, self.is_of_cards, is_again=True)


Group = Mapping[Key, Cell]  # the numbers of a column, of one engine, by row


@dataclass(frozen=True)
class Evidence:
    """Holds what all measurements of a section say of its numbers."""

    count: int = 1
    groups: Mapping[Key, Group] = field(default_factory=dict)  # by column and engine, what was measured more than once
    repeats: Repeated = field(default_factory=dict)  # runs of one case, of the section on noise
    edges: frozenset[Key] = frozenset()  # rows that end in one of two ways, by chance
    edge_share: float = 0.0  # how often a row has ended otherwise in one measurement than in the others
    changed: Sequence[tuple[int, int]] = ()  # by measurement: how many numbers it has, and how many of them changed
    cards: frozenset[str] = frozenset()  # those that times stand beside one another of

    def estimate(self, column: str, row: Cells) -> Estimate | None:
        """Return what is known of a number in ``row``; None where nobody knows its scatter."""
        value, about, key = row[column], column_of(column), key_of(row)
        if value is None:
            return None
        if trials := row.get(about.trials):
            scale = trials if column.endswith("_count") else 1
            if not 0 <= value <= scale:
                raise ReportError(f"{row['case']} has {column} {value:g}, with {about.trials} {trials:g}")
            return Estimate(value, (scale * binomial_noise(value / scale, trials) / Z) ** 2, samples=(value,))
        if about.is_exact:
            return Estimate(value)
        if cell := self.groups.get((column, *engine_of(row)), {}).get(key):
            return cell.estimate(value, key in self.edges)
        if isinstance(value, int):
            return Estimate(value)
        return _by_itself(column, row) or self._by_repeats(column, row)

    def means(self) -> dict[tuple[str, str], Estimate]:
        """Return what is known of the means of runs of one case, by case and column."""
        estimates = {}
        for case, columns in self.repeats.items():
            for column, runs in columns.items():
                key = MEAN, case, column
                group = self.groups.get((column, MEAN) if is_absolute(column) else (MEAN,), {})
                cell, once = group.get(key), Estimate(runs.mean, runs.variance, runs.run_count - 1, runs.run_count)
                estimates[case, column] = cell.estimate(runs.mean, key in self.edges) if cell else once
        return estimates

    @property
    def cells(self) -> list[Cell]:
        return [cell for group in self.groups.values() for cell in group.values()]

    def of_cards_known(self, share: float, freedom: float) -> "Evidence":
        """Return the same where cards scatter by this variance, of a number's square, or more, so well known."""

        def known(cell: Cell) -> Cell:
            return cell._replace(variance=max(cell.variance, share * cell.scale**2), freedom=freedom)

        groups = {
            name: {key: known(cell) if cell.is_of_cards else cell for key, cell in group.items()}
            for name, group in self.groups.items()
        }
        return replace(self, groups=groups)

    def _by_repeats(self, column: str, row: Cells) -> Estimate | None:
        """Return what the noisiest runs of one case say of a number; what repeats to the last bit is rounded."""
        value, about = row[column], column_of(column)
        rounding = 0.0 if is_cost(column) else REPEATED_SHARE * abs(value)
        if not is_cost(column) and any(row.get(name) in cells for name, cells in config().repeating.items()):
            return Estimate(value, least=rounding, samples=(value,))
        length = row.get(about.grows_with)
        runs = [columns[column] for columns in self.repeats.values() if column in columns]
        if (noisiest := max(runs, key=lambda run: run.variance_at(value, length), default=None)) is None:
            return None
        variance = noisiest.variance_at(value, length)
        least = about.resolution or (0.0 if variance else rounding)
        freedom = noisiest.run_count - 1
        return Estimate(value, variance, freedom, least=least, samples=(value,)) if variance or least else None


def _by_itself(column: str, row: Cells) -> Estimate | None:
    """Return what a row itself says of how well its number is known; None where it says nothing."""
    value, about = row[column], column_of(column)
    if share := row.get(about.known_within):
        return Estimate(value, (share * value / Z) ** 2, samples=(value,))
    timed = about.rate_of or column
    low, high = (row.get(timed + edge) for edge in EDGES)
    if low is None or high is None or not row.get(timed):
        return None
    deviation = MEDIAN * (high - low) / (2 * NormalDist().inv_cdf(0.95)) / row[timed] * value
    return Estimate(value, deviation**2, count=max(1, row.get("repeat_count") or 1), samples=(value,))


Far = tuple[Key, list[float]]  # of a column: a row, and normal deviations of its measurements from the others, or NaN


def evidence_of(measured: Sequence[Record | None], repeats: Repeated) -> Evidence:
    """Compare the measurements of a section, None where there is none; the first of them is that which is shown."""
    tracked, *replicas = measured
    if tracked is None or not any(replicas):
        return Evidence(repeats=repeats)
    # Rows that share a key are left out, and runs of one case.
    keyed = [single((key_of(row), row) for row in (each.rows if each else ()) if "of" not in row) for each in measured]
    rows_by_key = {key: [rows.get(key, {}) for rows in keyed] for key in keyed[0]}
    lost = {key: [is_lost(row) for row in rows] for key, rows in rows_by_key.items()}
    edges = {key for key, rows in rows_by_key.items() if _ends_apart(rows, lost[key])}
    keys = [key for key in rows_by_key if key not in edges and not lost[key][0]]
    is_alike = [record is not None and record.machine_for_speed == tracked.machine_for_speed for record in measured]
    groups: dict[Key, dict[Key, Cell]] = {}
    for key in keys:
        rows = [{} if gone else row for row, gone in zip(rows_by_key[key], lost[key], strict=True)]
        engine = engine_of(rows[0])
        for column in filter(scatters, rows[0]):
            if cell := _cell(column, rows, is_alike):
                groups.setdefault((column, *engine), {})[key] = cell
    runs = [repeats_of(record.rows if record else ()) for record in measured]
    for case, column in ((case, column) for case, columns in runs[0].items() for column in columns):
        means = [{column: run[case][column].mean} if column in run.get(case, {}) else {} for run in runs]
        spread = runs[0][case][column]
        if cell := _cell(column, means, is_alike, math.sqrt(spread.variance / spread.run_count)):
            groups.setdefault((column, MEAN) if is_absolute(column) else (MEAN,), {})[MEAN, case, column] = cell
    cards = [record.card if record else "" for record in measured]
    timed = frozenset(card for card, alike in zip(cards, is_alike, strict=True) if card and alike)
    far: list[Far] = []
    for name, group in groups.items():
        if is_absolute(name[0]) and (of_cards := _of_cards(group, cards)):
            groups[name] = of_cards
        else:
            groups[name], deviations = _moderated(MEAN if MEAN in name else name[0], group)
            far += zip(group, deviations, strict=True)
    # No chance is so far from all others.
    events = {(key, index) for key, numbers in far for index, number in enumerate(numbers) if number > AT_EDGE}
    count = sum(map(bool, cards))
    share = len(events) / max(1, len(keys) * count)
    changed = [_changed(far, events, index, len(keys) * (count - 1)) for index in range(len(cards)) if count > 2]
    return Evidence(count, groups, repeats, frozenset(edges | {key for key, _ in events}), share, changed, timed)


@cached_in_report
def scatters(column: str) -> bool:
    """Tell whether a column's numbers may come out otherwise, and say something when they do."""
    about = column_of(column)
    return not (about.is_exact or "uncompared" in about.kinds or column.endswith(EDGES))


def _ends_apart(rows: Sequence[Cells], lost: Sequence[bool]) -> bool:
    """Tell whether measurements of a row were lost in some and not in others, or say another thing in words."""
    pairs = [(row, gone) for row, gone in zip(rows, lost, strict=True) if row]
    texts = {name for row, _ in pairs for name, cell in row.items() if isinstance(cell, str | bool)}
    texts -= {"case"} | {name for name in texts if name.endswith(REASON)}
    return len({gone for _, gone in pairs}) > 1 or any(len({row.get(name) for row, _ in pairs}) > 1 for name in texts)


def _cell(column: str, rows: Sequence[Cells], is_alike: Sequence[bool], scale: float = 1.0) -> Cell | None:
    """Return a number in all measurements, of which costs stand beside those of machines alike alone; None of one."""
    numbers = [row.get(column) for row in rows]
    if is_cost(column):
        numbers = [number if alike else None for number, alike in zip(numbers, is_alike, strict=True)]
    samples = [float(number) if is_number(number) else math.nan for number in numbers]
    return Cell(samples, scale) if sum(sample == sample for sample in samples) > 1 else None


def _moderated(name: str, group: Group) -> tuple[dict[Key, Cell], list[list[float]]]:
    """Return how each number scatters, and how far each measurement is from the others, in normal deviations."""
    import numpy as np

    from measured_report.values.shrinkage import left_out, moderated

    samples = np.array([cell.samples for cell in group.values()])
    scales = np.array([cell.scale or 1.0 for cell in group.values()])
    scaled = samples / scales[:, None]
    counts = (~np.isnan(samples)).sum(axis=1)
    sizes = np.maximum(abs(np.nanmean(scaled, axis=1)), 1e-12) if name != MEAN else np.ones(len(group))
    fit = moderated(np.nanvar(scaled, axis=1, ddof=1), counts - 1.0, sizes, usual=float(name == MEAN))
    least = np.maximum(column_of(name).resolution, ROUNDED_SHARE * abs(np.nanmean(samples, axis=1))) / scales
    scatters = zip((fit.variances * scales**2).tolist(), fit.freedoms.tolist(), counts.tolist(), strict=True)
    cells = {key: Cell(*cell[:2], *scatter) for (key, cell), scatter in zip(group.items(), scatters, strict=True)}
    return cells, left_out(scaled, fit.lent, fit.common, least).tolist()


def _of_cards(group: Group, cards: Sequence[str]) -> dict[Key, Cell] | None:
    """Return absolute times: how far cards are apart is as well known as there are cards; None of one card."""
    import numpy as np

    samples = np.array([cell.samples for cell in group.values()])
    places_of = {card: np.array([name == card for name in cards]) for card in cards}
    sides = [samples[:, places] for places in places_of.values() if not np.isnan(samples[:, places]).all()]
    if len(sides) < 2:
        return None
    by_card = np.stack([np.nanmean(side, axis=1) if side.shape[1] > 1 else side[:, 0] for side in sides], axis=1)
    complete, means = ~np.isnan(by_card).any(axis=1), by_card.mean(axis=1)
    if not complete.any():
        return None
    share = float(np.median(by_card[complete].var(axis=1, ddof=1) / means[complete] ** 2))
    scatter: dict[str, Any] = {"freedom": len(sides) - 1.0, "mean_count": float(len(sides)), "is_of_cards": True}
    rows = zip(group.items(), means.tolist(), complete, strict=True)
    return {key: Cell(cell.samples, mean, share * mean**2, **scatter) for (key, cell), mean, is_so in rows if is_so}


def with_cards(evidence: Mapping[str, Evidence]) -> Mapping[str, Evidence]:
    """Let sections tell each other how far cards of one kind are apart, of which each knows few.

    None takes less than all do together, as few cards may be alike by chance. What all know they know of so many cards:
    a card that several sections were measured on is one. So the truth is within at least 95 % of the intervals, drawn
    with what a card is off by the same in all sections, by another in each, or both.
    """
    of_cards = {name: [*filter(lambda cell: cell.is_of_cards, each.cells)] for name, each in evidence.items()}
    shares = {name: median(cell.variance / cell.scale**2 for cell in of) for name, of in of_cards.items() if of}
    freedoms = {name: len(evidence[name].cards) - 1 for name in shares}
    linked: list[frozenset[str]] = []  # cards that sections have in common
    for name in shares:
        near = [cards for cards in linked if cards & evidence[name].cards]
        linked = [*(cards for cards in linked if cards not in near), evidence[name].cards.union(*near)]
    freedom = float(sum(len(cards) - 1 for cards in linked))
    pooled = sum(shares[name] * freedoms[name] for name in shares) / max(1, sum(freedoms.values()))
    pooled = max(pooled, CARDS_APART**2)
    taught = [name for name in shares if freedoms[name] < freedom]
    return {**evidence, **{name: evidence[name].of_cards_known(pooled, freedom) for name in taught}}


def _changed(far: Sequence[Far], events: set[tuple[Key, int]], index: int, count: int) -> tuple[int, int]:
    """Return how many numbers a measurement has, and how many changed against the others, of ``count`` rows."""
    elsewhere = {(key, measurement) for key, measurement in events if measurement != index}
    share, edges = len(elsewhere) / max(1, count), {key for key, _ in elsewhere}
    z = [numbers[index] for key, numbers in far if numbers[index] == numbers[index] and key not in edges]
    chances = [max(math.erfc(deviation / math.sqrt(2)), share) for deviation in z]
    limit = discoveries(chances)
    return len(z), sum(chance <= limit for chance in chances) if limit else 0
