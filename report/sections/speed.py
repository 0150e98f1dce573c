"""Speed of one world: as shipped, as fixed, and with either change alone."""

from collections.abc import Sequence

import numpy as np
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most, greater
from measured_report.parts.figures import INK, new_figure, say_value, write
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import ratio
from report.shared.drawing import SHIPPED, STIFF
from report.shared.timing import as_said, compared, fine_enough, resolution

order = 160
page = "cost"
label = "speed of one world"
labels = {
    "as-shipped": "shipped pads",
    "as-shipped-untrimmed": "exactly as shipped",
    "stiff-pads-only": "stiff pads",
    "all-gaps-zero": "no contact gap",
    "fixed": "fixed scene",
}


def derive(results: Results) -> Section:
    rows = results.rows
    times = Markup("; ").join(Markup("{}: {}").format(row.label, row.frame_ms) for row in rows)
    worst = resolution(results, "resolution", compared(rows))
    is_faster = _fixed_is_faster(results, worst)
    numbers = {"times": times, "is_faster": is_faster.outcome == HOLDS, "resolution": worst}
    frames = Figure(lambda: _draw_frames(rows), [row.frame_ms for row in rows], numbers)
    return Section(figures={"frames": frames}, claims=[_same_time(results), is_faster, _real_time(results)])


def _fixed_is_faster(results: Results, worst: Value) -> Claim:
    fixed, untrimmed = results.row["fixed"], results.row["as-shipped-untrimmed"]
    formula = "time of a frame exactly as shipped over that as fixed, each timed in turn with that as shipped"
    gain = ratio(results, "fixed_gain", formula, untrimmed.frame_ratio, fixed.frame_ratio)
    none = results.chosen("fixed_none", "as fast", 1.0)
    seen = untrimmed.ratio_resolution, fixed.ratio_resolution
    formula = "resolutions of the two ratios together, of the gain"
    noise = results.value("fixed_seen", formula, lambda gain, a, b: gain * (a + b), gain, *seen, is_noise=True)
    outcome = all_of(greater(gain, none, noise=noise), fine_enough(worst))
    outcome = as_said(results, "fixed_said", outcome, gain, untrimmed.frame_ms, fixed.frame_ms)
    numbers = {"fixed": fixed.frame_ms, "gain": gain, "before": untrimmed.frame_ms}
    return Claim("fixed_is_faster", outcome, numbers)


def _real_time(results: Results) -> Claim:
    factors = [row.realtime_factor for row in results.rows]
    slowest = results.value("slowest_realtime", "smallest of the cases' speeds against real time", min, *factors)
    return Claim("real_time", at_least(slowest, 1.0, why="as fast as the clock"), {"slowest": slowest})


def _same_time(results: Results) -> Claim:
    row = results.row["stiff-pads-only"]
    formula = "time of a frame of stiff-pads-only over that of as-shipped, less one, either way, with its resolution"
    sources = row.frame_ratio, row.ratio_resolution
    change = results.value(
        "stiff_pads_only_change", formula, lambda t, seen: 100 * (abs(t - 1) + seen), *sources, unit="%", is_noise=True
    )
    outcome = at_most(change, 3.0, why="a slowdown that would matter")
    return Claim("stiff_pads_only_same_time", outcome, {"change": change})


def _draw_frames(rows: Sequence[Row]) -> Drawing:
    rows = [row for row in rows if row.frame_ms.value is not None]
    names = [row.label for row in rows]
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
