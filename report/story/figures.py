"""Figures of the front page and the story: the cube in the grasp, the suspects and the mechanism."""

from collections.abc import Collection, Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing
from matplotlib.patches import Arc, Polygon, Rectangle

from measured_report.parts.figures import FAINT, INK, SERIES, new_figure, write
from measured_report.values.quantities import Quantity
from measured_report.values.results import Series
from report.shared.drawing import SHIPPED, STIFF, mark_points, name_lines
from report.story.found import CASES, FIX

EDGE_MM = 40.0  # of the cube, for drawings to scale
PAD_MM = (17.5, 18.5)  # width and height of the part of a finger that touches the cube, about the tool's point
FINGER_MM = (22.0, 20.0)  # of the part above it


def draw_still(traces: Mapping[str, Series], slips: Mapping[str, Quantity]) -> Drawing:
    """Draw the cube at the end of the shake, seen along the line between the fingers and to scale, for each case."""
    there = {case: trace.value for case, trace in traces.items() if trace.value is not None}
    drawing, panels = new_figure(7.2, 3.0, ncols=len(there), squeeze=False)
    for number, (axes, (case, frame)) in enumerate(zip(panels[0], there.items(), strict=True)):
        end = frame["x_mm"].iloc[-1], -frame["z_mm"].iloc[-1]
        _draw_grasp(axes, end, (SHIPPED, STIFF)[number])
        axes.set_title(f"{CASES[case]}: slips {write(slips[case])} mm")
        axes.plot(frame["x_mm"], -frame["z_mm"], color=INK, linewidth=1.0, linestyle="-", marker="")
    return drawing


def _draw_grasp(axes: Axes, end: tuple[float, float], colour: str) -> None:
    half, (x, y) = EDGE_MM / 2, end
    corner, edges = (x - half, y - half), (EDGE_MM, EDGE_MM)
    axes.add_patch(Rectangle(corner, *edges, facecolor=colour, alpha=0.28, linewidth=0))
    axes.add_patch(Rectangle(corner, *edges, fill=False, edgecolor=colour, linewidth=1.6))
    axes.add_patch(Rectangle((-half, -half), *edges, fill=False, edgecolor=INK, linestyle=(0, (4, 3)), linewidth=1.0))
    pad, finger = PAD_MM, FINGER_MM
    metal: dict[str, Any] = {"facecolor": FAINT, "alpha": 0.55, "edgecolor": INK, "linewidth": 0.8}
    axes.add_patch(Rectangle((-pad[0] / 2, -pad[1] / 2), *pad, **metal))
    above = (-finger[0] / 2, pad[1] / 2 + 6.0)
    neck = [(-pad[0] / 2, pad[1] / 2), (pad[0] / 2, pad[1] / 2), (finger[0] / 2, above[1]), (-finger[0] / 2, above[1])]
    axes.add_patch(Polygon(neck, **metal))
    axes.add_patch(Rectangle(above, finger[0], 12.0, **metal))
    axes.annotate("finger", (0.0, above[1] + 6.0), ha="center", va="center", fontsize=8.5)
    axes.annotate("pad", (0.0, -pad[1] / 2 + 3.0), ha="center", va="center", fontsize=8.5)
    axes.annotate("cube at the start", (-half + 0.8, -half - 3.6), fontsize=8.5)
    axes.plot([0.0], [0.0], marker="+", color=INK, markersize=7, markevery=1, linestyle="")
    axes.plot([x], [y], marker="o", color=colour, markersize=6, markevery=1, linestyle="")
    axes.set(xlim=(-30, 34), ylim=(-27, 30), aspect="equal")
    axes.set_axis_off()


def draw_suspects(
    slips: Mapping[str, Sequence[Quantity]], others: Collection[str], shipped: Quantity, bound: Quantity
) -> Drawing:
    """Draw the slip of each run [mm], a line for each thing that was changed; ``others`` are no suspects."""
    drawing, axes = new_figure(7.2, 0.9 + 0.32 * len(slips))
    for place, (name, cells) in enumerate(slips.items()):
        there = [cell for cell in cells if cell.value is not None]
        colour = {FIX: STIFF}.get(name, SHIPPED if name in others else SERIES[5])
        mark_points(axes, [(cell.value, place) for cell in there], marker="o", markersize=6, color=colour, alpha=0.75)
        for cell in there if name in others else []:
            axes.annotate(
                write(cell), (cell.number, place), xytext=(0, 6), textcoords="offset points", ha="center", fontsize=8.5
            )
    if shipped.value is not None and bound.value is not None:
        margin = 0.01 * bound.value * shipped.value
        axes.axvspan(shipped.value - margin, shipped.value + margin, color=FAINT, alpha=0.45, linewidth=0, zorder=0)
        axes.axvline(shipped.value, color=INK, linestyle="--", linewidth=1.0, marker="")
    name_lines(axes, slips)
    axes.margins(y=0.12)
    axes.set(xlabel="slip [mm]", xlim=(0.0, None))
    axes.grid(axis="y", visible=False)
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
    axes.set_title("1. The pad follows a curve")
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
    axes.annotate(
        "acceleration J̇·q̇:\nleft out", pad - 1.3 * outward + (-0.25, 0.1), color=SERIES[1], fontsize=9, ha="right"
    )
    axes.annotate("pad", pad + (0.1, 0.3), fontsize=9)
    axes.set(xlim=(-1.6, 4.9), ylim=(-0.8, 3.5))


def _draw_brake(axes: Axes) -> None:
    axes.set_title("2. Friction brakes, and nothing pulls back")
    axes.add_patch(Rectangle((0.0, 2.1), 2.4, 0.75, facecolor=SERIES[0], alpha=0.3, edgecolor=SERIES[0]))
    axes.annotate("pad, on its curve", (1.2, 2.47), fontsize=9, ha="center", va="center")
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
