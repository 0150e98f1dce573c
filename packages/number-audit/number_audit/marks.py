"""Reads marks: comments and roles that name the source of the number before them.

- Markdown and HTML: a comment, ``12.3 ms<!-- = bench.json#/mean -->``
- after a table in Markdown: ``<!-- = bench.json#/{row}/{column} -->``
- LaTeX: ``\\audited{12.3\\,ms}{= bench.json\\#/mean}``
- reStructuredText: ``:audit:`12.3 ms <= bench.json#/mean>```

A text is read once from its beginning to its end, so the time is proportional to its
length.
"""

import re
from bisect import bisect
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from urllib.parse import quote

from number_audit.quantities import NO_UNIT, split_unit
from number_audit.tables import MARKUP, Cell, Table, read_tables

MARK_LIMIT = 600
"""The largest number of characters in a mark."""

BEFORE_LIMIT = 200
"""The largest number of characters between a comment and the start of its number."""

NUMBER_MARK = re.compile(
    r"""
    ((?P<name>[^\W\d_]\w*)\s*)?
    =\s*(?=[\w(./-])(?P<source>.+?(?<=[\w)\]}]))
    (\s+(?P<unit>%|[^\W\d_]\S{0,20}))?
    (\s+digits\s+(?P<digits>\d{1,2}))?
    (\s*(±|\+/?-)\s*(?P<tolerance>\d[\d.]{0,9})\s*%)?
    """,
    re.VERBOSE,
)
WORD_MARK = re.compile(
    r"""
    (?P<yes>.+?)\ if\ (?P<left>[^<>]+?)\s*(?P<sign>[<>])\s*(?P<right>[^<>]+?)
    \ else\ (?P<no>.+)
    """,
    re.VERBOSE,
)
COMMENT = r"<!--(?P<comment>(?s:.*?))(-->|(?P<unclosed>\Z))"
ROLE = r"""
    (:audit:`|\\audited\{)(?P<printed>[^`<{}]{1,200})(<|\}\{)
    (?P<role>[^`{}]{1,600})(>`|\})
"""
BROKEN = r"""
    (?=(?P<broken>[^\n]{1,50}))
    (:audit:\s?`|\\audited\s?[\[{]|<!\s?-{0,2}\s?(?=(\w{1,40}\s?)?=\s|[^\s#]{1,80}\#/))
"""
"""Matches the start of a role that is not complete, or of a misspelled comment."""

FENCED_CODE = r"""
    ^[ >]*(?P<fence>`{3,}(?=[^`\n]*$)|~{3,})
    (?s:.*?)(^[ >]*(?P=fence)[`~]*[ \t\r]*$|\Z)
"""
INLINE_CODE = r"""
    (?<![\\`])(?P<ticks>`{1,8})(?!`)
    ([^\n]|\n(?![ \t\r]*\n)){1,200}?
    (?<!`)(?P=ticks)(?!`)
"""


def region_pattern(*parts: str) -> re.Pattern[str]:
    return re.compile("|".join(parts), re.VERBOSE | re.MULTILINE)


MARKS = (COMMENT, ROLE, BROKEN)
REGIONS = {
    ".html": region_pattern(*MARKS),
    ".htm": region_pattern(*MARKS),
    ".tex": region_pattern(*MARKS),
    ".rst": region_pattern(*MARKS, INLINE_CODE),
}
"""Patterns of the comments, roles and code in each type of text; others are Markdown."""

REGIONS_OF_MARKDOWN = region_pattern(*MARKS, FENCED_CODE, INLINE_CODE)
MARK_START = re.compile(r"(?!={3})=|[^\W\d_]\w*\s*=(?!=)")
"""Matches ``= place`` and ``name = place``, but neither ``===== Results =====`` nor
``a == b``."""

WORD_MARK_START = re.compile(r"(?P<yes>.+?)\sif\s.*[<>=≤≥](?P<rest>.*)")
TABLE_SOURCE = re.compile(r"\{row\}|\{column\}")
PLAIN_IN_PLACES = "/~!$&()*+,:;=@[]|"
"""Characters of a place that are not percent-encoded in a mark."""


@dataclass(frozen=True)
class Context:
    """The position of a mark and the text before it."""

    line: int
    start: int
    """The position at which ``before`` begins in the text."""
    before: str
    """The text whose last number or word belongs to the mark."""


@dataclass(frozen=True)
class NumberMark:
    """A mark of a number with its source: ``name = source unit ± 5 %``."""

    context: Context
    source: str
    name: str
    unit: str
    digits: str
    """The number of significant digits to print; empty to keep the present number."""
    tolerance: str
    """The allowed deviation [%]; empty to allow only the noise."""


@dataclass(frozen=True)
class WordMark:
    """A mark of a word with its comparison: ``yes if a < b else no``."""

    context: Context
    yes: str
    no: str
    left: str
    sign: str
    right: str


@dataclass(frozen=True)
class BrokenMark:
    """A comment or a role that looks like a mark but is not valid."""

    context: Context
    problem: str


Mark = NumberMark | WordMark | BrokenMark


def line_counter(text: str) -> Callable[[int], int]:
    """Return a function that maps a position in a text to its line."""
    newlines = [match.start() for match in re.finditer("\n", text)]
    return lambda position: bisect(newlines, position) + 1


def read_marks(text: str, suffix: str) -> Iterator[Mark]:
    """Yield the marks of a text from a file whose name ends in ``suffix``."""
    end = 0
    line_of = line_counter(text)
    tables = {table.end: table for table in read_tables(text)}
    for region in regions(text, suffix):
        start, stop = region.span("printed")
        if region["comment"] is not None:
            stop = region.start()
            # The limit keeps the time linear in the length of the text.
            start = max(end, stop - BEFORE_LIMIT)
        end = region.end()
        context = Context(line_of(region.start()), start, text[start:stop])
        mark = _parsed(region, context)
        if isinstance(mark, NumberMark) and TABLE_SOURCE.search(mark.source):
            table = tables.get(start + len(text[start:stop].rstrip()))
            yield from _marks_of_table(mark, table, line_of)
        elif mark is not None:
            yield mark


def _parsed(region: re.Match[str], context: Context) -> Mark | None:
    """Return the mark of a comment or role, or None if a region is not a mark."""
    role = region["role"] or region["broken"]
    text = " ".join((region["comment"] or role or "").split())
    text = re.sub(r"\\([#%_&])", r"\1", text)  # LaTeX needs these escapes.
    is_closed = region["unclosed"] is None
    if is_closed and len(text) <= MARK_LIMIT:
        if match := NUMBER_MARK.fullmatch(text):
            return NumberMark(context, **match.groupdict(""))
        if match := WORD_MARK.fullmatch(text):
            return WordMark(context, **match.groupdict(""))
    if not (role or _looks_like_mark(text, context.before)):
        return None
    if not is_closed:
        problem = "is not closed"
    elif len(text) > MARK_LIMIT:
        problem = f"has more than {MARK_LIMIT} characters"
    else:
        problem = "is not a valid mark: write = FILE#/PLACE"
    return BrokenMark(context, f"{text:.60} {problem}")


def _looks_like_mark(text: str, before: str) -> bool:
    """Return whether a comment after the text ``before`` is intended as a mark."""
    if MARK_START.match(text):
        return True
    if any("#/" in word and "://" not in word for word in text.split()):
        return True
    words = WORD_MARK_START.match(text[:MARK_LIMIT])
    if words is None:
        return False
    return "else" in words["rest"] or before.endswith(words["yes"])


def _marks_of_table(
    mark: NumberMark, table: Table | None, line_of: Callable[[int], int]
) -> Iterator[NumberMark | BrokenMark]:
    """Yield a mark for each number of the table that a mark follows."""
    if table is None or mark.name:
        problem = "must follow a table, and cannot have a name"
        yield BrokenMark(mark.context, f"{mark.source} {problem}")
        return
    for cell in number_cells(table):
        before = cell.text.rstrip(MARKUP)
        unit = split_unit(cell.column)[1]
        # The head of the column has the unit, unless the cell has its own.
        if unit != NO_UNIT and before[-1].isdigit():
            before += f" {unit}"
        context = Context(line_of(cell.start), cell.start, before)
        yield replace(mark, context=context, source=source_of_cell(mark.source, cell))


def number_cells(table: Table) -> Iterator[Cell]:
    """Yield the cells with a number, except code and cells with a mark of their own."""
    for cell in table.cells:
        if re.fullmatch(r"(?!.*(`|<!--|\0)).*\d.*", cell.text.strip()):
            yield cell


def source_of_cell(source: str, cell: Cell) -> str:
    """Insert the names of a cell's row and column into the source of a table's mark."""
    column = split_unit(cell.column)[0]
    return source.replace("{row}", quote(cell.row, PLAIN_IN_PLACES)).replace(
        "{column}", quote(column, PLAIN_IN_PLACES)
    )


def regions(text: str, suffix: str) -> Iterator[re.Match[str]]:
    """Return the comments, roles and code of a text in their order."""
    return REGIONS.get(suffix.lower(), REGIONS_OF_MARKDOWN).finditer(text)
