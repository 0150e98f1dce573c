"""All that figures are drawn with, and what several draw alike."""

# ruff: noqa: F401

from collections.abc import Iterable, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing
from matplotlib.text import Annotation

from measured_report.parts.figures import (
    FAINT,
    INK,
    MAP_INK,
    SERIES,
    is_narrow,
    new_figure,
    plain_labels,
    say_value,
    tick_125,
    tick_at,
    write,
)

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
