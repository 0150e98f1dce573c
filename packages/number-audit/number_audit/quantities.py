"""Computes with numbers that have a unit and noise."""

import math
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from statistics import NormalDist, fmean, stdev

from number_audit.files import AuditError

SURE = 0.95
"""Probability that the true value is within the noise of a number."""

Z = NormalDist().inv_cdf((1 + SURE) / 2)
SMALL_SAMPLE_T = (
    12.7062,
    4.3027,
    3.1824,
    2.7764,
    2.5706,
    2.4469,
    2.3646,
    2.3060,
    2.2622,
)
"""Student's t for ``SURE``, with 1 to 9 degrees of freedom."""

SOURCE_LIMIT = 1000
"""Most places in result files from which one number is computed."""

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
BASES = ("m", "s", "g", "N", "J", "W", "V", "A", "B", "bit", "Pa", "Hz", "rad")
UNITS = {
    prefix + base: (factor, base)
    for prefix, factor in PREFIXES.items()
    for base in BASES
}
UNITS |= {"min": (60.0, "s"), "sec": (1.0, "s"), "seconds": (1.0, "s")}
UNITS |= {"bytes": (1.0, "B")}

NO_UNIT = "1"
SUPERSCRIPTS = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
LOWERED = str.maketrans(SUPERSCRIPTS, "-0123456789")
RAISED = str.maketrans("-0123456789", SUPERSCRIPTS)
UNIT_FACTOR = re.compile(f"(/?)([^/·{SUPERSCRIPTS}]+)([{SUPERSCRIPTS[1:]}]*)")


@dataclass(frozen=True)
class Quantity:
    """A number with its unit and noise."""

    value: float
    unit: str = NO_UNIT
    offsets: Mapping[str, float] | None = field(default_factory=dict)
    """For each source, the change of the number if the source is off by its noise.

    None if the noise of a source is unknown.
    """

    @property
    def noise(self) -> float:
        """Return the distance within which the true value lies; 0 if it is unknown."""
        return math.hypot(*(self.offsets or {}).values())

    def __str__(self) -> str:
        text = f"{self.value:.6g}"
        if self.noise:
            text += f" ± {self.noise:.2g}"
        return text if self.unit in ("", NO_UNIT) else f"{text} {self.unit}"

    def __add__(self, other: "Quantity") -> "Quantity":
        return self._sum(other, 1.0)

    def __sub__(self, other: "Quantity") -> "Quantity":
        return self._sum(other, -1.0)

    def _sum(self, other: "Quantity", sign: float) -> "Quantity":
        if self.unit != other.unit:
            raise AuditError(f"{self} and {other} have different units")
        value = self.value + sign * other.value
        return Quantity(value, self.unit, self._offsets(1.0, other, sign))

    def __mul__(self, other: "Quantity") -> "Quantity":
        offsets = self._offsets(other.value, other, self.value)
        unit = product_unit(self.unit, other.unit, 1)
        return Quantity(self.value * other.value, unit, offsets)

    def __truediv__(self, other: "Quantity") -> "Quantity":
        if not other.value:
            raise AuditError("the expression divides by zero")
        value = self.value / other.value
        offsets = self._offsets(1.0 / other.value, other, -value / other.value)
        return Quantity(value, product_unit(self.unit, other.unit, -1), offsets)

    def __neg__(self) -> "Quantity":
        return Quantity(0.0, self.unit) - self

    def scaled(self, factor: float, unit: str) -> "Quantity":
        """Return the number in a unit that is 1 / ``factor`` of the present one."""
        offsets = self.offsets and {
            name: factor * offset for name, offset in self.offsets.items()
        }
        # Rounding to 12 digits removes the errors of floating point.
        return Quantity(float(f"{factor * self.value:.12g}"), unit, offsets)

    def _offsets(
        self, slope: float, other: "Quantity", other_slope: float
    ) -> Mapping[str, float] | None:
        """Combine the offsets of two numbers (JCGM 100:2008, 5.1.2).

        A source on which both numbers depend moves both at once. The slopes are the
        derivatives of the result with respect to the two numbers.
        """
        if self.offsets is None or other.offsets is None:
            return None
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


def is_known(unit: str) -> bool:
    """Return whether numbers in this unit can be converted."""
    return scale_of(unit)[1] != ""


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
    base = scale_of(quantity.unit)[1]
    return in_unit(quantity, base) or quantity


def product_unit(first: str, second: str, sign: int) -> str:
    """Return the unit of a product, or of a ratio if the sign is -1."""
    powers: Counter[str] = Counter()
    for unit, direction in ((first, 1), (second, sign)):
        for slash, symbol, exponent in UNIT_FACTOR.findall(unit):
            power = int(exponent.translate(LOWERED) or 1)
            powers[symbol] += -direction * power if slash else direction * power
    del powers[NO_UNIT]

    def written(symbol: str) -> str:
        power = abs(powers[symbol])
        return symbol if power == 1 else symbol + str(power).translate(RAISED)

    above = [written(symbol) for symbol in sorted(powers) if powers[symbol] > 0]
    below = [written(symbol) for symbol in sorted(powers) if powers[symbol] < 0]
    return "/".join(["·".join(above) or NO_UNIT, *below])


def mean_noise(deviation: float, count: float) -> float:
    """Return the confidence interval of the mean of ``count`` samples (Student's t)."""
    return student_t(count - 1) * deviation / math.sqrt(count)


def sample_mean(samples: Sequence[float]) -> tuple[float, float]:
    """Return the mean of at least two samples, and its noise."""
    return fmean(samples), mean_noise(stdev(samples), len(samples))


def student_t(freedom: float) -> float:
    """Return Student's t for the probability ``SURE``.

    Beyond the table it is an expansion in 1 / freedom (Abramowitz and Stegun 1964,
    26.7.5).
    """
    if freedom <= len(SMALL_SAMPLE_T):
        return SMALL_SAMPLE_T[max(0, math.floor(freedom) - 1)]
    first = (Z**3 + Z) / 4
    second = (5 * Z**5 + 16 * Z**3 + 3 * Z) / 96
    third = (3 * Z**7 + 19 * Z**5 + 17 * Z**3 - 15 * Z) / 384
    return Z + first / freedom + second / freedom**2 + third / freedom**3
