"""Figures of the story: the suspects and the mechanism."""

from collections.abc import Collection, Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing
from matplotlib.patches import Arc, Rectangle

from measured_report.parts.figures import FAINT, INK, SERIES, new_figure, write
from measured_report.values.quantities import Quantity
from report.shared.drawing import SHIPPED, STIFF, mark_points, name_lines

FIX = "the pads' ke and kd"


def draw_suspects(
    slips: Mapping[str, Sequence[Quantity]], others: Collection[str], shipped: Quantity, bound: Quantity
) -> Drawing:
    """Draw the slip of each run [mm], a line for each thing that was changed; ``others`` are no suspects."""
    drawing, axes = new_figure(7.2, 0.9 + 0.32 * len(slips))
    for place, (name, cells) in enumerate(slips.items()):
        measured = [cell for cell in cells if cell.value is not None]
        colour = {FIX: STIFF}.get(name, SHIPPED if name in others else SERIES[5])
        points = [(cell.value, place) for cell in measured]
        mark_points(axes, points, marker="o", markersize=6, color=colour, alpha=0.75)
        for cell in measured if name in others else []:
            above = {"xytext": (0, 6), "textcoords": "offset points", "ha": "center"}
            axes.annotate(write(cell), (cell.number, place), fontsize=8.5, **above)
    if shipped.value is not None and bound.value is not None:
        margin = 0.01 * bound.value * shipped.value
        axes.axvspan(shipped.value - margin, shipped.value + margin, color=FAINT, alpha=0.45, linewidth=0, zorder=0)
        axes.axvline(shipped.value, color=INK, linestyle="--", linewidth=1.0, marker="")
    name_lines(axes, slips)
    axes.margins(y=0.12)
    axes.set(xlabel="slip [mm]", xlim=(0.0, None))
    axes.grid(axis="y", visible=False)
    return drawing


def draw_setup(numbers: Mapping[str, Quantity]) -> Drawing:
    """Draw the cube between the pads from the front, and how the hand moves it: with dimensions, not to scale."""
    labels = {name: f"{write(number)} {number.unit}" for name, number in numbers.items()}
    drawing, (grasp, motion) = new_figure(7.2, 2.2, ncols=2)
    grasp.set_title("The grip")
    grasp.add_patch(Rectangle((-1.0, -1.0), 2.0, 2.0, facecolor=FAINT, edgecolor=INK))
    grasp.annotate(f"{labels['edge']}\n{labels['mass']}", (0.0, 0.0), fontsize=9, ha="center", va="center")
    for side in (-1, 1):
        grasp.add_patch(Rectangle((1.25 * side - 0.25, -0.6), 0.5, 1.2, facecolor=SERIES[0], edgecolor=SERIES[0]))
        _arrow(grasp, np.array([2.8 * side, 0.0]), np.array([1.55 * side, 0.0]), SERIES[1])
        grasp.annotate(labels["grip"], (2.3 * side, 0.25), color=SERIES[1], fontsize=9, ha="center")
    grasp.set(xlim=(-3.2, 3.2), ylim=(-1.2, 1.2), aspect="equal")
    motion.set_title("The shake")
    time = np.linspace(0.0, 3.0, 200)
    motion.plot(time, np.sin(2 * np.pi * time), color=INK, linestyle="-", marker="")
    motion.axhline(0.0, color=FAINT, linewidth=1.0, marker="")
    _arrow(motion, np.array([3.15, 0.0]), np.array([3.15, 1.0]), SERIES[1])
    motion.annotate(labels["amplitude"], (3.25, 0.5), color=SERIES[1], fontsize=9, va="center")
    motion.annotate(f"{labels['frequency']}, for {labels['duration']}", (1.5, -1.45), fontsize=9, ha="center")
    motion.set(xlim=(-0.1, 4.3), ylim=(-1.6, 1.2))
    for axes in (grasp, motion):
        axes.set_axis_off()
    return drawing


def draw_mechanism() -> Drawing:
    """Draw what a contact row leaves out, and what its friction does about it: a drawing of no data, not to scale."""
    drawing, (left, right) = new_figure(7.2, 2.5, ncols=2)
    _draw_arc(left)
    _draw_brake(right)
    for axes in (left, right):
        axes.set_axis_off()
        axes.set_aspect("equal", anchor="N")
    return drawing


def _draw_arc(axes: Axes) -> None:
    axes.set_title("1. A turning joint moves the pad")
    joint, radius, angle = np.array([0.0, 0.0]), 3.0, np.radians(58)
    outward, along = np.array([np.cos(angle), np.sin(angle)]), np.array([np.sin(angle), -np.cos(angle)])
    pad = joint + radius * outward
    axes.add_patch(Arc(joint, 2 * radius, 2 * radius, theta1=18, theta2=98, color=INK, linestyle="--", linewidth=1.0))
    axes.plot(*zip(joint, pad, strict=True), color=INK, linewidth=3.0, linestyle="-", marker="")
    axes.plot(*joint, marker="o", markersize=10, color=INK, markevery=1)
    axes.plot(*pad, marker="s", markersize=14, color=SERIES[0], markevery=1)
    _arrow(axes, pad, pad + 1.5 * along, SERIES[0])
    _arrow(axes, pad, pad - 1.5 * outward, SERIES[1])
    axes.annotate("joint", joint + (0.25, -0.1), fontsize=9, va="top")
    axes.annotate("velocity J·q̇:\nin the contact row", pad + 1.55 * along + (0.1, 0.1), color=SERIES[0], fontsize=9)
    beside = pad - 1.3 * outward + (-0.25, 0.1)
    axes.annotate("acceleration J̇·q̇:\nleft out", beside, color=SERIES[1], fontsize=9, ha="right")
    axes.annotate("pad", pad + (0.1, 0.3), fontsize=9)
    axes.set(xlim=(-1.6, 4.9), ylim=(-0.8, 3.5))


def _draw_brake(axes: Axes) -> None:
    axes.set_title("2. Friction brakes, and nothing pulls back")
    axes.add_patch(Rectangle((0.0, 2.1), 2.4, 0.75, facecolor=SERIES[0], alpha=0.3, edgecolor=SERIES[0]))
    axes.annotate("pad, on turning joints", (1.2, 2.47), fontsize=9, ha="center", va="center")
    axes.add_patch(Rectangle((0.0, 0.2), 2.4, 1.1, facecolor=FAINT, edgecolor=INK))
    axes.annotate("cube", (1.2, 0.62), fontsize=9, ha="center", va="center")
    _arrow(axes, np.array([2.5, 2.47]), np.array([4.0, 2.47]), SERIES[1])
    axes.annotate("J̇·q̇", (3.2, 2.6), color=SERIES[1], fontsize=9, ha="center")
    _arrow(axes, np.array([-0.1, 0.75]), np.array([-1.0, 0.75]), INK)
    axes.annotate("left behind\nat v = J̇·q̇ / b", (-1.0, 0.0), fontsize=9, va="top")
    y = 1.7
    axes.plot([0.5, 0.5, 1.05], [1.3, y, y], color=INK, linewidth=1.4, linestyle="-", marker="")
    axes.plot([1.45, 1.05, 1.05, 1.45], [y + 0.17, y + 0.17, y - 0.17, y - 0.17], color=INK, linestyle="-", marker="")
    axes.plot([1.3, 1.3], [y - 0.12, y + 0.12], color=INK, linewidth=2.0, linestyle="-", marker="")
    axes.plot([1.3, 1.9, 1.9], [y, y, 2.1], color=INK, linewidth=1.4, linestyle="-", marker="")
    axes.annotate("friction row: −b·v,\na damper and no spring", (2.1, 1.68), fontsize=9, va="center")
    axes.set(xlim=(-1.2, 5.3), ylim=(-0.9, 3.4))


def _arrow(axes: Axes, start: np.ndarray, end: np.ndarray, colour: str) -> None:
    style = {"arrowstyle": "-|>", "color": colour, "linewidth": 1.8, "shrinkA": 0}
    axes.annotate("", tuple(end), tuple(start), arrowprops=style)
