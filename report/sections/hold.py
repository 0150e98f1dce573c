"""The same grasp with the arm held still: how much of the drift needs the load cycle?"""

import numpy as np
import pandas as pd
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, all_of, at_least, at_most, greater
from measured_report.parts.figures import INK, new_figure
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.results import Results, Row, Series
from report.shared.arithmetic import by_case, departure, needs_shaking, noise_floor, other_cell, share, size_share

order = 80
page = "cause"
label = "arm held still"

NAMES = {
    "as-shipped": "shaken, shipped pads",
    "hold-60s": "held still, shipped pads",
    "hold-60s-stiff": "held still, stiff pads",
}
"""Traces that are drawn, and what they are called there."""
PRECISION = {
    "c-double": "MuJoCo C, double precision",
    "c-single": "MuJoCo C, rounded to single precision",
    "warp": "MuJoCo Warp, single precision",
}
SUBSTEPS = ("hold-substeps-4", "hold", "hold-substeps-32")
"""Cases with fewer, as many and more substeps than as shipped."""


def derive(results: Results) -> Section:
    traces = {case: results.trace(case) for case in NAMES}
    shaken, long, stiff = (results.row[case] for case in NAMES)
    motion = Figure(
        draw=lambda: _draw_motion(traces),
        sources=list(traces.values()),
        numbers={
            "shaken": shaken.slip_mm,
            "shake_duration": shaken.shake_duration_s,
            "held": long.slip_mm,
            "hold_duration": long.shake_duration_s,
            "stiff": stiff.slip_mm,
        },
    )
    return Section(
        tables={"cases": _table(results), "precision": _precision_table(results)},
        figures={"motion": motion},
        claims=[
            needs_shaking("drift_needs_cycle", results, results.row["hold"].drift_mm_s, shaken.drift_mm_s),
            _creep_goes_the_other_way(results),
            _creep_goes_on(results, long),
            _creep_is_monotonic(results, traces["hold-60s"]),
            _stiff_pads_keep_creep(results, long, stiff),
            _held_is_faster_when_stiff(results, stiff),
            _same_creep_in_c(results),
            _creep_is_rounding(results),
            _joint_stands_still(results),
            _longer_steps_creep_less(results),
        ],
    )


def _creep_goes_the_other_way(results: Results) -> Claim:
    held, shaken = results.row["hold"].drift_mm_s, results.row["as-shipped"].drift_mm_s
    along = results.value(
        "hold_drift_along",
        "drift with the arm held still, counted in the direction of the drift as shipped",
        lambda still, moving: still * np.sign(moving),
        held,
        shaken,
        unit="mm/s",
    )
    none = results.chosen("hold_drift_bound", "no motion that way", 0.0, unit="mm/s")
    return Claim("creep_goes_the_other_way", greater(none, along, noise=noise_floor(results, "drift_floor")))


def _creep_goes_on(results: Results, long: Row) -> Claim:
    final = results.value(
        "creep_final_share",
        "motion in the last second of the long hold, of its mean per second",
        lambda last, slip, duration: 100 * last * duration / slip,
        long.increment_final_mm,
        long.slip_mm,
        long.shake_duration_s,
        unit="%",
    )
    bound = results.chosen("creep_final_bound", "not dying out", 50.0, unit="%")
    none = results.chosen("creep_final_none", "no motion at all", 0.0, unit="mm")
    return Claim(
        "creep_goes_on",
        all_of(
            at_least(final, bound), greater(long.increment_final_mm, none, noise=noise_floor(results, "slip_floor"))
        ),
        numbers={"slip": long.slip_mm, "duration": long.shake_duration_s, "last": long.increment_final_mm},
    )


def _creep_is_monotonic(results: Results, trace: Series) -> Claim:
    back = results.value(
        "creep_seconds_back",
        "whole seconds of the long hold that do not bring the cube nearer to where it ends up by more than the noise",
        lambda frame, floor: seconds_back(frame, floor) if _way(frame).any() else np.nan,
        trace,
        noise_floor(results, "slip_floor"),
    )
    none = results.chosen("creep_seconds_back_bound", "none at all", 0)
    return Claim("creep_is_monotonic", at_most(back, none), numbers={"back": back})


def is_monotonic(frame: pd.DataFrame) -> bool:
    """Whether the cube goes in every whole second in the direction in which it ends up."""
    return seconds_back(frame) == 0


def seconds_back(frame: pd.DataFrame, least_mm: float = 0.0) -> int:
    """In how many whole seconds the cube goes no farther than ``least_mm`` in the direction in which it ends up."""
    return int((np.diff(_way(frame)) <= least_mm).sum())


def _way(frame: pd.DataFrame) -> np.ndarray:
    """How far the cube is after each whole second in the direction in which it ends up [mm]; zero if nowhere."""
    second = round(1.0 / frame["time_s"].iloc[1])
    moved = frame[["x_mm", "y_mm", "z_mm"]].to_numpy()
    return moved[::second] @ moved[-1] / (np.linalg.norm(moved[-1]) or 1.0)


def _stiff_pads_keep_creep(results: Results, long: Row, stiff: Row) -> Claim:
    formula = "slip of the long hold with stiff pads, of the slip of the long hold as shipped"
    remaining = share(results, "stiff_creep_share", formula, stiff.slip_mm, long.slip_mm)
    bound = results.chosen("stiff_creep_bound", "most of it remains", 50.0, unit="%")
    return Claim(
        "stiff_pads_keep_creep",
        at_least(remaining, bound),
        numbers={"stiff": stiff.slip_mm, "shipped": long.slip_mm, "duration": long.shake_duration_s},
    )


def _held_is_faster_when_stiff(results: Results, stiff: Row) -> Claim:
    """The shaken run, of section reproduction, is shorter than the long hold, so that rates are compared."""
    slip = other_cell(results, "reproduction", "stiff-pads", "slip_mm", unit="mm")
    shorter = other_cell(results, "reproduction", "stiff-pads", "shake_duration_s", unit="s")
    formula, times = "slip over its time, stiff pads", {"held": stiff.shake_duration_s, "shaken": shorter}
    held, shaken = (
        results.value(f"stiff_{name}_rate", formula, lambda a, b: a / b, moved, times[name], unit="mm/s")
        for name, moved in (("held", stiff.slip_mm), ("shaken", slip))
    )
    numbers = {"held": held, "shaken": shaken, "duration": stiff.shake_duration_s, "shorter": shorter}
    noise = results.value(
        "stiff_rate_noise",
        "how far apart identical runs slip, over the shorter time",
        lambda floor, *seconds: floor / min(seconds),
        noise_floor(results, "slip_floor"),
        *times.values(),
        unit="mm/s",
        is_noise=True,
    )
    outcome = greater(held, shaken, noise=noise)
    return Claim("held_is_faster_when_stiff", outcome, numbers)


def _same_creep_in_c(results: Results) -> Claim:
    warp, c = results.row["hold-warp"].slip_mm, results.row["hold-mujoco-c"].slip_mm
    difference = departure(
        results,
        "engine_creep_difference",
        "size of the difference between the engines' slips with the arm held still, of MuJoCo Warp's",
        c,
        warp,
    )
    bound = results.chosen("engine_creep_bound", "the same creep", 25.0, unit="%")
    return Claim("same_creep_in_c", at_most(difference, bound), numbers={"c": c, "warp": warp, "bound": bound})


def _creep_is_rounding(results: Results) -> Claim:
    double, single, warp = (results.row[f"precision-{name}"] for name in PRECISION)
    formula = "creep with positions in double precision, of that with positions rounded to single precision"
    remaining = share(results, "double_share", formula, double.creep_mm_s, single.creep_mm_s)
    rounded = departure(
        results,
        "rounded_departure",
        "difference between the creep with rounded positions and MuJoCo Warp's, of the latter",
        single.creep_mm_s,
        warp.creep_mm_s,
    )
    bound = results.chosen("double_share_bound", "most of it is gone", 50.0, unit="%")
    same = results.chosen("rounded_departure_bound", "the same creep", 10.0, unit="%")
    return Claim(
        "creep_is_rounding",
        all_of(at_most(remaining, bound), at_most(rounded, same)),
        numbers={"double": double.creep_mm_s, "single": single.creep_mm_s, "warp": warp.creep_mm_s},
    )


def _joint_stands_still(results: Results) -> Claim:
    warp = results.row["precision-warp"]
    followed = size_share(
        results,
        "joint_motion_share",
        "how much of its velocity the fastest arm joint's position follows",
        warp.joint_motion_mrad_s,
        warp.joint_velocity_mrad_s,
    )
    bound = results.chosen("joint_motion_bound", "it stands still", 20.0, unit="%")
    return Claim(
        "joint_stands_still", at_most(followed, bound), numbers={"velocity": warp.joint_velocity_mrad_s, "bound": bound}
    )


def _longer_steps_creep_less(results: Results) -> Claim:
    few, shipped, many = (results.row[case].increment_final_mm for case in SUBSTEPS)
    floor = noise_floor(results, "slip_floor")
    return Claim(
        "longer_steps_creep_less",
        all_of(greater(shipped, few, noise=floor), greater(many, shipped, noise=floor)),
        numbers={"few": few, "shipped": shipped, "many": many},
    )


def _precision_table(results: Results) -> Table:
    rows = [results.row[f"precision-{name}"] for name in PRECISION]
    columns = {
        "creep": [row.creep_mm_s for row in rows],
        "of it down": [row.creep_z_mm_s for row in rows],
        "joint": [row.joint for row in rows],
        "its velocity": [row.joint_velocity_mrad_s for row in rows],
        "its motion": [row.joint_motion_mrad_s for row in rows],
    }
    return Table(pd.DataFrame(columns, index=pd.Index(PRECISION.values(), name="positions")))


def _table(results: Results) -> Table:
    rows = [row for row in results.rows if "slip_mm" in row]
    columns = {
        "time": [row.shake_duration_s for row in rows],
        "slip": [row.slip_mm for row in rows],
        "wander": [row.wander_mm for row in rows],
        "drift": [row.drift_mm_s for row in rows],
        "drift down": [row.creep_z_mm_s for row in rows],
        "monotonic": [_monotonic(results, row) for row in rows],
    }
    return by_case(rows, columns)


def _monotonic(results: Results, row: Row) -> bool | None:
    """None where there is no whole second of motion."""
    trace = results.trace(row.case)
    there = row.increment_final_mm.value is not None and trace.value is not None
    return is_monotonic(trace.value) if there else None


def _draw_motion(traces: dict[str, Series]) -> Drawing:
    drawing, (along, total) = new_figure(7.2, 3.4, ncols=2, sharex=True)
    for number, (case, trace) in enumerate(traces.items()):
        if trace.value is not None:
            frame = trace.value
            every = (20 * number + 30, max(1, len(frame) // 6))
            along.plot(frame["time_s"], frame["along_mm"], label=NAMES[case], markevery=every)
            total.plot(frame["time_s"], np.linalg.norm(frame[["x_mm", "y_mm", "z_mm"]], axis=1), markevery=every)
    along.axhline(0.0, color=INK, linewidth=0.8)
    along.set_title("along the main axis")
    total.set_title("in all")
    along.set_ylabel("displacement [mm]")
    drawing.supxlabel("time since the shake would begin [s]", fontsize=10)
    drawing.legend(loc="outside upper center", ncols=len(traces))
    return drawing
