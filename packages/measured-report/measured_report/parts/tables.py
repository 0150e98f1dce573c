"""Tables as HTML: one unit a column, numbers aligned at their points, one mark for what there is none of."""

import re
from typing import Any, NamedTuple

import pandas as pd
from markupsafe import Markup

from measured_report.parts.macros import macros
from measured_report.values.format import ABSENT, unit_label
from measured_report.values.quantities import Quantity
from measured_report.values.results import ResultsError

FIGURE_SPACE, POINT_SPACE = "\u2007", "\u2008"
"""As wide as a digit and as a point. They are put behind a number by the stylesheet, so that nobody copies them."""
FRACTION = re.compile(r"\.(\d*)$")


class _Column(NamedTuple):
    """Hold all that the cells of a column have in common."""

    name: str
    has_numbers: bool
    unit: str
    """Empty where its numbers have several, and can't be compared."""
    places: int
    """The most digits behind a point."""

    @property
    def label(self) -> str:
        return unit_label(self.unit or "1")

    def cell(self, value: Any) -> tuple["_Column", Any, str]:
        """Return the column, the text of a cell, and what fills it for its point to stand below the others."""
        if isinstance(value, Quantity):
            if not self.unit:
                return self, value, ""
            count = _place_count(value)
            missing = "" if "×" in value.written else (self.places - count) * FIGURE_SPACE
            return self, value.bare, missing if count or not missing else POINT_SPACE + missing
        if isinstance(value, bool):
            return self, "yes" if value else "no", ""
        is_missing = pd.isna(value) or value == ""
        if isinstance(value, int | float) and not is_missing:
            raise ResultsError(f"the number {value} in a table says nothing of where it comes from")
        return self, ABSENT if is_missing else value, ""


def table_html(frame: pd.DataFrame) -> Markup:
    """Make the table of a frame whose cells are Quantities, text, or yes and no; the index names the rows."""
    columns = [_column(name, frame[name]) for name in frame]
    rows = (
        (name, [column.cell(value) for column, value in zip(columns, row, strict=True)])
        for name, row in zip(frame.index, frame.astype(object).to_numpy(), strict=True)
    )
    return macros().table(frame.index.name or "", columns, rows)


def _column(name: str, cells: pd.Series) -> _Column:
    numbers = [cell for cell in cells if isinstance(cell, Quantity)]
    units = {cell.unit for cell in numbers}
    places = max(map(_place_count, numbers), default=0)
    return _Column(name, bool(numbers), units.pop() if len(units) == 1 else "", places)


def _place_count(number: Quantity) -> int:
    """Count the digits behind the point of a number as it is written."""
    found = FRACTION.search(number.written if number.source else "")
    return len(found[1]) if found else 0
