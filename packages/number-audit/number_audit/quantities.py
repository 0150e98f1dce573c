"""Computes with numbers that have a unit and noise."""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from statistics import fmean, stdev

from number_audit.files import AuditError

Z = 1.959964
"""This quantile of the normal distribution gives a confidence interval of 95 %."""

SMALL_SAMPLE_T = [
    float(quantile)
    for quantile in """
    12.7062 4.3027 3.1824 2.7764 2.5706 2.4469 2.3646 2.3060 2.2622 2.2281
    2.2010 2.1788 2.1604 2.1448 2.1314 2.1199 2.1098 2.1009 2.0930 2.0860
    2.0796 2.0739 2.0687 2.0639 2.0595 2.0555 2.0518 2.0484 2.0452 2.0423
    """.split()
]
"""Student's t gives a confidence interval of 95 %, for 1 to 30 degrees of freedom."""

SOURCE_LIMIT = 1000
"""The largest number of places that one number may be computed from."""

PREFIXES = {
    "": 1.0,
    "n": 1e-9,
    "µ": 1e-6,  # the micro sign
    "μ": 1e-6,  # the Greek letter
    "u": 1e-6,
    "m": 1e-3,
    "c": 1e-2,
    "k": 1e3,
    "K": 1e3,
    "M": 1e6,
    "G": 1e9,
    "T": 1e12,
    "Ki": 2.0**10,
    "Mi": 2.0**20,
    "Gi": 2.0**30,
    "Ti": 2.0**40,
}
BASES = "m s g N J W V A B bit Pa Hz rad".split()
UNITS = {
    prefix + base: (factor, base)
    for prefix, factor in PREFIXES.items()
    for base in BASES
}
UNITS |= {"min": (60.0, "s"), "sec": (1.0, "s"), "seconds": (1.0, "s")}
UNITS |= {"bytes": (1.0, "B")}
SUFFIXES = "|".join(UNITS.keys() - {"min"})
COUNTS = {
    "count": 1.0,
    "ratio": 1.0,
    "%": 0.01,
    "percent": 0.01,
    "k": 1e3,
    "thousand": 1e3,
}
COUNTS |= {"K": 1e3, "M": 1e6, "million": 1e6, "billion": 1e9}
UNITS |= {name: (factor, "count") for name, factor in COUNTS.items()}

NO_UNIT = "1"
PLAIN_UNITS = {"", NO_UNIT, "x", "×", "times", "count", "ratio"}
"""Units of a plain number, which need no conversion."""

NAME_WITH_UNIT = re.compile(
    rf"""
    (?P<name>.+?(?<!per))
    (_(?P<units>({SUFFIXES})(_({SUFFIXES}))?)|\s*[\[(](?P<unit>[^\s()\[\]]+)[\])])
    """,
    re.VERBOSE,
)
LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@dataclass(frozen=True)
class Quantity:
    """A number with its unit and noise."""

    value: float
    unit: str = NO_UNIT
    offsets: Mapping[str, float] = field(default_factory=dict)
    """Change of the number if a source changes by its noise, or None if this is unknown."""

    @property
    def noise(self) -> float:
        """Return the distance within which the true value lies; 0 if it is unknown."""
        return math.hypot(*self.offsets.values())

    def __str__(self) -> str:
        text = f"{self.value:.6g}"
        if self.noise:
            text += f" ± {self.noise:.2g}"
        return text if self.unit in ("", NO_UNIT) else f"{text} {self.unit}"

    def __add__(self, other: "Quantity") -> "Quantity":
        if self.unit != other.unit:
            raise AuditError(f"cannot add the units {self.unit} and {other.unit}")
        offsets = self._offsets(1.0, other, 1.0)
        return Quantity(self.value + other.value, self.unit, offsets)

    def __sub__(self, other: "Quantity") -> "Quantity":
        return self + -other

    def __mul__(self, other: "Quantity") -> "Quantity":
        offsets = self._offsets(other.value, other, self.value)
        unit = product_unit(self.unit, other.unit)
        return Quantity(self.value * other.value, unit, offsets)

    def __truediv__(self, other: "Quantity") -> "Quantity":
        if not other.value:
            raise AuditError("the expression divides by zero")
        value = self.value / other.value
        offsets = self._offsets(1.0 / other.value, other, -value / other.value)
        return Quantity(value, ratio_unit(self.unit, other.unit), offsets)

    def __neg__(self) -> "Quantity":
        offsets = {name: -offset for name, offset in self.offsets.items()}
        return Quantity(-self.value, self.unit, offsets)

    def scaled(self, factor: float, unit: str) -> "Quantity":
        """Return the number in a unit that is 1 / ``factor`` of the present one."""
        offsets = {name: factor * offset for name, offset in self.offsets.items()}
        # Rounding to 12 digits removes the errors of floating point.
        return Quantity(float(f"{factor * self.value:.12g}"), unit, offsets)

    def _offsets(
        self, slope: float, other: "Quantity", other_slope: float
    ) -> Mapping[str, float]:
        """Combine the offsets of two numbers (JCGM 100:2008, 5.1.2).

        A source on which both numbers depend moves both at once. The slopes are the
        derivatives of the result with respect to the two numbers.
        """
        offsets = {name: slope * offset for name, offset in self.offsets.items()}
        for name, offset in other.offsets.items():
            offsets[name] = offsets.get(name, 0.0) + other_slope * offset
        if len(offsets) > SOURCE_LIMIT:
            raise AuditError(f"the number depends on more than {SOURCE_LIMIT} places")
        return offsets


def scale_of(unit: str) -> tuple[float, str]:
    """Split ``mm/s`` into 0.001 and ``m/s``; an unknown unit gives 1 and ""."""
    symbol, slash, below = unit.partition("/")
    if symbol not in UNITS:
        return 1.0, ""
    factor, base = UNITS[symbol]
    return factor, base + slash + below


def split_unit(name: str) -> tuple[str, str]:
    """Split ``slip_mm``, ``slip [mm]`` or ``slip (mm)`` into the name and the unit."""
    match = NAME_WITH_UNIT.fullmatch(name)
    if match and is_known(unit := (match["units"] or match["unit"]).replace("_", "/")):
        return match["name"], unit
    return name, NO_UNIT


def is_known(unit: str) -> bool:
    """Return whether numbers in this unit can be converted."""
    return scale_of(unit)[1] != ""


def same_unit(first: str, second: str) -> bool:
    """Return whether a number in one unit can be written in the other."""
    units = (first, second)
    return first == second or all(map(is_known, units)) or set(units) <= PLAIN_UNITS


def in_unit(quantity: Quantity, unit: str) -> Quantity | None:
    """Convert a number, or return None if the units measure different things.

    The number stays as it is if one of the units is unknown.
    """
    if not (is_known(quantity.unit) and is_known(unit)):
        return quantity
    own_factor, own_base = scale_of(quantity.unit)
    factor, base = scale_of(unit)
    if own_base != base:
        return None
    return quantity.scaled(own_factor / factor, unit)


def in_base_unit(quantity: Quantity) -> Quantity:
    """Convert a number to its unit without a prefix, because arithmetic needs this."""
    factor, base = scale_of(quantity.unit)
    if base == "count":
        return quantity.scaled(factor, NO_UNIT)
    return in_unit(quantity, base) or quantity


def product_unit(first: str, second: str) -> str:
    """Return the unit of a product; m/s times s is m."""
    if NO_UNIT in (first, second):
        return second if first == NO_UNIT else first
    quotient = f"/{second}"
    if first.endswith(quotient):
        return first.removesuffix(quotient)
    return f"{first}·{second}"


def ratio_unit(first: str, second: str) -> str:
    """Return the unit of a ratio."""
    if first == second:
        return NO_UNIT
    return first if second == NO_UNIT else f"{first}/{second}"


def mean_noise(deviation: float, count: float) -> float:
    """Return the confidence interval of the mean of ``count`` samples (Student's t)."""
    return student_t(count - 1) * deviation / math.sqrt(count)


def sample_mean(samples: Sequence[float]) -> tuple[float, float]:
    """Return the mean of at least two samples, and its noise."""
    return fmean(samples), mean_noise(stdev(samples), len(samples))


def student_t(freedom: float) -> float:
    """Return Student's t for a confidence interval of 95 %.

    Beyond the table it is the first term of the expansion in 1 / freedom (Abramowitz and
    Stegun 1964, 26.7.5), which is too small by at most 0.003.
    """
    if freedom <= len(SMALL_SAMPLE_T):
        return SMALL_SAMPLE_T[max(0, math.floor(freedom) - 1)]
    return Z + (Z**3 + Z) / (4 * freedom)
