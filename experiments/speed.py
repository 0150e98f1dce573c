"""Measure the speed of one world, with the scene as shipped and with the fix, and of
many worlds.
"""

from dataclasses import replace

import warp as wp

from experiments.facts.case import AS_SHIPPED, FIXED, STIFF_PADS, UNTRIMMED, differences
from experiments.simulation.frame_benchmark import time_cases
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.simulation.task import FRAME_RATE
from measured_report.measuring.batch import Batch, Plan

CASES = (  # compared with the first of them
    AS_SHIPPED,
    replace(UNTRIMMED, name="as-shipped-untrimmed"),
    replace(STIFF_PADS, name="stiff-pads-only"),
    replace(
        AS_SHIPPED,
        name="all-gaps-zero",
        cube_gap_m=0.0,
        robot_gap_m=0.0,
        ground_gap_m=0.0,
    ),
    FIXED,
)
MANY = 16384  # number of worlds in which only the pads are compared


def measure(conditions: Conditions) -> Plan:
    batches = [Batch("times", measure_times, (conditions,), exclusive=True)]
    if conditions.is_cuda and not conditions.quick:
        batches.append(Batch("many", measure_many, (conditions,), exclusive=True))
    rows_by_batch = yield batches
    return Measurement([row for rows in rows_by_batch for row in rows])


def measure_times(conditions: Conditions) -> list[dict[str, object]]:
    """Return a row for each case."""
    # On a CPU the large buffers take a quarter of a second per frame, so that case runs
    # only on a GPU.
    cases = (
        CASES
        if conditions.is_cuda
        else [case for case in CASES if case.name != "as-shipped-untrimmed"]
    )
    timed = time_cases(cases, 1, wp.get_device(conditions.device))
    return [
        {"case": case.name, **differences(case), **with_rates(timed[case.name])}
        for case in cases
    ]


def measure_many(conditions: Conditions) -> list[dict[str, object]]:
    """Return rows for shipped and for stiff pads in MANY worlds."""
    timed = time_cases([AS_SHIPPED, STIFF_PADS], MANY, wp.get_device(conditions.device))
    return [
        {"case": f"{name}-{MANY}", "worlds": MANY, **columns}
        for name, columns in timed.items()
    ]


def with_rates(row: dict) -> dict[str, object]:
    """Return a row with the speeds that correspond to its time."""
    if row["frame_ms"] is None:
        return row | absent(("frames_per_s", "realtime_factor"), row["frame_ms_reason"])
    per_s = 1e3 / row["frame_ms"]
    return row | {"frames_per_s": per_s, "realtime_factor": per_s / FRAME_RATE}
