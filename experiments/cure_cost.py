"""What the remedies cost: time of a frame with and without them, in one world and in many."""

from dataclasses import replace

import warp as wp

from experiments.case import AS_SHIPPED
from experiments.cure import BEST, POSITIONS, TERMS
from experiments.leave_out import time_cases
from experiments.measurement import Conditions, Measurement
from experiments.timing import in_the_shake

CASES = (
    AS_SHIPPED,
    replace(AS_SHIPPED, name="term", **TERMS["term"]),
    replace(AS_SHIPPED, name="kept", **POSITIONS["kept"]),
    replace(AS_SHIPPED, name="best", **BEST),
    replace(AS_SHIPPED, name="term-rk4", integrator="rk4", **TERMS["term"]),
)
WORLD_COUNTS = {"cuda": (1, 4096, 16384), "cpu": (1,)}
REPEAT_COUNT = {"cuda": 40, "cpu": 10}


def measure(conditions: Conditions) -> Measurement:
    """A row for each case and number of worlds; all start in the same state of the shake."""
    kind = "cuda" if conditions.is_cuda else "cpu"
    pilot = in_the_shake(AS_SHIPPED, wp.get_device(conditions.device))
    rows = []
    for world_count in WORLD_COUNTS[kind][:1] if conditions.quick else WORLD_COUNTS[kind]:
        timed = time_cases(CASES, world_count, pilot, REPEAT_COUNT[kind])
        for case in CASES:
            row = {"case": case.name, "worlds": world_count, "contact_bias": case.contact_bias}
            rows.append(row | timed[case.name])
    return Measurement(rows)
