"""Find units in texts. This module has no dependencies, because identities need it."""

import re
from collections.abc import Iterable

BASE = "(?:m|s|g|N|J|W|V|A|K|B|bit|Pa|Hz|rad|mol)"
SYMBOL = re.compile(
    rf"""
    (?: [nµmkMGT]? {BASE}  # with a prefix
      | cm | min | h | °C? | % | 1 | dB
    )
    [²³]?
    """,
    re.VERBOSE,
)
"""The factors of units that are known without a declaration.

Units can combine them with ``/`` and ``·``. Numbers are never converted between units.
"""
TYPED = re.compile(
    rf"(?<![\w.]) \d+ (?:\.\d+)? [\s\xa0]* (?!1) {SYMBOL.pattern} (?!\w)", re.VERBOSE
)
"""A number with a unit in a text, which should be a quantity."""
PREFIX = re.compile(
    rf"""
    (?<! [^/·] ) [nµmkMGT]  # at the start of a factor
    (?= {BASE} (?![a-zA-Z]) )
    """,
    re.VERBOSE,
)


LIKE_UNIT = re.compile(
    rf"""
    (?<! per ) _
    ( (?: [nuµmkMGT]{BASE} | [gJWVh] | m(?=[23]) | Pa | rad | mol | cm | deg
        | km_?h | mph | bar | rpm
      ) [23]?
    ) $
    """,
    re.VERBOSE | re.IGNORECASE,
)
"""The end of a column's name that may be meant as a unit."""


def unlike(units: Iterable[str]) -> list[str]:
    """Return two different units of one quantity, such as ms and s, if there are any."""
    kinds: dict[str, str] = {}
    for unit in units:
        kind = PREFIX.sub("", unit)
        if kinds.setdefault(kind, unit) != unit:
            return [kinds[kind], unit]
    return []
