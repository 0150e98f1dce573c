"""The same grasp with the arm held still: how much of the drift needs the load cycle?"""

import numpy as np
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import new_figure
from report.shared import (
    HOLDS,
    PERCENT,
    Claim,
    Figure,
    Quantity,
    Results,
    Row,
    Section,
    Series,
    all_of,
    at_least,
    at_most,
    constant,
    departure,
    greater,
    noise_floor,
    resolved,
)
from report.shared.drawing import SHIPPED, STIFF

order = 80
page = "cause"
reads = ("noise", "reproduction")
label = "arm held still"

LINES = {
    "as-shipped": ("shaken, shipped pads", SHIPPED, "-"),
    "stiff-pads": ("shaken, stiff pads", STIFF, "-"),
    "hold-60s": ("held still, shipped pads", SHIPPED, "--"),
    "hold-60s-stiff": ("held still, stiff pads", STIFF, "--"),
}
"""Traces that are drawn: what they are called, colour and style. The second is of section reproduction."""
PRECISION = (
    "c-double",
    "c-single",
    "warp",
)  # in C, with positions in double and in single precision; from one state


def derive(results: Results) -> Section:
    shaken, long, stiff = (
        results.row[case] for case in ("as-shipped", "hold-60s", "hold-60s-stiff")
    )
    sources = (
        {"stiff-pads": results.others["reproduction"]}
        if "reproduction" in results.others
        else {}
    )
    traces = {case: sources.get(case, results).trace(case) for case in LINES}
    keeps = _stiff_pads_keep_creep(
        results, long, stiff, goes_on := _creep_goes_on(results, long)
    )
    numbers = {
        "shaken": shaken.slip_mm,
        "held": long.slip_mm,
        "stiff": stiff.slip_mm,
        "is_so": keeps.outcome == HOLDS,
    }
    numbers |= {
        "shake_duration": shaken.shake_duration_s,
        "hold_duration": long.shake_duration_s,
    }
    figures = {
        "motion": Figure(lambda: _draw_motion(traces), list(traces.values()), numbers)
    }
    claims = [
        _drift_needs_cycle(results, results.row["hold"].drift_mm_s, shaken.drift_mm_s),
        goes_on,
        keeps,
    ]
    claims += [
        _creep_is_rounding(
            results, *(results.row[f"precision-{name}"] for name in PRECISION)
        )
    ]
    return Section(figures=figures, claims=claims)


def _drift_needs_cycle(results: Results, held: Quantity, shaken: Quantity) -> Claim:
    """Tell whether a held cube hardly drifts; if the other way, that is no part of the drift but takes no shake."""
    part = results.value(
        "hold_share",
        "drift with the arm held still, of the drift as shipped, in size",
        PERCENT * abs(held / shaken),
    )
    is_seen = None not in (held.value, shaken.value) and abs(held.value) > (
        held.noise or 0.0
    )
    is_opposed = is_seen and held.value * shaken.value < 0
    numbers = {"held": held, "shaken": shaken, "share": part, "is_opposed": is_opposed}
    bound = results.chosen("hold_share_bound", "no comparable drift", 10.0, "%")
    return Claim("drift_needs_cycle", at_most(part, bound), numbers)


def _creep_goes_on(results: Results, long: Row) -> Claim:
    slip, duration, last = long.slip_mm, long.shake_duration_s, long.increment_final_mm
    final = results.value(
        "creep_final_share",
        "motion in the last second of the long hold, of its mean per second",
        PERCENT * last * duration / slip / constant(1, "s"),
    )
    floor = noise_floor(results, "slip_floor")
    moves = (
        greater(way, 0.0, noise=floor, why="no motion at all") for way in (last, slip)
    )
    outcome = all_of(at_least(final, 50.0, why="not dying out"), *moves)
    return Claim(
        "creep_goes_on", outcome, {"slip": slip, "duration": duration, "last": last}
    )


def _stiff_pads_keep_creep(
    results: Results, long: Row, stiff: Row, goes_on: Claim
) -> Claim:
    remaining = results.value(
        "stiff_creep_share",
        "slip of the long hold with stiff pads, of the slip of the long hold as shipped",
        PERCENT * stiff.slip_mm / long.slip_mm,
    )
    numbers = {
        "stiff": stiff.slip_mm,
        "shipped": long.slip_mm,
        "duration": long.shake_duration_s,
    }
    remains = at_least(remaining, 50.0, why="most of it remains")
    return Claim("stiff_pads_keep_creep", all_of(goes_on.outcome, remains), numbers)


def _creep_is_rounding(results: Results, double: Row, single: Row, warp: Row) -> Claim:
    numbers = {
        "double": double.creep_mm_s,
        "single": single.creep_mm_s,
        "warp": warp.creep_mm_s,
    }
    remaining = results.value(
        "double_share",
        "creep with positions in double precision, of that with positions rounded to single precision",
        PERCENT * numbers["double"] / numbers["single"],
    )
    rounded = results.value(
        "rounded_departure",
        "difference between the creep with rounded positions and MuJoCo Warp's, of the latter",
        departure(numbers["single"], numbers["warp"]),
    )
    creeps = greater(
        numbers["warp"],
        0.0,
        noise=noise_floor(results, "drift_floor"),
        why="a creep to explain",
    )
    gone, same = (
        at_most(remaining, 50.0, why="most of it is gone"),
        at_most(rounded, 10.0, why="the same creep"),
    )
    noise = results.value(
        "creep_noise",
        "noise of the drift, of MuJoCo Warp's creep",
        PERCENT * abs(noise_floor(results, "drift_floor") / numbers["warp"]),
    )
    return Claim(
        "creep_is_rounding",
        all_of(creeps, gone, same, resolved(noise, 10.0, why="the same creep")),
        numbers,
    )


def _draw_motion(traces: dict[str, Series]) -> Drawing:
    drawing, axes = new_figure(7.2, 3.0)
    for case, trace in traces.items():
        if trace.value is not None:
            name, colour, style = LINES[case]
            way = np.linalg.norm(trace.value[["x_mm", "y_mm", "z_mm"]], axis=1)
            axes.plot(
                trace.value["time_s"],
                way,
                color=colour,
                linestyle=style,
                marker="",
                label=name,
            )
    axes.set(
        xlabel="time since the shake begins, or would [s]", ylabel="displacement [mm]"
    )
    drawing.legend(loc="outside upper left", ncols=2)
    return drawing
