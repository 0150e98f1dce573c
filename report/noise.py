"""Noise: when two values differ at all, and which way is better."""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from statistics import NormalDist, fmean, stdev
from typing import Any

from report.records.record import Record

NOISE = "noise"
"""The section whose rows are runs of one and the same case, as ``of`` says."""
ROUNDING_SHARE = 1e-3
"""Chosen: no difference smaller than this share of a value is one, however well a release repeats itself."""
PAIRS = 0.999
"""Chosen: so many of all pairs of runs of one case differ by no more than the noise. The page makes hundreds of
comparisons, and the largest difference that was seen among some tens of runs is less than the largest of those."""
CONFIDENCE = 0.95
"""Chosen: how sure that is, for a spread that was measured with as many runs."""
LEAST_RUNS = 4
"""With fewer their spread says too little."""
LESS_IS_BETTER = (
    "slip_mm",
    "drift_mm_s",
    "wander_mm",
    "frame_ms",
    "mjw_step_ms",
    "dropped",
    "bytes_per_world",
    "exit_status",
)
MORE_IS_BETTER = ("frames_per_s", "realtime_factor", "world_substeps_per_s")


def verdict(column: str, before: Any, after: Any) -> str:
    """Whether going from one value to the other is better or worse; empty where the column does not say."""
    if None in (before, after) or column not in LESS_IS_BETTER + MORE_IS_BETTER:
        return ""
    grows = abs(after) > abs(before)
    return "better" if grows == (column in MORE_IS_BETTER) else "worse"


def is_beyond(noise: float, before: float, after: float) -> bool:
    """Whether two values differ by more than noise, and by more than rounding.

    A processor without parallel sums repeats itself to the last bit and has no noise, but any other order of its sums
    would then be a change.
    """
    return abs(after - before) > max(noise, ROUNDING_SHARE * max(abs(before), abs(after)))


def tolerance(values: Sequence[float]) -> float:
    """How far apart two runs of one case may come out: ``PAIRS`` of all pairs do by no more, with ``CONFIDENCE``.

    A difference of two runs scatters normally by √2 σ, and σ is at most s √(ν / χ²), by the confidence interval of a
    standard deviation (NIST/SEMATECH e-Handbook of Statistical Methods, 7.2.3.1), with χ² at ν degrees of freedom by
    Wilson and Hilferty (1931). It is never less than the largest difference between the values themselves, in whose
    unit it is.
    """
    seen = max(values) - min(values)
    if len(values) < LEAST_RUNS or not seen:
        return seen
    normal, freedom = NormalDist(), len(values) - 1
    part = 2 / (9 * freedom)
    chi_squared = freedom * (1 - part + normal.inv_cdf(1 - CONFIDENCE) * math.sqrt(part)) ** 3
    deviation = stdev(values) * math.sqrt(freedom / chi_squared)
    return max(seen, math.sqrt(2) * normal.inv_cdf((1 + PAIRS) / 2) * deviation)


@dataclass(frozen=True)
class Floor:
    """How far apart runs of one case may come out in one column."""

    spread: float
    magnitude: float
    """The largest mean of such runs; larger values are taken to be noisier in proportion."""

    def at(self, *values: float) -> float:
        """The noise of such values."""
        scale = max(map(abs, values)) / self.magnitude if self.magnitude else 1.0
        return self.spread * max(1.0, scale)


def noise_floors(records: Iterable[Record]) -> dict[str, Floor]:
    """The noise of every column that records of the section on noise have, the largest of them."""
    floors: dict[str, Floor] = {}
    for record in records:
        for column, floor in _floors_of(record).items():
            if column not in floors or floor.spread > floors[column].spread:
                floors[column] = floor
    return floors


def _floors_of(record: Record) -> dict[str, Floor]:
    runs: dict[str, list[Mapping[str, Any]]] = {}
    for row in record.rows:
        runs.setdefault(row["of"], []).append(row)
    floors = {}
    for column in record.units:
        cells = [[row[column] for row in rows if row.get(column) is not None] for rows in runs.values()]
        cells = [cell for cell in cells if len(cell) > 1]
        if cells:
            spread = max(tolerance(cell) for cell in cells)
            floors[column] = Floor(spread, max(abs(fmean(cell)) for cell in cells))
    return floors
