"""How hard can one shake? Amplitude and frequency, as shipped and with stiff pads, as points and as a map."""

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure as Drawing
from matplotlib.lines import Line2D

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most, decided
from measured_report.parts.figures import INK, MAP_INK, new_figure, plain_labels, tick_at
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row, Series
from report.shared.arithmetic import noise_floor, resolved

order = 120
page = "fix"
reads = ("noise",)
label = "harder shakes"

SIDES = {"as-shipped": "shipped pads", "stiff": "stiff pads"}
SLIP_RANGE_MM = (0.01, 50.0)
"""Ends of the colour scale; what lies outside has the colour of the end."""
FREQUENCY_TICKS_HZ = (0.25, 0.5, 1, 2, 5)
AMPLITUDE_TICKS_CM = (0.5, 1, 2, 5, 10)
EMPTY = "#f2f2f2"
"""Colour of the cells of a map that have no slip to show."""
HELD_HEIGHT_M = 0.15
"""A cube that ends lower has left the hand, which shakes it about 0.2 m above the ground."""


def derive(results: Results) -> Section:
    trace = results.trace("map")
    held = results.chosen("held_height", "a cube that ends lower has left the hand", HELD_HEIGHT_M, unit="m")
    lost = {side: lost_count(results, trace, side, held) for side in SIDES}
    shipped, stiff = _drops(results, trace, lost, held)
    seconds = results.row["as-shipped-3cm-1hz"].shake_duration_s
    about = {"shipped": lost["as-shipped"], "stiff": lost["stiff"], "seconds": seconds}
    about |= {"keeps": stiff.outcome == HOLDS, "is_crossed": any(count.value for count in lost.values())}
    return Section(
        figures={"maps": Figure(lambda: draw_maps(trace.value, SIDES), [trace], about)},
        claims=[shipped, stiff, _map_gain(results, trace), _slip_grows(results)],
    )


def _held_slip(row: Row) -> Quantity:
    """Take the slip; none where the cube was dropped, because it then says how far the cube fell."""
    return replace(row.slip_mm, value=None, reason="the cube was dropped") if row.dropped else row.slip_mm


def lost_count(results: Results, trace: Series, side: str, held: Value) -> Value:
    """Count cells of a side of the map whose cube ends lower than ``held``, or nowhere."""
    return results.value(
        f"lost_{side.replace('-', '_')}",
        f"cells of side {side} whose cube ends lower than held_height, or nowhere",
        lambda frame, least: int((~(frame["cube_height_m"][frame["side"] == side] >= least)).sum()),
        *(trace, held),
    )


def _drops(results: Results, trace: Series, lost: Mapping[str, Value], held: Value) -> tuple[Claim, Claim]:
    shipped, stiff = (lost[side] for side in SIDES)
    cells = results.value("cells", "cells of the map on each side", lambda frame: len(frame) // len(SIDES), trace)
    drops = decided(bool(shipped.value), shipped)
    never = at_most(stiff, 0, why="no cell is dropped")
    return (
        Claim("as_shipped_drops", drops, {"lost": shipped, "cells": cells}),
        Claim("stiff_pads_never_drop", never, {"lost": stiff, "cells": cells, "held": held}),
    )


def _map_gain(results: Results, trace: Series) -> Claim:
    formula = "median over the map of the ratio of the slips, where the cube is held before and after"
    median = results.value("map_gain_median", formula, lambda frame: np.median(_gains(frame)), trace)
    least = results.value("map_gain_least", "least ratio on the map", lambda frame: _gains(frame).min(), trace)
    formula = "cells with less slip than as shipped"
    share = results.value("map_gain_share", formula, _share_above_one, trace, unit="%")
    formula = "least of the differences of the slips, as shipped less stiff, in size"
    gap = results.value(
        "map_gap_least", formula, lambda frame: abs(np.subtract(*_slips(frame))).min(), trace, unit="mm"
    )
    outcome = all_of(at_least(share, 100.0, why="every cell"), resolved(noise_floor(results, "slip_floor"), gap))
    return Claim("map_gain", outcome, {"median": median, "least": least, "share": share})


def _share_above_one(frame: pd.DataFrame) -> float:
    gains = _gains(frame)
    return 100 * float(np.mean(gains > 1.0)) if len(gains) else float("nan")


def _slip_grows(results: Results) -> Claim:
    small, large = results.row["as-shipped-1cm-1hz"], results.row["as-shipped-6cm-1hz"]

    def power(low: float, high: float, less: float, more: float) -> float:
        return math.log(more / less) / math.log(high / low)

    cells = small.shake_amplitude_m, large.shake_amplitude_m, _held_slip(small), _held_slip(large)
    formula = "logarithm of the ratio of the slips over that of the amplitudes"
    exponent = results.value("amplitude_exponent", formula, power, *cells)
    numbers = dict(zip(("small", "large", "small_slip", "large_slip"), cells, strict=True))
    numbers["frequency"] = small.shake_frequency_hz
    ends = (at_least, 1.7), (at_most, 2.3)
    outcome = all_of(*(bound(exponent, end, why="an exponent of about 2") for bound, end in ends))
    return Claim("slip_grows_faster_than_amplitude", outcome.having_read(numbers["frequency"]), numbers)


def grid_of(frame: pd.DataFrame, side: str, column: str) -> pd.DataFrame:
    """Lay out a column of one side of the map: amplitudes [m] down, frequencies [Hz] across."""
    mine = frame[frame["side"] == side]
    return mine.pivot(index="shake_amplitude_m", columns="shake_frequency_hz", values=column)


def held_slip(frame: pd.DataFrame, side: str) -> pd.DataFrame:
    """Lay out the slips of one side of the map, of cells that keep the cube."""
    return grid_of(frame, side, "slip_mm").where(grid_of(frame, side, "dropped").astype(str) == "False")


def _gains(frame: pd.DataFrame) -> np.ndarray:
    return np.divide(*_slips(frame))


def _slips(frame: pd.DataFrame) -> tuple[np.ndarray, np.ndarray]:
    shipped, stiff = (held_slip(frame, side).to_numpy(dtype=float) for side in SIDES)
    is_there = np.isfinite(shipped / stiff)
    return shipped[is_there], stiff[is_there]


def draw_maps(frame: pd.DataFrame, sides: Mapping[str, str]) -> Drawing:
    """Draw the slip of every cell, and which of them lose the cube, a panel for each of the ``sides``, which have
    labels."""
    drawing, panels = new_figure(7.2, 4.0, ncols=len(sides), sharey=True)
    drawing.set_layout_engine("constrained", wspace=0.06)
    for axes, (side, label) in zip(panels, sides.items(), strict=True):
        colours = _draw_map(axes, *(grid_of(frame, side, column) for column in ("slip_mm", "dropped", "failure")))
        axes.set_title(label)
    panels[0].set_ylabel("amplitude [cm]")
    drawing.supxlabel("frequency [Hz]", fontsize=10)
    bar = drawing.colorbar(colours, ax=list(panels), label="slip [mm]", extend="both", pad=0.02)
    bar.ax.yaxis.set_major_formatter(plain_labels())
    shown, handles = frame[frame["side"].isin(sides)], []
    if (shown["dropped"].astype(str) == "True").any():
        handles += [Line2D([], [], color=INK, marker="x", markersize=5, linewidth=1.6, linestyle="-", label="dropped")]
    if shown["failure"].notna().any():
        handles += [Line2D([], [], color=INK, marker="_", markersize=5, linestyle="none", label="no finite result")]
    if handles:
        drawing.legend(handles=handles, loc="outside upper left", ncols=2)
    return drawing


def _draw_map(axes: Axes, slip: pd.DataFrame, dropped: pd.DataFrame, failure: pd.DataFrame):
    frequency, amplitude = slip.columns.to_numpy(), 100 * slip.index.to_numpy()
    failed, lost = failure.notna().to_numpy(), (dropped.astype(str) == "True").to_numpy()
    shown = np.ma.masked_where(lost | failed | slip.isna().to_numpy(), slip.to_numpy(dtype=float))
    axes.set_facecolor(EMPTY)
    axes.grid(visible=False)
    norm = LogNorm(*SLIP_RANGE_MM)
    place = frequency, amplitude, shown
    colours = axes.pcolormesh(*place, zorder=0.5, norm=norm, cmap="viridis", shading="nearest", rasterized=True)
    x, y = np.broadcast_arrays(frequency[np.newaxis, :], amplitude[:, np.newaxis])
    axes.set(xscale="log", yscale="log")
    for marker, cells in (("x", lost), ("_", failed)):
        axes.scatter(x[cells], y[cells], marker=marker, s=9, linewidths=0.8, color=MAP_INK)
    if lost.any() and not lost.all():
        axes.contour(frequency, amplitude, lost.astype(float), levels=[0.5], colors=MAP_INK, linewidths=1.6)
    tick_at(axes.xaxis, FREQUENCY_TICKS_HZ)
    tick_at(axes.yaxis, AMPLITUDE_TICKS_CM)
    return colours
