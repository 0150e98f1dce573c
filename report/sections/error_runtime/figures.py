"""Draw the diagram of error against run time."""

from typing import Any

from matplotlib.axes import Axes

from report.sections.error_runtime.runs import (
    ENGINES,
    ERROR,
    PADS,
    TIME,
    Points,
    counts,
)
from report.shared import FRAME_RATE, Row
from report.shared.drawing import (
    FAINT,
    INK,
    SERIES,
    Drawing,
    new_figure,
    write,
    write_beside,
)

COLOURS = {"warp-cuda": SERIES[0], "warp-cpu": SERIES[4], "mujoco-c": SERIES[2]}
# Methods whose points are labelled with their substeps.
NAMED = ("newton", "newton-rk4", "cpu", "c", "c-rk4")
# Smaller errors are drawn on the lower edge, so that the others have enough room.
LEAST_ERROR_MM = 1e-5


def draw_numerical(points: Points) -> Drawing:
    drawing, panels = new_figure(
        7.2, 4.4, ncols=2, sharex=True, sharey=True, squeeze=False
    )
    rows = [row for row in points.settings if counts(row)]
    most = [row for row in points.worlds[-1:] if row[TIME].value]
    times = [_frame_ms(row) for row in (*rows, *most) if row[TIME].value]
    limits = {
        "xlim": (0.4 * min(times), 4.0 * max(times)),
        "ylim": (LEAST_ERROR_MM, 4.0 * max(row[ERROR].value for row in rows)),
    }
    for axes, (pads, title) in zip(panels[0], PADS.items(), strict=True):
        axes.set(title=title, xlabel="time of a world's frame [ms]")
        axes.set(xscale="log", yscale="log", **limits)
        axes.minorticks_off()
        axes.text(
            0.03,
            0.03,
            "↙ lower left is better",
            transform=axes.transAxes,
            fontsize=8.5,
        )
        left = {"xycoords": ("axes fraction", "data"), "fontsize": 8}
        floor = points.floors[pads].value
        creep = points.converged(pads).value
        if floor is not None:
            axes.axhspan(
                LEAST_ERROR_MM, floor, color=FAINT, alpha=0.5, linewidth=0, zorder=0
            )
            axes.annotate(" rounding of Warp", (0.01, floor), va="top", **left)
        if creep is not None:
            axes.axhline(creep, color=INK, linewidth=0.8, linestyle=":")
            axes.annotate(" creep per cycle", (0.01, creep), va="bottom", **left)
        for backend in points.engines:
            best = [
                row
                for row in rows
                if (row["pads"], row.backend) == (pads, backend)
                and row.case in points.backend_front
            ]
            if best:
                _draw_engine(axes, sorted(best, key=_frame_ms), backend)
            row = points.shipped(pads, backend)
            if row and row[ERROR].value:
                _star(axes, _place(row), row, write(row[ERROR]), (8, 4))
        alone = points.shipped(pads, points.engines[0])
        if pads == "stiff" and alone and alone[ERROR].value:
            # Many worlds run with the shipped settings, so they have the error of one
            # world.
            for row in most:
                place = (_frame_ms(row), alone[ERROR].value)
                _star(
                    axes, place, alone, f"{write(row.worlds)} worlds, each", (-4, -16)
                )
    panels[0][0].set_ylabel("numerical error [mm]")
    return drawing


def _frame_ms(row: Row) -> float:
    """Return the time per world and frame [ms], as in the figure of the front page."""
    worlds = row.worlds.value if "worlds" in row else 1
    return row[TIME].value / FRAME_RATE / worlds


def _place(row: Row) -> tuple[float, float]:
    return _frame_ms(row), max(row[ERROR].value, LEAST_ERROR_MM)


def _draw_engine(axes: Axes, best: list[Row], backend: str) -> None:
    """Draw the Pareto-optimal settings of an engine, the fastest first."""
    colour = COLOURS[backend]
    x, y = zip(*map(_place, best), strict=True)
    axes.step(
        [*x, axes.get_xlim()[1]],
        [*y, y[-1]],
        where="post",
        color=colour,
        linestyle="-",
        linewidth=1.1,
        marker="",
    )
    axes.scatter(x, y, s=14, color=colour, linewidths=0, clip_on=False)
    for row in best:
        if row.method in NAMED and row[ERROR].value > LEAST_ERROR_MM:
            text = write(row.substeps)
            if row.method.endswith("rk4"):
                text = f"RK4 {text}"
            write_beside(axes, text, _place(row), (3, 3), fontsize=7, color=colour)
    name = ENGINES[backend].replace("MuJoCo Warp", "Warp")
    # The name of the faster engine is to the left of its marks.
    side = "right" if backend == "mujoco-c" else "left"
    write_beside(
        axes, name, _place(best[0]), (0, 12), color=colour, ha=side, fontsize=9
    )


def _star(
    axes: Axes, place: tuple[float, float], row: Row, text: str, beside: tuple[int, int]
) -> None:
    style: dict[str, Any] = {"color": COLOURS[row.backend], "zorder": 6}
    axes.scatter(*place, s=130, marker="*", edgecolors=INK, linewidths=0.7, **style)
    write_beside(axes, text, place, beside, fontsize=8.5, **style)
