"""What figures of several sections draw alike."""

from collections.abc import Iterable, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure, say_value, write
from measured_report.values.quantities import Quantity

STIFF, SHIPPED, TERM, CURE = SERIES[:4]
"""The colour of a condition, the same in every figure: stiff pads, as shipped, the left-out term, the whole cure."""


def mark_points(axes: Axes, points: Iterable[tuple[float | None, float | None]], **style) -> None:
    """Mark the points that have both coordinates; a line goes through them only where the style has one."""
    there = [point for point in points if None not in point]
    axes.plot([x for x, _ in there], [y for _, y in there], **{"linestyle": "", "markevery": 1, **style})


def name_lines(axes: Axes, names: Iterable[str]) -> None:
    """Name the lines at the places 0, 1, … from the top down."""
    named = list(names)
    axes.set_yticks(range(len(named)), named)
    axes.invert_yaxis()


def draw_bars(
    names: Sequence[str], cells: Sequence[Quantity], colours: Sequence[str], xlabel: str
) -> tuple[Drawing, Axes]:
    """Draw a bar with its value for each cell, from the top down; none for one that is not there."""
    drawing, axes = new_figure(7.2, 0.9 + (0.36 if is_narrow() else 0.28) * len(names))
    for place, (cell, colour) in enumerate(zip(cells, colours, strict=True)):
        if cell.value is not None:
            axes.barh(place, cell.value, height=0.6, color=colour, linewidth=0)
            say_value(axes, max(cell.value, 0.0), place, write(cell))
    axes.axvline(0.0, color=INK, linewidth=0.8, marker="")
    name_lines(axes, names)
    axes.margins(x=0.15)
    axes.grid(axis="y", visible=False)
    axes.set_xlabel(xlabel)
    return drawing, axes
