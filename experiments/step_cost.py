"""Measure the time of a frame at each time step, for 1 to 16,384 worlds."""

from dataclasses import replace

import warp as wp

from experiments.facts.case import AS_SHIPPED, FIRM, STIFF_PADS
from experiments.simulation.frame_benchmark import time_cases
from experiments.simulation.measurement import Conditions, Measurement
from measured_report.measuring.batch import Batch, Plan

SETTINGS = {
    "stiff": {},
    "pyramidal": {"cone": "pyramidal"},
    "mujoco": {"contacts": "mujoco"},
    "mujoco-pyramidal": {"contacts": "mujoco", "cone": "pyramidal"},
    "cure": {
        name: value for name, value in FIRM.items() if not name.startswith("pad_")
    },
    "rk4": {"integrator": "rk4"},
}  # type: dict[str, dict]
SHIPPED_SUBSTEPS = STIFF_PADS.substeps
SUBSTEPS = {
    1: (1, 2, 4, 8, 16, 32, 64, 128),
    4096: (1, 4, 16, 64),
    16384: (1, 4, 16, 64),
}
"""Numbers of substeps by number of worlds."""
OTHERS = {1: (1, 4, 16, 64), 4096: (4, 16), 16384: (4, 16)}
"""Numbers of substeps with other contacts, by number of worlds."""
REMEDIES = {"cure": (4, 16), "rk4": (2, 4)}


def measure(conditions: Conditions) -> Plan:
    is_small = conditions.quick or not conditions.is_cuda
    counts = list(SUBSTEPS)[: 1 if is_small else None]
    found = yield [
        Batch(f"worlds-{count}", measure_worlds, (conditions, count), exclusive=True)
        for count in counts
    ]
    return Measurement([row for rows in found for row in rows])


def measure_worlds(conditions: Conditions, world_count: int) -> list[dict[str, object]]:
    """Return a row for each setting and number of substeps.

    The scene as shipped comes first, because all other settings are compared with it.
    """
    cases = [AS_SHIPPED]
    cases += [
        replace(
            STIFF_PADS,
            name=f"{setting}/substeps-{substeps}",
            substeps=substeps,
            **changes,
        )
        for setting, changes in SETTINGS.items()
        for substeps in substeps_of(setting, world_count, conditions.quick)
    ]
    timed = time_cases(cases, world_count, wp.get_device(conditions.device))
    return [
        {
            "case": case.name,
            "setting": case.name.partition("/")[0],
            "substeps": case.substeps,
            "worlds": world_count,
        }
        | timed[case.name]
        for case in cases
    ]


def substeps_of(setting: str, world_count: int, quick: bool) -> tuple[int, ...]:
    if quick:
        return (4, SHIPPED_SUBSTEPS)
    if setting == "stiff":
        return SUBSTEPS[world_count]
    return REMEDIES.get(setting, OTHERS[world_count])
