"""Maps of amplitude and frequency: the slip of each cell, and which of them lose the cube."""

from collections.abc import Mapping

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

SLIP_RANGE_MM = (
    0.01,
    50.0,
)  # ends of the colour scale; what lies outside has the colour of the end
FREQUENCY_TICKS_HZ = (0.25, 0.5, 1, 2, 5)
AMPLITUDE_TICKS_CM = (0.5, 1, 2, 5, 10)
HELD_HEIGHT_M = 0.15  # a cube that ends lower has left the hand, which shakes it about 0.2 m above the ground


def lost_count(results: Results, trace: Series, side: str, held: Value) -> Value:
    """Count cells of a side of the map whose cube ends lower than ``held``, or nowhere."""

    def lost(frame: pd.DataFrame, least: float) -> int:
        return int((~(frame["cube_height_m"][frame["side"] == side] >= least)).sum())

    return results.value(
        f"lost_{side.replace('-', '_')}",
        f"cells of side {side} whose cube ends lower than held_height, or nowhere",
        lost,
        trace,
        held,
    )


def grid_of(frame: pd.DataFrame, side: str, column: str) -> pd.DataFrame:
    """Lay out a column of one side of the map: amplitudes [m] down, frequencies [Hz] across."""
    return frame[frame["side"] == side].pivot(
        index="shake_amplitude_m", columns="shake_frequency_hz", values=column
    )


def held_slip(frame: pd.DataFrame, side: str) -> pd.DataFrame:
    """Lay out the slips of one side of the map, of cells that keep the cube."""
    return grid_of(frame, side, "slip_mm").where(
        grid_of(frame, side, "dropped").astype(str) == "False"
    )


def draw_maps(frame: pd.DataFrame, sides: Mapping[str, str]) -> Drawing:
    """Draw the slip of every cell, and which lose the cube, a panel for each of the ``sides`` under its label."""
    drawing, panels = new_figure(7.2, 4.0, ncols=len(sides), sharey=True)
    drawing.set_layout_engine("constrained", wspace=0.06)
    for axes, (side, label) in zip(panels, sides.items(), strict=True):
        colours = _draw_map(
            axes,
            *(
                grid_of(frame, side, column)
                for column in ("slip_mm", "dropped", "failure")
            ),
        )
        axes.set_title(label)
    panels[0].set_ylabel("amplitude [cm]")
    drawing.supxlabel("frequency [Hz]", fontsize=10)
    bar = drawing.colorbar(
        colours, ax=list(panels), label="slip [mm]", extend="both", pad=0.02
    )
    bar.ax.yaxis.set_major_formatter(plain_labels())
    shown, handles = frame[frame["side"].isin(sides)], []
    if (shown["dropped"].astype(str) == "True").any():
        handles += [
            Line2D(
                [],
                [],
                color=INK,
                marker="x",
                markersize=5,
                linewidth=1.6,
                linestyle="-",
                label="dropped",
            )
        ]
    if shown["failure"].notna().any():
        handles += [
            Line2D(
                [],
                [],
                color=INK,
                marker="_",
                markersize=5,
                linestyle="none",
                label="no finite result",
            )
        ]
    if handles:
        drawing.legend(handles=handles, loc="outside upper left", ncols=2)
    return drawing


def _draw_map(
    axes: Axes, slip: pd.DataFrame, dropped: pd.DataFrame, failure: pd.DataFrame
):
    frequency, amplitude = slip.columns.to_numpy(), 100 * slip.index.to_numpy()
    failed, lost = (
        failure.notna().to_numpy(),
        (dropped.astype(str) == "True").to_numpy(),
    )
    shown = np.ma.masked_where(
        lost | failed | slip.isna().to_numpy(), slip.to_numpy(dtype=float)
    )
    axes.set_facecolor("#f2f2f2")  # of cells that have no slip to show
    axes.grid(visible=False)
    place, norm = (frequency, amplitude, shown), LogNorm(*SLIP_RANGE_MM)
    colours = axes.pcolormesh(
        *place,
        zorder=0.5,
        norm=norm,
        cmap="viridis",
        shading="nearest",
        rasterized=True,
    )
    x, y = np.broadcast_arrays(frequency[np.newaxis, :], amplitude[:, np.newaxis])
    axes.set(xscale="log", yscale="log")
    for marker, cells in (("x", lost), ("_", failed)):
        axes.scatter(
            x[cells], y[cells], marker=marker, s=9, linewidths=0.8, color=MAP_INK
        )
    if lost.any() and not lost.all():
        axes.contour(
            frequency,
            amplitude,
            lost.astype(float),
            levels=[0.5],
            colors=MAP_INK,
            linewidths=1.6,
        )
    tick_at(axes.xaxis, FREQUENCY_TICKS_HZ)
    tick_at(axes.yaxis, AMPLITUDE_TICKS_CM)
    return colours
