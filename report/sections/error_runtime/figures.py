"""Error against run time as a diagram, and the run time of many worlds."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from report.deriving.timing import decade_axis, world_axis
from report.figures import FAINT, INK, SERIES, new_figure, write
from report.names import name_of
from report.quantities import Quantity
from report.results import Row
from report.sections.error_runtime.counting import counts
from report.sections.error_runtime.runs import ENGINES, ERROR, GRASP, PADS, TIME, Points, no_worse

COLOURS = {"warp-cuda": SERIES[0], "warp-cpu": SERIES[4], "mujoco-c": SERIES[2]}
NAMES = {backend: name.replace("MuJoCo Warp", "Warp") for backend, name in ENGINES.items()}
LEAST_ERROR_MM = 1e-5
"""Smaller errors are drawn on the left edge: no one can live with less, and the rest gets the room."""
FADED = 0.3


def draw_numerical(points: Points) -> Drawing:
    """Every setting that counts, faint; the front of each engine, and on it where it ships and what is no worse."""
    drawing, panels = new_figure(7.2, 4.4, ncols=2, sharex=True, sharey=True, squeeze=False)
    rows = [row for row in points.settings if counts(row) and row[ERROR].value is not None]
    for axes, (pads, title) in zip(panels[0], PADS.items(), strict=True):
        axes.set_title(title)
        _set_axes(axes, rows, ERROR, LEAST_ERROR_MM)
        axes.set_xlabel("numerical error [mm]")
        _shade_floor(axes, points.floors[pads].value)
        for backend in points.engines:
            mine = [row for row in rows if row["pads"] == pads and row.backend == backend]
            _draw_engine(axes, mine, ERROR, points.backend_front, COLOURS[backend])
            _name_engine(axes, mine, ERROR, backend)
            shipped = points.shipped(pads, backend)
            if shipped is not None:
                _mark(axes, shipped, ERROR, "*", f"shipped{_error(shipped)}", COLOURS[backend])
                better = no_worse(mine, shipped)
                if better is not None:
                    _mark(axes, better, ERROR, "s", f"{_setting(better)}{_error(better)}", COLOURS[backend])
    panels[0][0].set_ylabel("run time [ms per simulated s]")
    return drawing


def draw_grasp(points: Points) -> Drawing:
    """The drift of every setting that counts, faint; where each model converges to, and where each engine ships."""
    drawing, axes = new_figure(7.2, 4.2)
    rows = [row for row in points.settings if counts(row) and row[GRASP].value]
    _set_axes(axes, rows, GRASP, 0.5 * min(row[GRASP].value for row in rows))
    for colour, (pads, title) in zip((SERIES[1], SERIES[0]), PADS.items(), strict=True):
        mine = [row for row in rows if row["pads"] == pads]
        axes.scatter(*_places(mine, GRASP, 0.0), s=16, color=colour, alpha=FADED, linewidths=0)
        reference = points.reference(pads)
        if reference is not None and reference[GRASP].value:
            _name_converged(axes, reference[GRASP], title, colour)
        for backend in points.engines:
            shipped = points.shipped(pads, backend)
            if shipped is not None and shipped[GRASP].value:
                _mark(axes, shipped, GRASP, "*", NAMES[backend], colour)
    axes.set_xlabel("grasp error [mm/cycle]")
    axes.set_ylabel("run time [ms per simulated s]")
    return drawing


def _set_axes(axes: Axes, rows: Sequence[Row], error: str, left: float) -> None:
    times = [row[TIME].value for row in rows]
    axes.set(xscale="log", yscale="log")
    axes.set_xlim(left, 4.0 * max(row[error].value for row in rows))
    axes.set_ylim(0.4 * min(times), 4.0 * max(times))
    axes.minorticks_off()
    axes.text(0.03, 0.03, "↙ lower left is better", transform=axes.transAxes, fontsize=8.5)


def _shade_floor(axes: Axes, floor: float | None) -> None:
    if floor is not None:
        axes.axvspan(LEAST_ERROR_MM, floor, color=FAINT, alpha=0.5, linewidth=0, zorder=0)
        text = "Warp's rounding "
        axes.annotate(text, (floor, 0.97), xycoords=("data", "axes fraction"), fontsize=8, ha="right", va="top")


def _places(rows: Sequence[Row], error: str, left: float) -> tuple[np.ndarray, np.ndarray]:
    x = np.array([max(row[error].value, left) for row in rows])
    return x, np.array([row[TIME].value for row in rows])


def _draw_engine(axes: Axes, rows: Sequence[Row], error: str, front: frozenset[str], colour: str) -> None:
    axes.scatter(*_places(rows, error, LEAST_ERROR_MM), s=12, color=colour, alpha=FADED, linewidths=0, clip_on=False)
    best = sorted((row for row in rows if row.case in front), key=lambda row: row[error].value)
    if best:
        x, y = _places(best, error, LEAST_ERROR_MM)
        style = {"color": colour, "linestyle": "-", "linewidth": 1.1, "marker": ""}
        axes.step([*x, axes.get_xlim()[1]], [*y, y[-1]], where="post", **style)


def _name_engine(axes: Axes, rows: Sequence[Row], error: str, backend: str) -> None:
    """Above its slowest setting."""
    if rows:
        top = max(rows, key=lambda row: row[TIME].value)
        x, y = _places([top], error, LEAST_ERROR_MM)
        is_left = x[0] <= 10 * LEAST_ERROR_MM
        axes.annotate(
            NAMES[backend],
            (x[0], y[0]),
            xytext=(4 if is_left else 0, 8),
            textcoords="offset points",
            color=COLOURS[backend],
            fontsize=9,
            ha="left" if is_left else "center",
        )


def _mark(axes: Axes, row: Row, error: str, mark: str, text: str, colour: str) -> None:
    """One setting by its name, beside a mark that can be seen."""
    (x,), (y,) = _places([row], error, LEAST_ERROR_MM)
    size = {"*": 130, "s": 34}[mark]
    axes.scatter([x], [y], s=size, marker=mark, color=colour, edgecolors=INK, linewidths=0.7, zorder=5)
    axes.annotate(text, (x, y), xytext=(8, 2), textcoords="offset points", fontsize=8.5, color=colour, zorder=6)


def _setting(row: Row) -> str:
    """What is set, without pads and engine."""
    return ", ".join(name_of(row.case).split(", ")[2:])


def _error(row: Row) -> str:
    return f": {write(row[ERROR])} mm"


def _name_converged(axes: Axes, found: Quantity, title: str, colour: str) -> None:
    axes.axvline(found.value, color=colour, linestyle="--", linewidth=1.2, marker="")
    text = f" {title},\n converged: {write(found)}"
    axes.annotate(text, (found.value, 0.985), xycoords=("data", "axes fraction"), fontsize=8.5, color=colour, va="top")


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
        axes.annotate(
            f"{write(crossover)} worlds",
            (crossover.value, axes.get_ylim()[0]),
            xytext=(5, 6),
            textcoords="offset points",
        )
    axes.set_xlabel("worlds")
    axes.set_ylabel("world-seconds per second")
    drawing.legend(loc="outside upper left", ncols=2)
    return drawing
