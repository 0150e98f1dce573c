"""Provide helpers for the sections on run time and memory."""

from collections.abc import Iterable

from measured_report.values.format import format_number
from measured_report.values.quantities import PERCENT, Value, combined
from measured_report.values.results import Results, Row

TIMED_WORLDS = (
    1,
    4096,
    16384,
)  # numbers of worlds of sections that do not time all of them
# The smallest slowdown that matters, relative to the time of a frame [%].
SLOWER = ("a smaller slowdown makes no difference", 3.0)


def worlds_name(count: int) -> str:
    """Return the name of a batch with this number of worlds."""
    return f"{format_number(count)} world{'s' * (count > 1)}"


class RowsBy(dict):
    """Holds rows by their values in some columns.

    A missing key gives a row without numbers.
    """

    def __init__(self, results: Results, rows: Iterable[Row], *columns: str):
        self.results = results
        for row in rows:
            key = tuple(row.plain.get(column) for column in columns)
            if None not in key:
                self[key] = row

    def __missing__(self, key: tuple) -> Row:
        return self.results.row[" ".join(map(str, key))]


def resolution(results: Results, name: str, rows: Iterable[Row]) -> Value:
    """Derive the resolution of the least precise ratio in these rows [%].

    The reference row and rows without a time have no resolution.
    """
    cells = [row.ratio_resolution for row in rows if "ratio_resolution" in row]
    return results.value(
        name,
        "largest half-width of the 95 % intervals of time ratios, measured in turn",
        PERCENT * combined(max, *(cell for cell in cells if cell.value)),
        is_noise=True,
    )
