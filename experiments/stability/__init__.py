"""Measure whether the grasp holds, creeps, drops or explodes in extreme cases.

These include short and long time steps.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from experiments.facts import metrics
from experiments.facts.case import Case
from experiments.facts.classes import (
    CLASSES,
    STABLE,
    classify,
    creep_mm_s,
    cycle_increments,
    is_exploded,
    is_finite,
)
from experiments.facts.trace import Trace
from experiments.simulation.limits import (
    demand_m_s2,
    exit_bound_m_s,
    friction_load,
    step_s,
)
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.simulation.scene import cube_start
from experiments.simulation.simulation import simulate
from experiments.simulation.task import FRAME_RATE
from experiments.stability import families as stability_families
from experiments.stability.families import (
    HOLD_FRAME_COUNT,
    REFERENCE_SUBSTEPS,
    SHAKE_FRAME_COUNT,
    Probe,
)
from measured_report.measuring.batch import Batch, Plan

# Starts of the repeats: shifts of the cube in the hand.
OFFSETS_M = {
    "full": (0.0, 2e-4, -2e-4),
    "quick": (0.0,),
}
FLOOR_FAMILY = "steps"
"""The family whose repeats determine the smallest creep that can be distinguished from
zero. It has two repeats even in a quick run.
"""
SINGLE_FAMILY = "buffers"
TRIED_FAMILIES = ("ke-critical", "ke-kd-100")
TRIAL_FRAME_COUNT = 30
# Frames in which the grip at rest is measured.
HOLD_END = slice(
    HOLD_FRAME_COUNT - 11,
    HOLD_FRAME_COUNT - 1,
)
# If a cube has moved farther in the hand at the end of the hold, it is sliding out.
GONE_M = 0.005
EXIT_FRAMES = 15


def measure(conditions: Conditions) -> Plan:
    """Measure the long run and all other runs in parallel.

    The long run takes as long as all other runs together, which use the GPU.
    """
    (rows, floor), (long, trace) = yield [
        Batch("others", measure_others, (conditions,)),
        Batch("long", measure_long, (conditions,)),
    ]
    row = worst(long, [observe(long.case, trace, floor)])
    row |= long_columns(trace, long.case, row["class"]) | {"creep_floor_mm_s": floor}
    return Measurement([*rows, row], {"long": long_table(trace)})


def measure_others(conditions: Conditions) -> tuple[list[dict[str, object]], float]:
    """Return a row for each case except the long run, and the creep floor [mm/s].

    Creep below the floor cannot be distinguished from zero.
    """
    frame_count = HOLD_FRAME_COUNT + SHAKE_FRAME_COUNT[conditions.profile]
    probes = stability_families.probes(conditions.profile)
    runs = [
        replace(probe, case=replace(probe.case, frame_count=frame_count))
        for probe in probes
    ]
    runs += stability_families.buffers(frame_count)
    traces = simulate_repeats(conditions, runs)
    floor = creep_floor_mm_s(
        [
            [creep_mm_s(case, trace) for case, trace in group]
            for run, group in zip(runs, traces, strict=True)
            if run.family == FLOOR_FAMILY and run.case.substeps == REFERENCE_SUBSTEPS
        ]
    )
    rows = [
        worst(run, [observe(*pair, floor) for pair in group])
        for run, group in zip(runs, traces, strict=True)
    ]
    return [row | {"creep_floor_mm_s": floor} for row in rows], floor


def measure_long(conditions: Conditions) -> tuple[Probe, Trace]:
    """Return the long run and its trace."""
    long = stability_families.long_run(conditions.profile)
    [trace] = simulate(
        [long.case], device=conditions.device, title="stability, long run"
    )
    return long, trace


def simulate_repeats(
    conditions: Conditions, runs: Sequence[Probe]
) -> list[list[tuple[Case, Trace]]]:
    """Return every repeat of every run. All of them run side by side.

    A run that explodes does so immediately and then uses all solver iterations, so that
    all worlds of its batch wait for it. Runs that may explode are therefore tried for
    some frames first, and are not continued if they do.
    """
    groups = [
        [
            replace(run.case, cube_offset_m=offset)
            for offset in offsets_m(conditions, run)
        ]
        for run in runs
    ]
    cases = [case for group in groups for case in group]
    tried = [
        replace(case, frame_count=TRIAL_FRAME_COUNT)
        for run, group in zip(runs, groups, strict=True)
        for case in group
        if run.family in TRIED_FAMILIES
    ]
    trials = simulate(tried, device=conditions.device, title="stability, trial")
    ended = {
        (case.name, case.cube_offset_m): trace
        for case, trace in zip(tried, trials, strict=True)
        if not is_finite(trace) or is_exploded(case, trace)
    }
    waiting = [case for case in cases if (case.name, case.cube_offset_m) not in ended]
    traces = iter(simulate(waiting, device=conditions.device, title="stability"))
    return [
        [
            (case, ended.get((case.name, case.cube_offset_m)) or next(traces))
            for case in group
        ]
        for group in groups
    ]


def offsets_m(conditions: Conditions, run: Probe) -> tuple[float, ...]:
    """Return the starts of a run's repeats. Runs that always overflow have only one."""
    if run.family == SINGLE_FAMILY:
        return (0.0,)
    offsets = OFFSETS_M[conditions.profile]
    return (
        OFFSETS_M["full"][:2]
        if run.family == FLOOR_FAMILY and conditions.quick
        else offsets
    )


def creep_floor_mm_s(groups: Sequence[Sequence[float]]) -> float:
    """Return the largest difference between repeats of one case [mm/s]."""
    return max(max(group) - min(group) for group in groups)


def observe(case: Case, trace: Trace, floor: float) -> dict[str, Any]:
    """Return the results of one run.

    Columns about motion in the grasp have numbers only if the cube stays in it.
    """
    kind = classify(case, trace, floor)
    finite = is_finite(trace)
    row = {
        "class": kind,
        "finite": finite,
        "failure": str(trace.failure) if trace.failure else None,
    }
    moved = metrics.displacement(trace)
    reached = len(moved.time_s) > 2
    row |= numbers(
        "" if kind in STABLE and reached else f"the run ended as {kind}",
        creep_mm_s=lambda: creep_mm_s(case, trace),
        penetration_mm=lambda: (
            1e3 * float(np.median(trace.column("penetration_m")[HOLD_END]))
        ),
    )
    grip = grip_force_n(trace) if finite and reached and case.cube_in_hand else 0.0
    row |= numbers(
        "" if grip > 0.0 else "no grip force was measured",
        load=lambda: friction_load(case, demand_m_s2(case, trace), grip),
    )
    if case.start_overlap_m:
        row |= numbers(
            "" if finite else "the run ended as non-finite",
            exit_speed_mm_s=lambda: 1e3 * exit_speed_m_s(case, trace),
            exit_bound_mm_s=lambda: 1e3 * exit_bound_m_s(case),
        )
    peaks = {
        "peak_contact_count": trace.peak_contact_count,
        "peak_constraint_count": trace.peak_constraint_count,
    }
    return row | peaks | {"step_ms": 1e3 * step_s(case)}


def numbers(reason: str, **functions: Callable[[], float]) -> dict[str, object]:
    """Return the value of each function by name, or None with the given reason."""
    if not reason:
        return {name: function() for name, function in functions.items()}
    return absent(functions, reason)


def worst(run: Probe, observed: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Return one row for the repeats of a case.

    It contains the worst repeat, and the classes of all repeats, the worst first.
    """
    ranked = sorted(
        observed,
        key=lambda row: (CLASSES.index(row["class"]), -(row["creep_mm_s"] or 0.0)),
    )
    row = {"case": run.case.name, "family": run.family, **run.parameters, **ranked[0]}
    return row | {
        "repeat_count": len(observed),
        "classes": ", ".join(observation["class"] for observation in ranked),
    }


def exit_speed_m_s(case: Case, trace: Trace) -> float:
    """Return the largest exit speed [m/s] of the cube from its overlap.

    The speed is √(v² + 2 g h) at height h above contact.
    """
    start = np.array(cube_start(case))
    touching = start[2] + (0.0 if case.cube_in_hand else case.start_overlap_m)
    position = np.vstack(
        [start, trace.poses[:EXIT_FRAMES, metrics.CUBE, :3].astype(np.float64)]
    )
    velocity = np.diff(position, axis=0) / trace.frame_dt
    height = 0.5 * (position[1:, 2] + position[:-1, 2]) - touching
    return float(
        np.sqrt(
            (velocity**2).sum(axis=1)
            + 2.0 * case.gravity_m_s2 * np.maximum(0.0, height)
        ).max()
    )


def grip_force_n(trace: Trace) -> float:
    """Return the sum of the normal forces of the two pads [N] at the end of the hold.

    If the cube slides out, return the force in frame 0.
    """
    positions = metrics.relative_position(
        trace.poses[:HOLD_FRAME_COUNT], metrics.CUBE, metrics.TCP
    )
    is_gone = np.linalg.norm(positions[-1] - positions[0]) > GONE_M
    force = trace.column("normal_force_n")
    return float(force[0] if is_gone else np.median(force[HOLD_END]))


def long_columns(trace: Trace, case: Case, kind: str) -> dict[str, object]:
    """Return the creep per cycle in the first and in the last tenth of the long run.

    The first two cycles, in which the cube settles, are left out.
    """
    moved = metrics.displacement(trace)
    # The shake repeats after two cycles of its main axis.
    increments = (
        cycle_increments(
            moved.time_s, 1e3 * moved.along_m, 0.5 * case.shake_frequency_hz
        )[1:]
        / 2.0
    )
    tenth = max(1, len(increments) // 10)
    first, last = (
        float(np.abs(tenths.mean()))
        for tenths in (increments[:tenth], increments[-tenth:])
    )
    columns = numbers(
        "" if kind in STABLE else f"the run ended as {kind}",
        increment_first_mm_per_cycle=lambda: first,
        increment_last_mm_per_cycle=lambda: last,
    )
    return columns | {"shake_duration_s": float(moved.time_s[-1])}


def long_table(trace: Trace) -> dict[str, np.ndarray]:
    """Return the displacement in the long run once per second."""
    moved = metrics.displacement(trace)
    stride = slice(None, None, FRAME_RATE)
    vector = 1e3 * moved.vector_m[stride]
    names = ("x_mm", "y_mm", "z_mm")
    return {
        "time_s": moved.time_s[stride],
        "along_mm": 1e3 * moved.along_m[stride],
    } | dict(zip(names, vector.T, strict=True))
