"""Compute the confidence interval of a number, and test the difference of two numbers.

A number is the mean of all its measurements. ``scatter.py`` estimates the variance that
both the interval and the test use.
"""

import math
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from statistics import NormalDist, fmean, median
from typing import Any, NamedTuple

SURE = 0.95  # chosen: the probability that the true value lies within the noise
FALSE_SHARE = 0.01  # chosen: the share of the listed changes that may be false
OUTLIER = 5.0
"""Chosen: a measurement that is more deviations away from the median of its row is moved to
this distance. A normal distribution has one such number in 1.7 million."""
LEAST_FENCED = 6  # chosen: fewer numbers do not show which of them is an outlier
NORMAL = NormalDist()
Z = NORMAL.inv_cdf((1 + SURE) / 2)
"""Half the width of the interval that contains ``SURE`` of a normal distribution [σ].
"""
TO_DEVIATION = 1.4826
"""The standard deviation of a normal distribution, divided by its median absolute
deviation."""
WRITTEN_SHARE = (
    5e-4  # chosen: no number is printed more precisely than this share of it
)
ROUNDED_SHARE = 1e-6
"""Chosen: smaller relative differences are rounding; sums in single precision have them."""


@cache
def t_quantile(share: float, freedom: float) -> float:
    """Return the t for which ``share`` of Student's distribution lies within -t to t."""
    if math.isinf(freedom):
        return NORMAL.inv_cdf((1 + share) / 2)
    from scipy.special import (
        stdtrit,
    )  # slow to import, and a cached build does not need it

    return float(stdtrit(freedom, (1 + share) / 2))


def chance_of(difference: Any, error: Any, freedom: Any) -> list[float]:
    """Return the probability that two means of one true value differ by this or more.

    All arguments are arrays: the size of the difference, its standard error, and the
    degrees of freedom of this error. If the error is 0, any difference is certain.
    """
    import numpy as np
    from scipy.special import ndtr, stdtr

    difference, error, freedom = map(np.asarray, (difference, error, freedom))
    with np.errstate(divide="ignore", invalid="ignore"):
        t = np.where(difference > 0, difference / error, 0.0)
    tails = np.where(np.isinf(freedom), ndtr(-t), stdtr(np.minimum(freedom, 1e9), -t))
    chances: list[float] = (2 * tails).tolist()
    return chances


def discoveries(chances: Sequence[float]) -> float:
    """Return the largest of these probabilities that counts as a discovery, or 0.

    The method is by Benjamini and Hochberg (1995), J. R. Stat. Soc. B 57, 289.
    """
    limit = 0.0
    for rank, chance in enumerate(sorted(chances), 1):
        if chance <= FALSE_SHARE * rank / len(chances):
            limit = chance
    return limit


def exceeds_chance(count: int, expected: float) -> bool:
    """Return whether there are more rare events than chance explains.

    Their count has Poisson's distribution. Chance alone produces as many in fewer
    than ``FALSE_SHARE`` of all comparisons.
    """
    if not count:
        return False
    from scipy.special import gammainc

    return bool(gammainc(count, expected) < FALSE_SHARE)


def exceeds_share(count: int, total: int, share: float) -> bool:
    """Return whether there are more rare events among ``total`` than their share explains.

    Their count has the binomial distribution; see ``exceeds_chance``.
    """
    from scipy.special import bdtrc

    return bool(bdtrc(count - 1, total, share) < FALSE_SHARE) if count else False


def fenced(numbers: Sequence[float]) -> list[float]:
    """Return the numbers with outliers moved to ``OUTLIER`` deviations from the median.

    A deviation is 1.4826 times the median absolute deviation (Hampel 1974, J. Am. Stat.
    Assoc. 69, 383-393). Fewer than ``LEAST_FENCED`` numbers are returned unchanged.
    """
    middle = median(numbers)
    deviation = TO_DEVIATION * median(abs(number - middle) for number in numbers)
    reach = OUTLIER * deviation
    if len(numbers) < LEAST_FENCED or not reach:
        return list(numbers)
    return [min(max(number, middle - reach), middle + reach) for number in numbers]


def variance_of(numbers: Sequence[float]) -> float:
    """Return the variance of the population, estimated from a sample."""
    mean = fmean(numbers)
    return math.fsum((number - mean) ** 2 for number in numbers) / (len(numbers) - 1)


def binomial_noise(share: float, trials: float) -> float:
    """Return the noise of an observed share of successes.

    This is the wider side of Wilson's interval (1927), J. Am. Stat. Assoc. 22, 209-212.
    """
    squared = Z**2 / trials
    middle = (share + squared / 2) / (1 + squared)
    spread = math.sqrt(share * (1 - share) / trials + squared / (4 * trials))
    return abs(share - middle) + Z * spread / (1 + squared)


def rounding_variance(size: Any) -> Any:
    """Return the variance of rounding, which is uniform within ``ROUNDED_SHARE``."""
    return (ROUNDED_SHARE * size) ** 2 / 12


@dataclass(frozen=True)
class Scatter:
    """Gives the variance of one measurement of any number of a column in a section."""

    level: float  # the variance for a number of size 1
    slope: float  # the exponent by which the variance grows with the size
    freedom: float  # degrees of freedom of the variance for a row measured once
    rows: Mapping[Hashable, tuple[float, float]] = field(default_factory=dict)
    """The level and the degrees of freedom of rows that were measured more than once."""
    least_sizes: Mapping[Hashable, float] = field(default_factory=dict)
    """The size below which the numbers of a row scatter like a row of their own."""
    shared: float = 0.0
    """The relative variance of an error that all measurements of a number share."""

    def key(self, row: Hashable, size: float) -> Hashable:
        """Return the key in ``rows`` for a number of this size."""
        return ("small", row) if size < self.least_sizes.get(row, 0.0) else row

    def varies(self, row: Hashable) -> bool:
        """Return whether measurements of this row differ."""
        level, _ = self.rows.get(row, (0.0, 0.0))
        return level > 0

    def of(self, row: Hashable, size: float, count: float = 1) -> tuple[float, float]:
        """Return the variance of one of ``count`` measurements of a number of this size.

        Also return its degrees of freedom. A mean does not reduce the shared error.
        """
        column = self.level, self.freedom
        level, freedom = self.rows.get(self.key(row, size), column)
        variance = max(level * size**self.slope, rounding_variance(size))
        return variance + count * self.shared * size**2, freedom


class Estimate(NamedTuple):
    """A number estimated from all its measurements."""

    value: float | int  # the mean of the measurements, or the number that all agree on
    variance: float = 0.0  # of one measurement
    freedom: float = math.inf  # degrees of freedom of the variance
    count: float = 1.0  # type: ignore[assignment] # of measurements in the mean
    least: float = 0.0  # the least uncertainty, for example of rounding
    samples: Sequence[float | None] = ()
    """The number by measurement, None if it is missing; empty for an exact number."""
    dissent: int = 0  # count of outliers, which hardly move the mean
    is_shared: bool = False
    """Whether all numbers of one measurement share a part of their error, as times do."""
    is_edge: bool = False  # whether chance decides in which of two ways its run ends

    @property
    def note(self) -> str:
        """Return a text that lists the measurements, or an empty one if there is only
        one.
        """
        present = [sample for sample in self.samples if sample is not None]
        if len(present) < 2:
            return ""
        least = min(present)
        largest = max(present)
        summary = f"{len(present)} measurements from {least:.6g} to {largest:.6g}"
        if self.is_edge:
            return f"chance decides how this run ends: {summary}"
        mean = "mean of " if least < largest else ""
        if self.dissent:
            agreeing = len(present) - self.dissent
            return f"{mean}{summary}; {agreeing} of them agree"
        return f"{mean}{summary}"

    @property
    def error(self) -> float:
        """Return the standard error of the value."""
        return math.sqrt(self.variance / self.count)

    @property
    def noise(self) -> float:
        """Return half the confidence interval of the value, by Student's t."""
        error = self.error
        if not error:
            return self.least
        return max(t_quantile(SURE, self.freedom) * error, self.least)

    @property
    def written_noise(self) -> float:
        """Return the noise that sets the digits of the number; 0 if it is exact."""
        noise = self.noise
        return max(noise, WRITTEN_SHARE * abs(self.value)) if noise else 0.0
