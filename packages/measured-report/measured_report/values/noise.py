"""Noise: when two values differ at all."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from statistics import NormalDist, fmean, stdev
from typing import Any

from measured_report.files.config import config
from measured_report.records.columns import column_of

NOISE = config().noise_section
"""The section whose rows are runs of one and the same case, as ``of`` says."""
ROUNDING_SHARE = 1e-3
"""Chosen: no difference smaller than this share of a value is one, however well a release repeats itself."""
EDGES = ("_p5", "_p95")
"""Ends of columns that say how far the numbers spread of which a column has the median."""
MEDIAN = 1.25
"""Ratio of the spreads of the median of n numbers and of their mean, which does by 1/√n of theirs: √(π/2), for many."""
TIMES = ("s", "ms")
PAIRS = 0.999
"""Chosen: so many of all pairs of runs of one case differ by no more than the noise, of hundreds that are compared."""
CONFIDENCE = 0.95
"""Chosen: how sure that is, for a spread that was measured with as many runs."""
LEAST_RUNS = 4
"""With fewer their spread says too little."""


def is_beyond(noise: float, before: float, after: float) -> bool:
    """Tell whether two values differ by more than noise, and than rounding, as another order of sums may make."""
    return abs(after - before) > max(noise, ROUNDING_SHARE * max(abs(before), abs(after)))


def tolerance(values: Sequence[float]) -> float:
    """Bound how far apart two runs of one case come out: ``PAIRS`` of all pairs do by no more, with ``CONFIDENCE``.

    A difference of two runs scatters normally by √2 σ, and σ is at most s √(ν / χ²), by the confidence interval of a
    standard deviation (NIST/SEMATECH e-Handbook of Statistical Methods, 7.2.3.1), with χ² at ν degrees of freedom by
    Wilson and Hilferty (1931). It is never less than the largest difference between the values themselves.
    """
    seen = max(values) - min(values)
    if len(values) < LEAST_RUNS or not seen:
        return seen
    normal, freedom = NormalDist(), len(values) - 1
    part = 2 / (9 * freedom)
    chi_squared = freedom * (1 - part + normal.inv_cdf(1 - CONFIDENCE) * math.sqrt(part)) ** 3
    deviation = stdev(values) * math.sqrt(freedom / chi_squared)
    return max(seen, math.sqrt(2) * normal.inv_cdf((1 + PAIRS) / 2) * deviation)


def binomial_noise(share: float, trials: float) -> float:
    """Bound how far apart shares of successes of two times so many trials come out, one of them ``share``.

    Either is off by no more than its interval is wide on the wider side, and both are independent, as in Newcombe
    (1998), Statistics in Medicine 17, 873-890, method 10. The interval is Wilson's (1927), Journal of the American
    Statistical Association 22, 209-212, with ``CONFIDENCE``.
    """
    z2 = NormalDist().inv_cdf((1 + CONFIDENCE) / 2) ** 2
    middle = (share + z2 / (2 * trials)) / (1 + z2 / trials)
    half = math.sqrt(z2 * (share * (1 - share) / trials + z2 / (4 * trials**2))) / (1 + z2 / trials)
    return math.sqrt(2) * (abs(share - middle) + half)


@dataclass(frozen=True)
class Floor:
    """Bounds how far apart runs of one case come out in one column."""

    spread: float
    magnitude: float
    """The largest mean of such runs; larger values are taken to be noisier in proportion."""
    length: float = 0.0
    """Length of the longest of them, in the column that it grows with; 0 where it does not."""

    def at(self, *values: float, length: float | None = None) -> float:
        """Return the noise of such values, of a run of that length."""
        scale = max(map(abs, values)) / self.magnitude if self.magnitude else 1.0
        longer = (length or 0.0) / self.length if self.length else 1.0
        return self.spread * max(1.0, scale, longer)


def is_lost(row: Mapping[str, Any]) -> bool:
    """Tell whether the run of a row was lost, which makes its numbers chance."""
    return any(row[name] for name in row if "loss" in column_of(name).kinds)


def is_repeated(column: str, row: Mapping[str, Any]) -> bool:
    """Tell whether an engine repeats this number of a row to the last bit."""
    told = any(row.get(name) in said for name, said in config().repeating.items())
    return told and column_of(column).unit not in TIMES


def cell_noise(column: str, row: Mapping[str, Any], floors: Mapping[str, Floor]) -> float | None:
    """Return the noise of a number in ``row``, in its unit; None where nobody measured it."""
    value, about = row[column], column_of(column)
    timed = about.rate_of or column
    if value is None:
        return None
    if trials := row.get(about.trials):
        count = trials if column.endswith("_count") else 1
        return binomial_noise(value / count, trials) * count
    if about.is_exact or isinstance(value, int):
        return 0.0
    if seen := row.get(about.known_within):
        return abs(seen * value)
    low, high = (row.get(timed + edge) for edge in EDGES)
    if low is not None and high is not None and row.get(timed):
        share = MEDIAN * (high - low) / math.sqrt(max(1, row.get("repeat_count") or 1)) / row[timed]
        return abs(share * value)
    if column not in floors:
        return ROUNDING_SHARE * abs(value) if is_repeated(column, row) else None
    found = max(floors[column].at(value, length=row.get(about.grows_with)), about.resolution)
    return found or (None if about.unit in TIMES else ROUNDING_SHARE * abs(value))  # what repeats to the last bit


def derived_noise(
    function: Callable[..., float], values: Sequence[float], noises: Sequence[float | None]
) -> float | None:
    """Return the noise of ``function``, each source changed by its noise; None where one has none.

    Each of two runs is off by 1/√2 of the noise, and what is off independently adds in squares: a difference of two has
    the noise of one, a mean of many less. It never has less than its noisiest source gives it, nor more than all of
    them together can: the largest of many has the noise of one. What was chosen has a noise of 0.
    """
    if None in noises:
        return None
    middle, farthest = function(*values), list(values)
    changes = []
    for place, noise in enumerate(noises):
        if noise:
            ways = [values[place] + noise, values[place] - noise]
            moves = [function(*values[:place], way, *values[place + 1 :]) - middle for way in ways]
            changes.append(max(map(abs, moves)))
            farthest[place] = ways[moves.index(max(moves))]
    together = abs(function(*farthest) - middle)
    return max(max(changes, default=0.0), min(math.hypot(*changes) / math.sqrt(2.0), together))


def floors_of(rows: Iterable[Mapping[str, Any]], units: Iterable[str]) -> dict[str, Floor]:
    """Measure the noise of the columns ``units`` of one record of the section on noise."""
    runs, floors = runs_of(rows), {}
    for column in units:
        lengths = [row.get(column_of(column).grows_with) or 0.0 for rows in runs.values() for row in rows]
        cells = [[row[column] for row in rows if row.get(column) is not None] for rows in runs.values()]
        cells = [cell for cell in cells if len(cell) > 1]
        if cells:
            spread = max(tolerance(cell) for cell in cells)
            floors[column] = Floor(spread, max(abs(fmean(cell)) for cell in cells), max(lengths))
    return floors


def runs_of(rows: Iterable[Mapping[str, Any]]) -> dict[str, list[Mapping[str, Any]]]:
    """Group rows of the section on noise by the case that they are runs of, which a damaged one may not say."""
    runs: dict[str, list[Mapping[str, Any]]] = {}
    for row in rows:
        if "of" in row:
            runs.setdefault(row["of"], []).append(row)
    return runs
