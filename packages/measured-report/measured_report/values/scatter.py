"""Estimate the variance between measurements of a number from all editions.

The numbers of a column in a section scatter alike. Each row has a variance of its own,
estimated from the measurements of that row in every edition. It is shrunk towards the
variance of its column. The strength of the shrinkage is estimated from the spread of
the variances: Smyth (2004), Statistical Applications in Genetics and Molecular Biology
3, article 3. A row that was never measured twice has the variance of its column. A row
with an outlying variance keeps it, and has no influence on other rows: Phipson et al.
(2016), Annals of Applied Statistics 10, 946-963.
"""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from scipy.optimize import brentq
from scipy.special import digamma, fdtrc, ndtri, polygamma

from measured_report.values.noise import (
    OUTLIER,
    ROUNDED_SHARE,
    TO_DEVIATION,
    Scatter,
    rounding_variance,
)

Array = Any  # an array of NumPy's
MOST_FREEDOM = 100.0
"""The prior degrees of freedom of a column whose variances differ only by chance.

Smyth uses infinity, but with few rows some rows may scatter more.
"""
LEAST_FREEDOM = 0.2
"""Chosen: the fewest prior degrees of freedom. With fewer, Student's t has no finite
quantiles in double precision."""
USUAL_FREEDOM = 4.0  # chosen: the prior degrees of freedom of a column with few rows
USUAL_ROWS = 8  # chosen: the count of rows that weigh as much as that usual value
LEAST_ROWS = 3  # fewer rows do not show how a column scatters
WILD = 3.3
"""Chosen: a row keeps its own variance if it exceeds the variance of its column by more
than this many normal deviations. By chance, one row in 2,000 does.
"""
SLOPES = (2.0, 1.0, 0.0)
"""The exponents with which the variance of a number may grow with its size: its noise
is proportional to the size, proportional to its square root, or constant.
"""
CLEARLY = 1.25
"""Chosen: the factor by which the spread of the variances has to shrink with another
exponent. The first exponent is the usual one, and few rows favour others by chance."""
LEAST_SHARE = 1e-3
"""Chosen: a number below this share of the same row in another edition scatters like another
row. Its relative scatter can be huge, and does not apply to the larger number."""
QUIET_SHARE = 0.1
"""Chosen: if a smaller share of the rows scatters at all, a row that was measured once
is assumed to repeat exactly, like most of its column.
"""


@dataclass(frozen=True)
class Fit:
    """The numbers of a column in a section, a row for each, and their scatter."""

    scatter: Scatter
    fenced: Array  # by number and measurement, with outliers moved in
    is_outlier: Array  # of the same shape

    @cached_property
    def values(self) -> Array:
        """Return the mean of each number."""
        return np.nanmean(self.fenced, axis=1)


def prior_of(
    variances: Array, freedoms: Array, sizes: Array, slopes: Sequence[float] = SLOPES
) -> Scatter:
    """Fit the variances of a column, all above 0, by the distribution of their logarithms.

    The first of the slopes is used, unless the logarithms scatter clearly less with another
    one.
    """
    logs = np.log(variances) - digamma(freedoms / 2) + np.log(freedoms / 2)

    def spread(slope: float) -> float:
        quartiles = np.quantile(logs - slope * np.log(sizes), [0.25, 0.75])
        return float(np.ptp(quartiles))

    slope = min(
        slopes, key=lambda slope: spread(slope) * (1 if slope == slopes[0] else CLEARLY)
    )
    residuals = logs - slope * np.log(sizes)
    low, high = np.quantile(residuals, [0.25, 0.75])
    residuals = np.minimum(residuals, high + 1.5 * (high - low))  # Tukey's fence
    by_chance = polygamma(1, freedoms / 2).mean()
    usual = USUAL_ROWS * (by_chance + polygamma(1, USUAL_FREEDOM / 2))
    squares = ((residuals - residuals.mean()) ** 2).sum() + usual
    excess = squares / (len(residuals) - 1 + USUAL_ROWS) - by_chance
    freedom = MOST_FREEDOM
    if excess >= polygamma(1, LEAST_FREEDOM / 2):
        freedom = LEAST_FREEDOM
    elif excess > polygamma(1, MOST_FREEDOM / 2):
        freedom = 2 * brentq(lambda half: polygamma(1, half) - excess, 1e-3, 1e6)
    level = np.exp(residuals.mean() + digamma(freedom / 2) - np.log(freedom / 2))
    return Scatter(float(level), slope, float(freedom))


def fit_of(
    samples: Array,
    rows: Sequence[Hashable],
    general: Scatter | None = None,
    slopes: Sequence[float] = SLOPES,
) -> Fit | None:
    """Fit the numbers of a column in a section; None if none was measured twice.

    Args:
        samples: by number and measurement, NaN for those that are missing.
        rows: the row of each number; a row occurs once for each edition that has it.
        general: the scatter of the same column in all sections, for one with few rows.
        slopes: the exponents by which the variance of a number may grow with its size.
    """
    counts = (~np.isnan(samples)).sum(axis=1)
    medians = _medians(samples)
    sizes = np.maximum(abs(medians), 1e-12)
    prior = _column_scatter(samples, counts, sizes, slopes) or general
    is_shrunk = prior is not None
    if prior is None:
        if counts.max() < 2:
            return None
        prior = _few_rows_scatter(samples, counts, sizes)
    usual = np.maximum(prior.level * sizes**prior.slope, rounding_variance(sizes))
    distances = samples - medians[:, None]
    deviations = TO_DEVIATION * _medians(abs(distances))
    reach = OUTLIER * np.maximum(deviations, np.sqrt(usual))
    # Of two measurements, none is an outlier.
    reach = np.where(counts > 2, reach, np.inf)[:, None]
    fenced = medians[:, None] + np.clip(distances, -reach, reach)
    sizes = np.maximum(abs(np.nanmean(fenced, axis=1)), 1e-12)
    scatter = _with_rows(
        prior,
        fenced,
        counts,
        sizes,
        rows,
        is_shrunk=is_shrunk,
        is_count=np.array_equal(samples, np.round(samples), equal_nan=True),
    )
    return Fit(scatter, fenced, abs(distances) > reach)


def _medians(samples: Array) -> Array:
    """Return the median of each row without NaN.

    NumPy's own function takes ten times as long.
    """
    ranked = np.sort(samples, axis=1)  # NaN comes last
    counts = (~np.isnan(samples)).sum(axis=1)
    rows = np.arange(len(samples))
    return (ranked[rows, (counts - 1) // 2] + ranked[rows, counts // 2]) / 2


def _column_scatter(
    samples: Array, counts: Array, sizes: Array, slopes: Sequence[float]
) -> Scatter | None:
    """Fit the scatter of a column by the numbers that were measured more than once."""
    is_repeated = counts > 1
    if is_repeated.sum() < LEAST_ROWS:
        return None
    variances = np.nanvar(samples[is_repeated], axis=1, ddof=1)
    sizes = sizes[is_repeated]
    floors = rounding_variance(sizes)
    moves = variances > 1e-3 * floors
    if moves.mean() < QUIET_SHARE:
        return Scatter(rounding_variance(1.0), 2.0, USUAL_FREEDOM)
    variances = np.maximum(variances, floors)[moves]
    return prior_of(variances, counts[is_repeated][moves] - 1.0, sizes[moves], slopes)


def _few_rows_scatter(samples: Array, counts: Array, sizes: Array) -> Scatter:
    """Return the mean relative variance of the few rows that were measured repeatedly."""
    is_repeated = counts > 1
    freedoms = counts[is_repeated] - 1.0
    variances = np.nanvar(samples[is_repeated], axis=1, ddof=1)
    shares = variances / sizes[is_repeated] ** 2
    level = max(float(np.average(shares, weights=freedoms)), rounding_variance(1.0))
    return Scatter(level, 2.0, float(freedoms.sum()))


def _with_rows(
    prior: Scatter,
    samples: Array,
    counts: Array,
    sizes: Array,
    rows: Sequence[Hashable],
    *,
    is_shrunk: bool,
    is_count: bool,
) -> Scatter:
    """Return the scatter, with its own variance for each row that was measured more
    than once. If the numbers of a row are close to zero in some editions and not in
    others, these scatter separately. The variance of a row is not shrunk if its column
    has few rows, or if the row is a count on which all measurements agree.
    """
    least_sizes: dict[Hashable, float] = {}
    for row, size in zip(rows, sizes, strict=True):
        least_sizes[row] = max(least_sizes.get(row, 0.0), LEAST_SHARE * float(size))
    prior = replace(prior, least_sizes=least_sizes)
    sums: dict[Hashable, list[float]] = {}
    is_repeated = counts > 1
    variances = np.full(len(samples), np.nan)
    variances[is_repeated] = np.nanvar(samples[is_repeated], axis=1, ddof=1)
    wild: set[Hashable] = set()
    for index in np.flatnonzero(is_repeated):
        freedom = float(counts[index] - 1)
        level = float(variances[index] / sizes[index] ** prior.slope)
        key = prior.key(rows[index], sizes[index])
        entry = sums.setdefault(key, [0.0, 0.0])
        entry[0] += freedom * level
        entry[1] += freedom
        # A row that repeats well in other editions does not hide that it is wild in one.
        if _is_wild(level, freedom, prior):
            wild.add(key)
    levels = {}
    for row, (weighted, freedom) in sums.items():
        is_certain = is_count and not weighted
        is_wild = row in wild or _is_wild(weighted / freedom, freedom, prior)
        is_alike = is_shrunk and not is_certain and not is_wild
        prior_freedom = prior.freedom if is_alike else 0.0
        level = (prior_freedom * prior.level + weighted) / (prior_freedom + freedom)
        levels[row] = level, prior_freedom + freedom
    return replace(prior, rows=levels)


def _is_wild(level: float, freedom: float, prior: Scatter) -> bool:
    """Return whether a row scatters more than its column; see ``WILD``.

    This is an F test, whose probability is converted to normal deviations.
    """
    chance = fdtrc(freedom, prior.freedom, level / prior.level)
    return bool(-ndtri(chance) > WILD)


def left_out(
    samples: Array, rows: Sequence[Hashable], fit: Fit
) -> tuple[Array, Array, Array]:
    """Leave out each measurement in turn and predict it from the others.

    Return by number and measurement the distance from the mean of the others, its
    standard error, and the degrees of freedom. The distance is NaN if it cannot be
    tested.

    Its contribution to the variance of its row is left out as well. The variance of the
    column, towards which the row's variance is shrunk, does not change.
    """
    unknown = np.nan, np.nan
    keys = map(fit.scatter.key, rows, abs(fit.values))
    row_scatters = [fit.scatter.rows.get(key, unknown) for key in keys]
    levels, freedoms = np.array(row_scatters).T[:, :, None]
    counts = (~np.isnan(samples)).sum(axis=1)[:, None]
    means = fit.values[:, None]
    sizes = np.maximum(abs(means), 1e-12)
    shapes = sizes**fit.scatter.slope
    with np.errstate(invalid="ignore", divide="ignore"):
        own = (fit.fenced - means) ** 2 * counts / (counts - 1)
        remaining = np.broadcast_to(freedoms - 1, samples.shape)
        variances = (levels * freedoms - own / shapes) / remaining * shapes
        variances = np.maximum(variances, rounding_variance(sizes))
        errors = np.sqrt(variances * counts / (counts - 1))
        means_of_others = (counts * means - fit.fenced) / (counts - 1)
        distances = abs(samples - means_of_others) - ROUNDED_SHARE * sizes
    # Without half a degree of freedom, the variance of the others is hardly known.
    is_tested = ~np.isnan(samples) & (counts > 1) & (remaining >= 0.5)
    distances = np.where(is_tested, np.maximum(distances, 0), np.nan)
    return distances, errors, remaining
