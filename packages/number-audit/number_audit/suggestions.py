"""Suggests marks for numbers in a text that occur exactly once in the results."""

import re
from collections.abc import Iterator
from functools import cache
from urllib.parse import quote

from number_audit.audit import CLOSING, NUMBER, ROUNDED, UNIT, Finding, printed_value
from number_audit.marks import regions
from number_audit.quantities import in_unit, is_known
from number_audit.sources import SAMPLES, Source

UNMARKED = re.compile(
    rf"(?<![\w./\#-]){NUMBER}(([ \xa0\u2009\u202f~]|\\,)?{UNIT})?(?![\w/-]|\.\w)",
    re.VERBOSE,
)
MARKED = re.compile(rf"{CLOSING}<!--", re.VERBOSE)
FORMS = {".rst": ":audit:`{} <= {}>`", ".tex": r"\audited{{{}}}{{= {}}}"}
COMMENT_FORM = "{}<!-- = {} -->"
PLAIN_IN_PLACES = "/~!$&()*+,:;=@[]|"
"""Characters of a place that are not percent-encoded in a mark."""

CHOICE_LIMIT = 9
"""Most places that are listed for one number."""


def suggestions(text: str, suffix: str, file: str, source: Source) -> Iterator[Finding]:
    """Yield a mark for each unmarked number that occurs exactly once in the results.

    For a number that occurs several times, yield a line that lists its places.
    """
    form = FORMS.get(suffix, COMMENT_FORM)
    places = [
        quote(place, PLAIN_IN_PLACES)
        for place, found in source.places.items()
        if found.key not in SAMPLES
    ]
    quantities = [(f"{file}#{place}", source.quantity(place)) for place in places]

    @cache
    def values_in(unit: str) -> list[tuple[str, float]]:
        in_units = ((place, in_unit(quantity, unit)) for place, quantity in quantities)
        return [(place, quantity.value) for place, quantity in in_units if quantity]

    for match in UNMARKED.finditer(_without_regions(text, suffix)):
        printed = printed_value(match)
        unit = match["unit"] or ""
        last_digit = printed.as_tuple().exponent
        assert isinstance(last_digit, int)
        limit = ROUNDED * 10.0**last_digit
        near = [
            place
            for place, value in values_in(unit)
            if abs(value - float(printed)) <= limit
        ]
        # Short numbers such as 2 or 10 occur in many results by chance.
        is_telling = len(printed.as_tuple().digits) > (1 if last_digit < 0 else 2)
        if not (near and is_telling) or MARKED.match(text, match.end()):
            continue
        start = match.start()
        has_unit = is_known(unit) or unit in ("", "×", "%", "°")
        end = match.end() if has_unit else match.start("unit")
        number = text[start:end].rstrip()
        line = text.count("\n", 0, start) + 1
        if len(near) > 1:
            choice = f"{number} may be {' or '.join(near[:CHOICE_LIMIT])}"
            yield Finding(line, "unclear", choice)
            continue
        place = near[0]
        if suffix == ".tex":
            place = re.sub(r"(?=[#%_&])", r"\\", place)
        mark = form.format(number, place)
        end = start + len(number)
        yield Finding(line, "fresh", mark, start=start, end=end, replacement=mark)


def _without_regions(text: str, suffix: str) -> str:
    """Return the text with comments, roles and code blanked out."""
    parts = []
    end = 0
    for region in regions(text, suffix):
        parts.append(text[end : region.start])
        parts.append("\0" * (region.end - region.start))
        end = region.end
    return "".join([*parts, text[end:]])
