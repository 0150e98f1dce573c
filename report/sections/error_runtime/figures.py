"""Error against run time as a diagram, and the run time of many worlds."""

from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import FAINT, INK, SERIES, new_figure, write
from report.sections.error_runtime.runs import (
    ENGINES,
    ERROR,
    PADS,
    TIME,
    Points,
    counts,
)
from report.sections.reproduction import FRAME_RATE
from report.shared import Row

COLOURS = {"warp-cuda": SERIES[0], "warp-cpu": SERIES[4], "mujoco-c": SERIES[2]}
NAMES = {
    backend: name.replace("MuJoCo Warp", "Warp") for backend, name in ENGINES.items()
}
NAMED = (
    "newton",
    "newton-rk4",
    "cpu",
    "c",
    "c-rk4",
)  # methods whose points have their substeps beside them
LEAST_ERROR_MM = (
    1e-5  # smaller errors are drawn on the left edge, which leaves the rest the room
)


def draw_numerical(points: Points) -> Drawing:
    drawing, panels = new_figure(
        7.2, 4.4, ncols=2, sharex=True, sharey=True, squeeze=False
    )
    rows = [
        row for row in points.settings if counts(row) and row[ERROR].value is not None
    ]
    times = [_frame_ms(row) for row in (*rows, *points.worlds[-1:]) if row[TIME].value]
    limits = {"xlim": (0.4 * min(times), 4.0 * max(times))}
    limits["ylim"] = (LEAST_ERROR_MM, 4.0 * max(row[ERROR].value for row in rows))
    for axes, (pads, title) in zip(panels[0], PADS.items(), strict=True):
        axes.set(
            title=title,
            xlabel="time of a world's frame [ms]",
            xscale="log",
            yscale="log",
            **limits,
        )
        axes.minorticks_off()
        axes.text(
            0.03, 0.03, "↙ lower left is better", transform=axes.transAxes, fontsize=8.5
        )
        if (floor := points.floors[pads].value) is not None:
            axes.axhspan(
                LEAST_ERROR_MM, floor, color=FAINT, alpha=0.5, linewidth=0, zorder=0
            )
            _say_level(axes, floor, " Warp's rounding", "top")
        if (creep := points.converged(pads).value) is not None:
            axes.axhline(creep, color=INK, linewidth=0.8, linestyle=":", marker="")
            _say_level(axes, creep, " creep in a cycle", "bottom")
        for backend in points.engines:
            mine = [
                row for row in rows if row["pads"] == pads and row.backend == backend
            ]
            if mine:
                _draw_engine(axes, mine, points.backend_front, backend)
            if (row := points.shipped(pads, backend)) and row[ERROR].value:
                _star(axes, _place(row), row, write(row[ERROR]), (8, 4))
        if (
            pads == "stiff"
            and (one := points.shipped(pads, points.engines[0]))
            and one[ERROR].value
        ):
            # The most worlds at the run time of each, with the error of one as shipped, whose settings they have.
            for row in (row for row in points.worlds[-1:] if row[TIME].value):
                _star(
                    axes,
                    (_frame_ms(row), one[ERROR].value),
                    one,
                    f"{write(row.worlds)} worlds, each",
                    (-4, -16),
                )
    panels[0][0].set_ylabel("numerical error [mm]")
    return drawing


def _say_level(axes: Axes, level: float, text: str, side: str) -> None:
    axes.annotate(
        text, (0.01, level), xycoords=("axes fraction", "data"), va=side, fontsize=8
    )


def _frame_ms(row: Row) -> float:
    """Return the time of a world's frame, as the figure of the front page has it."""
    return row[TIME].value / FRAME_RATE / (row.worlds.value if "worlds" in row else 1)


def _place(row: Row) -> tuple[float, float]:
    return _frame_ms(row), max(row[ERROR].value, LEAST_ERROR_MM)


def _draw_engine(
    axes: Axes, rows: Sequence[Row], front: frozenset[str], backend: str
) -> None:
    colour = COLOURS[backend]
    best = sorted((row for row in rows if row.case in front), key=_frame_ms)
    if best:
        x, y = zip(*(_place(row) for row in best), strict=True)
        style = {"color": colour, "linestyle": "-", "linewidth": 1.1, "marker": ""}
        axes.step([*x, axes.get_xlim()[1]], [*y, y[-1]], where="post", **style)
        axes.scatter(x, y, s=14, color=colour, linewidths=0, clip_on=False)
        for row in (
            row
            for row in best
            if row.method in NAMED and row[ERROR].value > LEAST_ERROR_MM
        ):
            text = ("RK4 " if row.method.endswith("rk4") else "") + write(row.substeps)
            axes.annotate(
                text,
                _place(row),
                xytext=(3, 3),
                textcoords="offset points",
                fontsize=7,
                color=colour,
            )
        side = (
            "right" if backend == "mujoco-c" else "left"
        )  # the faster engine stands to the left
        above: dict[str, Any] = {
            "xytext": (0, 12),
            "textcoords": "offset points",
            "ha": side,
            "fontsize": 9,
        }
        axes.annotate(NAMES[backend], _place(best[0]), color=colour, **above)


def _star(
    axes: Axes, place: tuple[float, float], row: Row, text: str, beside: tuple[int, int]
) -> None:
    style: dict[str, Any] = {"color": COLOURS[row.backend], "zorder": 6}
    axes.scatter(*place, s=130, marker="*", edgecolors=INK, linewidths=0.7, **style)
    axes.annotate(
        text, place, xytext=beside, textcoords="offset points", fontsize=8.5, **style
    )
