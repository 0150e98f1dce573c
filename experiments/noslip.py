"""MuJoCo's own remedy for slip: friction solved once more, without its regularization."""

from dataclasses import replace
from importlib import metadata

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.simulation.measurement import SHAKE_COLUMNS, Conditions, Measurement, absent
from newton_lint.newton_models.compat import warp_has_noslip

ITERATION_COUNT = 10
PLAIN = [
    replace(case, name=f"{case.name}-{ending}", backend=backend)
    for ending, backend in (("mujoco-c", "mujoco"), ("warp", "warp"))
    for case in (AS_SHIPPED, STIFF_PADS)
]
TREATED = [replace(case, name=f"{case.name}-noslip", noslip_iterations=ITERATION_COUNT) for case in PLAIN]


def measure(conditions: Conditions) -> Measurement:
    """A row for each case; without numbers where MuJoCo Warp has no noslip."""
    there = [case for case in TREATED if case.backend == "mujoco" or warp_has_noslip()]
    rows = list(conditions.measure([*PLAIN, *there], "noslip").rows)
    reason = f"mujoco-warp {metadata.version('mujoco-warp')} has no noslip"
    for case in TREATED:
        if case not in there:
            row = {"case": case.name, "backend": case.backend, "noslip_iterations": case.noslip_iterations}
            rows.append(row | absent(SHAKE_COLUMNS, reason))
    return Measurement(rows)
