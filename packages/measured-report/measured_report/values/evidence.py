"""Estimate an edition's numbers from all their measurements.

A measurement differs from the true value by several errors: those of its host and card,
of its process, and of its run. The estimate of a number that was measured several times
is the mean of its measurements; their scatter is estimated from all editions, see
``scatter.py``. If no number of a column was ever measured twice, its scatter is
estimated from repeated runs of one case, or from the repeats within its own row.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from statistics import NormalDist, fmean
from typing import Any, NamedTuple

from measured_report.files.columns import REASON, Column, Schema, is_number
from measured_report.files.groups import grouped
from measured_report.values.noise import (
    Estimate,
    Scatter,
    Z,
    binomial_noise,
    fenced,
    variance_of,
)

REPEATED_SHARE = 1e-3
"""Chosen: the relative difference that rounding may cause between two machines, in a
number whose repeats are bit-identical on each of them.
"""
HOST_SHARE = 0.03
"""Chosen: the relative deviation of times between hosts and cards, if no time was measured
twice. Ten hosts with one kind of card differed by 0.5 to 5 %."""
HOST_FREEDOM = (
    4.0  # chosen: degrees of freedom of HOST_SHARE, about those of five hosts
)
EDGES = ("_p5", "_p95")  # ends of columns with the quantiles beside a median
MEDIAN = math.sqrt(math.pi / 2)
"""The standard error of the median of many normal numbers, divided by the standard
error of their mean.
"""
MEAN = "mean of"  # the first part of the key for a mean over runs of one case
RowKey = tuple[Any, ...]
Cells = Mapping[str, Any]
CellKey = tuple[RowKey, str]  # the row and the column of a number
ColumnKey = tuple[
    Any, ...
]  # a column of a section, and the engine that its rows ran on
Repeated = Mapping[str, Mapping[str, "Repeats"]]  # by case and column


def is_lost(row: Cells, columns: Schema) -> bool:
    """Return whether the run of a row failed, so that its numbers have no meaning."""
    return any(row[name] for name in row if "failure" in columns[name].kinds)


def is_absolute(column: Column) -> bool:
    """Return whether a column has times or rates, which depend on the host and card."""
    return column.is_cost and (
        not column.unit.endswith(("1", "B")) or bool(column.rate_of)
    )


def scatters(column: Column) -> bool:
    """Return whether the scatter of a column is estimated from its measurements.

    The noise of a number of trials follows from the trials, not from other
    measurements.
    """
    is_ignored = column.is_exact or column.trials or "uncompared" in column.kinds
    return not (is_ignored or column.name.endswith(EDGES))


def key_of(row: Cells, columns: Schema) -> RowKey:
    """Return the cells that distinguish a row from the others of its section."""
    return tuple(row.get(name) for name in columns.settings.changes.keys)


def column_key_of(name: str, row: Cells, columns: Schema) -> ColumnKey:
    """Return the column and the engine of a number. Numbers that share both scatter alike."""
    return name, *(row.get(engine) for engine in columns.settings.repeating)


def split_repeats(
    rows: Sequence[Cells], section: str, columns: Schema
) -> tuple[list[Cells], list[Cells]]:
    """Return the rows to compare, and the rows that repeat the case ``of``.

    Outside of the section on noise, this must be a case of the section.
    """
    is_noise = section == columns.settings.noise_section
    cases = {row["case"] for row in rows}
    singles: list[Cells] = []
    repeats: list[Cells] = []
    for row in rows:
        is_repeat = "of" in row and (is_noise or row["of"] in cases)
        (repeats if is_repeat else singles).append(row)
    return singles, repeats


class Repeats(NamedTuple):
    """The mean and the variance of repeated runs of one case, in one column."""

    mean: float
    variance: float
    run_count: int
    length: float = 0.0  # of the longest run, in the column that noise grows with

    def variance_at(
        self, value: float, length: float | None, is_cost: bool = False
    ) -> float:
        """Return the variance of one run, which grows with its number and its length.

        The noise of a cost is in proportion to it, so that of a smaller one is smaller.
        """
        scale = abs(value / self.mean) if self.mean else 1.0
        least = 0.0 if is_cost else 1.0
        longer = (length or 0.0) / self.length if self.length else least
        return self.variance * max(least, scale, longer) ** 2


def repeats_of(rows: Iterable[Cells], columns: Schema) -> Repeated:
    """Return the repeats of each case that ``of`` names, by case and column."""
    repeats: dict[str, dict[str, Repeats]] = {}
    for case, runs in grouped((row["of"], row) for row in rows if "of" in row).items():
        repeats[case] = {}
        for column in filter(scatters, map(columns.__getitem__, runs[0])):
            cells = [row.get(column.name) for row in runs]
            finite = [cell for cell in cells if is_number(cell)]
            if len(finite) > 1:
                numbers = fenced(finite)
                length = max(row.get(column.grows_with) or 0.0 for row in runs)
                repeats[case][column.name] = Repeats(
                    mean=fmean(numbers),
                    variance=variance_of(numbers),
                    run_count=len(numbers),
                    length=length,
                )
    return repeats


class Several(NamedTuple):
    """A number that was measured several times."""

    value: float | int  # the mean, with outliers moved in
    samples: Sequence[float | None]  # by measurement, None if it lacks the number
    total: int  # count of the measurements that have the number
    dissent: int = 0  # count of outliers among them


@dataclass(frozen=True)
class Evidence:
    """The measurements of a section, and the scatter of its numbers."""

    count: int = 1  # of measurements of the section
    numbers: Mapping[CellKey, Several] = field(default_factory=dict)
    scatters: Mapping[ColumnKey, Scatter] = field(default_factory=dict)
    repeats: Repeated = field(default_factory=dict)  # of the section on noise
    edges: frozenset[RowKey] = (
        frozenset()
    )  # rows that end in one of two ways, by chance
    odd_rows: float | None = None
    """The expected number of rows in one measurement that end differently from all
    others although nothing changed. It is None if no measurement was repeated.
    """
    host: tuple[float, float] = (HOST_SHARE**2, HOST_FREEDOM)
    """The relative variance of times between hosts, and its degrees of freedom."""
    changed: Sequence[tuple[int, int]] = ()
    """For each measurement: the count of its numbers, and the count of those that differ
    from the other measurements beyond noise. Nothing changed, so these are false alarms."""

    def estimate(self, name: str, row: Cells, columns: Schema) -> Estimate | None:
        """Return the estimate of a number, or None if its scatter is not known."""
        value = columns.number_of(name, row)
        column = columns[name]
        if value is None:
            return None
        if column.trials and (trials := row.get(column.trials)):
            return _of_trials(column, row, trials)
        if column.is_exact:
            return Estimate(value)
        key = key_of(row, columns)
        column_key = column_key_of(name, row, columns)
        if several := self.numbers.get((key, name)):
            return self._by_measurements(several, column, key, column_key)
        scatter = self.scatters.get(column_key)
        # A count is exact unless several measurements of its row show otherwise.
        if isinstance(value, int) and not (scatter and scatter.varies(key)):
            return Estimate(value)
        if scatter:
            variance, freedom = scatter.of(key, abs(value))
            return Estimate(
                value,
                variance,
                freedom,
                samples=(value,),
                is_shared=is_absolute(column),
            )
        if estimate := _by_itself(column, row):
            return estimate
        repeating = columns.settings.repeating.items()
        rounding = 0.0 if column.is_cost else REPEATED_SHARE * abs(value)
        repeats = any(row.get(engine) in cells for engine, cells in repeating)
        if repeats and not column.is_cost:
            return Estimate(value, least=rounding, samples=(value,))
        return self._by_repeats(column, row, rounding)

    def means(self) -> dict[tuple[str, str], Estimate]:
        """Return the estimates of the means over runs of one case, by case and column."""
        means = {}
        for case, columns in self.repeats.items():
            for name, runs in columns.items():
                key = (MEAN, case, name)
                several = self.numbers.get((key, name))
                scatter = self.scatters.get((MEAN, name))
                if several and scatter:
                    variance, freedom = scatter.of(key, abs(several.value))
                    estimate = Estimate(
                        several.value,
                        variance,
                        freedom,
                        count=several.total,
                        samples=several.samples,
                    )
                else:
                    estimate = Estimate(
                        runs.mean,
                        runs.variance,
                        freedom=runs.run_count - 1,
                        count=runs.run_count,
                    )
                means[case, name] = estimate
        return means

    def _by_measurements(
        self, several: Several, column: Column, key: RowKey, column_key: ColumnKey
    ) -> Estimate:
        value = several.value
        present = [sample for sample in several.samples if sample is not None]
        reach = max(abs(sample - value) for sample in present)
        common: dict[str, Any] = {
            "count": several.total,
            "samples": several.samples,
            "dissent": several.dissent,
            "is_shared": is_absolute(column),
        }
        if key in self.edges and reach:
            return Estimate(value, least=reach, **common, is_edge=True)
        # Measurements that agree on a count, or on zero, leave no doubt.
        if not reach and not (isinstance(value, float) and value):
            return Estimate(value, **common)
        scatter = self.scatters[column_key]
        return Estimate(value, *scatter.of(key, abs(value), several.total), **common)

    def _by_repeats(
        self, column: Column, row: Cells, rounding: float
    ) -> Estimate | None:
        """Return an estimate with the noise of the noisiest runs of one case."""
        value = row[column.name]
        length = row.get(column.grows_with)
        cases = [
            case[column.name] for case in self.repeats.values() if column.name in case
        ]
        if not cases:
            return None
        variances = [
            repeats.variance_at(value, length, column.is_cost) for repeats in cases
        ]
        variance = max(variances)
        noisiest = cases[variances.index(variance)]
        least = column.resolution or (0.0 if variance else rounding)
        if not (variance or least):
            return None
        freedom = noisiest.run_count - 1
        return Estimate(value, variance, freedom, least=least, samples=(value,))


def _of_trials(column: Column, row: Cells, trials: float) -> Estimate:
    """Return an estimate of a number, or share, of trials that succeeded."""
    value = row[column.name]
    scale = trials if column.name.endswith("_count") else 1
    deviation = scale * binomial_noise(value / scale, trials) / Z
    return Estimate(value, deviation**2, samples=(value,))


def _by_itself(column: Column, row: Cells) -> Estimate | None:
    """Return an estimate with the noise that the row itself states, or None."""
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
    if not is_absolute(column):
        return Estimate(value, deviation**2, count=count, samples=(value,))
    variance = deviation**2 / count + (HOST_SHARE * value) ** 2
    return Estimate(value, variance, HOST_FREEDOM, samples=(value,), is_shared=True)


def ending_of(row: Cells, columns: Schema) -> tuple[Any, ...]:
    """Return how the run of a row ended: whether it failed, and its cells with text."""
    texts = frozenset(
        (name, cell)
        for name, cell in row.items()
        if isinstance(cell, str | bool) and name != "case" and not name.endswith(REASON)
    )
    return is_lost(row, columns), texts
