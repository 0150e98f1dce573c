"""How hard can one shake? Amplitude and frequency, as shipped and with stiff pads, as points and as a map."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure as Drawing
from matplotlib.lines import Line2D

from measured_report.claims.claim import Claim, Outcome, all_of, at_least, at_most, decided
from measured_report.parts.figures import INK, MAP_INK, new_figure, plain_labels, tick_at
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row, Series
from report.shared.arithmetic import SETTLES, cell_count, extreme, noise_floor, ratio, resolved, table_of

order = 120
page = "fix"
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
Points = Mapping[str, tuple[Row, Row]]
"""As shipped and with stiff pads, by the name of the point."""


def derive(results: Results) -> Section:
    points, costs = _points(results), results.row["map"]
    gains = {name: _gain(results, name, *sides) for name, sides in points.items()}
    trace = results.trace("map")
    held = results.chosen("held_height", "a cube that ends lower has left the hand", HELD_HEIGHT_M, unit="m")
    lost = {side: lost_count(results, trace, side, held) for side in SIDES}
    numbers = {"shipped": costs.dropped_as_shipped_count, "stiff": costs.dropped_stiff_count}
    return Section(
        tables={"points": _table(points, gains)},
        figures={"maps": Figure(lambda: draw_maps(trace.value, SIDES), [trace], numbers)},
        claims=[
            *_drops(results, costs, lost, held),
            _gain_everywhere(results, points, gains),
            _map_gain(results, trace),
            *_growth(results),
            _batch_is_fast(results, costs),
        ],
    )


def _points(results: Results) -> Points:
    first, second = (f"{side}-" for side in SIDES)
    names = [case.removeprefix(first) for case in results.row if case.startswith(first)]
    return {name: (results.row[first + name], results.row[second + name]) for name in names}


def _held_slip(row: Row) -> Quantity:
    """Take the slip; none where the cube was dropped, because it then says how far the cube fell."""
    return replace(row.slip_mm, value=None, reason="the cube was dropped") if row.dropped else row.slip_mm


def _gain(results: Results, name: str, shipped: Row, stiff: Row) -> Value:
    key = "gain_" + name.replace("-", "_").replace(".", "_")
    formula = f"slip as shipped over slip with stiff pads, {name}"
    return ratio(results, key, formula, _held_slip(shipped), _held_slip(stiff))


def lost_count(results: Results, trace: Series, side: str, held: Value) -> Value:
    """Count cells of a side of the map whose cube ends lower than ``held``, or nowhere."""
    return results.value(
        f"lost_{side.replace('-', '_')}",
        f"cells of side {side} whose cube ends lower than held_height, or nowhere",
        lambda frame, least: int((~(frame["cube_height_m"][frame["side"] == side] >= least)).sum()),
        *(trace, held),
    )


def _drops(results: Results, row: Row, lost: Mapping[str, Value], held: Value) -> Iterator[Claim]:
    """Tell on which side of the map cubes are dropped."""
    shipped, stiff = (lost[side] for side in SIDES)
    cells = results.value("cells", "cells of the map on each side", lambda count: count // len(SIDES), row.world_count)
    never = at_most(stiff, 0, why="no cell is dropped")
    yield Claim("stiff_pads_never_drop", never, {"lost": stiff, "cells": cells, "held": held})
    yield Claim("as_shipped_drops", decided(bool(shipped.value), shipped), {"lost": shipped})


def _gain_everywhere(results: Results, points: Points, gains: Mapping[str, Value]) -> Claim:
    there = [gain for gain in gains.values() if gain.value is not None]
    bound, shipped = results.chosen("gain_bound", *SETTLES), [before.frame_count for before, _ in points.values()]
    numbers = {
        "least": extreme(results, "gain_least", "least of the points' ratios", min, there),
        "most": extreme(results, "gain_most", "largest of the points' ratios", max, there),
        "held": cell_count(results, "gain_count", "points where the cube is held before and after", there),
        "count": cell_count(results, "point_count", "points of the table", shipped),
        "bound": bound,
    }
    return Claim("gain_everywhere", at_least(numbers["least"], bound), numbers)


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


def _growth(results: Results) -> Iterator[Claim]:
    """Tell how the slip grows as shipped, with the amplitude and with the frequency."""
    small, large = results.row["as-shipped-1cm-1hz"], results.row["as-shipped-6cm-1hz"]
    low, high = small.shake_amplitude_m, large.shake_amplitude_m
    exponent = _exponent(results, "amplitude", "as shipped at the baseline's frequency", low, high, small, large)
    numbers = {"exponent": exponent, "frequency": large.shake_frequency_hz}
    numbers |= {"small": low, "small_slip": small.slip_mm, "large": high, "large_slip": large.slip_mm}
    outcome = at_least(exponent, 1.5, why="clearly more than in proportion")
    yield Claim("slip_grows_faster_than_amplitude", outcome, numbers)

    slow, fast = results.row["as-shipped-3cm-0.5hz"], results.row["as-shipped-3cm-3hz"]
    low, high = slow.shake_frequency_hz, fast.shake_frequency_hz
    exponent = _exponent(results, "frequency", "shipped pads at the baseline's amplitude", low, high, slow, fast)
    numbers = {"exponent": exponent, "slow": low, "slow_slip": slow.slip_mm, "fast": high, "fast_slip": fast.slip_mm}
    outcome = at_most(exponent, 1.5, why="clearly less than the square")
    yield Claim("slip_grows_less_with_frequency", outcome, numbers)


def _exponent(results: Results, name: str, where: str, low: Quantity, high: Quantity, less: Row, more: Row) -> Value:
    """Derive the power of what goes from ``low`` to ``high`` with which the slip grows between two runs."""

    def power(low: float, high: float, less: float, more: float) -> float:
        return float(np.log(more / less) / np.log(high / low))

    formula = f"logarithm of the ratio of the slips over that of what is changed, {where}"
    return results.value(f"{name}_exponent", formula, power, low, high, _held_slip(less), _held_slip(more))


def _batch_is_fast(results: Results, row: Row) -> Claim:
    alone, worlds = [other.wall_s for other in results.rows if other.case.startswith("alone-")], row.world_count
    formula = "mean wall time of one world alone"
    one = results.value("alone_wall_s", formula, lambda *wall: float(np.mean(wall)), *alone, unit="s")
    timed = cell_count(results, "alone_count", "worlds that were timed alone", alone)
    formula = "worlds × mean wall time of one alone, over the wall time of the batch"
    gain = results.value("batch_gain", formula, lambda n, single, batch: n * single / batch, worlds, one, row.wall_s)
    bound = results.chosen("batch_gain_bound", "what the batch is aimed at", 500.0)
    outcome = at_least(gain, bound)
    if worlds.value is not None and worlds.value < bound.value:
        outcome = Outcome("unknown", "the map has fewer worlds than that")
    numbers = {"worlds": worlds, "batch": row.wall_s, "single": one, "timed": timed, "gain": gain, "bound": bound}
    return Claim("batch_is_fast", outcome, numbers)


def _table(points: Points, gains: Mapping[str, Value]) -> Table:
    sides = dict(zip(("before", "after"), zip(*points.values(), strict=True), strict=True))
    columns: dict[str, list] = {f"slip {when}": [row.slip_mm for row in rows] for when, rows in sides.items()}
    columns["ratio"] = list(gains.values())
    fates = {True: "dropped", False: "held"}
    told = [[fates.get(row.dropped, "no result") for row in pair] for pair in points.values()]
    columns["cube"] = [" → ".join(dict.fromkeys(pair)) for pair in told]
    columns |= {f"height {when}": [row.cube_height_m for row in rows] for when, rows in sides.items()}
    return table_of("shake", [name.replace("cm-", " cm, ").replace("hz", " Hz") for name in points], columns)


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
    """Take the slips of every cell that is held on both sides, as shipped and with stiff pads, shape [cells] each."""
    shipped, stiff = (held_slip(frame, side).to_numpy(dtype=float) for side in SIDES)
    is_there = np.isfinite(shipped / stiff)
    return shipped[is_there], stiff[is_there]


def draw_maps(frame: pd.DataFrame, sides: Mapping[str, str]) -> Drawing:
    """The slip of every cell, and which of them lose the cube, a panel for each of the ``sides``, which have labels."""
    drawing, panels = new_figure(7.2, 4.0, ncols=len(sides), sharey=True)
    drawing.set_layout_engine("constrained", wspace=0.06)
    for axes, (side, label) in zip(panels, sides.items(), strict=True):
        colours = _draw_map(axes, *(grid_of(frame, side, column) for column in ("slip_mm", "dropped", "failure")))
        axes.set_title(label)
    panels[0].set_ylabel("amplitude [cm]")
    drawing.supxlabel("frequency [Hz]", fontsize=10)
    bar = drawing.colorbar(colours, ax=list(panels), label="slip [mm]", extend="both", pad=0.02)
    bar.ax.yaxis.set_major_formatter(plain_labels())
    handles = [Line2D([], [], color=INK, marker="x", markersize=5, linewidth=1.6, linestyle="-", label="dropped")]
    if frame["failure"].notna().any():
        handles += [Line2D([], [], color=INK, marker="_", markersize=5, linestyle="none", label="no finite result")]
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
