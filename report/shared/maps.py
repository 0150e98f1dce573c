"""Draw maps of the slip over amplitude and frequency, with the cells that lose the cube."""

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.lines import Line2D

from measured_report.values.quantities import Value
from measured_report.values.results import Results, Series
from report.shared.drawing import (
    INK,
    MAP_INK,
    Drawing,
    new_figure,
    plain_labels,
    tick_at,
)

# Ends of the colour scale. A slip outside it has the colour of the nearer end.
SLIP_RANGE_MM = (0.01, 50.0)
FREQUENCY_TICKS_HZ = (0.25, 0.5, 1, 2, 5)
AMPLITUDE_TICKS_CM = (0.5, 1, 2, 5, 10)
# The hand shakes the cube about 0.2 m above the ground. A lower cube has left the hand.
HELD_HEIGHT_M = 0.15


def lost_count(results: Results, trace: Series, side: str, held_height: Value) -> Value:
    """Count the cells on a side of the map whose cube ends below ``held_height``."""

    def lost(frame: pd.DataFrame, least: float) -> int:
        heights = frame["cube_height_m"][frame["side"] == side]
        # A failed run has a height that is not a number, and counts as lost.
        return int((~(heights >= least)).sum())

    return results.value(
        f"lost_{side.replace('-', '_')}",
        f"cells of side {side} whose cube ends below held_height, or whose run fails",
        lost,
        trace,
        held_height,
    )


def grid_of(frame: pd.DataFrame, side: str, column: str) -> pd.DataFrame:
    """Return a column of a side as a grid of amplitudes [m] by frequencies [Hz]."""
    cells = frame[frame["side"] == side]
    return cells.pivot(
        index="shake_amplitude_m", columns="shake_frequency_hz", values=column
    )


def held_slip(frame: pd.DataFrame, side: str) -> pd.DataFrame:
    """Return the slips of a side as a grid. Cells that lose the cube are NaN."""
    is_held = grid_of(frame, side, "dropped").astype(str) == "False"
    return grid_of(frame, side, "slip_mm").where(is_held)


def draw_maps(frame: pd.DataFrame, sides: dict[str, str]) -> Drawing:
    """Draw the slips of each side in a panel, and mark the cells that lose the cube."""
    drawing, panels = new_figure(7.2, 4.0, ncols=len(sides), sharey=True)
    drawing.set_layout_engine("constrained", wspace=0.06)
    for axes, (side, label) in zip(panels, sides.items(), strict=True):
        colours = _draw_map(axes, frame, side)
        axes.set_title(label)
    panels[0].set_ylabel("amplitude [cm]")
    drawing.supxlabel("frequency [Hz]", fontsize=10)
    bar = drawing.colorbar(
        colours, ax=list(panels), label="slip [mm]", extend="both", pad=0.02
    )
    bar.ax.yaxis.set_major_formatter(plain_labels())
    shown = frame[frame["side"].isin(sides)]
    handles = []
    look = {"color": INK, "markersize": 5}
    if (shown["dropped"].astype(str) == "True").any():
        handles.append(Line2D([], [], label="dropped", marker="x", **look))
    if shown["failure"].notna().any():
        line = Line2D(
            [], [], label="no finite result", marker="_", linestyle="", **look
        )
        handles.append(line)
    if handles:
        drawing.legend(handles=handles, loc="outside upper left", ncols=2)
    return drawing


def _draw_map(axes: Axes, frame: pd.DataFrame, side: str):
    slip = grid_of(frame, side, "slip_mm")
    failed = grid_of(frame, side, "failure").notna().to_numpy()
    lost = (grid_of(frame, side, "dropped").astype(str) == "True").to_numpy()
    hidden = lost | failed | slip.isna().to_numpy()
    frequency = slip.columns.to_numpy()
    amplitude = 100 * slip.index.to_numpy()
    axes.set_facecolor("#f2f2f2")  # background of the cells without a slip
    axes.grid(visible=False)
    colours = axes.pcolormesh(
        frequency,
        amplitude,
        np.ma.masked_where(hidden, slip.to_numpy(dtype=float)),
        zorder=0.5,
        norm=LogNorm(*SLIP_RANGE_MM),
        cmap="viridis",
        shading="nearest",
        rasterized=True,
    )
    axes.set(xscale="log", yscale="log")
    x, y = np.meshgrid(frequency, amplitude)
    for marker, cells in (("x", lost), ("_", failed)):
        axes.scatter(
            x[cells], y[cells], marker=marker, s=9, linewidths=0.8, color=MAP_INK
        )
    if lost.any() and not lost.all():
        edge = lost.astype(float)
        axes.contour(frequency, amplitude, edge, levels=[0.5], colors=MAP_INK)
    tick_at(axes.xaxis, FREQUENCY_TICKS_HZ)
    tick_at(axes.yaxis, AMPLITUDE_TICKS_CM)
    return colours
