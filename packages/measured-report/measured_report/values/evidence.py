"""Evidence: what all measurements of an edition say of its numbers.

A measurement gives the truth with errors of its host and card, of its process and of its
run. A number that was measured several times has the mean of its measurements; how much
they scatter is known from all editions, see ``scatter.py``. A number of which nothing was
ever measured twice has the scatter of the runs of one case, or of its own repeats.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from statistics import NormalDist, fmean
from typing import Any, NamedTuple

from measured_report.files.columns import REASON, Column, Schema, is_number
from measured_report.files.errors import ReportError
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
"""Chosen: by how much a number that repeats to the last bit on one machine may differ on
another, by rounding."""
HOST_SHARE = 0.03
"""Chosen: the deviation of a time between hosts and cards if none was measured twice; it
was 0.5 to 5 % between ten hosts with one kind of card."""
HOST_FREEDOM = 4.0  # chosen: degrees of freedom of that
EDGES = ("_p5", "_p95")  # columns with the spread of the numbers that a median is of
MEDIAN = math.sqrt(
    math.pi / 2
)  # the error of the median of many, over that of their mean
MEAN = "mean of"  # begins the key of a mean of runs of one case
Key = tuple[Any, ...]
Cells = Mapping[str, Any]
Number = tuple[Key, str]  # the row and the column of a number
Place = tuple[Any, ...]  # a column of a section and the engine that its rows ran on
Repeated = Mapping[str, Mapping[str, "Repeats"]]  # runs of one case, by case and column


def is_lost(row: Cells, columns: Schema) -> bool:
    """Return whether the run of a row failed, so that its numbers are chance."""
    return any(row[name] for name in row if "failure" in columns[name].kinds)


def is_absolute(column: Column) -> bool:
    """Return whether a column has times or rates, which depend on the host and card."""
    return column.is_cost and (column.unit not in ("1", "B") or bool(column.rate_of))


def scatters(column: Column) -> bool:
    """Return whether measurements of a column differ by chance and are compared."""
    is_ignored = column.is_exact or "uncompared" in column.kinds
    return not (is_ignored or column.name.endswith(EDGES))


def key_of(row: Cells, columns: Schema) -> Key:
    """Return the cells that tell a row from the others of its section."""
    return tuple(row.get(name) for name in columns.settings.changes.keys)


def place_of(name: str, row: Cells, columns: Schema) -> Place:
    """Return the column and the engine of a number, which scatters as others there do."""
    return name, *(row.get(engine) for engine in columns.settings.repeating)


class Repeats(NamedTuple):
    """Holds what runs of one case of one measurement say of a column."""

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
            finite = [cell for cell in cells if is_number(cell)]
            if len(finite) > 1:
                numbers = fenced(finite)
                length = max(row.get(column.grows_with) or 0.0 for row in runs)
                found = fmean(numbers), variance_of(numbers), len(numbers), length
                repeats[case][column.name] = Repeats(*found)
    return repeats


class Several(NamedTuple):
    """Holds what several measurements of a number say."""

    value: float | int
    samples: Sequence[float | None]
    total: int  # of measurements that have it
    dissent: int = 0


@dataclass(frozen=True)
class Evidence:
    """Holds what all measurements of a section say of its numbers."""

    count: int = 1  # of measurements of the section
    numbers: Mapping[Number, Several] = field(default_factory=dict)
    """What was measured several times."""
    scatters: Mapping[Place, Scatter] = field(default_factory=dict)
    repeats: Repeated = field(default_factory=dict)  # of the section on noise
    edges: frozenset[Key] = frozenset()  # rows that end in one of two ways, by chance
    odd_rows: float | None = None
    """How many rows of one measurement end unlike all others though nothing changed; None
    if no measurement was repeated."""
    host: tuple[float, float] = (HOST_SHARE**2, HOST_FREEDOM)
    """The relative variance of times between hosts, and its degrees of freedom."""
    changed: Sequence[tuple[int, int]] = ()
    """By measurement: how many numbers it has, and how many seem to have changed beside
    the others, though nothing changed."""

    def estimate(self, name: str, row: Cells, columns: Schema) -> Estimate | None:
        """Return what is known of a number; None if its scatter is not known."""
        value = row[name]
        column = columns[name]
        if value is None:
            return None
        if column.trials and (trials := row.get(column.trials)):
            return _of_trials(column, row, trials)
        if column.is_exact:
            return Estimate(value)
        key = key_of(row, columns)
        place = place_of(name, row, columns)
        if several := self.numbers.get((key, name)):
            return self._by_measurements(several, column, key, place)
        if isinstance(value, int):
            return Estimate(value)
        if scatter := self.scatters.get(place):
            variance, freedom = scatter.of(key, abs(value))
            is_shared = is_absolute(column)
            samples = (value,)
            return Estimate(
                value, variance, freedom, samples=samples, is_shared=is_shared
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
        """Return what is known of means of runs of one case, by case and column."""
        means = {}
        for case, columns in self.repeats.items():
            for name, runs in columns.items():
                key = (MEAN, case, name)
                several = self.numbers.get((key, name))
                scatter = self.scatters.get((MEAN, name))
                if several and scatter:
                    value = several.value
                    known = scatter.of(key, abs(value))
                    estimate = Estimate(value, *known, several.total)
                    estimate = estimate._replace(samples=several.samples)
                else:
                    freedom = runs.run_count - 1
                    estimate = Estimate(
                        runs.mean, runs.variance, freedom, runs.run_count
                    )
                means[case, name] = estimate
        return means

    def _by_measurements(
        self, several: Several, column: Column, key: Key, place: Place
    ) -> Estimate:
        value = several.value
        present = [sample for sample in several.samples if sample is not None]
        reach = max(abs(sample - value) for sample in present)
        is_shared = is_absolute(column)
        common: dict[str, Any] = {
            "count": several.total,
            "samples": several.samples,
            "dissent": several.dissent,
            "is_shared": is_shared,
        }
        if key in self.edges and reach:
            return Estimate(value, least=reach, **common, is_edge=True)
        # Measurements that agree on a count, or on zero, leave no doubt.
        if not reach and not (isinstance(value, float) and value):
            return Estimate(value, **common)
        scatter = self.scatters.get(place)
        if scatter is None:
            freedom = several.total - 1
            variance = variance_of(present) if freedom else 0.0
            return Estimate(value, variance, freedom, **common)
        return Estimate(value, *scatter.of(key, abs(value)), **common)

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


def _of_trials(column: Column, row: Cells, trials: float) -> Estimate:
    """Return an estimate of a number, or share, of trials that succeeded."""
    value = row[column.name]
    scale = trials if column.name.endswith("_count") else 1
    if not 0 <= value <= scale:
        given = f"{column.name} {value:g}, with {column.trials} {trials:g}"
        raise ReportError(f"{row['case']} has {given}")
    deviation = scale * binomial_noise(value / scale, trials) / Z
    return Estimate(value, deviation**2, samples=(value,))


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
    if not is_absolute(column):
        return Estimate(value, deviation**2, count=count, samples=(value,))
    variance = deviation**2 / count + (HOST_SHARE * value) ** 2
    return Estimate(value, variance, HOST_FREEDOM, samples=(value,), is_shared=True)


def ending_of(row: Cells, columns: Schema) -> tuple[Any, ...]:
    """Return how the run of a row ended: whether it failed, and what it says in words."""
    texts = frozenset(
        (name, cell)
        for name, cell in row.items()
        if isinstance(cell, str | bool) and name != "case" and not name.endswith(REASON)
    )
    return is_lost(row, columns), texts
