"""Draw the figures of section stability."""

import math
from collections.abc import Callable
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path
from matplotlib.ticker import LogLocator

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from report.sections.stability.limits import Limit
from report.sections.stability.passing import CLASSES
from report.shared import FRAME_RATE, Row
from report.shared.drawing import (
    INK,
    MAP_INK,
    SHIPPED,
    STIFF,
    Drawing,
    draw_line,
    is_narrow,
    mark_points,
    new_figure,
    tick_at,
    write,
    write_beside,
)

# Colours and markers of the classes. A creeping run is marked with its rate.
COLOURS = ("#cfe8cf", "#d6e6f5", "#f6cf8f", "#f09a86", "#cdb4dd", "#8c939b")
MARKS = ("o", "", "v", "*", "s", "x")
CREEPS = {  # colours of creeping cells, by upper bounds of their rate [mm/s]
    0.03: "#eaf3fb",
    0.1: "#d3e5f6",
    0.3: "#b7d3ef",
    1.0: "#97bfe7",
    math.inf: "#74a8dd",
}
Panel = tuple[str, list[Row], Callable[[np.ndarray], np.ndarray], str]


def draw_maps(panels: list[Panel]) -> Drawing:
    """Draw the maps as panels, one below the other.

    Each panel has a title, its rows, a bound of the step [s] as a function of ke, and
    the name of the bound.
    """
    drawing, axes = new_figure(
        7.6, 3.5 * len(panels), nrows=len(panels), sharex=True, squeeze=False
    )
    marked = {"shipped": AS_SHIPPED.pad_ke, "stiff": STIFF_PADS.pad_ke}
    for panel, (title, rows, bound, label) in zip(axes[:, 0], panels, strict=True):
        draw_map(panel, rows, marked, has_numbers=not is_narrow())
        marked.pop("stiff", None)  # only the first map has the kd of stiff pads
        panel.set(title=f"{title}; above the line {label}", ylabel="step [ms]")
        ke = np.geomspace(*panel.get_xlim(), 200)
        draw_line(
            panel, ke, 1e3 * bound(ke), color=MAP_INK, linewidth=1.8, scaley=False
        )
    axes[-1, 0].set_xlabel("pad ke")

    classes = {row["class"] for _, rows, _, _ in panels for row in rows}
    handles: list[Any] = []
    names = []
    edge = {"edgecolor": MAP_INK, "linewidth": 0.4}
    # Matplotlib draws a text as a marker only if it is allowed to parse formulas.
    with matplotlib.rc_context({"text.parse_math": True}):
        for name, colour, mark in zip(CLASSES, COLOURS, MARKS, strict=True):
            if name not in classes:
                continue
            size = 5 if mark else 11
            if name == "creeping" and not is_narrow():
                name = "creeping [mm/s]"
                mark = "$1.2$"
            line = Line2D(
                [], [], marker=mark, linestyle="", color=MAP_INK, markersize=size
            )
            handles.append((Patch(facecolor=colour, **edge), line))
            names.append(name)
    if is_narrow():  # a scale of colours instead of numbers
        handles += [Patch(facecolor=colour, **edge) for colour in CREEPS.values()]
        names += [f"creep above {low:g} mm/s" for low in [0.0, *CREEPS][:-1]]
    drawing.legend(
        handles,
        names,
        loc="outside upper center",
        ncols=4,
        fontsize=9,
        handlelength=2.6,
        handleheight=1.5,
    )
    return drawing


def draw_limits(limits: list[Limit]) -> Drawing:
    """Draw the range of each setting on its own axis, with its own unit."""
    height = 0.66 if is_narrow() else 0.56
    drawing, panels = new_figure(
        7.2, 0.4 + height * len(limits), nrows=len(limits), squeeze=False
    )
    for axes, limit in zip(panels[:, 0], limits, strict=True):
        _draw_limit(axes, limit)
    handles = [
        Line2D([], [], color=STIFF, linewidth=8),
        Line2D([], [], color=INK, marker="D", linestyle=""),
        Line2D([], [], color=SHIPPED, marker="X", linestyle="", markersize=8),
    ]
    names = ("holds", "as shipped", "breaks")
    drawing.legend(handles, names, loc="outside upper center", ncols=3, fontsize=9)
    return drawing


def _draw_limit(axes: Axes, limit: Limit) -> None:
    low = limit.low.number
    high = limit.high.number
    places = [low, high]
    draw_line(axes, [low, high], [0, 0], color=STIFF, linewidth=8)
    if limit.shipped is not None:
        places.append(limit.shipped)
        shipped = [(limit.shipped, 0)]
        mark_points(axes, shipped, color=INK, marker="D", markersize=6, clip_on=False)
    if limit.broken.value is not None:
        broken = limit.broken.number
        places.append(broken)
        look = {"marker": "X", "markersize": 9, "clip_on": False}
        mark_points(axes, [(broken, 0)], color=SHIPPED, **look)
        side = {"ha": "left"} if broken > high else {"ha": "right"}
        offset = (7 if broken > high else -7, 0)
        text = write(limit.broken)
        look = {"color": SHIPPED, "va": "center", "fontsize": 8.5, **side}
        write_beside(axes, text, (broken, 0), offset, **look)
    left, right = min(places), max(places)
    if low > 0.0:
        axes.set_xscale("log")
        room = max(right / left, 10.0) ** 0.15
        axes.set_xlim(left / room, right * room)
    else:
        axes.margins(x=0.15)
    tick_at(axes.xaxis, [low, high])
    axes.set_xticklabels(
        [write(limit.low, is_short=0.01 < low < 0.1), write(limit.high)]
    )
    axes.set_title(limit.name, fontsize=9, pad=4)
    axes.set_yticks([])
    axes.set_ylim(-0.5, 0.5)
    axes.spines["left"].set_visible(False)
    axes.grid(False)


def draw_map(
    axes: Axes, rows: list[Row], marked: dict[str, float], *, has_numbers: bool
) -> None:
    """Draw how runs end over ke and the step, and mark values of ke at the shipped step."""
    cells = {(row.pad_ke.value, row.step_ms.value): row for row in rows}
    ke = sorted({x for x, _ in cells})
    steps = sorted({y for _, y in cells})
    colours = [*COLOURS, *CREEPS.values()]
    grid = np.full((len(steps), len(ke)), np.nan)
    for (x, y), row in cells.items():
        grid[steps.index(y), ke.index(x)] = colours.index(_colour(row))
    edges_x = _edges(ke)
    edges_y = _edges(steps)
    axes.set(xscale="log", yscale="log", xlim=edges_x[[0, -1]], ylim=edges_y[[0, -1]])
    axes.grid(False)
    for number, colour in enumerate(colours):
        outlines = []
        for y, x in np.argwhere(grid == number):
            left = edges_x[x]
            right = edges_x[x + 1]
            low = edges_y[y]
            high = edges_y[y + 1]
            corners = [(left, low), (left, high), (right, high), (right, low)]
            outlines.append(Path(corners, closed=False))
        if outlines:
            # All cells of a colour are one shape, which keeps the file small.
            shape = Path.make_compound_path(*outlines)
            patch = PathPatch(shape, color=colour, linewidth=0.2, zorder=0.5)
            axes.add_artist(patch)
    for name, mark in zip(CLASSES, MARKS, strict=True):
        places = [place for place, row in cells.items() if row["class"] == name]
        if mark and places:
            x, y = zip(*places, strict=True)
            axes.scatter(x, y, marker=mark, s=16, color=MAP_INK, linewidths=0.9)
    for (x, y), row in cells.items():
        if row["class"] == "creeping" and has_numbers:
            # The box behind the text interrupts the line of the bound.
            behind = {"facecolor": _colour(row), "linewidth": 0, "pad": 0.6}
            axes.text(
                x,
                y,
                write(row.creep_mm_s, is_short=True),
                ha="center",
                va="center",
                fontsize=7,
                color=MAP_INK,
                bbox=behind,
            )
    for name, pad_ke in marked.items():
        place = (pad_ke, 1e3 / (FRAME_RATE * AS_SHIPPED.substeps))
        axes.scatter(
            *place,
            marker="s",
            s=170,
            zorder=4,
            facecolors="none",
            edgecolors=MAP_INK,
            linewidths=1.8,
        )
        write_beside(
            axes, name, place, (0, 10), ha="center", fontsize=8.5, color=MAP_INK
        )
    axes.xaxis.set_major_locator(LogLocator(numticks=12))  # whole decades
    tick_at(axes.yaxis, steps, digits=2)


def _colour(row: Row) -> str:
    """Return the colour of a cell, which depends on its class and its creep."""
    rate = row.creep_mm_s.value
    if row["class"] != "creeping" or rate is None:
        return COLOURS[CLASSES.index(row["class"])]
    return next(colour for bound, colour in CREEPS.items() if abs(rate) < bound)


def _edges(centres: list[float]) -> np.ndarray:
    logs = np.log(centres)
    middle = 0.5 * (logs[1:] + logs[:-1])
    return np.exp([2 * logs[0] - middle[0], *middle, 2 * logs[-1] - middle[-1]])
