"""Tables of rows, and what stands in their cells."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from markupsafe import Markup

from measured_report.parts.section import Table
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row

Column = (
    str | Callable[[Row], Any] | Sequence
)  # a column of the record, what makes a cell of a row, or the cells
NAMED_COUNT = 6  # cases that a sentence names at most


def by_case(
    rows: Sequence[Row], columns: Mapping[str, Column], **numbers: Quantity | str | bool
) -> Table:
    """Make a table with a line for each row, under the name of its case."""
    return table_of("case", [case_html(row) for row in rows], columns, rows, **numbers)


def case_html(row: Row) -> Markup:
    """Return the label of a row's case, its code name in the title."""
    return Markup('<span class="case" title="{}">{}</span>').format(
        row["case"], row.label
    )


def some_html(names: Sequence[Markup]) -> Markup:
    """Name as many as a sentence can hold, and that there are others."""
    return Markup("; ").join(names[:NAMED_COUNT]) + (
        " and others" if len(names) > NAMED_COUNT else ""
    )


def table_of(
    heading: str,
    names: Iterable[Any],
    columns: Mapping[str, Column],
    rows: Iterable[Row] = (),
    **numbers: Quantity | str | bool,
) -> Table:
    """Make a table with a line for each name, of which ``rows`` has the row; the caption can name ``numbers``."""
    import pandas as pd  # it takes long, and what is kept from before needs none of it

    rows, filled = list(rows), dict[str, list]()
    for above, column in columns.items():
        cells = (
            (cell_or_lost(row, column) for row in rows)
            if isinstance(column, str)
            else column
        )
        filled[above] = list(map(cells, rows) if callable(cells) else cells)
    return Table(
        pd.DataFrame(filled, index=pd.Index(list(names), name=heading), dtype=object),
        numbers,
    )


def cell_or_lost(row: Row, column: str) -> Any:
    """Return a cell of a table, in words where the cube was lost."""
    cell = row[column]
    return (
        "lost"
        if row.plain.get("dropped") and getattr(cell, "value", cell) is None
        else cell
    )


def creep_or_unseen(row: Row) -> Any:
    """Return the creep of a row for a table, in words where its slip is not seen."""
    is_seen = row.slip_mm.value is None or row.slip_mm.value > (
        row.slip_mm.noise or 0.0
    )
    return cell_or_lost(row, "creep_mm_per_cycle") if is_seen else "not seen"
