"""Evidence: what all measurements of an edition say of its numbers.

A measurement gives the truth, with a part of its host and card, one of its process and
one of its run. A number that was measured several times scatters by all of them.
Absolute times share the part of their card, so they are known only by as many cards as
there are. A number that was measured once has the scatter that runs of one case, or its
own row, show.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from statistics import NormalDist, fmean
from typing import Any, NamedTuple

from measured_report.files.columns import Column, Schema, is_number
from measured_report.files.errors import ReportError
from measured_report.files.groups import grouped
from measured_report.values.noise import (
    Estimate,
    Z,
    binomial_noise,
    fenced,
    variance_of,
)

REPEATED_SHARE = 1e-3
"""Chosen: a number that repeats to the last bit on one machine may differ by this share
on another one, by rounding."""
EDGES = ("_p5", "_p95")  # columns with the spread of the numbers that a median is of
MEDIAN = math.sqrt(math.pi / 2)  # the spread of a median of many, by that of their mean
MEAN = "mean of"  # begins the key of a mean of runs of one case
Key = tuple[Any, ...]
Cells = Mapping[str, Any]
Number = tuple[Key, str]  # the row and the column of a number
Repeated = Mapping[str, Mapping[str, "Repeats"]]  # runs of one case, by case and column


def is_lost(row: Cells, columns: Schema) -> bool:
    """Return whether the run of a row failed, so that its numbers are chance."""
    return any(row[name] for name in row if "failure" in columns[name].kinds)


def is_absolute(column: Column) -> bool:
    """Return whether a column has times or rates, which depend on the card."""
    return column.is_cost and (column.unit not in ("1", "B") or bool(column.rate_of))


def scatters(column: Column) -> bool:
    """Return whether measurements of a column differ by chance and are compared."""
    is_ignored = column.is_exact or "uncompared" in column.kinds
    return not (is_ignored or column.name.endswith(EDGES))


def key_of(row: Cells, columns: Schema) -> Key:
    """Return the cells that tell a row from the others of its section."""
    return tuple(row.get(name) for name in columns.settings.changes.keys)


class Repeats(NamedTuple):
    """Hold what runs of one case of one measurement say of a column."""

    mean: float
    variance: float
    run_count: int
    length: float = 0.0  # of the longest, in the column that numbers grow with

    def variance_at(self, value: float, length: float | None) -> float:
        """Return the variance of one run; it grows with its number and its length."""
        scale = abs(value / self.mean) if self.mean else 1.0
        longer = (length or 0.0) / self.length if self.length else 1.0
        return self.variance * max(1.0, scale, longer) ** 2


def repeats_of(rows: Iterable[Cells], columns: Schema) -> Repeated:
    """Return what the runs of one case, as ``of`` names it, say of each column."""
    repeats: dict[str, dict[str, Repeats]] = {}
    for case, runs in grouped((row["of"], row) for row in rows if "of" in row).items():
        repeats[case] = {}
        for column in filter(scatters, map(columns.__getitem__, runs[0])):
            cells = [row.get(column.name) for row in runs]
            numbers = fenced([cell for cell in cells if is_number(cell)] or [0.0])
            if len(numbers) > 1:
                length = max(row.get(column.grows_with) or 0.0 for row in runs)
                found = fmean(numbers), variance_of(numbers), len(numbers), length
                repeats[case][column.name] = Repeats(*found)
    return repeats


@dataclass(frozen=True)
class Evidence:
    """Holds what all measurements of a section say of its numbers."""

    count: int = 1
    estimates: Mapping[Number, Estimate] = field(default_factory=dict)
    """Of the numbers that were measured several times."""
    repeats: Repeated = field(default_factory=dict)  # of the section on noise
    edges: frozenset[Key] = frozenset()  # rows that end in one of two ways, by chance
    edge_share: float = 0.0  # how often a row of one measurement ended otherwise
    changed: Sequence[tuple[int, int]] = ()
    """By measurement: how many numbers it has, and how many differ from the others."""

    def estimate(self, name: str, row: Cells, columns: Schema) -> Estimate | None:
        """Return what is known of a number; None if its scatter is not known."""
        value = row[name]
        column = columns[name]
        if value is None:
            return None
        if trials := row.get(column.trials):
            scale = trials if name.endswith("_count") else 1
            if not 0 <= value <= scale:
                given = f"{name} {value:g}, with {column.trials} {trials:g}"
                raise ReportError(f"{row['case']} has {given}")
            deviation = scale * binomial_noise(value / scale, trials) / Z
            return Estimate(value, deviation**2, samples=(value,))
        if column.is_exact:
            return Estimate(value)
        if estimate := self.estimates.get((key_of(row, columns), name)):
            return estimate
        if isinstance(value, int):
            return Estimate(value)
        if estimate := _by_itself(column, row):
            return estimate
        repeating = columns.settings.repeating.items()
        rounding = 0.0 if column.is_cost else REPEATED_SHARE * abs(value)
        repeats = any(row.get(engine) in cells for engine, cells in repeating)
        if repeats and not column.is_cost:
            return Estimate(value, least=rounding, samples=(value,))
        return self._by_repeats(column, row, rounding)

    def means(self) -> dict[tuple[str, str], Estimate]:
        """Return what is known of means of runs of one case, by case and column."""
        means = {}
        for case, columns in self.repeats.items():
            for name, runs in columns.items():
                once = Estimate(
                    runs.mean, runs.variance, runs.run_count - 1, runs.run_count
                )
                means[case, name] = self.estimates.get(((MEAN, case, name), name), once)
        return means

    def _by_repeats(
        self, column: Column, row: Cells, rounding: float
    ) -> Estimate | None:
        """Return an estimate with the noise of the noisiest runs of one case."""
        value = row[column.name]
        length = row.get(column.grows_with)
        runs = [
            each[column.name] for each in self.repeats.values() if column.name in each
        ]
        if not runs:
            return None
        noisiest = max(runs, key=lambda run: run.variance_at(value, length))
        variance = noisiest.variance_at(value, length)
        least = column.resolution or (0.0 if variance else rounding)
        if not (variance or least):
            return None
        freedom = noisiest.run_count - 1
        return Estimate(value, variance, freedom, least=least, samples=(value,))


def _by_itself(column: Column, row: Cells) -> Estimate | None:
    """Return an estimate with the noise that the row has; None if it has none."""
    value = row[column.name]
    if share := row.get(column.known_within):
        return Estimate(value, (share * value / Z) ** 2, samples=(value,))
    timed = column.rate_of or column.name
    low, high = (row.get(timed + edge) for edge in EDGES)
    if low is None or high is None or not row.get(timed):
        return None
    tails = 2 * NormalDist().inv_cdf(0.95)
    deviation = MEDIAN * (high - low) / tails / row[timed] * value
    count = max(1, row.get("repeat_count") or 1)
    return Estimate(value, deviation**2, count=count, samples=(value,))
