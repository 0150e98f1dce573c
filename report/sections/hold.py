"""Compare the drift with the arm held still with the drift during the shake."""

import numpy as np

from report.shared import (
    HOLDS,
    PERCENT,
    Claim,
    Figure,
    Results,
    Section,
    Series,
    all_of,
    at_least,
    at_most,
    constant,
    departure,
    greater,
)
from report.shared.drawing import SHIPPED, STIFF, Drawing, draw_line, new_figure

order = 80
page = "cause"
reads = ("reproduction",)
label = "arm held still"

LINES = {
    "as-shipped": ("shaken, shipped pads", SHIPPED, "-"),
    "stiff-pads": ("shaken, stiff pads", STIFF, "-"),
    "hold-60s": ("held still, shipped pads", SHIPPED, "--"),
    "hold-60s-stiff": ("held still, stiff pads", STIFF, "--"),
}
"""Name, colour and style of each trace in the figure."""


def derive(results: Results) -> Section:
    shaken = results.row["as-shipped"]
    long = results.row["hold-60s"]
    stiff = results.row["hold-60s-stiff"]
    slip = long.slip_mm
    duration = long.shake_duration_s

    # A drift in the other direction cannot be a part of the drift with shipped pads.
    held = results.row["hold"].drift_mm_s
    drift = shaken.drift_mm_s
    share = results.value(
        "hold_share",
        "absolute drift with the arm held still, relative to the drift as shipped",
        PERCENT * abs(held / drift),
    )
    bound = results.chosen("hold_share_bound", "no comparable drift", 10.0, "%")
    is_opposed = held.is_distinct and drift.value and held.value * drift.value < 0

    last = long.increment_final_mm
    final = results.value(
        "creep_final_share",
        "motion in the last second of the long hold, relative to its mean per second",
        PERCENT * last * duration / slip / constant(1, "s"),
    )
    goes_on = all_of(
        at_least(final, 50.0, "it does not die out"),
        greater(last, 0.0, "no motion at all"),
        greater(slip, 0.0, "no motion at all"),
    )
    remaining = results.value(
        "stiff_creep_share",
        "slip of the long hold with stiff pads, relative to the slip with shipped pads",
        PERCENT * stiff.slip_mm / slip,
    )
    keeps = all_of(goes_on, at_least(remaining, 50.0, "most of it remains"))

    # The three runs start from the same state. In C, the positions are stored in double
    # or in single precision.
    double = results.row["precision-c-double"].creep_mm_s
    single = results.row["precision-c-single"].creep_mm_s
    warp = results.row["precision-warp"].creep_mm_s
    double_share = results.value(
        "double_share",
        "creep with positions in double precision, relative to the creep with positions"
        " rounded to single precision",
        PERCENT * double / single,
    )
    rounded = results.value(
        "rounded_departure",
        "absolute difference between the creep with rounded positions and the creep in"
        " MuJoCo Warp, relative to the latter",
        departure(single, warp),
    )
    is_rounding = all_of(
        greater(warp, 0.0, "a creep to explain"),
        at_most(double_share, 50.0, "most of it is gone"),
        at_most(rounded, 10.0, "the same creep"),
    )

    # The trace of stiff pads belongs to section reproduction.
    others = results.others
    sources = {"stiff-pads": others["reproduction"]} if "reproduction" in others else {}
    traces = {case: sources.get(case, results).trace(case) for case in LINES}
    numbers = {
        "shaken": shaken.slip_mm,
        "held": slip,
        "stiff": stiff.slip_mm,
        "is_so": keeps == HOLDS,
        "shake_duration": shaken.shake_duration_s,
        "hold_duration": duration,
    }
    motion = Figure(lambda: _draw_motion(traces), list(traces.values()), numbers)
    return Section(
        figures={"motion": motion},
        claims=[
            Claim(
                "drift_needs_cycle",
                at_most(share, bound),
                {
                    "held": held,
                    "shaken": drift,
                    "share": share,
                    "is_opposed": bool(is_opposed),
                },
            ),
            Claim(
                "creep_goes_on",
                goes_on,
                {"slip": slip, "duration": duration, "last": last},
            ),
            Claim(
                "stiff_pads_keep_creep",
                keeps,
                {"stiff": stiff.slip_mm, "shipped": slip, "duration": duration},
            ),
            Claim(
                "creep_is_rounding",
                is_rounding,
                {"double": double, "single": single, "warp": warp},
            ),
        ],
    )


def _draw_motion(traces: dict[str, Series]) -> Drawing:
    drawing, axes = new_figure(7.2, 3.0)
    for case, trace in traces.items():
        if trace.value is not None:
            name, colour, style = LINES[case]
            displacement = np.linalg.norm(trace.value[["x_mm", "y_mm", "z_mm"]], axis=1)
            draw_line(
                axes,
                trace.value["time_s"],
                displacement,
                color=colour,
                linestyle=style,
                label=name,
            )
    axes.set(xlabel="time since the start of the shake [s]", ylabel="displacement [mm]")
    drawing.legend(loc="outside upper left", ncols=2)
    return drawing
