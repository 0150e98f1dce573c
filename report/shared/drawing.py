"""What the sections' figures share."""

from collections.abc import Sequence

from matplotlib.axes import Axes


def draw_marks(axes: Axes, x: Sequence[float], y: Sequence, marker: str, **style) -> None:
    """A mark at each place, and no line between them."""
    axes.plot(x, y, linestyle="", marker=marker, markevery=1, **style)
