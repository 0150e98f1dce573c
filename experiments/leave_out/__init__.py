"""Measure the cost of parts that the scene does not need.

The parts are left out one at a time, then all together.
"""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import warp as wp

from experiments.facts.case import AS_SHIPPED, LEAN, UNTRIMMED, Case
from experiments.facts.trace import Trace
from experiments.leave_out.audit import audit, audit_rows
from experiments.simulation.frame_benchmark import TIMED, time_cases
from experiments.simulation.measurement import (
    Conditions,
    Measurement,
    absent,
    summarize,
)
from experiments.simulation.simulation import Simulation, simulate
from measured_report.measuring.batch import Batch, Plan

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
    "sensors": {"sensors": False},
    "limits": {"limits": False},
}  # type: dict[str, dict]
"""Parameters by the name of the part that they leave out."""
UNUSED_STAGES = WITHOUT["sensors"] | WITHOUT["limits"]
"""Stages of the engine that this scene does not use.

They are not in LEAN, because joints reach their limits in other runs.
"""
WORLD_COUNTS = {"cuda": (1, 4096, 16384), "cpu": (1,)}
WITH_MOST_WORLDS = (
    "ik-iterations",
    "ik-in-turn",
    "state-sync",
    "sensors",
    "limits",
    "buffers",
)
"""Parts left out with the most worlds, for which building a batch takes longer than
timing it.
"""
# Parts that are left out on a CPU, where frames with large buffers are slow.
ON_CPU = ("buffers",)
# Number of worlds for a case that runs to the end on a GPU. On a CPU all worlds would
# be equal.
RUN_COUNT = 8
AUDIT_FRAME_COUNT = {"full": 250, "quick": 130}


def variants(quick: bool, names: Iterable[str] = WITHOUT) -> list[Case]:
    """Return the cases.

    ``names`` selects the parts that are left out one at a time. A quick run leaves out
    only the largest part.
    """
    names = ("buffers",) if quick else names
    single = [
        replace(UNTRIMMED, name=f"without-{name}", **WITHOUT[name]) for name in names
    ]
    return [
        UNTRIMMED,
        *single,
        replace(LEAN, name="without-all", **UNUSED_STAGES),
        AS_SHIPPED,
    ]


def measure(conditions: Conditions) -> Plan:
    kinds = ("cuda", "cpu") if conditions.is_cuda else ("cpu",)
    timings = [
        (kind, count)
        for kind in kinds
        for count in ((1,) if conditions.quick else WORLD_COUNTS[kind])
    ]
    trajectories, items, *times = yield [
        Batch("to-end", run_to_end, (conditions, kinds)),
        Batch("audit", measure_audit, (conditions,)),
        *(
            Batch(f"{kind}-{n}", measure_times, (conditions, kind, n), exclusive=True)
            for kind, n in timings
        ),
    ]
    rows = []
    for kind in kinds:
        for (of, count), timed in zip(timings, times, strict=True):
            for case in variants(conditions.quick) if of == kind else ():
                row = {"case": case.name, "device": kind, "worlds": count}
                rows.append(row | timed[case.name] | trajectories[kind][case.name])
    return Measurement(rows + items)


def measure_times(
    conditions: Conditions, kind: str, world_count: int
) -> dict[str, dict[str, object]]:
    """Return the times of the variants with this number of worlds, by case."""
    many = kind == "cuda" and world_count == WORLD_COUNTS[kind][-1]
    timed = variants(
        conditions.quick,
        ON_CPU if kind == "cpu" else WITH_MOST_WORLDS if many else WITHOUT,
    )
    # The cases with small buffers are timed first.
    timed.sort(key=lambda case: case is not UNTRIMMED and has_large_buffers(case))
    untimed = absent(TIMED, "not timed here, where it would take long")
    columns = dict.fromkeys((case.name for case in variants(conditions.quick)), untimed)
    return columns | time_cases(timed, world_count, wp.get_device(kind))


def measure_audit(conditions: Conditions) -> list[dict[str, object]]:
    simulation = Simulation([UNTRIMMED], wp.get_device(conditions.device))
    return audit_rows(audit(simulation, AUDIT_FRAME_COUNT[conditions.profile]))


def run_to_end(
    conditions: Conditions, kinds: Sequence[str]
) -> dict[str, dict[str, dict]]:
    """Run every variant to the end on each kind of device.

    The reference is the untrimmed scene. On the CPU, large buffers take minutes, so all
    cases run without them. The CPU's reference is therefore the case that leaves out
    only the buffers.
    """
    frame_count = conditions.frame_count(AS_SHIPPED.frame_count)
    cases = [
        replace(case, frame_count=frame_count) for case in variants(conditions.quick)
    ]
    on_gpu = (
        [case for case in cases for _ in range(RUN_COUNT)] if "cuda" in kinds else []
    )
    on_cpu = [replace(case, device="cpu") for case in cases[1:]]
    on_cpu = [
        replace(case, **WITHOUT["buffers"]) if has_large_buffers(case) else case
        for case in on_cpu
    ]
    traces = simulate([*on_gpu, *on_cpu], device=conditions.device, title="leave_out")
    columns = {
        "cpu": {
            cases[0].name: absent(
                ["slip_mm"], "not run to the end on the CPU, where it takes minutes"
            )
        }
    }
    columns["cpu"] |= compared(on_cpu, traces[len(on_gpu) :], 1)
    return columns | (
        {"cuda": compared(cases, traces[: len(on_gpu)], RUN_COUNT)} if on_gpu else {}
    )


def has_large_buffers(case: Case) -> bool:
    return case.contact_max == UNTRIMMED.contact_max


def compared(
    cases: Sequence[Case], traces: Sequence[Trace], run_count: int
) -> dict[str, dict[str, object]]:
    """Return the mean slip of each case by name.

    Each case has ``run_count`` consecutive runs.
    """
    return {
        case.name: mean_slip(
            [
                summarize(case, trace)
                for trace in traces[index * run_count : (index + 1) * run_count]
            ]
        )
        for index, case in enumerate(cases)
    }


def mean_slip(summaries: Sequence[dict[str, Any]]) -> dict[str, object]:
    """Return the mean slip over the runs of a case."""
    failure = next((row["failure"] for row in summaries if row["failure"]), None)
    missing = next(
        (row["slip_mm_reason"] for row in summaries if row["slip_mm"] is None), None
    )
    slips = [row["slip_mm"] for row in summaries]
    return {"failure": failure} | (
        absent(["slip_mm"], missing) if missing else {"slip_mm": float(np.mean(slips))}
    )
