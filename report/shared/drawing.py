"""All that figures are drawn with, and what several draw alike."""

# ruff: noqa: F401

from collections.abc import Iterable, Sequence

from matplotlib import ticker
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure as Drawing
from matplotlib.text import Annotation

from measured_report.parts.figures import FAINT, INK, SERIES, is_narrow, new_figure
from measured_report.values.format import format_short
from measured_report.values.quantities import Quantity

MAP_INK = "#101418"
"""Colour of texts on a map, which keeps its colours on a dark page."""

# The colour of a condition, the same in every figure.
STIFF, SHIPPED, TERM, CURE = SERIES[:4]
Point = tuple[float | None, float | None]


def mark_points(axes: Axes, points: Iterable[Point], **style) -> None:
    """Mark the points that have both coordinates, with a line if the style has one."""
    complete = [point for point in points if None not in point]
    style = {"linestyle": "", "markevery": 1, **style}
    axes.plot([x for x, _ in complete], [y for _, y in complete], **style)


def draw_line(axes: Axes, x: Sequence, y: Sequence, **style) -> None:
    """Draw a line without marks."""
    axes.plot(x, y, **{"linestyle": "-", "marker": "", **style})


def write_beside(
    axes: Axes, text: str, place: Point, offset: tuple[float, float], **style
) -> Annotation:
    """Write a text so many points beside a place."""
    style = {"xytext": offset, "textcoords": "offset points", **style}
    return axes.annotate(text, place, **style)


def name_lines(axes: Axes, names: Iterable[str]) -> None:
    """Name the lines at the places 0, 1, … from the top down."""
    named = list(names)
    axes.set_yticks(range(len(named)), named)
    axes.invert_yaxis()


def write(quantity: Quantity, *, is_short: bool = False) -> str:
    """Write a number for a figure, in four characters if ``is_short``."""
    return format_short(quantity.number) if is_short else quantity.written


def plain_labels(*, digits: int = 6) -> ticker.FuncFormatter:
    """Format labels as plain numbers, without zeros at their ends."""
    return ticker.FuncFormatter(lambda value, _: f"{value:.{digits}g}")


def tick_125(axis: Axis) -> None:
    """Label a logarithmic axis at 1, 2 and 5 of each decade, so that less than a decade has labels too."""
    axis.set_major_locator(ticker.LogLocator(subs=(1.0, 2.0, 5.0), numticks=12))
    axis.set_major_formatter(plain_labels())
    axis.set_minor_locator(ticker.NullLocator())


def tick_at(axis: Axis, places: Sequence[float], *, digits: int = 6) -> None:
    """Label an axis at these places."""
    axis.set_ticks(places)
    axis.set_minor_locator(ticker.NullLocator())
    axis.set_major_formatter(plain_labels(digits=digits))


def say_value(axes: Axes, x: float, y: float, text: str, *, gap: float = 6.0) -> None:
    """Write the value of a mark or a bar, ``gap`` points to the right of it."""
    axes.annotate(
        text,
        (x, y),
        xytext=(gap, 0),
        textcoords="offset points",
        fontsize=8.5,
        va="center",
        zorder=6,
    )
