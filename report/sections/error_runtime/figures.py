"""Error against run time as a diagram, and the run time of many worlds."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from report.deriving.timing import decade_axis, world_axis
from report.figures import FAINT, INK, SERIES, new_figure
from report.format import format_number
from report.quantities import Quantity
from report.results import Row
from report.sections.error_runtime.runs import (
    ENGINES,
    ERROR,
    GRASP,
    LABELS,
    PADS,
    Points,
    hit_iteration_limit,
    is_clamped,
    is_own_model,
)

STYLES = {
    "newton": (SERIES[0], "-", "o"),
    "newton-each-substep": (SERIES[0], "", "^"),
    "mujoco": (SERIES[1], "--", "s"),
    "newton-rk4": (SERIES[3], "-.", "v"),
    "mujoco-rk4": (SERIES[3], ":", "P"),
    "cpu": (SERIES[4], ":", "X"),
    "c": (SERIES[2], "-", "D"),
    "c-rk4": (SERIES[2], "--", "h"),
}
GRASP_STYLES = {"warp-cuda": "o", "warp-cpu": "X", "mujoco-c": "D"}
LEAST_ERROR_MM = 1e-5
"""Smaller errors are drawn on the left edge: no one can live with less, and the rest gets the room."""
FADED = 0.35


def draw_numerical(points: Points, orders: Mapping[tuple[str, str], Quantity]) -> Drawing:
    drawing, panels = new_figure(7.2, 5.6, ncols=2, sharex=True, sharey=True, squeeze=False)
    right, top = _limits(points.settings, ERROR)
    for axes, (pads, title) in zip(panels[0], PADS.items(), strict=True):
        axes.set_title(title)
        _set_axes(axes, LEAST_ERROR_MM, right, top, points.settings)
        axes.set_xlabel("numerical error [mm]")
        _shade_floor(axes, points.floors[pads].value)
        _say_reference(axes, points.reference(pads))
        _draw_spread(axes, [row for row in points.settings if row["pads"] == pads and row.valid and is_own_model(row)])
        for method, (colour, line, mark) in STYLES.items():
            ladder = [row for row in points.ladder(pads, method) if row.valid]
            x, y = _places(ladder, ERROR, LEAST_ERROR_MM)
            axes.plot(x, y, linestyle=line, color=colour, marker="", linewidth=1.0, alpha=0.6)
            _scatter(axes, x, y, ladder, colour, mark, points.backend_front)
        others = [row for row in points.knobs(pads) if row.valid and is_own_model(row)]
        axes.scatter(*_places(others, ERROR, LEAST_ERROR_MM), s=9, color=INK, alpha=FADED)
        _draw_front(axes, points, pads, LEAST_ERROR_MM)
        _mark_failures(axes, [row for row in points.settings if row["pads"] == pads], right, top)
    panels[0][0].set_ylabel("run time [ms per simulated s]")
    _legend(drawing, points, orders)
    return drawing


def _limits(rows: Sequence[Row], error: str) -> tuple[float, float]:
    """Right and upper end of the axes."""
    valid = [row for row in rows if row.valid and row[error].value is not None]
    return 3.0 * max(row[error].value for row in valid), 4.0 * max(row.ms_per_s.value for row in valid)


def _set_axes(axes: Axes, left: float, right: float, top: float, rows: Sequence[Row]) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(left, right)
    axes.set_ylim(0.4 * min(row.ms_per_s.value for row in rows if row.valid), top)
    axes.minorticks_off()
    axes.text(0.03, 0.03, "↙ lower left is better", transform=axes.transAxes, fontsize=9)


def _shade_floor(axes: Axes, floor: float | None) -> None:
    if floor is not None:
        axes.axvspan(LEAST_ERROR_MM, floor, color=FAINT, alpha=0.5, linewidth=0, zorder=0)


def _say_reference(axes: Axes, reference: Row | None) -> None:
    """The reference's own error, which lies far beyond the left edge."""
    if reference is not None and reference.numerical_error_mm.value is not None:
        text = f"← reference itself: {format_number(reference.numerical_error_mm.value, digits=1)} mm"
        axes.text(0.03, 0.94, text, transform=axes.transAxes, fontsize=9)


def _draw_spread(axes: Axes, rows: Sequence[Row]) -> None:
    """From the 5th to the 95th percentile of the run time."""
    x, _ = _places(rows, ERROR, LEAST_ERROR_MM)
    low, high = ([row[column].value for row in rows] for column in ("ms_per_s_p5", "ms_per_s_p95"))
    axes.vlines(x, low, high, color=INK, linewidth=0.7, alpha=0.5, zorder=1)


def _places(rows: Sequence[Row], error: str, left: float) -> tuple[np.ndarray, np.ndarray]:
    x = np.array([max(row[error].value, left) for row in rows])
    return x, np.array([row.ms_per_s.value for row in rows])


def _scatter(
    axes: Axes, x: np.ndarray, y: np.ndarray, rows: Sequence[Row], colour: str, mark: str, front: frozenset[str]
) -> None:
    """Marks: open where the timeconst is raised, faint where another setting of the same engine beats it."""
    for clamped in (False, True):
        for best in (False, True):
            mine = [i for i, row in enumerate(rows) if is_clamped(row) is clamped and (row.case in front) is best]
            if mine:
                axes.scatter(
                    x[mine],
                    y[mine],
                    s=26,
                    marker=mark,
                    facecolors="none" if clamped else colour,
                    edgecolors=colour,
                    alpha=1.0 if best else FADED,
                    clip_on=False,
                    zorder=3,
                )


def _draw_front(axes: Axes, points: Points, pads: str, left: float) -> None:
    mine = (row for row in points.settings if row.case in points.front and row["pads"] == pads)
    front = sorted(mine, key=lambda row: row.numerical_error_mm.value)
    if front:
        x, y = _places(front, ERROR, left)
        axes.step(
            [*x, axes.get_xlim()[1]],
            [*y, y[-1]],
            where="post",
            color=INK,
            linestyle="-",
            linewidth=1.0,
            marker="",
            zorder=2,
        )


def _mark_failures(axes: Axes, rows: Sequence[Row], right: float, top: float) -> None:
    """On the upper edge, at their error where they have one: they have no time that counts."""
    for mark, mine in (("x", _limited(rows)), ("P", _lost(rows))):
        x = [min(row.numerical_error_mm.value or right, right) for row in mine]
        axes.scatter(x, [top] * len(x), marker=mark, s=40, color=SERIES[5], clip_on=False, zorder=4)


def _limited(rows: Sequence[Row]) -> list[Row]:
    return [row for row in rows if not row.valid and hit_iteration_limit(row)]


def _lost(rows: Sequence[Row]) -> list[Row]:
    return [row for row in rows if not row.valid and not hit_iteration_limit(row)]


def _legend(drawing: Drawing, points: Points, orders: Mapping[tuple[str, str], Quantity]) -> None:
    axes = drawing.axes[0]
    handles = []
    for method, (colour, line, mark) in STYLES.items():
        if any(row.method == method for row in points.settings):
            label = LABELS[method] + _order_note([orders.get((pads, method)) for pads in PADS])
            handles += axes.plot([], [], linestyle=line, color=colour, marker=mark, label=label)
    handles += axes.plot(
        [], [], linestyle="", marker=".", color=INK, alpha=FADED, label="other knobs, shipped substeps"
    )
    handles += axes.plot([], [], linestyle="-", marker="", color=INK, linewidth=1.0, label="Pareto front of all")
    for mark, found, label in (
        ("x", _limited, "failed: iteration limit"),
        ("P", _lost, "failed: grasp lost, not finite, overflow"),
    ):
        if found(points.settings):
            handles += axes.plot([], [], linestyle="", marker=mark, color=SERIES[5], label=label)
    drawing.legend(handles=handles, loc="outside lower center", ncols=2, fontsize=8.5)


def _order_note(orders: Sequence[Quantity | None]) -> str:
    """The observed orders, that of the pads as shipped first."""
    texts = [
        format_number(order.value, digits=2) if order is not None and order.value is not None else "–"
        for order in orders
    ]
    return f" (order {' | '.join(texts)})" if any(text != "–" for text in texts) else ""


def draw_grasp(points: Points) -> Drawing:
    drawing, axes = new_figure(7.2, 4.6)
    rows = [row for row in points.settings if row.valid and row.grasp_error_mm_per_cycle.value]
    errors = [row.grasp_error_mm_per_cycle.value for row in rows]
    right, top = _limits(rows, GRASP)
    _set_axes(axes, 0.5 * min(errors), right, top, rows)
    for number, (pads, title) in enumerate(PADS.items()):
        for backend, mark in GRASP_STYLES.items():
            mine = [row for row in rows if row["pads"] == pads and row.backend == backend]
            x, y = _places(mine, GRASP, 0.0)
            _scatter(axes, x, y, mine, SERIES[number], mark, points.grasp_backend_front)
            if mine:
                label = f"{title}, {ENGINES[backend].replace('MuJoCo Warp', 'Warp')}"
                axes.plot([], [], linestyle="", marker=mark, color=SERIES[number], label=label)
        reference = points.reference(pads)
        if reference is not None and reference.grasp_error_mm_per_cycle.value:
            axes.axvline(
                reference.grasp_error_mm_per_cycle.value,
                color=SERIES[number],
                linestyle=(":", "--")[number],
                linewidth=1.2,
                marker="",
                label=f"{title}, converged",
            )
    front = sorted((row for row in rows if row.case in points.grasp_front), key=lambda row: row[GRASP].value)
    x, y = _places(front, GRASP, 0.0)
    axes.step(
        [*x, right],
        [*y, y[-1]],
        where="post",
        color=INK,
        linestyle="-",
        linewidth=1.0,
        marker="",
        label="Pareto front of all",
    )
    axes.set_xlabel("grasp error [mm/cycle]")
    axes.set_ylabel("run time [ms per simulated s]")
    drawing.legend(loc="outside lower center", ncols=2, fontsize=8.5)
    return drawing


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
            f"{format_number(round(crossover.value))} worlds",
            (crossover.value, axes.get_ylim()[0]),
            xytext=(5, 6),
            textcoords="offset points",
        )
    axes.set_xlabel("worlds")
    axes.set_ylabel("world-seconds per second")
    drawing.legend(loc="outside upper left", ncols=2)
    return drawing
