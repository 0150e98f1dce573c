"""Reads Markdown tables whose lines begin with ``|``."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

TABLE = re.compile(
    r"""
    ^(?P<quote>[ >]*)\|(?P<head>.*)\n
    [ >]*\|[ \t:|-]+\r?\n
    (?P<rows>([ >]*\|.*(\n|\Z))*)
    """,
    re.VERBOSE | re.MULTILINE,
)
COLUMN_END = re.compile(r"(?<!\\)\|")
MARKUP = " \t\r*_`~"
"""Characters that may surround the name of a row or column."""


@dataclass(frozen=True)
class Cell:
    """A cell of a table that is not in its first row or column."""

    row: str
    """This is the text in the first column."""
    column: str
    """This is the text in the first row."""
    text: str
    start: int
    """The position at which ``text`` begins in the document."""


@dataclass(frozen=True)
class Table:
    """Holds the cells of a table, and its first and last position in the document."""

    cells: list[Cell]
    start: int
    end: int
    """The position that follows the last ``|`` of the table."""


def read_tables(text: str) -> Iterator[Table]:
    """Yield the tables of a document."""
    for match in TABLE.finditer(text):
        head = list(map(_name, COLUMN_END.split(match["head"])))
        cells = []
        start = match.start("rows")
        for line in match["rows"].splitlines(keepends=True):
            first, *texts = COLUMN_END.split(line[line.index("|") + 1 :])
            position = start + line.index("|") + len(first) + 2
            for column, cell in zip(head[1:], texts, strict=False):
                cells.append(Cell(_name(first), column, cell, position))
                position += len(cell) + 1
            start += len(line)
        yield Table(cells, match.start(), match.start() + len(match[0].rstrip()))


def _name(cell: str) -> str:
    """Return the name of a row or column without its markup."""
    return cell.strip(MARKUP).replace("\\|", "|")
