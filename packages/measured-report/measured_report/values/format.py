"""Format measured numbers by their noise, and hard-coded numbers in full."""

import math
import re
from collections.abc import Mapping
from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_UP, Decimal

MINUS = "\u2212"
THIN_SPACE = "\u202f"  # narrow and no-break, so that a number never wraps
ABSENT = "n/a"
BELOW = "<"  # the first character of a number that is below its noise
DIGITS_KNOWN = 3  # chosen: the most significant digits if the noise is known
DIGITS_UNKNOWN = 2  # chosen: the most significant digits if the noise is not known
DIGITS_TYPED = 6
"""Chosen: an exact number with at most this many digits was typed and is written in
full. A longer one was computed, and is written with `DIGITS_KNOWN` digits.
"""
DIGITS_EXACT = 12  # chosen: later digits may be rounding errors of floating point
# Chosen: numbers of these powers of ten are written without an exponent.
PLAIN_EXPONENTS = range(-4, 7)
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
NAMED = r"(\d[\d.]*(?:e[+-]?\d+)?)"  # a number in the name of a case


def unit_label(unit: str) -> str:
    """Return the text of a unit, which is empty for a bare number."""
    return "" if unit == "1" else unit


def format_number(
    value: float | int | None,
    *,
    noise: float | None = None,
    rounding: str = ROUND_HALF_UP,
) -> str:
    """Write ``value`` with the digits that its ``noise`` allows.

    The noise is 0 for an exact number and None if it is not known. Integers are written in
    full. A number below its noise is written as "<" with the bound of its size.
    """
    if value is None:
        return ABSENT
    if isinstance(value, int):
        return _typeset(f"{value:,}")
    value = float(value)  # numbers in figures may come from NumPy
    if value == 0:
        return "0"
    if noise == 0:
        exact = Decimal(repr(value)).normalize()
        is_computed = len(exact.as_tuple().digits) > DIGITS_TYPED
        if is_computed:
            return _format_rounded(exact, DIGITS_KNOWN, rounding)
        return _format_decimal(exact)
    if noise and abs(value) <= noise:
        return f"{BELOW}{THIN_SPACE}{format_most(value, noise=noise)}"
    return _format_decimal(rounded(value, noise, rounding))


def format_most(value: float | int | None, *, noise: float | None = None) -> str:
    """Write the upper end of the interval of ``value``, rounded up.

    For a number below its noise, this is the bound of its size.
    """
    return _format_bound(value, noise, ROUND_CEILING)


def format_least(value: float | int | None, *, noise: float | None = None) -> str:
    """Write the lower end of the interval of ``value``, rounded down, or 0 if the value
    is below its noise.
    """
    return _format_bound(value, noise, ROUND_FLOOR)


def _format_bound(value: float | int | None, noise: float | None, rounding: str) -> str:
    if value is None or not noise:
        bound = without_rounding_error(value)
        return format_number(bound, noise=noise, rounding=rounding)
    middle, width = (Decimal(repr(float(number))) for number in (value, noise))
    is_upper = rounding == ROUND_CEILING
    if abs(middle) <= width:
        if not is_upper:
            return "0"
        middle = abs(middle)
    end = middle + width if is_upper else middle - width
    return _format_decimal(rounded(float(end), noise, rounding))


def format_interval(value: float | int | None, *, noise: float | None = None) -> str:
    """Write ``value`` and two digits of its noise, such as 0.042 ± 0.010."""
    if value is None or not noise:
        return format_number(value, noise=noise)
    exact = Decimal(repr(float(noise)))
    digit = Decimal(1).scaleb(exact.adjusted() - 1)
    middle = Decimal(repr(float(value))).quantize(digit, ROUND_HALF_UP)
    half = exact.quantize(digit, ROUND_HALF_UP)
    return f"{_format_decimal(middle)} ± {_format_decimal(half)}"


MOST = "most"
LEAST = "least"
INTERVAL = "interval"
# The functions that write a number, by the form in which a page prints it.
WRITES = {
    "": format_number,
    MOST: format_most,
    LEAST: format_least,
    INTERVAL: format_interval,
}


def without_rounding_error(value: float | int | None) -> float | int | None:
    """Return ``value`` without the rounding error of floating point.

    A bound would otherwise round 0.020000000000000462 up to 0.021.
    """
    return float(f"{value:.{DIGITS_EXACT}g}") if isinstance(value, float) else value


def rounded(
    value: float, noise: float | None, rounding: str = ROUND_HALF_UP
) -> Decimal:
    """Round ``value`` to the last digit that its noise allows.

    The last digit is worth at least half the noise, and there is at least one digit. If
    rounding would then change the value by more than half the noise, there is one digit
    more. By default halves of the shortest decimal are rounded away from zero.
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
        return rounded(float(decimal), noise, rounding)  # 9.996 gives 10.0, not 10.00
    return decimal


def format_code(value: float | int | None) -> str:
    """Write ``value`` for a program, without zeros at the end."""
    return ABSENT if value is None else f"{value:.{DIGITS_TYPED}g}"


def format_share(share: float, sign: str = "") -> str:
    """Write a share as a percentage with two digits.

    ``sign`` is a sign option of Python's format specification, such as "+".
    """
    return f"{float(f'{100 * share:.2g}'):{sign},.12g} %"


def format_power(exponent: int) -> str:
    return f"10{str(exponent).translate(SUPERSCRIPTS)}"


def label_of(case: str, labels: Mapping[str, str]) -> str:
    """Return the first of ``labels`` that matches a case, filled with its numbers.

    In a pattern, # stands for a number. Without a match, return the name of the case with
    spaces instead of hyphens and underscores.

    >>> label_of("length-2.5e6", {"length-#": "{} m long"})
    '2.5×10⁶ m long'
    """
    for pattern, label in labels.items():
        if match := re.fullmatch(re.escape(pattern).replace(r"\#", NAMED), case):
            return label.format(*map(number_of, match.groups()))
    return case.replace("-", " ").replace("_", " ")


def number_of(text: str) -> str:
    """Return a number in the name of a case as text: 2.5×10⁶ for ``2.5e6``.

    A number without an exponent is returned unchanged.
    """
    mantissa, _, power = text.partition("e")
    if not power:
        return text
    if 1e-3 <= float(text) < 1e5:
        return f"{float(text):g}"
    scale = format_power(int(power))
    return scale if float(mantissa) == 1 else f"{mantissa}×{scale}"


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
