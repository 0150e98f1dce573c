"""Measure the influence of solver settings on the slip.

The settings are iterations, tolerance, cone, impratio, steps and noslip.
"""

from dataclasses import replace
from importlib import metadata

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.simulation.measurement import (
    SHAKE_COLUMNS,
    Conditions,
    Measurement,
    absent,
)
from experiments.simulation.stepper_c import has_noslip

CASES = (
    replace(AS_SHIPPED, name="iterations-15"),
    replace(AS_SHIPPED, name="iterations-200", iterations=200),
    replace(AS_SHIPPED, name="tolerance-1e-10", tolerance=1e-10, ls_tolerance=1e-10),
    replace(AS_SHIPPED, name="impratio-1000", impratio=1000.0),
    replace(AS_SHIPPED, name="cone-pyramidal", cone="pyramidal"),
    replace(AS_SHIPPED, name="substeps-32", substeps=32),
    replace(AS_SHIPPED, name="substeps-64", substeps=64),
)
PLAIN = tuple(
    replace(case, name=f"{case.name}-{ending}", backend=backend)
    for ending, backend in (("mujoco-c", "mujoco"), ("warp", "warp"))
    for case in (AS_SHIPPED, STIFF_PADS)
)
NOSLIP = tuple(
    replace(case, name=f"{case.name}-noslip", noslip_iterations=10) for case in PLAIN
)


def measure(conditions: Conditions) -> Measurement:
    """Return a row for each case, without numbers if MuJoCo Warp has no noslip."""
    there = [case for case in NOSLIP if has_noslip(case)]
    rows = [
        *conditions.measure(CASES, "solver").rows,
        *conditions.measure([*PLAIN, *there], "noslip").rows,
    ]
    reason = f"mujoco-warp {metadata.version('mujoco-warp')} has no noslip"
    for case in NOSLIP:
        if case not in there:
            row = {
                "case": case.name,
                "backend": case.backend,
                "noslip_iterations": case.noslip_iterations,
            }
            rows.append(row | absent(SHAKE_COLUMNS, reason))
    return Measurement(rows)
