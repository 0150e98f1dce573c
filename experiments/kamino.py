"""Measure the shake and the box in Kamino with each of its backends."""

from dataclasses import replace

import numpy as np
import warp as wp
from newton.solvers import SolverKamino

from experiments import newton_solvers
from experiments.facts import metrics
from experiments.facts.case import Case
from experiments.facts.trace import Trace
from experiments.newton_solvers import box
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.simulation.scene import FINGERS, TRACKED_BODIES
from experiments.simulation.simulation import run
from measured_report.measuring.batch import Batch, Plan

BACKENDS = ("padmm", "dvi", "lox")
COARSE = replace(newton_solvers.WEIGHTLESS, substeps=4)  # steps of 4.2 ms
QUICK = {"4-substeps": COARSE}
SHAKES = {16: newton_solvers.SHAKES, 4: QUICK}
"""Shakes by number of substeps; those with the same number are worlds of one batch."""
# Position of the fingers' joints along the hand's z axis [m], as in the robot's URDF.
FINGER_Z_M = 0.0584
WORLD_COUNTS = (1, 64)


def measure(conditions: Conditions) -> Plan:
    """Return rows for each shake and each scene with the box, and for the frame times."""
    variants = [variant_of(backend) for backend in BACKENDS if is_offered(backend)]
    counts = WORLD_COUNTS if conditions.is_cuda and not conditions.quick else (1,)
    timed = [newton_solvers.MUJOCO, *variants]
    found = yield [
        *(
            Batch(f"shakes-{each.name}", measure_shakes, (conditions, each))
            for each in variants
        ),
        *(
            Batch(f"box-{each.name}", box.rows_of, (conditions, each))
            for each in variants
        ),
        Batch(
            "times",
            newton_solvers.measure_times,
            (conditions, timed, counts),
            exclusive=True,
        ),
    ]
    return Measurement([row for rows in found for row in rows])


def is_offered(backend: str) -> bool:
    """Return whether the release has the backend; the first ones have only padmm."""
    return backend == "padmm" or hasattr(SolverKamino.Config, "dynamics_solver")


def variant_of(backend: str) -> box.Variant:
    options = (
        {"config": SolverKamino.Config(dynamics_solver=backend)}
        if backend != "padmm"
        else {}
    )
    return box.Variant(backend, "SolverKamino", options)


def measure_shakes(
    conditions: Conditions, variant: box.Variant
) -> list[dict[str, object]]:
    """Return a row for each shake."""
    rows = []
    # Section newton_solvers measures the other shakes of the default.
    is_short = conditions.quick or variant.name == "padmm"
    for shakes in [QUICK] if is_short else SHAKES.values():
        cases = [
            replace(case, frame_count=conditions.frame_count(case.frame_count))
            for case in shakes.values()
        ]
        try:
            simulation = newton_solvers.build(
                variant, cases, wp.get_device(conditions.device)
            )
            [traces] = run([simulation], title=variant.name)
        # A backend that cannot run the scene is a result.
        except Exception as error:
            reason = box.reason_of(error)
            numbers = absent(("slip_mm", *newton_solvers.GRASP), reason)
            rows += [
                {"case": f"{variant.name}-{shake}", "variant": variant.name, **numbers}
                for shake in shakes
            ]
            continue
        rows += [
            row_of(variant.name, *each)
            for each in zip(shakes, cases, traces, strict=True)
        ]
    return rows


def row_of(variant: str, shake: str, case: Case, trace: Trace) -> dict[str, object]:
    row = newton_solvers.row_of(variant, shake, case, trace)
    return row | {"substeps": case.substeps, "joint_error_mm": joint_error_mm(trace)}


def joint_error_mm(trace: Trace) -> float | None:
    """Return the largest distance of a finger from the line on which it may slide [mm].

    The line is the y axis of its joint. Solvers with coordinates for each body can
    leave it.
    """
    hand, errors = TRACKED_BODIES.index("fr3_hand"), []
    for finger in FINGERS:
        place = metrics.relative_position(
            trace.poses, TRACKED_BODIES.index(finger), hand
        )
        errors.append(np.hypot(place[:, 0], place[:, 2] - FINGER_Z_M).max())
    largest = 1e3 * float(np.max(errors))
    return largest if np.isfinite(largest) else None
