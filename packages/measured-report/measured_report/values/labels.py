"""Labels: what people call a case, as the module of its section says."""

import re
from collections.abc import Mapping

from measured_report.values.format import format_power

NUMBER = r"(\d[\d.]*(?:e[+-]?\d+)?)"


def label_of(case: str, labels: Mapping[str, str]) -> str:
    """Return the words of the first of ``labels`` that fits, where # stands for a number; or its own name, spaced.

    >>> label_of("length-2.5e6", {"length-#": "{} m long"})
    '2.5×10⁶ m long'
    """
    for pattern, words in labels.items():
        if match := re.fullmatch(re.escape(pattern).replace(r"\#", NUMBER), case):
            return words.format(*map(number_of, match.groups()))
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
