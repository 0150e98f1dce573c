"""Make tables of rows, and the text of their cells."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from markupsafe import Markup

from measured_report.parts.section import Table
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row

NAMED_COUNT = 6  # the largest number of cases that a sentence can list readably


def by_case(
    rows: Sequence[Row], columns: Mapping[str, Any], **numbers: Quantity | str
) -> Table:
    """Make a table with one line per row, which is named after its case."""
    return table_of("case", map(case_html, rows), columns, rows, **numbers)


def case_html(row: Row) -> Markup:
    """Return the label of a row's case, with the name of the case as its tooltip."""
    html = Markup('<span class="case" title="{}">{}</span>')
    return html.format(row["case"], row.label)


def some_html(names: Sequence[Markup]) -> Markup:
    """Join the first names to a list, and add "and others" if there are more."""
    more = " and others" if len(names) > NAMED_COUNT else ""
    return Markup("; ").join(names[:NAMED_COUNT]) + more


def table_of(
    heading: str,
    names: Iterable[Any],
    columns: Mapping[str, Any],
    rows: Sequence[Row] = (),
    **numbers: Quantity | str,
) -> Table:
    """Make a table with one line per name.

    Args:
        heading: Heading of the names.
        columns: The cells of each heading, or the name of a column of ``rows``.
        numbers: Numbers that the caption can print.
    """
    import pandas as pd  # imported here because it is slow, and cached sections do not need it

    cells = {
        title: [cell_or_lost(row, column) for row in rows]
        if isinstance(column, str)
        else list(column)
        for title, column in columns.items()
    }
    index = pd.Index(list(names), name=heading)
    return Table(pd.DataFrame(cells, index=index, dtype=object), numbers)


def cell_or_lost(row: Row, column: str) -> Any:
    """Return a cell, or "lost" if it has no number because the cube was lost."""
    cell = row[column]
    is_missing = getattr(cell, "value", cell) is None
    return "lost" if row.plain.get("dropped") and is_missing else cell


def measurable_creep(row: Row) -> Any:
    """Return the creep of a row, or "not measurable" if its slip is within the noise."""
    slip = row.slip_mm
    if slip.value is not None and not slip.is_distinct:
        return "not measurable"
    return cell_or_lost(row, "creep_mm_per_cycle")
