"""Find units in texts. This module has no dependencies, because identities need it."""

import re

SYMBOL = re.compile(
    r"""
    (?: [nµmkMGT]? (?:m|s|g|N|J|W|V|A|K|B|bit|Pa|Hz|rad|mol)  # with a prefix
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
