"""Reads marks: comments and roles that name the source of the number before them.

- Markdown and HTML: a comment, ``12.3 ms<!-- = bench.json#/mean -->``
- LaTeX: ``\\audited{12.3\\,ms}{= bench.json\\#/mean}``
- reStructuredText: ``:audit:`12.3 ms <= bench.json#/mean>```

A text is read once from its beginning to its end, so the time is proportional to its
length.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

MARK_LIMIT = 600
"""Most characters of a mark."""

BEFORE_LIMIT = 200
"""Largest distance between a comment and the start of its number."""

CODE_LIMIT = 200
"""Most characters of inline code."""

TICK_LIMIT = 8
"""Most backticks before inline code."""

NUMBER_MARK = re.compile(
    r"""
    ((?P<name>[^\W\d_]\w*)\s*)?
    =\s*(?=[\w(./-])(?P<source>.+?(?<=[\w)\]]))
    (\s+(?P<unit>[^\W\d_]\S{0,20}))?
    (\s+digits\s+(?P<digits>\d{1,2}))?
    (\s*±\s*(?P<tolerance>\d[\d.]{0,9})\s*%)?
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
ROLE = re.compile(
    r"""
    (?P<opening>:audit:`|\\audited\{)
    (?P<printed>[^`<{}]{1,200})(<|\}\{)
    (?P<mark>[^`{}]{1,600})(>`|\})
    """,
    re.VERBOSE,
)
FENCE = r"^[ >]*(?P<fence>`{3,}(?=[^`\n]*$)|~{3,})"
TICKS = r"(?P<ticks>`+)"
OPENINGS = ("<!--", r"(?P<role>:audit:`|\\audited\{)")
OPENINGS_BY_SUFFIX = {
    ".html": OPENINGS,
    ".htm": OPENINGS,
    ".tex": OPENINGS,
    ".rst": (*OPENINGS, TICKS),
}
OPENINGS_OF_MARKDOWN = (*OPENINGS, FENCE, TICKS)
BLANK_LINE = re.compile(r"\n[ \t\r]*\n")
RULER = re.compile(r"={3,}")
"""Matches a comment that divides a text, such as ``<!-- ===== Results ===== -->``."""


@dataclass(frozen=True)
class Region:
    """A comment, a role or code, in which numbers are not audited."""

    start: int
    end: int
    mark: str | None = None
    """The text of a comment or a role, or None for code."""
    printed: tuple[int, int] = (0, 0)
    """Start and end of the text whose last number belongs to the mark."""
    is_role: bool = False
    is_closed: bool = True


@dataclass(frozen=True)
class Context:
    """The position of a mark and the text before it."""

    line: int
    start: int
    """Position of ``before`` in the text."""
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
    """Significant digits to print; empty to keep the present number of digits."""
    tolerance: str
    """Allowed deviation [%]; empty to allow only the noise."""


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


def read_marks(text: str, suffix: str) -> Iterator[Mark]:
    """Yield the marks of a text from a file whose name ends in ``suffix``."""
    line = 1
    counted = 0
    for region in regions(text, suffix):
        line += text.count("\n", counted, region.start)
        counted = region.start
        if region.mark is None:
            continue
        start, end = region.printed
        mark = _parsed(region, Context(line, start, text[start:end]))
        if mark is not None:
            yield mark


def _parsed(region: Region, context: Context) -> Mark | None:
    """Return the mark of a comment or role, or None if the comment is not a mark."""
    text = " ".join((region.mark or "").split())
    text = re.sub(r"\\([#%_&])", r"\1", text)  # LaTeX needs these escapes.
    if region.is_closed and len(text) <= MARK_LIMIT:
        if match := NUMBER_MARK.fullmatch(text):
            return NumberMark(context, **match.groupdict(""))
        if match := WORD_MARK.fullmatch(text):
            return WordMark(context, **match.groupdict(""))
    if not (region.is_role or _looks_like_mark(text)):
        return None
    if not region.is_closed:
        problem = "is not closed"
    elif len(text) > MARK_LIMIT:
        problem = f"has more than {MARK_LIMIT} characters"
    else:
        problem = "is not a valid mark: write = FILE#/PLACE"
    return BrokenMark(context, f"{text:.60} {problem}")


def _looks_like_mark(text: str) -> bool:
    """Return whether a comment seems to be intended as a mark."""
    names_place = any("#/" in word and "://" not in word for word in text.split())
    return names_place or (text.startswith("=") and not RULER.match(text))


def regions(text: str, suffix: str) -> Iterator[Region]:
    """Yield the comments, roles and code of a text in their order."""
    openings = OPENINGS_BY_SUFFIX.get(suffix.lower(), OPENINGS_OF_MARKDOWN)
    opening = re.compile("|".join(openings), re.MULTILINE)
    end = 0
    while match := opening.search(text, end):
        start = match.start()
        groups = match.groupdict()
        if groups.get("role"):
            region = _role(text, start, match.end())
        elif groups.get("fence"):
            region = Region(start, _end_of_fenced_code(text, match))
        elif groups.get("ticks"):
            region = Region(start, _end_of_code(text, match))
        else:
            region = _comment(text, start, max(end, start - BEFORE_LIMIT))
        yield region
        end = region.end


def _comment(text: str, start: int, printed: int) -> Region:
    content = start + len("<!--")
    closing = text.find("-->", content)
    is_closed = closing >= 0
    if not is_closed:
        closing = len(text)
    return Region(
        start=start,
        end=closing + len("-->") if is_closed else closing,
        mark=text[content:closing],
        printed=(printed, start),
        is_closed=is_closed,
    )


def _role(text: str, start: int, content: int) -> Region:
    """Read a role, or the start of one that is not valid."""
    if match := ROLE.match(text, start):
        printed = match.span("printed")
        return Region(start, match.end(), match["mark"], printed, is_role=True)
    following = text[start : content + 40].partition("\n")[0]
    return Region(start, content, following, (start, start), is_role=True)


def _end_of_fenced_code(text: str, opening: re.Match[str]) -> int:
    """Return where fenced code ends: at a closing fence or at the end of the text."""
    fence = opening["fence"]
    closing = re.compile(rf"^[ >]*{fence}{fence[0]}*[ \t\r]*$", re.MULTILINE)
    match = closing.search(text, opening.end())
    return match.end() if match else len(text)


def _end_of_code(text: str, opening: re.Match[str]) -> int:
    """Return the end of inline code, or of its backticks if it is not closed."""
    ticks = opening["ticks"]
    start = opening.end()
    if len(ticks) > TICK_LIMIT:
        return start
    closing = re.compile(f"(?<!`){ticks}(?!`)")
    match = closing.search(text, start, start + CODE_LIMIT + TICK_LIMIT)
    if not match or BLANK_LINE.search(text, start, match.start()):
        return start
    return match.end()
