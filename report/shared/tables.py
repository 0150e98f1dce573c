"""Tables of rows, and how their cells are written."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from markupsafe import Markup

from measured_report.parts.section import Table
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row

NAMED_COUNT = 6  # cases that a sentence names at most


def by_case(
    rows: Sequence[Row], columns: Mapping[str, Any], **numbers: Quantity | str
) -> Table:
    """Make a table with a line for each row, under the name of its case."""
    return table_of("case", map(case_html, rows), columns, rows, **numbers)


def case_html(row: Row) -> Markup:
    """Return the label of a row's case, its code name in the title."""
    html = Markup('<span class="case" title="{}">{}</span>')
    return html.format(row["case"], row.label)


def some_html(names: Sequence[Markup]) -> Markup:
    """Name as many as a sentence can hold, and say if there are others."""
    more = " and others" if len(names) > NAMED_COUNT else ""
    return Markup("; ").join(names[:NAMED_COUNT]) + more


def table_of(
    heading: str,
    names: Iterable[Any],
    columns: Mapping[str, Any],
    rows: Sequence[Row] = (),
    **numbers: Quantity | str,
) -> Table:
    """Make a table with a line for each name.

    Args:
        columns: By heading the cells, or the name of a column of ``rows``.
        numbers: Numbers that the caption can name.
    """
    import pandas as pd  # it takes long, and what is kept from before needs none of it

    cells = {
        above: [cell_or_lost(row, column) for row in rows]
        if isinstance(column, str)
        else list(column)
        for above, column in columns.items()
    }
    index = pd.Index(list(names), name=heading)
    return Table(pd.DataFrame(cells, index=index, dtype=object), numbers)


def cell_or_lost(row: Row, column: str) -> Any:
    """Return a cell of a table, in words where the cube was lost."""
    cell = row[column]
    has_none = getattr(cell, "value", cell) is None
    return "lost" if row.plain.get("dropped") and has_none else cell


def creep_or_unseen(row: Row) -> Any:
    """Return the creep of a row for a table, in words where its slip is not seen."""
    slip = row.slip_mm
    if slip.value is not None and not slip.is_distinct:
        return "not measurable"
    return cell_or_lost(row, "creep_mm_per_cycle")
