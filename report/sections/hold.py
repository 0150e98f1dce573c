"""The same grasp with the arm held still: how much of the drift needs the load cycle?"""

from collections.abc import Iterator

import numpy as np
import pandas as pd
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import Claim, all_of, at_least, at_most, greater
from measured_report.parts.figures import INK, new_figure
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.results import Results, Row, Series
from report.shared.arithmetic import (
    by_case,
    departure,
    needs_shaking,
    noise_floor,
    other_cell,
    share,
    size_share,
    table_of,
)

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
COLUMNS = {
    "time": "shake_duration_s",
    "slip": "slip_mm",
    "wander": "wander_mm",
    "drift": "drift_mm_s",
    "drift down": "creep_z_mm_s",
}
PRECISION_COLUMNS = {
    "creep": "creep_mm_s",
    "of it down": "creep_z_mm_s",
    "joint": "joint",
    "its velocity": "joint_velocity_mrad_s",
    "its motion": "joint_motion_mrad_s",
}


def derive(results: Results) -> Section:
    traces = {case: results.trace(case) for case in NAMES}
    shaken, long, stiff = (results.row[case] for case in NAMES)
    numbers = {"shaken": shaken.slip_mm, "held": long.slip_mm, "stiff": stiff.slip_mm}
    numbers |= {"shake_duration": shaken.shake_duration_s, "hold_duration": long.shake_duration_s}
    precision = [results.row[f"precision-{name}"] for name in PRECISION]
    return Section(
        tables={
            "cases": _table(results),
            "precision": table_of("positions", PRECISION.values(), PRECISION_COLUMNS, precision),
        },
        figures={"motion": Figure(lambda: _draw_motion(traces), list(traces.values()), numbers)},
        claims=[
            needs_shaking("drift_needs_cycle", results, results.row["hold"].drift_mm_s, shaken.drift_mm_s),
            *_creep_goes_on(results, long, traces["hold-60s"]),
            *_stiff_pads_creep(results, long, stiff),
            *_creep_is_rounding(results, *precision),
            _longer_steps_creep_less(results),
        ],
    )


def _creep_goes_on(results: Results, long: Row, trace: Series) -> Iterator[Claim]:
    """Tell where the creep goes with the arm held still, that it does not die out, and never turns."""
    held, shaken = results.row["hold"].drift_mm_s, results.row["as-shipped"].drift_mm_s
    slip_floor, drift_floor = (noise_floor(results, name) for name in ("slip_floor", "drift_floor"))
    formula = "drift with the arm held still, counted in the direction of the drift as shipped"
    along = results.value("hold_drift_along", formula, lambda a, b: a * np.sign(b), held, shaken, unit="mm/s")
    yield Claim("creep_goes_the_other_way", greater(0.0, along, noise=drift_floor, why="no motion that way"))

    slip, duration, last = long.slip_mm, long.shake_duration_s, long.increment_final_mm
    formula, cells = "motion in the last second of the long hold, of its mean per second", (last, slip, duration)
    final = results.value("creep_final_share", formula, lambda last, slip, s: 100 * last * s / slip, *cells, unit="%")
    moves = greater(last, 0.0, noise=slip_floor, why="no motion at all")
    outcome = all_of(at_least(final, 50.0, why="not dying out"), moves)
    yield Claim("creep_goes_on", outcome, {"slip": slip, "duration": duration, "last": last})

    back = results.value(
        "creep_seconds_back",
        "whole seconds of the long hold that do not bring the cube nearer to where it ends up by more than the noise",
        lambda frame, floor: seconds_back(frame, floor) if _way(frame).any() else np.nan,
        trace,
        slip_floor,
    )
    yield Claim("creep_is_monotonic", at_most(back, 0, why="none at all"), {"back": back})


def is_monotonic(frame: pd.DataFrame) -> bool:
    """Tell whether the cube goes in every whole second in the direction in which it ends up."""
    return seconds_back(frame) == 0


def seconds_back(frame: pd.DataFrame, least_mm: float = 0.0) -> int:
    """Count the whole seconds in which the cube goes no farther than ``least_mm`` towards where it ends up."""
    return int((np.diff(_way(frame)) <= least_mm).sum())


def _way(frame: pd.DataFrame) -> np.ndarray:
    """Measure how far the cube is towards where it ends up after each whole second [mm]; zero if nowhere."""
    second = round(1.0 / frame["time_s"].iloc[1])
    moved = frame[["x_mm", "y_mm", "z_mm"]].to_numpy()
    return moved[::second] @ moved[-1] / (np.linalg.norm(moved[-1]) or 1.0)


def _stiff_pads_creep(results: Results, long: Row, stiff: Row) -> Iterator[Claim]:
    """Tell whether stiff pads keep the creep, and creep faster held still than shaken.

    The shaken run, of section reproduction, is shorter than the long hold, so that rates are compared.
    """
    formula = "slip of the long hold with stiff pads, of the slip of the long hold as shipped"
    remaining = share(results, "stiff_creep_share", formula, stiff.slip_mm, long.slip_mm)
    numbers = {"stiff": stiff.slip_mm, "shipped": long.slip_mm, "duration": long.shake_duration_s}
    yield Claim("stiff_pads_keep_creep", at_least(remaining, 50.0, why="most of it remains"), numbers)

    slip = other_cell(results, "reproduction", "stiff-pads", "slip_mm", unit="mm")
    shorter = other_cell(results, "reproduction", "stiff-pads", "shake_duration_s", unit="s")
    formula, duration = "slip over its time, stiff pads", stiff.shake_duration_s
    held, shaken = (
        results.value(f"stiff_{name}_rate", formula, lambda a, b: a / b, moved, time, unit="mm/s")
        for name, moved, time in (("held", stiff.slip_mm, duration), ("shaken", slip, shorter))
    )
    noise = results.value(
        "stiff_rate_noise",
        "how far apart identical runs slip, over the shorter time",
        lambda floor, *seconds: floor / min(seconds),
        noise_floor(results, "slip_floor"),
        *(duration, shorter),
        unit="mm/s",
        is_noise=True,
    )
    numbers = {"held": held, "shaken": shaken, "duration": duration, "shorter": shorter}
    yield Claim("held_is_faster_when_stiff", greater(held, shaken, noise=noise), numbers)


def _creep_is_rounding(results: Results, double: Row, single: Row, warp: Row) -> Iterator[Claim]:
    """Tell whether both engines creep alike, double precision takes the creep away, and joints stand still with it."""
    in_warp, c = results.row["hold-warp"].slip_mm, results.row["hold-mujoco-c"].slip_mm
    formula = "size of the difference between the engines' slips with the arm held still, of MuJoCo Warp's"
    apart = departure(results, "engine_creep_difference", formula, c, in_warp)
    bound = results.chosen("engine_creep_bound", "the same creep", 25.0, unit="%")
    yield Claim("same_creep_in_c", at_most(apart, bound), {"c": c, "warp": in_warp, "bound": bound})

    numbers = {"double": double.creep_mm_s, "single": single.creep_mm_s, "warp": warp.creep_mm_s}
    formula = "creep with positions in double precision, of that with positions rounded to single precision"
    remaining = share(results, "double_share", formula, numbers["double"], numbers["single"])
    formula = "difference between the creep with rounded positions and MuJoCo Warp's, of the latter"
    rounded = departure(results, "rounded_departure", formula, numbers["single"], numbers["warp"])
    outcome = all_of(at_most(remaining, 50.0, why="most of it is gone"), at_most(rounded, 10.0, why="the same creep"))
    yield Claim("creep_is_rounding", outcome, numbers)

    motion, velocity = warp.joint_motion_mrad_s, warp.joint_velocity_mrad_s
    formula = "how much of its velocity the fastest arm joint's position follows"
    followed = size_share(results, "joint_motion_share", formula, motion, velocity)
    bound = results.chosen("joint_motion_bound", "it stands still", 20.0, unit="%")
    yield Claim("joint_stands_still", at_most(followed, bound), {"velocity": velocity, "bound": bound})


def _longer_steps_creep_less(results: Results) -> Claim:
    few, shipped, many = (results.row[case].increment_final_mm for case in SUBSTEPS)
    floor = noise_floor(results, "slip_floor")
    outcome = all_of(greater(shipped, few, noise=floor), greater(many, shipped, noise=floor))
    return Claim("longer_steps_creep_less", outcome, {"few": few, "shipped": shipped, "many": many})


def _table(results: Results) -> Table:
    def monotonic(row: Row) -> bool | None:
        """None where there is no whole second of motion."""
        frame = results.trace(row.case).value
        return None if frame is None or row.increment_final_mm.value is None else is_monotonic(frame)

    return by_case([row for row in results.rows if "slip_mm" in row], {**COLUMNS, "monotonic": monotonic})


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
