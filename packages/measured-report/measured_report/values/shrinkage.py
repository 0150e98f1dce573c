"""Shrinkage: what the variances of a column's numbers, each known by few measurements, say of each other.

A number's own variance counts together with its column's, on the scale of the number, by a strength that the variances
themselves show: Smyth (2004), Statistical Applications in Genetics and Molecular Biology 3, article 3. Outliers do not
count for the others and keep their own: Phipson et al. (2016), Annals of Applied Statistics 10, 946-963.
"""

from typing import Any, NamedTuple

import numpy as np

from measured_report.values.noise import MOST_T, ROUNDED_SHARE, deviations_of

Array = Any  # an array of NumPy's, of which the types say nothing that a reader needs
MOST_FREEDOM = 100.0  # strength of a column whose variances differ by chance alone
USUAL_FREEDOM, USUAL_ROWS = 4.0, 8
"""Chosen: the strength of a column without rows, and of how many rows it is worth as much as what theirs show."""
LEAST_ROWS = 3  # fewer rows are no column
WILD = 3.3  # chosen: a variance so many normal deviations above its column's is none of that


def digamma(x: Array | float) -> Array:
    """Return the derivative of ln Γ: Abramowitz and Stegun (1964), 6.3.5 and 6.3.18."""
    x = np.asarray(x, float)
    below = 0.0
    for _ in range(6):
        below = below + 1 / x
        x = x + 1
    square = 1 / x**2
    return (
        np.log(x)
        - 1 / (2 * x)
        - square * (1 / 12 - square * (1 / 120 - square / 252))
        - below
    )


def trigamma(x: Array | float) -> Array:
    """Return the second derivative of ln Γ: Abramowitz and Stegun (1964), 6.4.6 and 6.4.12."""
    x = np.asarray(x, float)
    below = 0.0
    for _ in range(6):
        below = below + 1 / x**2
        x = x + 1
    square = 1 / x**2
    return (
        1 / x
        + square / 2
        + square / x * (1 / 6 - square * (1 / 30 - square / 42))
        + below
    )


def trigamma_inverse(y: float) -> float:
    """Return x of which ``y`` is the trigamma, which falls: by halving, in logarithms."""
    low = np.log(1e-3)
    high = np.log(1e6)
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if trigamma(np.exp(middle)) > y else (low, middle)
    return float(np.exp(low))


class Prior(NamedTuple):
    """Hold what a column says of a number's variance before it was measured twice."""

    level: float
    slope: float  # the power of a number's size that its variance goes with: 2 for noise in proportion to it
    freedom: float


def prior_of(variances: Array, freedoms: Array, sizes: Array) -> Prior:
    """Fit a column's variances, all above 0: their logarithms less what the degrees of freedom alone make of them."""
    logs = np.log(variances) - digamma(freedoms / 2) + np.log(freedoms / 2)
    fits = ((slope, logs - slope * np.log(sizes)) for slope in (2.0, 1.0, 0.0))
    slope, residuals = min(
        fits, key=lambda fit: np.ptp(np.quantile(fit[1], [0.25, 0.75]))
    )
    low, high = np.quantile(residuals, [0.25, 0.75])
    residuals = np.minimum(residuals, high + 1.5 * (high - low))  # Tukey's fence
    by_chance = trigamma(freedoms / 2).mean()
    usual = USUAL_ROWS * (by_chance + trigamma(USUAL_FREEDOM / 2))
    unlike = (((residuals - residuals.mean()) ** 2).sum() + usual) / (
        len(residuals) - 1 + USUAL_ROWS
    ) - by_chance
    freedom = (
        MOST_FREEDOM
        if unlike <= trigamma(MOST_FREEDOM / 2)
        else 2 * trigamma_inverse(unlike)
    )
    return Prior(
        float(np.exp(residuals.mean() + digamma(freedom / 2) - np.log(freedom / 2))),
        slope,
        freedom,
    )


class Moderated(NamedTuple):
    """Hold how the numbers of a column scatter, by row: one measurement of each."""

    variances: Array
    freedoms: Array
    lent: Array  # degrees of freedom that are the column's; none where a row is none of it
    common: Array  # the column's variance on the scale of each number


def moderated(
    variances: Array, freedoms: Array, sizes: Array, usual: float = 0.0
) -> Moderated:
    """Shrink variances towards their column's; those of few rows towards the ``usual`` one, where there is such."""
    floors = (ROUNDED_SHARE * sizes) ** 2 / 12
    clipped = np.maximum(variances, floors)
    scatters = variances > 1e-3 * floors
    if scatters.sum() < LEAST_ROWS:
        lent = np.full_like(clipped, USUAL_FREEDOM * bool(usual))
        common = np.full_like(clipped, usual) if usual else clipped
        return Moderated(
            (lent * common + freedoms * clipped) / (lent + freedoms),
            lent + freedoms,
            lent,
            common,
        )
    prior = prior_of(clipped[scatters], freedoms[scatters], sizes[scatters])
    # Where most agree to the last bit, those that do are not of the few that don't.
    common = np.where(
        ~scatters & (scatters.mean() < 0.5), floors, prior.level * sizes**prior.slope
    )
    lent = np.where(
        _deviations(clipped / common, freedoms, prior.freedom) > WILD,
        0.0,
        prior.freedom,
    )
    together = (lent * common + freedoms * variances) / (lent + freedoms)
    return Moderated(np.maximum(together, floors), lent + freedoms, lent, common)


def _deviations(ratios: Array, freedoms: Array, freedom: float) -> Array:
    """Return normal deviations as rare as these ratios of two variances: Paulson (1942), Ann. Math. Stat. 13, 233."""
    above = 2 / (9 * freedoms)
    below = 2 / (9 * freedom)
    root = np.cbrt(ratios)
    return ((1 - below) * root - (1 - above)) / np.sqrt(below * root**2 + above)


def left_out(samples: Array, lent: Array, common: Array, least: Array) -> Array:
    """Return how far each number is from the mean of its row's others, in normal deviations; NaN with fewer than two.

    The ``samples`` are by row and measurement, NaN where there is none; all else is by row: degrees of freedom that are
    ``lent`` by the column, its ``common`` variance, and ``least``, the differences that count as none.
    """
    present = ~np.isnan(samples)
    count = np.maximum(present.sum(axis=1, keepdims=True), 2)
    mean = np.nansum(samples, axis=1, keepdims=True) / count
    off = np.where(present, samples - mean, 0.0)
    remainder = np.maximum(
        (off**2).sum(axis=1, keepdims=True) - off**2 * count / (count - 1), 0.0
    )
    freedoms = count - 2 + lent[:, None]
    variances = (remainder + lent[:, None] * common[:, None]) / np.maximum(
        freedoms, 1.0
    )
    errors = np.sqrt(
        np.maximum(variances, (ROUNDED_SHARE * mean) ** 2 / 12) * count / (count - 1)
    )
    distance = np.maximum(0.0, abs(off) * count / (count - 1) - least[:, None])
    t = np.minimum(
        distance
        / np.where(errors > 0, errors, np.where(distance > 0, distance / MOST_T, 1.0)),
        MOST_T,
    )
    return np.where(
        present & (count > 2), deviations_of(t, np.maximum(freedoms, 1.0)), np.nan
    )
