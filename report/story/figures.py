"""Draw the figure that explains the mechanism."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Arc, Rectangle

from report.shared.drawing import FAINT, INK, SERIES, Drawing, draw_line, new_figure

PAD, LEFT_OUT = SERIES[:2]  # colours of the pad's velocity and of the left-out term


def draw_mechanism() -> Drawing:
    """Draw the acceleration that a contact row leaves out, and the reaction of its friction.

    The drawing does not show data and is not to scale.
    """
    drawing, (left, right) = new_figure(7.2, 2.5, ncols=2)
    _draw_arc(left)
    _draw_brake(right)
    for axes in (left, right):
        axes.set_axis_off()
        axes.set_aspect("equal", anchor="N")
    return drawing


def _draw_arc(axes: Axes) -> None:
    axes.set_title("1. A turning joint moves the pad")
    radius = 3.0
    angle = np.radians(58)
    outward = np.array([np.cos(angle), np.sin(angle)])
    along = np.array([np.sin(angle), -np.cos(angle)])
    pad = radius * outward
    arc = Arc((0.0, 0.0), 2 * radius, 2 * radius, theta1=18, theta2=98)
    arc.set(color=INK, linestyle="--", linewidth=1.0)
    axes.add_patch(arc)
    draw_line(axes, [0.0, pad[0]], [0.0, pad[1]], color=INK, linewidth=3.0)
    axes.plot(0.0, 0.0, marker="o", markersize=10, color=INK, markevery=1)
    axes.plot(*pad, marker="s", markersize=14, color=PAD, markevery=1)
    _arrow(axes, pad, pad + 1.5 * along, PAD)
    _arrow(axes, pad, pad - 1.5 * outward, LEFT_OUT)
    axes.annotate("joint", (0.25, -0.1), fontsize=9, va="top")
    beside = pad + 1.55 * along + (0.1, 0.1)
    text = "velocity J·q̇:\nin the contact row"
    axes.annotate(text, beside, color=PAD, fontsize=9)
    beside = pad - 1.3 * outward + (-0.25, 0.1)
    text = "acceleration J̇·q̇:\nleft out"
    axes.annotate(text, beside, color=LEFT_OUT, fontsize=9, ha="right")
    axes.annotate("pad", pad + (0.1, 0.3), fontsize=9)
    axes.set(xlim=(-1.6, 4.9), ylim=(-0.8, 3.5))


def _draw_brake(axes: Axes) -> None:
    axes.set_title("2. Friction brakes, but does not pull back")
    middle = {"fontsize": 9, "ha": "center", "va": "center"}
    pad = {"facecolor": PAD, "alpha": 0.3, "edgecolor": PAD}
    axes.add_patch(Rectangle((0.0, 2.1), 2.4, 0.75, **pad))
    axes.annotate("pad, on turning joints", (1.2, 2.47), **middle)
    axes.add_patch(Rectangle((0.0, 0.2), 2.4, 1.1, facecolor=FAINT, edgecolor=INK))
    axes.annotate("cube", (1.2, 0.62), **middle)
    _arrow(axes, (2.5, 2.47), (4.0, 2.47), LEFT_OUT)
    axes.annotate("J̇·q̇", (3.2, 2.6), color=LEFT_OUT, fontsize=9, ha="center")
    _arrow(axes, (-0.1, 0.75), (-1.0, 0.75), INK)
    axes.annotate("left behind\nat v = J̇·q̇ / b", (-1.0, 0.0), fontsize=9, va="top")
    y = 1.7  # height of the damper between pad and cube
    above = y + 0.17
    below = y - 0.17
    for xs, ys, width in (
        ([0.5, 0.5, 1.05], [1.3, y, y], 1.4),
        ([1.45, 1.05, 1.05, 1.45], [above, above, below, below], None),
        ([1.3, 1.3], [y - 0.12, y + 0.12], 2.0),
        ([1.3, 1.9, 1.9], [y, y, 2.1], 1.4),
    ):
        draw_line(axes, xs, ys, color=INK, linewidth=width)
    text = "friction row: −b·v,\na damper without a spring"
    axes.annotate(text, (2.1, 1.68), fontsize=9, va="center")
    axes.set(xlim=(-1.2, 5.3), ylim=(-0.9, 3.4))


def _arrow(axes: Axes, start, end, colour: str) -> None:
    style = {"arrowstyle": "-|>", "color": colour, "linewidth": 1.8, "shrinkA": 0}
    axes.annotate("", tuple(end), tuple(start), arrowprops=style)
