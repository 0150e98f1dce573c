"""Noise: how far a number may be from the truth, and whether two numbers differ, by what is known of their variances.

How far is a confidence interval of the mean of all measurements; whether is a two-sample test of all measurements of
both. Whose variance that is ``evidence.py`` says.
"""

import math
from collections.abc import Sequence
from functools import cache
from statistics import NormalDist, fmean, median
from typing import Any, NamedTuple

SURE = 0.95  # chosen: so often the truth is within a printed number's noise
FALSE_SHARE = 0.01  # chosen: so large a share of the changes that are told may be none
PAIRS, CONFIDENCE = (
    0.999,
    0.95,
)  # chosen: so many pairs of runs of one case are within the tolerance, and how surely
LEAST_RUNS = 4  # with fewer their spread says too little of a tolerance
OUTLIER, LEAST_FENCED = (
    5.0,
    6,
)  # chosen: an outlier is so many deviations from the median, and of no fewer numbers
NORMAL = NormalDist()
Z = NORMAL.inv_cdf(
    (1 + SURE) / 2
)  # deviations that `SURE` of a normal distribution is within
MOST_T, MOST_FREEDOM, TINY = 1e6, 1e9, 1e-300
WRITTEN_SHARE = 5e-4  # chosen: no number is written to a smaller share of it, however well it is known
ROUNDED_SHARE = 1e-6  # chosen: no difference is a smaller share of a number, as single precision makes of a few sums


@cache
def t_quantile(share: float, freedom: float) -> float:
    """Return Student's t that ``share`` of all lie within, by halving."""
    z = NORMAL.inv_cdf((1 + share) / 2)
    low, high = z, MOST_T  # it is never less than that of the normal distribution
    while high - low > 1e-7 * high:
        middle = math.sqrt(low * high)
        low, high = (
            (middle, high) if deviations_of(middle, freedom) < z else (low, middle)
        )
    return high


def deviations_of(t: Any, freedom: Any) -> Any:
    """Return normal deviations as rare as Student's t; of arrays too.

    Hill (1970), Algorithm 395, Communications of the ACM 13, 617-619; with fewer than two degrees of freedom, where it
    is too rare, between those of one and of two, of which the tails are known in closed form: chosen, within 1 %.
    """
    import numpy as np  # it takes long, and what is kept from before needs none of it

    freedom = np.minimum(freedom, MOST_FREEDOM)
    grown = np.log1p(t * t / freedom)
    a = np.maximum(freedom, 1.0) - 0.5
    b = 48 * a**2
    y = a * grown
    tail = (((-0.4 * y - 3.3) * y - 24) * y - 85.5) / (0.8 * y**2 + 100 + b)
    hill = np.asarray(((tail + y + 3) / b + 1) * np.sqrt(y))
    t, few = np.broadcast_arrays(t, np.maximum(freedom, 1.0))
    rare = few < 2
    if not rare.any():
        return hill
    t = t[rare]
    few = few[rare]
    root = np.hypot(t, math.sqrt(2))
    tails = np.arctan2(1, t) / math.pi, 1 / (root * (root + t))
    deviation = np.vectorize(NORMAL.inv_cdf, [float])
    with np.errstate(invalid="ignore"):  # of a number that is not there
        of_one, of_two = (-deviation(tail) for tail in tails)
    hill[rare] = of_one + (few - 1) * (6 - few) / 4 * (of_two - of_one)
    return hill


def chance_of(difference: Any, error: Any, freedom: Any) -> list[float]:
    """Tell of arrays how often two means of one truth come out so far apart or farther, by their standard error."""
    import numpy as np

    t = np.minimum(difference / np.maximum(error, difference / MOST_T + TINY), MOST_T)
    return [
        math.erfc(deviation)
        for deviation in (deviations_of(t, freedom) / math.sqrt(2)).tolist()
    ]


def discoveries(chances: Sequence[float]) -> float:
    """Return the largest chance that counts as none, by Benjamini and Hochberg (1995), J. R. Stat. Soc. B 57, 289."""
    ranked = enumerate(sorted(chances), 1)
    return max(
        (
            chance
            for rank, chance in ranked
            if chance <= FALSE_SHARE * rank / len(chances)
        ),
        default=0.0,
    )


def fenced(numbers: Sequence[float]) -> list[float]:
    """Return the numbers, an outlier moved to ``OUTLIER`` deviations from the median; where they are few, as they are.

    A deviation is 1.4826 times the median distance from the median (Hampel 1974, J. Am. Stat. Assoc. 69, 383-393).
    """
    middle = median(numbers)
    reach = OUTLIER * 1.4826 * median(abs(number - middle) for number in numbers)
    if len(numbers) < LEAST_FENCED or not reach:
        return list(numbers)
    return [min(max(number, middle - reach), middle + reach) for number in numbers]


def variance_of(numbers: Sequence[float]) -> float:
    """Return the variance of what these are a sample of."""
    mean = fmean(numbers)
    return math.fsum((number - mean) ** 2 for number in numbers) / (len(numbers) - 1)


def tolerance(numbers: Sequence[float]) -> float:
    """Bound how far apart two runs of one case come out: ``PAIRS`` of all pairs do by no more, with ``CONFIDENCE``.

    A difference of two runs scatters normally by √2 σ, and σ is at most s √(ν / χ²), by the confidence interval of a
    standard deviation (NIST/SEMATECH e-Handbook of Statistical Methods, 7.2.3.1), with χ² at ν degrees of freedom by
    Wilson and Hilferty (1931). Of fewer than ``LEAST_RUNS`` it is their largest difference.
    """
    if len(numbers) < LEAST_RUNS:
        return max(numbers) - min(numbers)
    freedom = len(numbers) - 1
    term = 2 / (9 * freedom)
    chi_squared = (
        freedom * (1 - term + NORMAL.inv_cdf(1 - CONFIDENCE) * math.sqrt(term)) ** 3
    )
    deviation = math.sqrt(variance_of(fenced(numbers)) * freedom / chi_squared)
    return math.sqrt(2) * NORMAL.inv_cdf((1 + PAIRS) / 2) * deviation


def binomial_noise(share: float, trials: float) -> float:
    """Bound how far the share of successes of so many trials is from the truth, on the wider side: with ``SURE``.

    The interval is Wilson's (1927), Journal of the American Statistical Association 22, 209-212.
    """
    middle = (share + Z**2 / (2 * trials)) / (1 + Z**2 / trials)
    half = (
        Z
        * math.sqrt(share * (1 - share) / trials + Z**2 / (4 * trials**2))
        / (1 + Z**2 / trials)
    )
    return abs(share - middle) + half


class Estimate(NamedTuple):
    """Holds what is known of a number by all that was measured of it."""

    value: float | int  # the mean of its measurements, or the number that all agree on
    variance: float = 0.0  # of one measurement
    freedom: float = math.inf  # degrees of freedom of the variance
    count: float = 1.0  # type: ignore[assignment] # of what the value is the mean of
    least: float = 0.0  # the least that it may be off, as by rounding
    samples: Sequence[float | None] = ()
    """By measurement, None where it was not measured; empty for an exact number."""
    is_of_cards: bool = False  # whether the variance has the part that cards have
    is_again: bool = False  # whether it was measured more than once
    is_edge: bool = False  # whether chance decides in which of two ways it ends

    @property
    def note(self) -> str:
        """Say what it is the mean of; nothing where it was measured once."""
        if (
            len(present := [sample for sample in self.samples if sample is not None])
            < 2
        ):
            return ""
        least = min(present)
        largest = max(present)
        several = f"{len(present)} measurements from {least:.6g} to {largest:.6g}"
        means = "mean of " if least < largest else ""
        return f"{'at an edge, where chance decides: ' if self.is_edge else means}{several}"

    @property
    def noise(self) -> float:
        """Bound how far the truth may be from the value: ``SURE``, by Student's t of the mean."""
        error = math.sqrt(self.variance / self.count)
        return (
            max(t_quantile(SURE, self.freedom) * error, self.least)
            if error
            else self.least
        )

    @property
    def written_noise(self) -> float:
        """Return the noise that sets the digits of the number; 0 for one that is exact."""
        return max(self.noise, WRITTEN_SHARE * abs(self.value)) if self.noise else 0.0


def welch(variances: Any, freedoms: Any) -> tuple[Any, Any]:
    """Return the standard errors of differences of two means, and their degrees of freedom, both in arrays.

    Welch (1947), Biometrika 34, 28-35, for variances of the means, by difference and side, that need not be the same.
    """
    import numpy as np

    total = variances.sum(axis=1)
    squared = (variances**2 / freedoms).sum(axis=1)
    return np.sqrt(total), np.where(
        squared > 0, total**2 / np.maximum(squared, TINY), math.inf
    )
