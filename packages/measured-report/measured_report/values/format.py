"""Numbers as they are written: the digits that its noise carries, and what was chosen as it was chosen."""

import math
import re
from collections.abc import Mapping
from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_UP, Decimal

MINUS = "\u2212"
THIN_SPACE = "\u202f"  # narrow and no-break, so that a number never wraps
ABSENT = "n/a"
BELOW = "<"  # begins what is below its noise
DIGITS_KNOWN, DIGITS_UNKNOWN = (
    3,
    2,
)  # the most significant digits: with a noise, which may allow fewer, and without
DIGITS_TYPED = 6  # the most significant digits of what was chosen; what has more was computed, and gets `DIGITS_KNOWN`
DIGITS_EXACT = (
    12  # so many significant digits of what was computed are those of its numbers
)
PLAIN_EXPONENTS = range(
    -4, 7
)  # powers of ten that are written plainly; anything smaller or larger gets a power of ten
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
DIGITS = {power: digit for digit, power in SUPERSCRIPTS.items()}
NAMED = r"(\d[\d.]*(?:e[+-]?\d+)?)"
WRITTEN = re.compile(r"(-?\d+(?:\.\d+)?)?(?:×?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?")


def unit_label(unit: str) -> str:
    """Write a unit; a bare number has none."""
    return "" if unit == "1" else unit


def format_number(
    value: float | int | None,
    *,
    noise: float | None = None,
    rounding: str = ROUND_HALF_UP,
) -> str:
    """Write ``value`` as people do, an integer in full, to what its ``noise`` carries: None where nobody knows it."""
    if value is None:
        return ABSENT
    if isinstance(value, int):
        return _typeset(f"{value:,}")
    value = float(value)  # what is drawn may come from NumPy
    if value == 0:
        return "0"
    if noise == 0:
        exact = Decimal(repr(value)).normalize()
        is_computed = len(exact.as_tuple().digits) > DIGITS_TYPED
        return (
            _format_rounded(exact, DIGITS_KNOWN, rounding)
            if is_computed
            else _format_decimal(exact)
        )
    if noise and abs(value) <= noise:
        return f"{BELOW}{THIN_SPACE}{_format_noise(noise, value)}"
    return _format_decimal(rounded(value, noise, rounding))


def format_most(value: float | int | None, *, noise: float | None = None) -> str:
    """Write ``value`` as what something is at most, or what it is within: rounded up, and never below the noise."""
    least_said = noise if noise and value == 0.0 else undusted(value)
    return format_number(least_said, noise=noise, rounding=ROUND_CEILING).removeprefix(
        f"{BELOW}{THIN_SPACE}"
    )


def format_least(value: float | int | None, *, noise: float | None = None) -> str:
    """Write ``value`` as what something is at least, or more than: rounded down; nothing below the noise."""
    text = format_number(undusted(value), noise=noise, rounding=ROUND_FLOOR)
    return "0" if text.startswith(BELOW) else text


def format_interval(value: float | int | None, *, noise: float | None = None) -> str:
    """Write ``value`` and its noise, to two digits of the noise, as 0.042 ± 0.010."""
    if value is None or not noise:
        return format_number(value, noise=noise)
    exact = Decimal(repr(float(noise)))
    digit = Decimal(1).scaleb(exact.adjusted() - 1)
    middle = Decimal(repr(float(value))).quantize(digit, ROUND_HALF_UP)
    half = exact.quantize(digit, ROUND_HALF_UP)
    return f"{_format_decimal(middle)} ± {_format_decimal(half)}"


MOST, LEAST = (
    "most",
    "least",
)  # said on the page of a number that is a bound from above or below
INTERVAL = "interval"
WRITES = {
    "": format_number,
    MOST: format_most,
    LEAST: format_least,
    INTERVAL: format_interval,
}  # by what the page says of a number


def undusted(value: float | int | None) -> float | int | None:
    """Return ``value`` without what floating point leaves behind its digits, which no bound is for."""
    return float(f"{value:.{DIGITS_EXACT}g}") if isinstance(value, float) else value


def read_number(text: str) -> Decimal | None:
    """Read the number that was written so; None for what is none."""
    match = WRITTEN.fullmatch(text.replace(THIN_SPACE, "").replace(MINUS, "-"))
    return (
        Decimal(match[1] or 1).scaleb(int((match[2] or "⁰").translate(DIGITS)))
        if match
        else None
    )


def rounded(
    value: float, noise: float | None, rounding: str = ROUND_HALF_UP
) -> Decimal:
    """Round ``value`` to the last digit that it carries; halves, as its shortest decimal has them, away from zero.

    Two runs are apart by the noise, so that one is off by half of it: the last digit is worth at least that, but where
    rounding itself would move the value by more, there is a digit more. What is beyond the noise has one in any case.
    """
    exact = Decimal(repr(value))
    exponent = (
        exact.adjusted() + 1 - (DIGITS_UNKNOWN if noise is None else DIGITS_KNOWN)
    )
    if noise:
        exponent = min(
            max(exponent, math.ceil(math.log10(noise / 2))), exact.adjusted()
        )
    decimal = exact.quantize(Decimal(1).scaleb(exponent), rounding)
    while noise and abs(decimal - exact) > Decimal(repr(noise)) / 2:
        exponent -= 1
        decimal = exact.quantize(Decimal(1).scaleb(exponent), rounding)
    if decimal.adjusted() > exact.adjusted():
        return rounded(float(decimal), noise, rounding)  # 9.996 is 10.0 and not 10.00
    return decimal


def format_code(value: float | int | None) -> str:
    """Write ``value`` as a program reads it, without zeros at its end."""
    return ABSENT if value is None else f"{value:.{DIGITS_TYPED}g}"


def format_short(value: float) -> str:
    """Write ``value`` up to 99, in two digits and as few characters as can be."""
    if value < 0.005:
        return "<.01"
    exact = Decimal(repr(float(value)))
    places = next(
        (
            places
            for places, limit in ((2, "0.095"), (1, "9.95"))
            if exact < Decimal(limit)
        ),
        0,
    )
    return str(exact.quantize(Decimal(1).scaleb(-places), ROUND_HALF_UP)).removeprefix(
        "0" if places == 2 else ""
    )


def format_share(share: float, sign: str = "") -> str:
    """Write a share in percent, in two digits; ``sign`` as Python's formats have it."""
    return f"{float(f'{100 * share:.2g}'):{sign},.12g} %"


def format_power(exponent: int) -> str:
    return f"10{str(exponent).translate(SUPERSCRIPTS)}"


def label_of(case: str, labels: Mapping[str, str]) -> str:
    """Return the words of the first of ``labels`` that fits, where # stands for a number; or its own name, spaced.

    >>> label_of("length-2.5e6", {"length-#": "{} m long"})
    '2.5×10⁶ m long'
    """
    for pattern, label in labels.items():
        if match := re.fullmatch(re.escape(pattern).replace(r"\#", NAMED), case):
            return label.format(*map(number_of, match.groups()))
    return case.replace("-", " ").replace("_", " ")


def number_of(text: str) -> str:
    """Return a number of a case's name as one reads it: ``2.5e6`` as 2.5×10⁶ and ``0.2`` as it is."""
    mantissa, _, power = text.partition("e")
    if not power:
        return text
    if 1e-3 <= float(text) < 1e5:
        return f"{float(text):g}"
    scale = format_power(int(power))
    return scale if float(mantissa) == 1 else f"{mantissa}×{scale}"


def _format_noise(noise: float, value: float) -> str:
    texts = [
        _format_rounded(Decimal(repr(noise)), digits, ROUND_CEILING)
        for digits in range(1, DIGITS_KNOWN + 1)
    ]
    most = Decimal(repr(noise + abs(value)))
    return next(
        (text for text in texts if (read_number(text) or most) <= most), texts[-1]
    )


def _format_rounded(exact: Decimal, digits: int, rounding: str) -> str:
    return _format_decimal(
        exact.quantize(
            Decimal(1).scaleb(exact.adjusted() + 1 - digits), rounding
        ).normalize()
    )


def _format_decimal(number: Decimal) -> str:
    exponent = number.adjusted()
    if exponent in PLAIN_EXPONENTS:
        return _typeset(f"{number:,f}")
    mantissa = _typeset(f"{number.scaleb(-exponent):f}")
    power = format_power(exponent)
    return power if mantissa == "1" else f"{mantissa}{THIN_SPACE}×{THIN_SPACE}{power}"


def _typeset(text: str) -> str:
    return text.replace("-", MINUS).replace(",", THIN_SPACE)
