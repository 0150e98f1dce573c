"""Suggests marks for numbers that are in the results, or were in earlier ones."""

import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from functools import cache
from urllib.parse import quote

from number_audit.audit import CLOSING, NUMBER, ROUNDED, UNIT, Finding, printed_value
from number_audit.files import AuditError
from number_audit.marks import (
    PLAIN_IN_PLACES,
    line_counter,
    number_cells,
    regions,
    source_of_cell,
)
from number_audit.quantities import NO_UNIT, in_unit, is_known, scale_of, split_unit
from number_audit.sources import SAMPLES, Repeats, simplified
from number_audit.tables import Table, read_tables

UNMARKED = re.compile(
    rf"(?<![\w./\#-]){NUMBER}(([ \xa0\u2009\u202f~]|\\,)?{UNIT})?(?![\w/-]|\.\w)",
    re.VERBOSE,
)
NOT_PROSE = re.compile(
    r"""
    \A---\r?\n(.*\n)*?---    # the front matter
    |</?\w[^<>]*>            # a tag
    |\]\([^()\n]*\)          # the address of a link
    |^\[[^\]\n]*\]:.*
    |\{\{[^{}\n]*\}\}|\{%[^%\n]*%\} # a template
    |\$[^$\n]+\$             # a formula
    |(?<=\n\n)(\ {4}.*\n)+    # code
    """,
    re.VERBOSE | re.MULTILINE,
)
"""Matches the parts of Markdown and HTML in which a comment would be visible."""

MARKED = re.compile(rf"{CLOSING}<!--", re.VERBOSE)
MARKED_TABLE = re.compile(r"\s*<!--[^>]*\{")
FORMS = {".rst": ":audit:`{} <= {}>`", ".tex": r"\audited{{{}}}{{= {}}}"}

CHOICE_LIMIT = 9
"""Largest number of places that are listed for one number."""


class Results:
    """The numbers of a result file, as sources of marks."""

    def __init__(self, source: Repeats):
        self.source = source
        self._values_in = cache(lambda unit: list(self._values(unit)))

    def near(self, number: re.Match[str], unit: str) -> list[str]:
        """Return the sources that agree with a number after rounding.

        ``unit`` is the unit of a number that does not state one.
        """
        printed, last_digit = printed_value(number)
        limit = ROUNDED * 10.0**last_digit
        sources = [
            source
            for source, value in self._values_in(number["unit"] or unit)
            if abs(value - printed) <= limit
        ]
        if number["unit"] or not unit:
            return sources
        return [f"{source.removesuffix(f' {unit}')} {unit}" for source in sources]

    def _values(self, unit: str) -> Iterator[tuple[str, float]]:
        """Yield the value of each place in one unit, which the mark states if needed."""
        for pointer, place in self.source.places.items():
            # The mean of samples is rarely printed, and the file states it beside them.
            if place.key in SAMPLES:
                continue
            name = quote(pointer, PLAIN_IN_PLACES)
            quantity = self.source.quantity(name)
            measured = in_unit(quantity, unit)
            if measured is None:
                continue
            source = f"{self.source.name}#{name}"
            if is_known(quantity.unit) or not is_known(unit):
                yield source, measured.value
                continue
            yield f"{source} {unit}", measured.value
            factor, base = scale_of(unit)
            if base == "count" and factor != 1.0:
                name = "ratio" if factor < 1.0 else base
                yield f"{source} {name}", measured.value / factor

    def source_of(self, table: Table) -> str:
        """Return the source of a table whose rows and columns are named in the file."""
        cells = list(number_cells(table))
        if len(cells) < 2:
            return ""
        row = f"/{cells[0].row}/"
        column = simplified(split_unit(cells[0].column)[0])
        for pointer, place in self.source.places.items():
            if row in pointer and simplified(split_unit(place.key)[0]) == column:
                parents = pointer.removesuffix(place.key).split(row)
                name = "/{row}/".join(quote(part, PLAIN_IN_PLACES) for part in parents)
                with suppress(AuditError):  # The file may not have all cells.
                    for cell in cells:
                        self.source.quantity(source_of_cell(f"{name}{{column}}", cell))
                    return f"{self.source.name}#{name}{{column}}"
        return ""


def suggestions(
    text: str, suffix: str, sources: Iterable[tuple[str, Repeats]]
) -> list[Finding]:
    """Return a mark for each table, and for each unmarked number with a single matching
    place. ``sources`` contains the results now, and the results of earlier commits. A
    number that is only in earlier results is stale. A number with several matching
    places, or none, is listed without a mark.
    """
    editions = [(commit, Results(source)) for commit, source in sources]
    current = editions[0][1]
    hidden = _blanked(text, [region.span() for region in regions(text, suffix)])
    if suffix not in FORMS:
        hidden = _blanked(
            hidden, [match.span() for match in NOT_PROSE.finditer(hidden)]
        )
    line_of = line_counter(text)
    findings = []
    marked_tables = []
    units: dict[int, str] = {}
    for table in read_tables(text):
        for cell in table.cells:
            unit = split_unit(cell.column)[1]
            places = range(cell.start, cell.start + len(cell.text))
            units |= dict.fromkeys(places, "" if unit == NO_UNIT else unit)
        end = table.end
        is_marked = MARKED_TABLE.match(text, end)
        source = current.source_of(table)
        if hidden[table.start] == "\0" or not (is_marked or source):
            continue
        marked_tables.append((table.start, end))
        if not is_marked:
            mark = f"<!-- = {source} -->"
            line = line_of(table.start)
            findings.append(Finding(line, "fresh", mark, end, end, f"\n\n{mark}"))
    for match in UNMARKED.finditer(_blanked(hidden, marked_tables)):
        if not _is_telling(match) or MARKED.match(text, match.end()):
            continue
        start = match.start()
        unit = match["unit"] or ""
        has_unit = is_known(unit) or unit in ("", "×", "°")
        number = text[start : match.end() if has_unit else match.start("unit")].rstrip()
        end = start + len(number)
        head = units.get(start, "")
        kind, message, place = _suggestion(number, match, head, editions)
        mark = ""
        if place:
            form = FORMS.get(suffix, "{}<!-- = {} -->")
            if suffix == ".tex":
                place = re.sub(r"(?=[#%_&])", r"\\", place)
            mark = form.format(number, place)
            message = f"{mark}{message}"
        findings.append(Finding(line_of(start), kind, message, start, end, mark))
    return sorted(findings, key=lambda finding: finding.start)


def _suggestion(
    number: str,
    match: re.Match[str],
    head: str,
    editions: Sequence[tuple[str, Results]],
) -> tuple[str, str, str]:
    """Return the kind of a suggestion, its message and the only place of a number.

    ``head`` is the unit in the head of the column.
    """
    # The results now come first, so a number that agrees with them is not stale.
    for commit, results in editions:
        places = results.near(match, head)
        if len(places) > 1:
            choice = " or ".join(places[:CHOICE_LIMIT])
            return "unclear", f"{number} may be {choice}", ""
        if places and commit:
            return "stale", f" was right until commit {commit}", places[0]
        if places:
            return "fresh", "", places[0]
    return "unclear", f"{number} is not in {editions[0][1].source.name}", ""


def _is_telling(number: re.Match[str]) -> bool:
    """Return whether a number is unlikely to occur in the results by chance."""
    digits = re.sub(r"\D", "", number["digits"]).lstrip("0")
    return len(digits) > (1 if "." in number["digits"] else 2)


def _blanked(text: str, spans: Iterable[tuple[int, int]]) -> str:
    """Return a text in which the given parts are blanked out."""
    parts = []
    position = 0
    for start, end in spans:
        parts.append(text[position:start])
        parts.append("\0" * (end - start))
        position = end
    return "".join([*parts, text[position:]])
