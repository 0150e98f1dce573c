"""Scatter: the variance between measurements of a number, estimated from all editions.

The numbers of a column in a section scatter alike. Each row has a variance of its own,
from the measurements of that row in every edition; it is shrunk towards the variance of
its column by a strength that the variances themselves show: Smyth (2004), Statistical
Applications in Genetics and Molecular Biology 3, article 3. A row that was never measured
twice has the variance of its column. Outliers do not count for other rows and keep their
own variance: Phipson et al. (2016), Annals of Applied Statistics 10, 946-963.
"""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import brentq
from scipy.special import digamma, fdtrc, ndtri, polygamma

from measured_report.values.noise import (
    OUTLIER,
    ROUNDED_SHARE,
    TO_DEVIATION,
    Scatter,
)

Array = Any  # an array of NumPy's
MOST_FREEDOM = 100.0  # strength of a column whose variances differ by chance alone
USUAL_FREEDOM = 4.0  # chosen: the strength of a column with too few rows to tell
USUAL_ROWS = (
    8  # chosen: how many rows of a column that usual strength weighs as much as
)
LEAST_ROWS = 3  # fewer rows do not show how a column scatters
WILD = 3.3
"""Chosen: a row whose variance exceeds its column's by so many normal deviations keeps
its own."""
SLOPES = (2.0, 1.0, 0.0)
"""The powers of a number's size that its variance may go with: noise in proportion to it,
to its root, or the same for all."""
CLEARLY = 1.25  # chosen: by how much less the variances scatter with another slope
QUIET_SHARE = 0.1  # chosen: below this share of rows that scatter, the others do not


@dataclass(frozen=True)
class Fit:
    """Holds the numbers of a column in a section, a line for each, and their scatter."""

    scatter: Scatter
    fenced: Array  # by number and measurement, outliers moved in
    apart: Array  # the same: whether it is an outlier

    @cached_property
    def values(self) -> Array:
        """Return the mean of each number."""
        return np.nanmean(self.fenced, axis=1)


def prior_of(
    variances: Array, freedoms: Array, sizes: Array, slopes: Sequence[float] = SLOPES
) -> Scatter:
    """Fit the variances of a column, all above 0, by the distribution of their logarithms.

    The first of the slopes is taken unless the logarithms scatter clearly less with
    another one.
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
    if excess > polygamma(1, MOST_FREEDOM / 2):
        freedom = 2 * brentq(lambda half: polygamma(1, half) - excess, 1e-3, 1e6)
    level = np.exp(residuals.mean() + digamma(freedom / 2) - np.log(freedom / 2))
    return Scatter(float(level), slope, freedom)


def fit_of(
    samples: Array,
    rows: Sequence[Hashable],
    general: Scatter | None = None,
    slopes: Sequence[float] = SLOPES,
) -> Fit | None:
    """Fit the numbers of a column in a section; None if nothing shows how they scatter.

    Args:
        samples: by number and measurement, NaN where there is none.
        rows: the row of each number; a row occurs once for each edition that has it.
        general: the scatter of the same column in all sections, for one with few rows.
        slopes: by which powers of a number's size its variance may go.
    """
    counts = (~np.isnan(samples)).sum(axis=1)
    medians = _medians(samples)
    sizes = np.maximum(abs(medians), 1e-12)
    prior = _column_scatter(samples, counts, sizes, slopes) or general
    if prior is None:
        return None
    floors = (ROUNDED_SHARE * sizes) ** 2 / 12
    usual = np.maximum(prior.level * sizes**prior.slope, floors)
    off = samples - medians[:, None]
    deviations = TO_DEVIATION * _medians(abs(off))
    reach = OUTLIER * np.maximum(deviations, np.sqrt(usual))
    reach = np.where(counts > 2, reach, np.inf)[:, None]
    fenced = medians[:, None] + np.clip(off, -reach, reach)
    scatter = _with_rows(prior, fenced, counts, sizes, rows)
    return Fit(scatter, fenced, abs(off) > reach)


def _medians(samples: Array) -> Array:
    """Return the median of each row, NaN left out; NumPy's own takes ten times as long."""
    ranked = np.sort(samples, axis=1)  # NaN comes last
    counts = (~np.isnan(samples)).sum(axis=1)
    places = np.arange(len(samples))
    return (ranked[places, (counts - 1) // 2] + ranked[places, counts // 2]) / 2


def _column_scatter(
    samples: Array, counts: Array, sizes: Array, slopes: Sequence[float]
) -> Scatter | None:
    """Fit the scatter of a column by the numbers that were measured more than once."""
    again = counts > 1
    if again.sum() < LEAST_ROWS:
        return None
    variances = np.nanvar(samples[again], axis=1, ddof=1)
    sizes = sizes[again]
    floors = (ROUNDED_SHARE * sizes) ** 2 / 12
    moves = variances > 1e-3 * floors
    if moves.sum() < LEAST_ROWS or moves.mean() < QUIET_SHARE:
        return Scatter(ROUNDED_SHARE**2 / 12, 2.0, USUAL_FREEDOM)
    variances = np.maximum(variances, floors)[moves]
    return prior_of(variances, counts[again][moves] - 1.0, sizes[moves], slopes)


def _with_rows(
    prior: Scatter,
    samples: Array,
    counts: Array,
    sizes: Array,
    rows: Sequence[Hashable],
) -> Scatter:
    """Return the scatter with the level of each row that was measured more than once."""
    sums: dict[Hashable, list[float]] = {}
    again = counts > 1
    variances = np.full(len(samples), np.nan)
    variances[again] = np.nanvar(samples[again], axis=1, ddof=1)
    for index in np.flatnonzero(again):
        freedom = counts[index] - 1.0
        level = variances[index] / sizes[index] ** prior.slope
        entry = sums.setdefault(rows[index], [0.0, 0.0])
        entry[0] += freedom * level
        entry[1] += freedom
    levels = {}
    for row, (weighted, freedom) in sums.items():
        lent = prior.freedom
        ratio = weighted / freedom / prior.level
        if -ndtri(fdtrc(freedom, prior.freedom, ratio)) > WILD:
            lent = 0.0
        level = (lent * prior.level + weighted) / (lent + freedom)
        levels[row] = level, lent + freedom
    return Scatter(prior.level, prior.slope, prior.freedom, levels)


class LeftOut(NamedTuple):
    """Holds each measurement as the others predict it, by number and measurement."""

    distances: Array  # from the mean of the others; NaN if that cannot be tested
    errors: Array  # standard errors of those
    freedoms: Array


def left_out(samples: Array, rows: Sequence[Hashable], fit: Fit) -> LeftOut:
    """Leave out each measurement in turn and predict it from the others.

    What it adds to the variance of its row is left out with it; what the column lends to
    that row stays as it is.
    """
    known = [fit.scatter.rows.get(row, (np.nan, np.nan)) for row in rows]
    levels, freedoms = np.array(known).T[:, :, None]
    counts = (~np.isnan(samples)).sum(axis=1)[:, None]
    means = fit.values[:, None]
    sizes = np.maximum(abs(means), 1e-12)
    shapes = sizes**fit.scatter.slope
    floors = (ROUNDED_SHARE * sizes) ** 2 / 12
    with np.errstate(invalid="ignore", divide="ignore"):
        own = (fit.fenced - means) ** 2 * counts / (counts - 1)
        left = np.broadcast_to(freedoms - 1, samples.shape)
        variances = (levels * freedoms - own / shapes) / left * shapes
        errors = np.sqrt(np.maximum(variances, floors) * counts / (counts - 1))
        others = (counts * means - fit.fenced) / (counts - 1)
        distances = abs(samples - others) - ROUNDED_SHARE * sizes
    # Little is left that shows how a row scatters if its column lends nothing.
    is_tested = ~np.isnan(samples) & (counts > 1) & (left >= 0.5)
    return LeftOut(np.where(is_tested, np.maximum(distances, 0), np.nan), errors, left)
