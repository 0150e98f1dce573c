"""Shared by the sections on time and memory."""

import math
from collections.abc import Iterable

from matplotlib.axes import Axes

from measured_report.parts.claim import Outcome
from measured_report.parts.figures import SERIES, is_narrow
from measured_report.values.format import format_number
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import resolved
from report.shared.drawing import mark_points

TIMED_WORLDS = (1, 4096, 16384)
"""Numbers of worlds that are timed wherever not all are."""


def worlds_name(count: int) -> str:
    """Name a batch of so many worlds."""
    return f"{format_number(count)} world{'s' * (count > 1)}"


class RowsBy(dict):
    """Rows by the cells that tell them apart, but for those that lost one; of what was not measured, a row without
    anything."""

    def __init__(self, results: Results, rows: Iterable[Row], *columns: str):
        self.results = results
        for row in rows:
            key = tuple(row.plain.get(column) for column in columns)
            if None not in key:
                self[key] = row

    def __missing__(self, key: tuple) -> Row:
        return self.results.row[" ".join(map(str, key))]


def resolution(results: Results, name: str, rows: Iterable[Row]) -> Value:
    """Derive to within what share the ratios of these rows are known [%], the largest of them."""
    formula = "half the 95 % interval of the ratio of two times measured in turn, the largest"
    cells = [row.ratio_resolution for row in rows]
    return results.value(name, formula, lambda *found: 100 * max(found), *cells, unit="%", is_noise=True)


def compared(rows: Iterable[Row]) -> list[Row]:
    """Select the rows that have a ratio; the reference has none, and others may have no time."""
    return [row for row in rows if "ratio_resolution" in row and row.ratio_resolution.value]


def fine_enough(unseen: Quantity) -> Outcome:
    """Tell whether times are known well enough to say that nothing is slower, from what share would be seen [%]."""
    return resolved(unseen, 3.0, why="a slowdown that would matter")


def world_axis(axes: Axes, counts: list[int]) -> None:
    """Make the axis of numbers of worlds logarithmic, with a tick at each that was measured; on a narrow screen every
    second has its label, the last among them."""
    axes.set_xscale("log")
    axes.minorticks_off()
    labelled = counts[::-2] if is_narrow() else counts
    axes.set_xticks(counts, [format_number(count) if count in labelled else "" for count in counts])


def decade_axis(axes: Axes) -> None:
    """Make the vertical axis logarithmic over whole powers of ten, so that it has labels however little is drawn."""
    low, high = axes.dataLim.intervaly
    axes.set_yscale("log")
    if 0 < low <= high:
        axes.set_ylim(10 ** math.floor(math.log10(low)), 10 ** (math.floor(math.log10(high)) + 1))
    axes.minorticks_off()


def draw_line(axes: Axes, counts: list[int], cells: list[Quantity], series: int, label: str) -> None:
    """Draw ``cells`` against the number of worlds, as the series of that number."""
    line, marker = (("-", "o"), ("--", "s"))[series]
    points = zip(counts, (cell.value for cell in cells), strict=True)
    mark_points(axes, points, color=SERIES[series], linestyle=line, marker=marker, label=label)
