"""How fast one world runs: as shipped, as fixed, and with either change alone."""

from collections.abc import Sequence

import numpy as np
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import Claim, at_least, at_most, greater, within
from measured_report.parts.figures import INK, SERIES, new_figure, say_value, write
from measured_report.parts.section import Figure, Section
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import Column, by_case, departure, ratio, share, size_difference
from report.shared.timing import cell, frame_spread

order = 160
page = "cost"
label = "speed of one world"

UNTRIMMED = "as-shipped-untrimmed"
WHAT = {
    UNTRIMMED: "nothing: exactly as shipped",
    "as-shipped": "without most IK iterations, waiting for IK, state writes, room in the buffers",
    "stiff-pads-only": "shipped pads, made stiff",
    "all-gaps-zero": "shipped pads, without contact gaps",
    "fixed": "stiff pads, without all that is unneeded",
}
COLUMNS: dict[str, Column] = {
    "time of a frame": "frame_ms",
    "frames/s": "frames_per_s",
    "× real time": "realtime_factor",
    "changed": lambda row: WHAT.get(row.case, ""),
    "slip": "slip_mm",
}


def derive(results: Results) -> Section:
    rows = results.rows
    times = Markup("; ").join(Markup("{}: {}").format(name_of(row.case), row.frame_ms) for row in rows)
    frames = Figure(lambda: _draw_frames(rows), [row.frame_ms for row in rows], {"times": times})
    return Section(
        tables={"cases": by_case(rows, COLUMNS)},
        figures={"frames": frames},
        claims=[
            _fixed_is_faster(results),
            _real_time(results),
            *(_same_time(results, case) for case in ("stiff-pads-only", "all-gaps-zero")),
            _sections_time_apart(results),
        ],
    )


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


def _same_time(results: Results, case: str) -> Claim:
    row, baseline, name = results.row[case], results.row["as-shipped"], case.replace("-", "_")
    formula = f"time of a frame of {case} less that of as-shipped, either way"
    change = size_difference(results, f"{name}_change", formula, row.frame_ms, baseline.frame_ms)
    spread = frame_spread(results, f"{name}_spread", row, baseline)
    unseen = share(results, f"{name}_unseen", "that spread, of the time of a frame", spread, baseline.frame_ms)
    numbers = {"time": row.frame_ms, "baseline": baseline.frame_ms, "spread": spread, "unseen": unseen}
    return Claim(f"{name}_same_time", within(change, spread).having_read(unseen), numbers)


def _sections_time_apart(results: Results) -> Claim:
    """Here frames are timed in a row, in section leave_out again and again from one state."""
    other = results.others.get("leave_out")
    rows = (row for row in (other.rows if other else ()) if row["device"] == "cuda" and row.worlds.value == 1)
    timed = next((row for row in rows if row.case == "as-shipped"), None)
    there = cell(results, timed, "frame_ms", "the case in section leave_out")
    here = results.row["as-shipped"].frame_ms
    apart = departure(results, "sections_apart", "difference of the two, of the time here", there, here)
    outcome = at_most(apart, 10.0, why="one machine, timed in two ways")
    return Claim("sections_time_apart", outcome, {"there": there, "here": here, "apart": apart})


def _draw_frames(rows: Sequence[Row]) -> Drawing:
    rows = [row for row in rows if row.frame_ms.value is not None]
    names = [name_of(row.case) for row in rows]
    median, low, high = (
        np.array([row[name].value for row in rows]) for name in ("frame_ms", "frame_ms_p5", "frame_ms_p95")
    )
    drawing, axes = new_figure(7.2, 0.8 + 0.34 * len(rows))
    whiskers = {"xerr": [median - low, high - median], "capsize": 3, "error_kw": {"ecolor": INK, "elinewidth": 1.2}}
    axes.barh(names, median, height=0.6, color=SERIES[0], edgecolor=INK, linewidth=0.6, **whiskers)
    for place, row in enumerate(rows):
        say_value(axes, high[place], place, f"{write(row.frame_ms)} ms")
    axes.margins(x=0.15)
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("time of a frame [ms]")
    return drawing
