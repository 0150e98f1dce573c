"""The figures of section stability."""

from collections.abc import Callable, Sequence
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path

from measured_report.parts.figures import (
    FAINT,
    INK,
    MAP_INK,
    SERIES,
    is_narrow,
    new_figure,
    tick_125,
    tick_at,
    tick_decades,
    write,
)
from measured_report.values.results import Row
from report.sections.stability.passing import CLASSES, is_stable, near_limit
from report.shared.drawing import SHIPPED, STIFF, mark_points

GRIPS = STIFF, SERIES[4]
"""As shipped, and scaled with the mass."""
COLOURS = ("#cfe8cf", "#d6e6f5", "#f6cf8f", "#f09a86", "#cdb4dd", "#8c939b")
MARKS = ("o", "", "v", "*", "s", "x")
"""A creeping run is marked by its rate."""


def draw_maps(panels: Sequence[tuple[str, Sequence[Row], Callable[[np.ndarray], np.ndarray], str]]) -> Drawing:
    """Draw one map above the other. A panel is a title, its rows, a bound on the step [s] over ke, and the bound's
    name."""
    drawing, axes = new_figure(7.6, 3.5 * len(panels), nrows=len(panels), sharex=True, squeeze=False)
    for one, (title, rows, bound, label) in zip(axes[:, 0], panels, strict=True):
        _draw_map(one, rows)
        one.set(title=f"{title}; above the line {label}", ylabel="step [ms]")
        low, high = one.get_xlim()
        ke = np.geomspace(low, high, 200)
        one.plot(ke, 1e3 * bound(ke), color=MAP_INK, linewidth=1.8, linestyle="-", marker="", scaley=False)
    axes[-1, 0].set_xlabel("pad ke")
    there = {row["class"] for _, rows, _, _ in panels for row in rows}
    rate, rates = ("", "creeping") if is_narrow() else ("$1.2$", "creeping [mm/s]")
    handles: list[Any] = []
    with matplotlib.rc_context({"text.parse_math": True}):  # a mark that is text is a formula to Matplotlib
        for name, colour, mark in zip(CLASSES, COLOURS, MARKS, strict=True):
            if name in there:
                style: dict[str, Any] = {"linestyle": "", "color": MAP_INK, "markersize": 5 if mark else 11}
                patch = Patch(facecolor=colour, edgecolor=MAP_INK, linewidth=0.4)
                handles.append((patch, Line2D([], [], marker=mark or rate, **style)))
    names = [rates if name == "creeping" else name for name in CLASSES if name in there]
    drawing.legend(handles, names, loc="outside upper center", ncols=4, fontsize=9, handlelength=2.6, handleheight=1.5)
    return drawing


def _draw_map(axes: Axes, rows: Sequence[Row]) -> None:
    ke = sorted({row.pad_ke.value for row in rows})
    steps = sorted({row.step_ms.value for row in rows})
    cells = {(row.pad_ke.value, row.step_ms.value): row for row in rows}
    grid = np.full((len(steps), len(ke)), np.nan)
    for (x, y), row in cells.items():
        grid[steps.index(y), ke.index(x)] = CLASSES.index(row["class"])
    edges_x, edges_y = _edges(ke), _edges(steps)
    axes.set(xscale="log", yscale="log", xlim=edges_x[[0, -1]], ylim=edges_y[[0, -1]])
    axes.grid(False)
    for number, colour in enumerate(COLOURS):
        corners = [[(x, y), (x, y + 1), (x + 1, y + 1), (x + 1, y)] for y, x in np.argwhere(grid == number)]
        outlines = [Path([(edges_x[x], edges_y[y]) for x, y in cell], closed=False) for cell in corners]
        if outlines:  # the cells of a colour are one shape
            axes.add_patch(PathPatch(Path.make_compound_path(*outlines), color=colour, linewidth=0.2, zorder=0.5))
    for name, mark in zip(CLASSES, MARKS, strict=True):
        found = [place for place, row in cells.items() if row["class"] == name]
        if mark and found:
            x, y = zip(*found, strict=True)
            axes.scatter(x, y, marker=mark, s=16, color=MAP_INK, linewidths=0.9)
    for (x, y), row in cells.items():
        if row["class"] == "creeping" and not is_narrow():  # where there is no room for numbers
            behind = {
                "facecolor": COLOURS[CLASSES.index("creeping")],
                "linewidth": 0,
                "pad": 0.6,
            }  # the line stops there
            text = write(row.creep_mm_s, is_short=True)
            axes.text(x, y, text, ha="center", va="center", fontsize=7, color=MAP_INK, bbox=behind)
    tick_decades(axes.xaxis)
    tick_at(axes.yaxis, steps, digits=2)


def _edges(centres: Sequence[float]) -> np.ndarray:
    logs = np.log(centres)
    middle = 0.5 * (logs[1:] + logs[:-1])
    return np.exp([2 * logs[0] - middle[0], *middle, 2 * logs[-1] - middle[-1]])


def draw_steps(rows: Sequence[Row]) -> Drawing:
    """Draw the size of the drift over the step, one line for each kind of pads; marks are open where it goes the other
    way."""
    drawing, axes = new_figure(7.2, 3.0)
    for pads, label, colour, marker in (
        ("as-shipped", "shipped pads", SHIPPED, "o"),
        ("stiff", "stiff pads", STIFF, "s"),
    ):
        mine = [row for row in rows if row.pads == pads and row.drift_mm_s.value is not None]
        axes.plot(
            [row.step_ms.value for row in mine],
            [abs(row.drift_mm_s.value) for row in mine],
            color=colour,
            label=label,
            marker=marker,
            markevery=[i for i, row in enumerate(mine) if row.drift_mm_s.value >= 0.0],
        )
        back = [(row.step_ms.value, -row.drift_mm_s.value) for row in mine if row.drift_mm_s.value < 0.0]
        mark_points(axes, back, marker=marker, color=colour, markerfacecolor="none")
    axes.set(xscale="log", yscale="log", xlabel="step [ms]", ylabel="drift [mm/s]")
    tick_125(axes.xaxis)
    tick_125(axes.yaxis)
    drawing.legend(loc="outside upper left", ncols=2)
    return drawing


def draw_loads(series: Sequence[tuple[str, Sequence[Row]]]) -> Drawing:
    drawing, axes = new_figure(7.2, 1.3 + 0.5 * len(series))
    axes.axvspan(*near_limit(), color=FAINT, alpha=0.6, linewidth=0, zorder=0)
    axes.axvline(1.0, color=INK, linewidth=1, linestyle="--")
    colours = (SERIES[2], SERIES[0], SERIES[1], SERIES[3], SERIES[5], INK)
    marks = ("o", "s", "v", "*", "P", "x")
    for name, colour, mark in zip(CLASSES, colours, marks, strict=True):
        rows = [(row, place) for place, (_, mine) in enumerate(series) for row in mine if row["class"] == name]
        found = [(row.load.value, place) for row, place in rows if row.load.value is not None]
        if found:
            axes.scatter(*zip(*found, strict=True), color=colour, marker=mark, s=40, label=name, alpha=0.9, zorder=3)
    axes.set_yticks(range(len(series)), [label for label, _ in series])
    axes.set(xscale="log", xlabel="friction needed over friction there is", ylim=(len(series) - 0.5, -0.5))
    tick_125(axes.xaxis)
    axes.grid(axis="y", visible=False)
    drawing.legend(loc="outside upper left", ncols=4)
    return drawing


def draw_sizes(rows: Sequence[Row], bound_percent: float) -> Drawing:
    drawing, axes = new_figure(7.2, 3.2)
    held = [_share(row) for row in rows if is_stable(row)]
    top = 3.0 * max([*held, bound_percent])
    for number, grip in enumerate(dict.fromkeys(row.grip for row in rows)):
        mine = [row for row in rows if row.grip == grip]
        kept = [row for row in mine if is_stable(row)]
        colour = GRIPS[number]
        label = {"as-shipped": "shipped grip", "scaled": "grip scaled with the mass"}.get(grip, grip)
        x = [row.cube_edge_mm.value for row in kept]
        axes.plot(x, [_share(row) for row in kept], color=colour, label=label, markevery=1)
        lost = [(row.cube_edge_mm.value * (1.0 + 0.04 * number), top) for row in mine if not is_stable(row)]
        if lost:
            mark_points(axes, lost, marker="v", color=colour, clip_on=False, markersize=7)
    axes.axhline(bound_percent, color=INK, linewidth=1, linestyle="--")
    axes.set(xscale="log", yscale="log", xlabel="edge [mm]", ylabel="depth over edge [%]")
    axes.set_ylim(top=top)
    tick_125(axes.xaxis)
    tick_125(axes.yaxis)
    if not all(map(is_stable, rows)):
        axes.plot([], [], linestyle="", marker="v", color=INK, markersize=7, markevery=1, label="lost")
    drawing.legend(loc="outside upper left", ncols=3)
    return drawing


def _share(row: Row) -> float:
    return 100.0 * row.penetration_mm.value / row.cube_edge_mm.value
