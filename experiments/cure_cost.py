"""Measure the time of a frame with and without the remedies, for 1 to 16,384 worlds."""

from dataclasses import replace

import warp as wp

from experiments.facts.case import AS_SHIPPED, BEST, FIRM, TERMS
from experiments.simulation.frame_benchmark import time_cases
from experiments.simulation.measurement import Conditions, Measurement
from measured_report.measuring.batch import Batch, Plan

CASES = (
    AS_SHIPPED,
    replace(AS_SHIPPED, name="term", **TERMS["term"]),
    replace(AS_SHIPPED, name="best", **BEST),
    replace(AS_SHIPPED, name="firm", **FIRM),
    replace(AS_SHIPPED, name="firm-euler", integrator="euler", **FIRM),
    replace(AS_SHIPPED, name="term-rk4", integrator="rk4", **TERMS["term"]),
)
WORLD_COUNTS = {"cuda": (1, 4096, 16384), "cpu": (1,)}


def measure(conditions: Conditions) -> Plan:
    counts = WORLD_COUNTS[
        "cuda" if conditions.is_cuda and not conditions.quick else "cpu"
    ]
    found = yield [
        Batch(f"worlds-{count}", measure_worlds, (conditions, count), exclusive=True)
        for count in counts
    ]
    return Measurement([row for rows in found for row in rows])


def measure_worlds(conditions: Conditions, world_count: int) -> list[dict[str, object]]:
    """Return a row for each case; all cases start in the same states of the shake."""
    timed = time_cases(CASES, world_count, wp.get_device(conditions.device))
    return [
        {"case": case.name, "worlds": world_count, "contact_bias": case.contact_bias}
        | timed[case.name]
        for case in CASES
    ]
