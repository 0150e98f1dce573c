"""What figures of several sections draw alike."""

from collections.abc import Iterable, Sequence

from matplotlib.axes import Axes

from measured_report.parts.figures import SERIES
from measured_report.values.quantities import Quantity

STIFF, SHIPPED, TERM, CURE = SERIES[:4]
"""The colour of a condition, the same in every figure: stiff pads, as shipped, the left-out term, the whole cure."""


def mark_cells(axes: Axes, cells: Sequence[Quantity | None], colour: str, label: str, **style) -> None:
    """Mark each cell that there is, and that the axis can show, in the line of its place."""
    least = 0.0 if axes.get_xscale() == "log" else float("-inf")
    found = [(cell.value, place) for place, cell in enumerate(cells) if cell is not None and cell.value is not None]
    there = [(value, place) for value, place in found if value > least]
    mark_points(axes, there, color=colour, label=label, **style)


def mark_points(axes: Axes, points: Iterable[tuple[float | None, float | None]], **style) -> None:
    """Mark the points that have both coordinates; a line goes through them only where the style has one."""
    there = [point for point in points if None not in point]
    axes.plot([x for x, _ in there], [y for _, y in there], **{"linestyle": "", "markevery": 1, **style})


def name_lines(axes: Axes, names: Iterable[str]) -> None:
    """Name the lines at the places 0, 1, … from the top down."""
    named = list(names)
    axes.set_yticks(range(len(named)), named)
    axes.invert_yaxis()
