"""Tables as HTML: one unit a column, numbers aligned at their points, one mark for what there is none of."""

import re
from typing import Any

import pandas as pd
from markupsafe import Markup

from measured_report.values.format import ABSENT, unit_label
from measured_report.values.quantities import Quantity
from measured_report.values.results import ResultsError

FIGURE_SPACE, POINT_SPACE = "\u2007", "\u2008"
"""As wide as a digit and as a point. They are put behind a number by the stylesheet, so that nobody copies them."""
FRACTION = re.compile(r"\.(\d*)$")


def table_html(frame: pd.DataFrame) -> Markup:
    """The table of a frame whose cells are Quantities, text, or yes and no; the index names the rows."""
    columns = {name: _Column(frame[name]) for name in frame}
    corner = Markup('<th scope="col">{}</th>').format(frame.index.name or "")
    head = Markup("").join(column.head(name) for name, column in columns.items())
    body = Markup("\n").join(
        Markup('<tr><th scope="row">{}</th>{}</tr>').format(
            name, Markup("").join(columns[column].cell(value) for column, value in row.items())
        )
        for name, row in frame.astype(object).iterrows()
    )
    return Markup(
        '<div class="wide"><table>\n<thead><tr>{}{}</tr></thead>\n<tbody>\n{}\n</tbody></table></div>'
    ).format(corner, head, body)


class _Column:
    """What all cells of a column have in common."""

    def __init__(self, cells: pd.Series):
        numbers = [cell for cell in cells if isinstance(cell, Quantity)]
        units = {cell.unit for cell in numbers}
        self._has_numbers = bool(numbers)
        self._unit = units.pop() if len(units) == 1 else None
        self._places = max((_place_count(cell) for cell in numbers), default=0)

    def head(self, name: str) -> Markup:
        label = unit_label(self._unit or "1")
        kind = Markup(' class="number"') if self._has_numbers else ""
        return Markup('<th scope="col"{}>{}{}</th>').format(kind, name, f" [{label}]" if label else "")

    def cell(self, value: Any) -> Markup:
        if isinstance(value, Quantity):
            if not self._unit:  # the numbers of this column can't be compared, and have no points to align
                return Markup('<td class="number">{}</td>').format(value)
            return Markup('<td class="number"{}>{}</td>').format(self._filled(value), value.bare)
        if isinstance(value, bool):
            return Markup("<td>{}</td>").format("yes" if value else "no")
        if isinstance(value, int | float) and not pd.isna(value):
            raise ResultsError(f"the number {value} in a table says nothing of where it comes from")
        kind = Markup(' class="number"') if self._has_numbers else ""
        return Markup("<td{}>{}</td>").format(kind, ABSENT if pd.isna(value) or value == "" else value)

    def _filled(self, value: Quantity) -> Markup:
        """What is missing behind the number for its point to stand below the others."""
        count = _place_count(value)
        missing = (self._places - count) * FIGURE_SPACE
        if not missing or "×" in value.written:
            return Markup("")
        return Markup(' data-fill="{}"').format(missing if count else POINT_SPACE + missing)


def _place_count(number: Quantity) -> int:
    """Digits behind the point as it is written."""
    found = FRACTION.search(number.written if number.source else "")
    return len(found[1]) if found else 0
