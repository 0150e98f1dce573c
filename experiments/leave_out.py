"""What the scene pays for and does not need: left out one at a time, then all together."""

import gc
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import warp as wp

from experiments import metrics
from experiments.audit import audit, audit_rows
from experiments.case import AS_SHIPPED, LEAN, UNTRIMMED, Case
from experiments.measurement import SETUP_FRAME_COUNT, Conditions, Measurement, absent, summarize
from experiments.reference import NativeShake, pilot_at_shake, starts_of
from experiments.simulation import Simulation, simulate
from experiments.timing import buffer_bytes_per_world, frame_ms, in_the_shake, put_in_state_of, spread

WITHOUT = {
    "buffers": {"contact_max": None, "constraint_max": None},
    "ik-iterations": {"ik_iterations": AS_SHIPPED.ik_iterations},
    "ik-in-turn": {"ik_beside": True},
    "state-sync": {"state_sync": False},
    "cube-gap": {"cube_gap_m": AS_SHIPPED.robot_gap_m},
    "hand-box": {"hand_collides": False},
    "visuals": {"visuals": False},
    "fixed-joints": {"fixed_joints": False},
    "broad-phase": {"broad_phase": "explicit"},
}
"""What is left out, by name, and the parameters that do it."""
IN_THE_MODEL = ("cube-gap", "hand-box", "visuals", "fixed-joints")
"""What of it is in the engine's model. The rest is about how the model is run."""
WORLD_COUNTS = {"cuda": (1, 1024, 16384), "cpu": (1,)}
REPEAT_COUNT = {"cuda": 30, "cpu": 10}
RUN_COUNT = {"cuda": 8, "cpu": 1}
"""Worlds in which a case is run to the end; on a CPU they would all be the same."""
AUDIT_FRAME_COUNT = {"full": 250, "quick": 130}
MEASURED = ("slip_mm", "drift_mm_s", "pose_difference_mm")


def variants(quick: bool) -> list[Case]:
    """The cases; of those that leave out one thing only the one that matters most when ``quick``."""
    names = ("buffers",) if quick else WITHOUT
    single = [replace(UNTRIMMED, name=f"without-{name}", **WITHOUT[name]) for name in names]
    return [UNTRIMMED, *single, replace(LEAN, name="without-all"), AS_SHIPPED]


def measure(conditions: Conditions) -> Measurement:
    rows = []
    for kind in ("cuda", "cpu") if conditions.is_cuda else ("cpu",):
        trajectories = run_to_end(conditions, kind)
        pilot = in_the_shake(AS_SHIPPED, wp.get_device(kind))
        for world_count in (1,) if conditions.quick else WORLD_COUNTS[kind]:
            for case in variants(conditions.quick):
                row = {"case": case.name, "device": kind, "worlds": world_count}
                row |= time_case(case, world_count, pilot, REPEAT_COUNT[kind])
                rows.append(row | trajectories[case.name])
    frame_count = AUDIT_FRAME_COUNT[conditions.profile]
    items = audit(Simulation([UNTRIMMED], wp.get_device(conditions.device)), frame_count)
    return Measurement(rows + double_rows(conditions) + audit_rows(items))


def run_to_end(conditions: Conditions, kind: str) -> dict[str, dict[str, object]]:
    """Every variant run to the end: mean slip, peaks, and what the trajectory has other than the reference's.

    The reference is the untrimmed scene. On the CPU, where the large buffers take minutes, all cases are run to the end
    without them, and the reference is the one that leaves out nothing else.
    """
    frame_count = conditions.frame_count(AS_SHIPPED.frame_count)
    cases = [replace(case, frame_count=frame_count) for case in variants(conditions.quick)]
    found = {}
    if kind == "cpu":
        reason = "not run to the end on the CPU, where it takes minutes"
        found[cases.pop(0).name] = absent(MEASURED, reason)
        cases = [
            replace(case, **WITHOUT["buffers"]) if case.contact_max == UNTRIMMED.contact_max else case for case in cases
        ]
    run_count = RUN_COUNT[kind]
    traces = simulate([case for case in cases for _ in range(run_count)], device=kind, title=f"leave_out on {kind}")
    for index, case in enumerate(cases):
        worlds = traces[index * run_count : (index + 1) * run_count]
        found[case.name] = mean_columns([summarize(case, trace) for trace in worlds])
        found[case.name] |= likeness(worlds[0].poses, traces[0].poses)
    return found


def double_rows(conditions: Conditions) -> list[dict[str, object]]:
    """The shake through MuJoCo's own loop in C, in double precision: is it the same model without what is left out?

    Where it is, differences that single precision shows are rounding. All runs start from the same state.
    """
    wanted = {UNTRIMMED.name, "without-all", *(f"without-{name}" for name in IN_THE_MODEL)}
    cases = [case for case in variants(conditions.quick) if case.name in wanted]
    frame_count = conditions.frame_count(AS_SHIPPED.frame_count) - SETUP_FRAME_COUNT
    [start] = starts_of(pilot_at_shake([AS_SHIPPED], wp.get_device(conditions.device)), frame_count)
    traces = [NativeShake(replace(case, frame_count=frame_count), start).run() for case in cases]
    return [
        {
            "case": f"double-{case.name}",
            "of": case.name,
            "failure": str(trace.failure) if trace.failure else None,
            "slip_mm": metrics.slip_mm(metrics.displacement(trace)),
            **likeness(trace.poses, traces[0].poses),
        }
        for case, trace in zip(cases, traces, strict=True)
    ]


def likeness(poses: np.ndarray, reference: np.ndarray) -> dict[str, object]:
    """In how many frames any number of a trajectory differs from the reference's, and the largest distance of any body
    in any frame."""
    differing = (poses != reference).reshape(len(poses), -1).any(axis=1)
    apart = np.abs(poses[..., :3] - reference[..., :3]).max()
    return {"differing_frame_count": int(differing.sum()), "pose_difference_mm": 1e3 * float(apart)}


def mean_columns(summaries: Sequence[dict[str, object]]) -> dict[str, object]:
    """Slip and drift as means over the runs of a case, and the peaks of all of them."""
    failure = next((row["failure"] for row in summaries if row["failure"]), None)
    columns: dict[str, object] = {"failure": failure, "run_count": len(summaries)}
    for name in ("peak_contact_count", "peak_constraint_count"):
        columns[name] = max(row[name] for row in summaries)
    for name in ("slip_mm", "drift_mm_s"):
        values = [row[name] for row in summaries]
        missing = next((row[f"{name}_reason"] for row in summaries if row[name] is None), None)
        columns |= absent([name], missing) if missing else {name: float(np.mean(values))}
    return columns


def time_case(case: Case, world_count: int, pilot: Simulation, repeat_count: int) -> dict[str, object]:
    """Time frames of the shake in ``world_count`` worlds; every number None, with the reason, if memory runs out."""
    gc.collect()  # frees the batch before
    try:
        simulation = Simulation([replace(case, frame_count=1)] * world_count, pilot.device)
        put_in_state_of(simulation, pilot)
        times = frame_ms(simulation, repeat_count)
    except RuntimeError as error:
        reason = " ".join(str(error).split())[:120]
        return absent(("frame_ms", "frame_ms_p5", "frame_ms_p95", "buffer_bytes_per_world"), reason)
    memory = buffer_bytes_per_world(simulation.solver, simulation.contacts)
    return spread("frame_ms", times) | {"buffer_bytes_per_world": memory}
