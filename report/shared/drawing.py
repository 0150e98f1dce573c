"""What figures of several sections draw alike."""

from collections.abc import Iterable

from matplotlib.axes import Axes

from measured_report.parts.figures import SERIES

STIFF, SHIPPED, TERM, CURE = SERIES[
    :4
]  # the colour of a condition, the same in every figure


def mark_points(
    axes: Axes, points: Iterable[tuple[float | None, float | None]], **style
) -> None:
    """Mark the points that have both coordinates; a line goes through them only where the style has one."""
    complete = [point for point in points if None not in point]
    axes.plot(
        [x for x, _ in complete],
        [y for _, y in complete],
        **{"linestyle": "", "markevery": 1, **style},
    )


def name_lines(axes: Axes, names: Iterable[str]) -> None:
    """Name the lines at the places 0, 1, … from the top down."""
    named = list(names)
    axes.set_yticks(range(len(named)), named)
    axes.invert_yaxis()
