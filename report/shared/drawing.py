"""Draw the elements that several figures share."""

# ruff: noqa: F401

from collections.abc import Iterable, Sequence
from decimal import ROUND_HALF_UP, Decimal

from matplotlib import ticker
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure as Drawing
from matplotlib.text import Annotation

from measured_report.parts.figures import FAINT, INK, SERIES, is_narrow, new_figure
from measured_report.values.quantities import Quantity

MAP_INK = "#101418"
"""Text on a map has this colour, because a map keeps its colours on a dark page."""

# Each condition has the same colour in every figure.
STIFF, SHIPPED, TERM, CURE = SERIES[:4]
NAME_GAP = 1.45  # chosen: the factor between two names on a logarithmic axis of slips
Point = tuple[float | None, float | None]


def mark_points(axes: Axes, points: Iterable[Point], **style) -> None:
    """Mark the points that have both coordinates, and connect them if the style has a line."""
    complete = [point for point in points if None not in point]
    style = {"linestyle": "", "markevery": 1, **style}
    axes.plot([x for x, _ in complete], [y for _, y in complete], **style)


def draw_line(axes: Axes, x: Sequence, y: Sequence, **style) -> None:
    """Draw a line without markers."""
    axes.plot(x, y, **{"linestyle": "-", "marker": "", **style})


def write_beside(
    axes: Axes, text: str, place: Point, offset: tuple[float, float], **style
) -> Annotation:
    """Write a text beside a place, at an offset in points."""
    style = {"xytext": offset, "textcoords": "offset points", **style}
    return axes.annotate(text, place, **style)


def name_ends(
    axes: Axes,
    ends: Iterable[tuple[float, float, str, str]],
    offset: float,
    near: float,
    **style,
) -> None:
    """Write the name of each line beside its end, below the names of nearby lines.

    Args:
        ends: the coordinates of each end on logarithmic axes, its name and its colour.
        offset: the horizontal distance of the names in points.
        near: the factor between the x of lines whose names could overlap.
    """
    written: list[tuple[float, float]] = []
    for x, y, name, colour in sorted(ends, key=lambda end: -end[1]):
        places = [low for other, low in written if x / near < other < x * near]
        low = min([y, *(place / NAME_GAP for place in places)])
        written.append((x, low))
        look = {"color": colour, "va": "center", "fontsize": 9, **style}
        write_beside(axes, name, (x, low), (offset, 0), **look)


def name_lines(axes: Axes, names: Iterable[str]) -> None:
    """Label the rows at y = 0, 1, … with these names, from the top down."""
    labels = list(names)
    axes.set_yticks(range(len(labels)), labels)
    axes.invert_yaxis()


def write(quantity: Quantity, *, is_short: bool = False) -> str:
    """Write a number for a figure.

    If ``is_short``, it is rounded to two digits for narrow cells.
    """
    return format_short(quantity.number) if is_short else quantity.written


def plain_labels(*, digits: int = 6) -> ticker.FuncFormatter:
    """Return a formatter of plain numbers without trailing zeros."""
    return ticker.FuncFormatter(lambda value, _: f"{value:.{digits}g}")


def tick_125(axis: Axis) -> None:
    """Label a logarithmic axis at 1, 2 and 5, so that less than a decade has labels."""
    axis.set_major_locator(ticker.LogLocator(subs=(1.0, 2.0, 5.0), numticks=12))
    axis.set_major_formatter(plain_labels())
    axis.set_minor_locator(ticker.NullLocator())


def tick_at(axis: Axis, places: Sequence[float], *, digits: int = 6) -> None:
    """Label an axis at these places only."""
    axis.set_ticks(places)
    axis.set_minor_locator(ticker.NullLocator())
    axis.set_major_formatter(plain_labels(digits=digits))


def format_short(value: float) -> str:
    """Write a ``value`` below 100 with two digits and as few characters as possible."""
    if value <= -0.005:
        return "−" + format_short(-value)
    if value < 0.005:
        return "<.01"
    exact = Decimal(repr(float(value)))
    places = next(
        (
            places
            for places, limit in ((2, "0.095"), (1, "9.95"))
            if exact < Decimal(limit)
        ),
        0,
    )
    return str(exact.quantize(Decimal(1).scaleb(-places), ROUND_HALF_UP)).removeprefix(
        "0" if places == 2 else ""
    )
