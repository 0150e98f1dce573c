"""Error against run time as a diagram, and the run time of many worlds."""

from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import FAINT, INK, SERIES, is_narrow, new_figure, write
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row
from report.names import name_of
from report.sections.error_runtime.runs import ENGINES, ERROR, GRASP, PADS, TIME, Points, counts
from report.shared.timing import decade_axis, world_axis

COLOURS = {"warp-cuda": SERIES[0], "warp-cpu": SERIES[4], "mujoco-c": SERIES[2]}
NAMES = {backend: name.replace("MuJoCo Warp", "Warp") for backend, name in ENGINES.items()}
SIDES: dict[str, dict[str, Any]] = {
    "right": {"xytext": (8, 4), "ha": "left"},
    "left": {"xytext": (-8, 2), "ha": "right"},
    "below": {"xytext": (-4, -6), "ha": "right", "va": "top"},
}
"""Where the name of a mark stands. Below and to the left of the best there is nothing of the same engine."""
LEAST_ERROR_MM = 1e-5
"""Smaller errors are drawn on the left edge: no one can live with less, and the rest gets the room."""


def draw_numerical(points: Points) -> Drawing:
    """Draw the best of each engine at each error, where it ships, and what is recommended in place of that."""
    drawing, panels = new_figure(7.2, 4.4, ncols=2, sharex=True, sharey=True, squeeze=False)
    rows = [row for row in points.settings if counts(row) and row[ERROR].value is not None]
    for axes, (pads, title) in zip(panels[0], PADS.items(), strict=True):
        axes.set_title(title)
        _set_axes(axes, rows, ERROR, LEAST_ERROR_MM)
        axes.set_xlabel("numerical error [mm]")
        floor = points.floors[pads].value
        if floor is not None:
            axes.axvspan(LEAST_ERROR_MM, floor, color=FAINT, alpha=0.5, linewidth=0, zorder=0)
            place = {"xycoords": ("data", "axes fraction"), "ha": "right", "va": "top"}
            axes.annotate("Warp's rounding ", (floor, 0.97), fontsize=8, **place)
        for backend in points.engines:
            mine = [row for row in rows if row["pads"] == pads and row.backend == backend]
            if mine:
                _draw_engine(axes, mine, points.backend_front, backend)
            _mark_both(axes, points, pads, backend, ERROR, COLOURS[backend])
    panels[0][0].set_ylabel("run time [ms per simulated s]")
    return drawing


def draw_grasp(points: Points) -> Drawing:
    """Draw where each model converges to, where each engine ships, and what is recommended in place of that."""
    drawing, axes = new_figure(7.2, 3.6)
    places = [(pads, backend) for pads in PADS for backend in points.engines]
    found = [find(*place) for place in places for find in (points.shipped, points.recommended)]
    rows = [row for row in found if row and row[GRASP].value]
    errors = [row[GRASP].value for row in rows]
    _set_axes(axes, rows, GRASP, 0.5 * min(errors))
    axes.set(xlim=(axes.get_xlim()[0], 1.6 * max(errors)), ylim=(None, 5 * axes.get_ylim()[1]))
    for backend in points.engines:
        times = [row[TIME].value for row in rows if row.backend == backend]
        if times:
            place = (0.02, 2.0 * max(times))
            axes.annotate(NAMES[backend], place, xycoords=("axes fraction", "data"), fontsize=9, va="center")
    for colour, side, (pads, title) in zip((SERIES[1], SERIES[0]), ("left", "right"), PADS.items(), strict=True):
        converged = points.converged(pads)
        if converged.value:
            _name_converged(axes, converged, title, colour, side)
        for backend in points.engines:
            _mark_both(axes, points, pads, backend, GRASP, colour, side, side if is_narrow() else "left")
    axes.set(xlabel="grasp error [mm/cycle]", ylabel="run time [ms per simulated s]")
    return drawing


def _set_axes(axes: Axes, rows: Sequence[Row], error: str, left: float) -> None:
    times = [row[TIME].value for row in rows]
    axes.set(xscale="log", yscale="log")
    right = 4.0 * max(row[error].value for row in rows)
    axes.set(xlim=(left, right), ylim=(0.4 * min(times), 4.0 * max(times)))
    axes.minorticks_off()
    axes.text(0.03, 0.03, "↙ lower left is better", transform=axes.transAxes, fontsize=8.5)


def _place(row: Row, error: str) -> tuple[float, float]:
    return max(row[error].value, LEAST_ERROR_MM), row[TIME].value


def _draw_engine(axes: Axes, rows: Sequence[Row], front: frozenset[str], backend: str) -> None:
    """Draw the front of an engine, and its name above its slowest setting."""
    colour = COLOURS[backend]
    best = sorted((row for row in rows if row.case in front), key=lambda row: row[ERROR].value)
    if best:
        x, y = zip(*(_place(row, ERROR) for row in best), strict=True)
        style = {"color": colour, "linestyle": "-", "linewidth": 1.1, "marker": ""}
        axes.step([*x, axes.get_xlim()[1]], [*y, y[-1]], where="post", **style)
        axes.scatter(x, y, s=14, color=colour, linewidths=0, clip_on=False)
    top = _place(max(rows, key=lambda row: row[TIME].value), ERROR)
    is_left = top[0] <= 10 * LEAST_ERROR_MM
    above: dict[str, Any] = {"xytext": (4 if is_left else 0, 8), "ha": "left" if is_left else "center"}
    axes.annotate(NAMES[backend], top, **above, textcoords="offset points", color=colour, fontsize=9)


def _mark(axes: Axes, row: Row, error: str, mark: str, text: str, colour: str, side: str) -> None:
    """Mark one setting so that it can be seen, with its name on one side."""
    x, y = _place(row, error)
    size = {"*": 130, "s": 34}[mark]
    axes.scatter([x], [y], s=size, marker=mark, color=colour, edgecolors=INK, linewidths=0.7, zorder=5)
    axes.annotate(text, (x, y), **SIDES[side], textcoords="offset points", fontsize=8.5, color=colour, zorder=6)


def _mark_both(
    axes: Axes, points: Points, pads: str, backend: str, error: str, colour: str, side: str = "right", better: str = ""
) -> None:
    """Mark the shipped and the recommended setting, each with its error on that side, or else where there is room."""
    shipped, recommended = points.shipped(pads, backend), points.recommended(pads, backend)
    if shipped is not None and shipped[error].value:
        _mark(axes, shipped, error, "*", write(shipped[error]), colour, side)
    if recommended is not None and recommended[error].value:
        left, right = axes.get_xlim()
        roomy = "below" if recommended[error].value ** 2 > left * right else "right"
        setting = ", ".join(name_of(recommended.case).split(", ")[2:])  # without pads and engine
        _mark(axes, recommended, error, "s", f"{setting}: {write(recommended[error])}", colour, better or roomy)


def _name_converged(axes: Axes, found: Quantity, title: str, colour: str, side: str) -> None:
    """Draw a line with its name on one side of it; the names of both lines stand in lines of their own."""
    axes.axvline(found.value, color=colour, linestyle="--", linewidth=1.2, marker="")
    offset, height, edge = {"right": (4, 0.985, "left"), "left": (-4, 0.91, "right")}[side]
    place: dict[str, Any] = {"xytext": (offset, 0), "textcoords": "offset points", "ha": edge, "va": "top"}
    text, at = f"{title}, converged: {write(found)}", (found.value, height)
    axes.annotate(text, at, **place, xycoords=("data", "axes fraction"), fontsize=8.5, color=colour)


def draw_worlds(
    rows: Sequence[Row], rates: Sequence[Quantity], one_core: Quantity, crossover: Quantity, engine: str
) -> Drawing:
    drawing, axes = new_figure(7.2, 3.6)
    counts = [row.worlds.value for row in rows]
    there = [(count, rate.value) for count, rate in zip(counts, rates, strict=True) if rate.value is not None]
    axes.plot(*zip(*there, strict=True), label=engine, markevery=1)
    if one_core.value is not None:
        axes.axhline(one_core.value, color=SERIES[1], linestyle="--", marker="", label="MuJoCo C, one core")
    decade_axis(axes)
    world_axis(axes, counts)
    if crossover.value is not None and one_core.value is not None:
        axes.axvline(crossover.value, color=INK, linewidth=1.0, linestyle=":", marker="")
        place = (crossover.value, axes.get_ylim()[0])
        axes.annotate(f"{write(crossover)} worlds", place, xytext=(5, 6), textcoords="offset points")
    axes.set(xlabel="worlds", ylabel="world-seconds per second")
    drawing.legend(loc="outside upper left", ncols=2)
    return drawing
