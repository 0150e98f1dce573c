"""Shared by the sections on time and memory."""

from collections.abc import Iterable

from measured_report.values.format import format_number
from measured_report.values.quantities import PERCENT, Value, combined
from measured_report.values.results import Results, Row

TIMED_WORLDS = (1, 4096, 16384)  # numbers of worlds that are timed wherever not all are
# From which share of a frame's time on a slowdown matters, and why [%].
SLOWER = ("a smaller slowdown makes no difference", 3.0)


def worlds_name(count: int) -> str:
    """Name a batch of so many worlds."""
    return f"{format_number(count)} world{'s' * (count > 1)}"


class RowsBy(dict):
    """Rows by the cells that tell them apart; a row of a missing key has no numbers."""

    def __init__(self, results: Results, rows: Iterable[Row], *columns: str):
        self.results = results
        for row in rows:
            key = tuple(row.plain.get(column) for column in columns)
            if None not in key:
                self[key] = row

    def __missing__(self, key: tuple) -> Row:
        return self.results.row[" ".join(map(str, key))]


def resolution(results: Results, name: str, rows: Iterable[Row]) -> Value:
    """Derive to within what share all ratios of these rows are known [%].

    The reference and lost times have none.
    """
    cells = [row.ratio_resolution for row in rows if "ratio_resolution" in row]
    return results.value(
        name,
        "half the 95 % interval of the ratio of two times measured in turn, the largest",
        PERCENT * combined(max, *(cell for cell in cells if cell.value)),
        is_noise=True,
    )
