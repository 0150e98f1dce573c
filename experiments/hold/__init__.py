"""The same grasp with the arm held still: what is left of the motion without the load cycle?"""

from dataclasses import replace

import numpy as np

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, HOLD, STIFF_PADS
from experiments.facts.trace import Trace
from experiments.hold.precision import measure_precision
from experiments.simulation.measurement import (
    SETUP_FRAME_COUNT,
    Conditions,
    Measurement,
    absent,
    displacement_table,
    summarize,
)
from experiments.simulation.task import FRAME_RATE

LONG_FRAME_COUNT = SETUP_FRAME_COUNT + 60 * FRAME_RATE + 1
CASES = (
    HOLD,
    replace(HOLD, name="hold-60s", frame_count=LONG_FRAME_COUNT),
    replace(STIFF_PADS, name="hold-60s-stiff", shake_amplitude_m=0.0, frame_count=LONG_FRAME_COUNT),
    AS_SHIPPED,
)


def measure(conditions: Conditions) -> Measurement:
    traces = conditions.simulate(CASES, title="hold")
    rows = [summarize(case, trace) | creep(trace) for case, trace in zip(CASES, traces, strict=True)]
    rows += measure_precision(conditions)
    return Measurement(rows, {case.name: displacement_table(trace) for case, trace in zip(CASES, traces, strict=True)})


CREEP_COLUMNS = ("creep_z_mm_s", "increment_final_mm")


def creep(trace: Trace) -> dict[str, object]:
    """Return the rate along the tool, and how far the cube goes in the last whole second, in the direction in which it
    ends up; None without a whole second."""
    moved = metrics.displacement(trace)
    if trace.failure or len(moved.time_s) <= FRAME_RATE:
        reason = str(trace.failure or "the time after the lift is shorter than a second")
        return absent(CREEP_COLUMNS, reason)
    slope = 1e3 * np.polyfit(moved.time_s, moved.vector_m, 1)[0]
    way = moved.vector_m @ (moved.vector_m[-1] / np.linalg.norm(moved.vector_m[-1]))
    return dict(zip(CREEP_COLUMNS, (float(slope[2]), 1e3 * float(np.diff(way[::FRAME_RATE])[-1])), strict=True))
