"""Units: what arithmetic makes of them. They are written as ``mm/s²`` and ``N·m``, and never converted."""

import re
from collections import Counter

from measured_report.records.columns import PLAIN
from measured_report.values.format import DIGITS, SUPERSCRIPTS

FACTOR = re.compile("(/?)([^/·¹²³⁴-⁹]+)([¹²³⁴-⁹]?)")


def product_unit(a: str, b: str, power: int = 1) -> str:
    """Return the unit of a product of two numbers, the second to a power.

    >>> product_unit("mm/s", "s")
    'mm'
    >>> product_unit("N", "m", -2)
    'N/m²'
    """
    powers: Counter[str] = Counter()
    for unit, sign in ((a, 1), (b, power)):
        for below, symbol, exponent in FACTOR.findall(unit):
            powers[symbol] += (-sign if below else sign) * int(exponent.translate(DIGITS) or 1)
    del powers[PLAIN]
    above, below = ([_factor(*each) for each in sorted((+side).items())] for side in (powers, -powers))
    return "/".join(["·".join(above) or PLAIN, *below])


def _factor(symbol: str, power: int) -> str:
    return symbol + str(power).translate(SUPERSCRIPTS) * (power > 1)
