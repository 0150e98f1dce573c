"""The same grasp with the arm held still: how much of the drift needs the load cycle?"""

import numpy as np
import pandas as pd
from matplotlib.figure import Figure as Drawing

from report.claims import FAILS, HOLDS, Claim, Outcome, all_of, at_least, at_most, greater
from report.figures import INK, new_figure
from report.parts import Figure, Section, Table
from report.results import Results, Row, Trace
from report.sections._common import NO_DRIFT, by_case, departure, friction_rows_differ, noise_floor, share, size_share

order = 80

NAMES = {
    "as-shipped": "shaken, as shipped",
    "hold-60s": "held still, as shipped",
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
ONE_MODEL = (
    " Here and in what follows on rounding, friction rows have no time constant of their own in MuJoCo Warp either (kf "
    "of the pads is negative), since they have none in contacts that MuJoCo's C engine finds."
)


def derive(results: Results) -> Section:
    note = ONE_MODEL if friction_rows_differ(results.others.get("contacts")) else ""
    traces = {case: results.trace(case) for case in NAMES}
    long, stiff = results.row["hold-60s"], results.row["hold-60s-stiff"]
    motion = Figure(
        draw=lambda: _draw_motion(traces),
        caption="The cube in the TCP frame since the shake would begin: along the shake's main axis, and in all.",
        alt=f"Shaken, the cube moves {results.row['as-shipped'].slip_mm} in "
        f"{results.row['as-shipped'].shake_duration_s}; held still it creeps {long.slip_mm} in "
        f"{long.shake_duration_s}, "
        f"with stiff pads {stiff.slip_mm}.",
        sources=list(traces.values()),
    )
    return Section(
        tables={
            "cases": _table([row for row in results.rows if "slip_mm" in row]),
            "precision": _precision_table(results),
        },
        figures={"motion": motion},
        claims=[
            _drift_needs_cycle(results),
            _creep_goes_the_other_way(results),
            _creep_goes_on(results, long),
            _creep_is_monotonic(long),
            _stiff_pads_keep_creep(results, long, stiff),
            _same_creep_in_c(results, note),
            _creep_is_rounding(results),
            _joint_stands_still(results),
            _longer_steps_creep_less(results),
        ],
    )


def _drift_needs_cycle(results: Results) -> Claim:
    held, shaken = results.row["hold"].drift_mm_s, results.row["as-shipped"].drift_mm_s
    part = size_share(
        results,
        "hold_share",
        "size of the drift along the main axis with the arm held still, of the drift as shipped",
        held,
        shaken,
    )
    bound = results.chosen("hold_share_bound", *NO_DRIFT, unit="%")
    return Claim(
        "drift_needs_cycle",
        at_most(part, bound),
        holds="The drift needs the load cycle: with the arm held still, the cube drifts at {held} along the shake's "
        "main axis, against {shaken} when shaken. That is {share} of it in size.",
        fails="With the arm held still, the cube drifts at {held} along the shake's main axis, in size {share} of the "
        "{shaken} when shaken.",
        unknown="Whether the drift needs the load cycle cannot be told.",
        numbers={"held": held, "shaken": shaken, "share": part},
        explanation="Time alone, with the weight of the cube on the pads, does not do it.",
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
    bound = results.chosen("hold_drift_bound", "no motion that way", 0.0, unit="mm/s")
    return Claim(
        "creep_goes_the_other_way",
        at_most(along, bound),
        holds="The creep of the held arm goes the other way, so it is not what moves the shaken cube.",
        fails="The creep of the held arm goes the same way.",
        unknown="Which way it goes cannot be told.",
    )


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
    return Claim(
        "creep_goes_on",
        at_least(final, bound),
        holds="Held still, the grasp is not at rest either: it creeps {slip} in {duration}, and the last second still "
        "adds {last}.",
        fails="Held still, the cube settles: it moves {slip} in {duration}, and the last second adds {last}.",
        unknown="Whether the cube comes to rest when held still cannot be told.",
        numbers={"slip": long.slip_mm, "duration": long.shake_duration_s, "last": long.increment_final_mm},
    )


def _creep_is_monotonic(long: Row) -> Claim:
    outcome = HOLDS if long.monotonic else FAILS
    return Claim(
        "creep_is_monotonic",
        Outcome("unknown", long.monotonic_reason) if long.monotonic is None else outcome,
        holds="It goes the same way in every second.",
        fails="It does not go the same way in every second: along the way from start to end, the first second counts "
        "{first}, the last {last}.",
        unknown="Whether it goes the same way in every second cannot be told.",
        numbers={"first": long.increment_first_mm, "last": long.increment_final_mm},
    )


def _stiff_pads_keep_creep(results: Results, long: Row, stiff: Row) -> Claim:
    formula = "slip of the long hold with stiff pads, of the slip of the long hold as shipped"
    remaining = share(results, "stiff_creep_share", formula, stiff.slip_mm, long.slip_mm)
    bound = results.chosen("stiff_creep_bound", "most of it remains", 50.0, unit="%")
    return Claim(
        "stiff_pads_keep_creep",
        at_least(remaining, bound),
        holds="Stiff pads do not end this creep: with them it is {stiff} in {duration}, as shipped {shipped}.",
        fails="Stiff pads reduce this creep too: to {stiff} from {shipped} in {duration}.",
        unknown="Whether stiff pads change this creep cannot be told.",
        numbers={"stiff": stiff.slip_mm, "shipped": long.slip_mm, "duration": long.shake_duration_s},
        explanation="The fix does not cure it: who holds an object for minutes should know of it.",
    )


def _same_creep_in_c(results: Results, note: str) -> Claim:
    warp, c = results.row["hold-warp"].slip_mm, results.row["hold-mujoco-c"].slip_mm
    difference = departure(
        results,
        "engine_creep_difference",
        "size of the difference between the engines' slips with the arm held still, of MuJoCo Warp's",
        c,
        warp,
    )
    bound = results.chosen("engine_creep_bound", "the same creep", 25.0, unit="%")
    return Claim(
        "same_creep_in_c",
        at_most(difference, bound),
        holds="MuJoCo's C engine creeps as well: {c} against {warp} in the same time." + note,
        fails="MuJoCo's C engine creeps differently: {c} against {warp} in the same time." + note,
        unknown="Whether MuJoCo's C engine creeps as well cannot be told.",
        numbers={"c": c, "warp": warp},
        explanation="The C engine is run through Newton here, which hands it the state in single precision before "
        "every step.",
    )


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
        holds="Most of it is rounding. With positions in double precision MuJoCo's C engine creeps at {double}; with "
        "the same positions rounded to single precision after every step, and nothing else changed, at {single}. "
        "MuJoCo Warp, which computes in single precision, creeps at {warp}.",
        fails="Rounding does not account for it: with positions in double precision MuJoCo's C engine creeps at "
        "{double}, with positions rounded to single precision at {single}, MuJoCo Warp at {warp}.",
        unknown="Whether rounding causes it cannot be told.",
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
        "joint_stands_still",
        at_most(followed, bound),
        holds="Joint {joint} has a velocity of {velocity} and moves at {moved}.",
        fails="The arm's joints do follow their velocities: joint {joint} has {velocity} and moves at {moved}.",
        unknown="Whether the joints follow their velocities cannot be told.",
        numbers={
            "joint": warp.joint,
            "velocity": warp.joint_velocity_mrad_s,
            "moved": warp.joint_motion_mrad_s,
        },
        explanation="What it would move in a substep is less than half the spacing of single-precision numbers at its "
        "angle, so the sum is rounded back to where it was. Its position error stays, and with it the velocity. The "
        "contacts let the cube follow the fingers' velocity, and the cube, whose coordinates are smaller and finer, "
        "does move.",
    )


def _longer_steps_creep_less(results: Results) -> Claim:
    few, shipped, many = (results.row[case].increment_final_mm for case in SUBSTEPS)
    floor = noise_floor(results, "slip_floor")
    return Claim(
        "longer_steps_creep_less",
        all_of(greater(shipped, few, noise=floor), greater(many, shipped, noise=floor)),
        holds="The longer the step, the less it creeps: in the last second {few} with a quarter of the substeps, "
        "{shipped} as shipped, {many} with twice as many.",
        fails="A longer step does not always help: in the last second the cube creeps {few} with a quarter of the "
        "substeps, {shipped} as shipped, {many} with twice as many.",
        unknown="Whether a longer step helps cannot be told.",
        numbers={"few": few, "shipped": shipped, "many": many},
        explanation="Over this range, more substeps make the held grasp worse, not better.",
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
    return Table(
        pd.DataFrame(columns, index=pd.Index(PRECISION.values(), name="positions")),
        "The held grasp, stepped on from one state in which single precision had come to rest: how fast the cube "
        "creeps in the TCP frame, and the velocity of the arm's fastest joint, a mean of looks a second apart that "
        "begins with the first, next to how fast its position changes.",
    )


def _table(rows: list[Row]) -> Table:
    columns = {
        "time": [row.shake_duration_s for row in rows],
        "slip": [row.slip_mm for row in rows],
        "wander": [row.wander_mm for row in rows],
        "drift": [row.drift_mm_s for row in rows],
        "drift down": [row.creep_z_mm_s for row in rows],
        "monotonic": [row.monotonic for row in rows],
    }
    return by_case(
        rows,
        columns,
        "The arm held still, against the shake: drift along the shake's main axis and along the tool, which points "
        "down, and whether every second moves the cube the same way. The cases hold-warp and hold-mujoco-c are one "
        "model in both engines.",
    )


def _draw_motion(traces: dict[str, Trace]) -> Drawing:
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
