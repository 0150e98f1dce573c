"""How fast one world runs: as shipped, as fixed, and with either change alone."""

from collections.abc import Sequence

import numpy as np
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import HOLDS, Claim, at_least, greater, within
from measured_report.parts.figures import INK, new_figure, say_value, write
from measured_report.parts.section import Figure, Section
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import ratio, share, size_difference
from report.shared.drawing import SHIPPED, STIFF
from report.shared.timing import cell, frame_spread

order = 160
page = "cost"
label = "speed of one world"

UNTRIMMED = "as-shipped-untrimmed"


def derive(results: Results) -> Section:
    rows = results.rows
    same_time = _same_time(results)
    times = Markup("; ").join(Markup("{}: {}").format(name_of(row.case), row.frame_ms) for row in rows)
    numbers = {"times": times, "is_same": same_time.outcome == HOLDS}
    frames = Figure(lambda: _draw_frames(rows), [row.frame_ms for row in rows], numbers)
    return Section(figures={"frames": frames}, claims=[same_time, _fixed_is_faster(results), _real_time(results)])


def _fixed_is_faster(results: Results) -> Claim:
    fixed, untrimmed = results.row["fixed"], results.row.get(UNTRIMMED)
    before = cell(results, untrimmed, "frame_ms", "the scene exactly as shipped")
    gain = ratio(results, "fixed_gain", "time of a frame exactly as shipped over that as fixed", before, fixed.frame_ms)
    outcome = greater(before, fixed.frame_ms, noise=frame_spread(results, "fixed_spread", fixed, untrimmed))
    return Claim("fixed_is_faster", outcome, {"fixed": fixed.frame_ms, "gain": gain, "before": before})


def _real_time(results: Results) -> Claim:
    factors = [row.realtime_factor for row in results.rows]
    slowest = results.value("slowest_realtime", "smallest of the cases' speeds against real time", min, *factors)
    return Claim("real_time", at_least(slowest, 1.0, why="as fast as the clock"), {"slowest": slowest})


def _same_time(results: Results) -> Claim:
    row, baseline = results.row["stiff-pads-only"], results.row["as-shipped"]
    formula = "time of a frame of stiff-pads-only less that of as-shipped, either way"
    change = size_difference(results, "stiff_pads_only_change", formula, row.frame_ms, baseline.frame_ms)
    spread = frame_spread(results, "stiff_pads_only_spread", row, baseline)
    formula = "that spread, of the time of a frame"
    unseen = share(results, "stiff_pads_only_unseen", formula, spread, baseline.frame_ms)
    numbers = {"time": row.frame_ms, "baseline": baseline.frame_ms, "spread": spread, "unseen": unseen}
    return Claim("stiff_pads_only_same_time", within(change, spread).having_read(unseen), numbers)


def _draw_frames(rows: Sequence[Row]) -> Drawing:
    rows = [row for row in rows if row.frame_ms.value is not None]
    names = [name_of(row.case) for row in rows]
    median, low, high = (
        np.array([row[name].value for row in rows]) for name in ("frame_ms", "frame_ms_p5", "frame_ms_p95")
    )
    colours = [STIFF if row.case in ("stiff-pads-only", "fixed") else SHIPPED for row in rows]
    drawing, axes = new_figure(7.2, 0.8 + 0.34 * len(rows))
    whiskers = {"xerr": [median - low, high - median], "capsize": 3, "error_kw": {"ecolor": INK, "elinewidth": 1.2}}
    axes.barh(names, median, height=0.6, color=colours, edgecolor=INK, linewidth=0.6, **whiskers)
    for place, row in enumerate(rows):
        say_value(axes, high[place], place, f"{write(row.frame_ms)} ms")
    axes.margins(x=0.15)
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("time of a frame [ms]")
    return drawing
