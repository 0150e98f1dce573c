"""How fast is one world: 600 frames after 240 of warm-up, as shipped and as fixed."""

import time
from dataclasses import replace

import numpy as np
import warp as wp

from experiments.facts.case import AS_SHIPPED, FIXED, STIFF_PADS, UNTRIMMED, Case
from experiments.simulation.measurement import Conditions, Measurement, absent, summarize
from experiments.simulation.simulation import Simulation
from experiments.simulation.timing import invalid_reason, spread
from measured_report.measuring.batch import Batch, Plan

CASES = (
    replace(UNTRIMMED, name="as-shipped-untrimmed"),
    AS_SHIPPED,
    replace(STIFF_PADS, name="stiff-pads-only"),
    replace(AS_SHIPPED, name="all-gaps-zero", cube_gap_m=0.0, robot_gap_m=0.0, ground_gap_m=0.0),
    FIXED,
)
WARMUP_FRAME_COUNT = 240
FRAME_COUNT = {"full": 600, "quick": 60}
CHUNK_FRAME_COUNT = 20
"""Frames between two looks at the clock."""


def measure(conditions: Conditions) -> Plan:
    # On a CPU the large buffers take a quarter of a second a frame: that case is left to a GPU there.
    cases = CASES if conditions.is_cuda else CASES[1:]
    rows = yield [Batch(case.name, measure_case, (conditions, case), alone=True) for case in cases]
    return Measurement(rows)


def measure_case(conditions: Conditions, case: Case) -> dict[str, object]:
    frame_count = FRAME_COUNT[conditions.profile]
    case = replace(case, frame_count=WARMUP_FRAME_COUNT + frame_count)
    simulation = Simulation([case], wp.get_device(conditions.device))
    for _ in range(WARMUP_FRAME_COUNT):
        simulation.step()
    times = np.array([frame_ms(simulation) for _ in range(frame_count // CHUNK_FRAME_COUNT)])
    wall_s = 1e-3 * CHUNK_FRAME_COUNT * float(times.sum())
    [trace] = simulation.recorder.traces(simulation.frame_dt, case.frame_count, wall_s)
    found: dict[str, object] = {**spread("frame_ms", times)}
    median = float(np.median(times))
    found |= {"frames_per_s": 1e3 / median, "realtime_factor": 1e3 * simulation.frame_dt / median}
    reason = invalid_reason(case, trace)
    return summarize(case, trace) | (absent(found, f"not timed: {reason}") if reason else found)


def frame_ms(simulation: Simulation) -> float:
    """Wall time [ms] of a frame, mean of the next CHUNK_FRAME_COUNT."""
    wp.synchronize_device(simulation.device)
    start = time.perf_counter()
    for _ in range(CHUNK_FRAME_COUNT):
        simulation.step()
    wp.synchronize_device(simulation.device)
    return 1e3 * (time.perf_counter() - start) / CHUNK_FRAME_COUNT
