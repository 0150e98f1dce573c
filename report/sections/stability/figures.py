"""The figures of section stability."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path
from matplotlib.ticker import LogLocator

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from measured_report.parts.figures import (
    INK,
    MAP_INK,
    is_narrow,
    new_figure,
    tick_at,
    write,
)
from report.sections.reproduction import FRAME_RATE
from report.sections.stability.limits import Limit
from report.sections.stability.passing import CLASSES
from report.shared import Row
from report.shared.drawing import SHIPPED, STIFF, name_lines

COLOURS = ("#cfe8cf", "#d6e6f5", "#f6cf8f", "#f09a86", "#cdb4dd", "#8c939b")
CREEPS = (
    (0.03, "#eaf3fb"),
    (0.1, "#d3e5f6"),
    (0.3, "#b7d3ef"),
    (1.0, "#97bfe7"),
    (math.inf, "#74a8dd"),
)
"""Colours of creeping cells, each by what their rate [mm/s] is below."""
MARKS = ("o", "", "v", "*", "s", "x")  # a creeping run is marked by its rate


def draw_maps(
    panels: Sequence[
        tuple[str, Sequence[Row], Callable[[np.ndarray], np.ndarray], str]
    ],
) -> Drawing:
    """Draw maps one above the other, each of a title, its rows, a bound on the step [s] over ke, and its name."""
    drawing, axes = new_figure(
        7.6, 3.5 * len(panels), nrows=len(panels), sharex=True, squeeze=False
    )
    marked = {"shipped": AS_SHIPPED.pad_ke, "stiff": STIFF_PADS.pad_ke}
    for one, (title, rows, bound, label) in zip(axes[:, 0], panels, strict=True):
        _draw_map(one, rows, marked)
        marked.pop("stiff", None)  # whose kd the first map alone has
        one.set(title=f"{title}; above the line {label}", ylabel="step [ms]")
        ke = np.geomspace(*one.get_xlim(), 200)
        one.plot(
            ke,
            1e3 * bound(ke),
            color=MAP_INK,
            linewidth=1.8,
            linestyle="-",
            marker="",
            scaley=False,
        )
    axes[-1, 0].set_xlabel("pad ke")
    classes = {row["class"] for _, rows, _, _ in panels for row in rows}
    rate, rates = ("", "creeping") if is_narrow() else ("$1.2$", "creeping [mm/s]")
    handles: list[Any] = []
    with matplotlib.rc_context(
        {"text.parse_math": True}
    ):  # a mark that is text is a formula to Matplotlib
        for name, colour, mark in zip(CLASSES, COLOURS, MARKS, strict=True):
            if name in classes:
                style: dict[str, Any] = {
                    "linestyle": "",
                    "color": MAP_INK,
                    "markersize": 5 if mark else 11,
                }
                patch = Patch(facecolor=colour, edgecolor=MAP_INK, linewidth=0.4)
                handles.append((patch, Line2D([], [], marker=mark or rate, **style)))
    names = [
        rates if name == "creeping" else name for name in CLASSES if name in classes
    ]
    if is_narrow():  # a scale in the place of the numbers
        handles += [
            Patch(facecolor=colour, edgecolor=MAP_INK, linewidth=0.4)
            for _, colour in CREEPS
        ]
        ends = [0.0, *(bound for bound, _ in CREEPS)]
        names += [f"creep over {low:g} mm/s" for low in ends[:-1]]
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


def draw_limits(limits: Sequence[Limit]) -> Drawing:
    """Draw each extreme as a bar over multiples of the scene as shipped: a cross breaks, an arrow was not seen to."""
    drawing, axes = new_figure(7.6, 0.9 + (0.46 if is_narrow() else 0.34) * len(limits))
    for place, limit in enumerate(limits):
        low, high = (cell.number / limit.shipped for cell in (limit.low, limit.high))
        bar = [low, high], [place, place]
        axes.plot(
            *bar,
            color=STIFF,
            linewidth=8,
            marker="",
            solid_capstyle="butt",
            linestyle="-",
        )
        axes.plot(
            *bar, color=STIFF, linestyle="", marker="|", markersize=8, markevery=1
        )
        is_lost = limit.broken.value is not None
        end = limit.broken.number / limit.shipped if is_lost else 1.6 * high
        style = (
            {"color": SHIPPED, "marker": "X", "markersize": 8}
            if is_lost
            else {"color": STIFF, "marker": ">"}
        )
        axes.plot(end, place, markevery=1, **style)
        text = (
            f"{write(limit.low)} holds"
            if low == high
            else f"{write(limit.low)} to {write(limit.high)} hold"
        )
        text += f"; {write(limit.broken)} breaks" if is_lost and not limit.over else ""
        if limit.over and is_lost:
            text = (
                f"{write(limit.over[0])} % over holds; {write(limit.over[1])} % breaks"
            )
        at = (
            {"xy": (0.0, place - 0.22), "va": "bottom"}
            if is_narrow()
            else {"xy": (1.02, place), "va": "center"}
        )
        axes.annotate(
            text,
            xycoords=("axes fraction", "data"),
            fontsize=8.5,
            annotation_clip=False,
            **at,
        )
    axes.axvline(1.0, color=INK, linewidth=1.0, linestyle=":", marker="")
    axes.annotate(
        "as shipped",
        (1.0, -0.65),
        fontsize=8.5,
        ha="center",
        va="bottom",
        annotation_clip=False,
    )
    name_lines(axes, [limit.name for limit in limits])
    axes.set(xscale="log", xlabel="times the scene as shipped")
    axes.set_xlim(0.5 * axes.get_xlim()[0], 3 * axes.get_xlim()[1])
    tick_at(axes.xaxis, [10.0**power for power in range(-4, 5, 2)])
    axes.set_ylim(len(limits) - 0.4, -0.6)
    axes.grid(axis="y", visible=False)
    return drawing


def _draw_map(axes: Axes, rows: Sequence[Row], marked: Mapping[str, float]) -> None:
    ke = sorted({row.pad_ke.value for row in rows})
    steps = sorted({row.step_ms.value for row in rows})
    cells = {(row.pad_ke.value, row.step_ms.value): row for row in rows}
    grid = np.full((len(steps), len(ke)), np.nan)
    for (x, y), row in cells.items():
        grid[steps.index(y), ke.index(x)] = _colour_index(row)
    edges_x, edges_y = _edges(ke), _edges(steps)
    axes.set(xscale="log", yscale="log", xlim=edges_x[[0, -1]], ylim=edges_y[[0, -1]])
    axes.grid(False)
    for number, colour in enumerate([*COLOURS, *(colour for _, colour in CREEPS)]):
        corners = [
            [(x, y), (x, y + 1), (x + 1, y + 1), (x + 1, y)]
            for y, x in np.argwhere(grid == number)
        ]
        outlines = [
            Path([(edges_x[x], edges_y[y]) for x, y in cell], closed=False)
            for cell in corners
        ]
        if outlines:  # the cells of a colour are one shape, within limits that are set: it need not be measured
            axes.add_artist(
                PathPatch(
                    Path.make_compound_path(*outlines),
                    color=colour,
                    linewidth=0.2,
                    zorder=0.5,
                )
            )
    for name, mark in zip(CLASSES, MARKS, strict=True):
        places = [place for place, row in cells.items() if row["class"] == name]
        if mark and places:
            x, y = zip(*places, strict=True)
            axes.scatter(x, y, marker=mark, s=16, color=MAP_INK, linewidths=0.9)
    for (x, y), row in cells.items():
        if (
            row["class"] == "creeping" and not is_narrow()
        ):  # where there is no room for numbers
            facecolor = CREEPS[_colour_index(row) - len(COLOURS)][1]
            behind = {
                "facecolor": facecolor,
                "linewidth": 0,
                "pad": 0.6,
            }  # the line stops there
            text = write(row.creep_mm_s, is_short=True)
            axes.text(
                x,
                y,
                text,
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
            facecolors="none",
            edgecolors=MAP_INK,
            linewidths=1.8,
            zorder=4,
        )
        axes.annotate(
            name,
            place,
            xytext=(0, 10),
            textcoords="offset points",
            ha="center",
            fontsize=8.5,
            color=MAP_INK,
        )
    axes.xaxis.set_major_locator(LogLocator(numticks=12))  # whole decades
    tick_at(axes.yaxis, steps, digits=2)


def _colour_index(row: Row) -> int:
    """Return the place of a cell's colour among ``COLOURS`` and then ``CREEPS``."""
    rate = row.creep_mm_s.value
    if row["class"] != "creeping" or rate is None:
        return CLASSES.index(row["class"])
    return len(COLOURS) + next(
        place for place, (bound, _) in enumerate(CREEPS) if abs(rate) < bound
    )


def _edges(centres: Sequence[float]) -> np.ndarray:
    logs = np.log(centres)
    middle = 0.5 * (logs[1:] + logs[:-1])
    return np.exp([2 * logs[0] - middle[0], *middle, 2 * logs[-1] - middle[-1]])
