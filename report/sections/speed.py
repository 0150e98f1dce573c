"""How fast one world runs: as shipped, as fixed, and with either change alone."""

from collections.abc import Sequence

import numpy as np
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, at_least, at_most, greater, within
from measured_report.parts.figures import INK, SERIES, new_figure, say_value, write
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import by_case, departure, ratio, share
from report.shared.timing import cell, frame_spread

order = 160
page = "cost"
label = "speed of one world"

EDGES = ("frame_ms_p5", "frame_ms_p95")
UNTRIMMED = "as-shipped-untrimmed"
WHAT = {
    UNTRIMMED: "nothing: exactly as shipped",
    "as-shipped": "without most IK iterations, waiting for IK, state writes, room in the buffers",
    "stiff-pads-only": "shipped pads, made stiff",
    "all-gaps-zero": "shipped pads, without contact gaps",
    "fixed": "stiff pads, without all that is unneeded",
}


def derive(results: Results) -> Section:
    frames = Figure(
        draw=lambda: _draw_frames(results.rows),
        sources=[row.frame_ms for row in results.rows],
        numbers={
            "times": Markup("; ").join(Markup("{}: {}").format(name_of(row.case), row.frame_ms) for row in results.rows)
        },
    )
    return Section(
        tables={"cases": _table(results.rows)},
        figures={"frames": frames},
        claims=[
            _fixed_is_faster(results),
            _real_time(results),
            _same_time(results, "stiff-pads-only"),
            _same_time(results, "all-gaps-zero"),
            _sections_time_apart(results),
        ],
    )


def _fixed_is_faster(results: Results) -> Claim:
    fixed, untrimmed = results.row["fixed"], results.row.get(UNTRIMMED)
    before = cell(results, untrimmed, "frame_ms", "the scene exactly as shipped")
    gain = ratio(results, "fixed_gain", "time of a frame exactly as shipped over that as fixed", before, fixed.frame_ms)
    spread = frame_spread(results, "fixed_spread", fixed, untrimmed)
    return Claim(
        "fixed_is_faster",
        greater(before, fixed.frame_ms, noise=spread),
        numbers={"fixed": fixed.frame_ms, "gain": gain, "before": before},
    )


def _real_time(results: Results) -> Claim:
    slowest = results.value(
        "slowest_realtime",
        "smallest of the cases' speeds against real time",
        min,
        *(row.realtime_factor for row in results.rows),
    )
    bound = results.chosen("realtime_bound", "as fast as the clock", 1.0)
    return Claim("real_time", at_least(slowest, bound), numbers={"slowest": slowest})


def _same_time(results: Results, case: str) -> Claim:
    row, baseline = results.row[case], results.row["as-shipped"]
    name = case.replace("-", "_")
    change = results.value(
        f"{name}_change",
        f"time of a frame of {case} less that of as-shipped, either way",
        lambda a, b: abs(a - b),
        row.frame_ms,
        baseline.frame_ms,
        unit="ms",
    )
    spread = frame_spread(results, f"{name}_spread", row, baseline)
    unseen = share(results, f"{name}_unseen", "that spread, of the time of a frame", spread, baseline.frame_ms)
    return Claim(
        f"{name}_same_time",
        within(change, spread).having_read(unseen),
        numbers={"time": row.frame_ms, "baseline": baseline.frame_ms, "spread": spread, "unseen": unseen},
    )


def _sections_time_apart(results: Results) -> Claim:
    """Here frames are timed in a row, in section leave_out again and again from one state."""
    other = results.others.get("leave_out")
    rows = (row for row in (other.rows if other else ()) if row["device"] == "cuda" and row.worlds.value == 1)
    timed = next((row for row in rows if row.case == "as-shipped"), None)
    there = cell(results, timed, "frame_ms", "the case in section leave_out")
    here = results.row["as-shipped"].frame_ms
    apart = departure(results, "sections_apart", "difference of the two, of the time here", there, here)
    bound = results.chosen("sections_apart_bound", "one machine, timed in two ways", 10.0, unit="%")
    return Claim("sections_time_apart", at_most(apart, bound), {"there": there, "here": here, "apart": apart})


def _table(rows: Sequence[Row]) -> Table:
    columns = {
        "time of a frame": [row.frame_ms for row in rows],
        "frames/s": [row.frames_per_s for row in rows],
        "× real time": [row.realtime_factor for row in rows],
        "changed": [WHAT.get(row.case, "") for row in rows],
        "slip": [row.slip_mm for row in rows],
    }
    return by_case(rows, columns)


def _draw_frames(rows: Sequence[Row]) -> Drawing:
    rows = [row for row in rows if row.frame_ms.value is not None]
    names = [name_of(row.case) for row in rows]
    median, low, high = (np.array([row[name].value for row in rows]) for name in ("frame_ms", *EDGES))
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
