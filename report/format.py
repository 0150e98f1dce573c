"""How a number is written on the page."""

MINUS = "\u2212"
THIN_SPACE = "\u202f"
"""Narrow and no-break, so that a number never wraps."""
ABSENT = "n/a"

PLAIN_EXPONENTS = range(-4, 7)
"""Powers of ten that are written plainly; anything smaller or larger gets a power of ten."""
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

LABELS = {"1": ""}
"""Units that are written in another way than they are named."""


def unit_label(unit: str) -> str:
    return LABELS.get(unit, unit)


def format_number(value: float | int | None, *, digits: int = 3) -> str:
    """``value`` to ``digits`` significant digits; digits before the point are never rounded away."""
    if value is None:
        return ABSENT
    if isinstance(value, int) or value == 0:
        return _typeset(f"{value:,.0f}" if value == 0 else f"{value:,}")
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    if int(exponent) not in PLAIN_EXPONENTS:
        return f"{_typeset(mantissa)}{THIN_SPACE}×{THIN_SPACE}{format_power(int(exponent))}"
    return _typeset(f"{value:,.{max(0, digits - 1 - int(exponent))}f}")


def format_code(value: float | int | None, *, digits: int = 6) -> str:
    """``value`` as a program reads it, without zeros at its end."""
    return ABSENT if value is None else f"{value:.{digits}g}"


def format_short(value: float) -> str:
    """``value`` up to 99 in two digits and as few characters as can be, for where there is no room."""
    if value < 0.005:
        return "<.01"
    if value >= 9.95:
        return f"{value:.0f}"
    return f"{value:.1f}" if value >= 0.095 else f"{value:.2f}".removeprefix("0")


def format_power(exponent: int) -> str:
    """A power of ten."""
    return f"10{str(exponent).translate(SUPERSCRIPTS)}"


def _typeset(text: str) -> str:
    return text.replace("-", MINUS).replace(",", THIN_SPACE)
