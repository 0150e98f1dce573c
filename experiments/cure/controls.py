"""Measure a cube between two walls that shake along a line or an arc, or rotate.

If compliance and cyclic load caused the creep of a grasp, the straight shake would
cause it too, because its acceleration equals that of the arm. If the ignored term
causes the creep, the cube creeps whenever a joint rotates, as fast as the law in
``turntable`` predicts. On the same arc it then creeps on a hinge, and on two hinges
that keep the walls upright, but not on two slides, whose J̇ is zero.

The section also runs the shake in MuJoCo's C engine with a dense and with a sparse
Jacobian. Both should give the same result, but MuJoCo 4.0.0 has a bug in its sparse
Cholesky factorization (google-deepmind/mujoco issue #3767).
"""

from dataclasses import replace

import mujoco
import numpy as np
import warp as wp

from experiments.cure import turntable
from experiments.cure.turntable import MASS_KG, SAMPLE_S, SETTLE_S, TURN_RAD_S
from experiments.drivers.mjcf import numbers
from experiments.facts.case import AS_SHIPPED
from experiments.simulation.measurement import Conditions, summarize
from experiments.simulation.reference import NativeShake, pilot_at_shake, starts_of

# Amplitude and angular frequency are the same as in the shake. The cube settles during
# the first period.
SHAKE_M, SHAKE_RAD_S = (
    0.03,
    2.0 * np.pi,
)
PLACE_M = SHAKE_M * SHAKE_RAD_S**2 / TURN_RAD_S**2
"""Distance from the axis at which the acceleration equals the peak of the shake."""
SECONDS = {"full": 6.0, "quick": 3.0}
JACOBIANS = {
    "dense": mujoco.mjtJacobian.mjJAC_DENSE,
    "sparse": mujoco.mjtJacobian.mjJAC_SPARSE,
}
HALF_M, PRESSED_M = 0.025, 0.002
FEET_M = [
    (x, y, z) for x in (-0.02, 0.02) for y in (-HALF_M, HALF_M) for z in (-0.02, 0.02)
]
HINGE, SLIDE = (
    '<joint axis="0 {sign} 0" pos="{at} 0 0" {spring}/>',
    '<joint type="slide" axis="{axis}" {spring}/>',
)
SWING = f'stiffness="{1e3 * SHAKE_RAD_S**2}" armature="1000"'
# Distance between the middle of the arc's radial motion and its lowest point.
ARC_M = SHAKE_M**2 / (4.0 * PLACE_M)
# The radial motion has twice the frequency of the shake.
ALONG = f'springref="{-ARC_M}" stiffness="{4e3 * SHAKE_RAD_S**2}" armature="1000"'
JOINTS = {
    "straight": SLIDE.format(axis="1 0 0", spring=SWING),
    "turning": '<joint axis="0 0 1" armature="1000"/>',
    "hinge": HINGE.format(sign=-1, at=-PLACE_M, spring=SWING),
    "two-hinges": HINGE.format(sign=-1, at=-PLACE_M, spring=SWING)
    + HINGE.format(sign=1, at=0, spring=SWING),
    "two-slides": SLIDE.format(axis="1 0 0", spring=ALONG)
    + SLIDE.format(axis="0 0 1", spring=SWING),
}
ON_AN_ARC = ("hinge", "two-hinges", "two-slides")
SPEED_M_S = SHAKE_M * SHAKE_RAD_S  # speed in the middle of a shake
SWING_RAD_S = SPEED_M_S / PLACE_M
STARTS = {  # at rest at an end of the shake, rotating, or in the middle of the arc
    "straight": f'qpos="{SHAKE_M} {SHAKE_M} 0 0 1 0 0 0"',
    "turning": f'qvel="{numbers([TURN_RAD_S, 0.0, TURN_RAD_S * PLACE_M, 0.0, 0.0, 0.0, TURN_RAD_S])}"',
    "hinge": f'qvel="{numbers([SWING_RAD_S, 0.0, 0.0, SPEED_M_S, 0.0, -SWING_RAD_S, 0.0])}"',
    "two-hinges": f'qvel="{numbers([SWING_RAD_S, SWING_RAD_S, 0.0, 0.0, SPEED_M_S, 0.0, 0.0, 0.0])}"',
    "two-slides": f'qvel="{numbers([0.0, SPEED_M_S, 0.0, 0.0, SPEED_M_S, 0.0, 0.0, 0.0])}"',
}


def walls(motion: str) -> str:
    """Return the scene: walls on joints, and a cube between them without gravity."""
    place_m = 0.0 if motion == "straight" else PLACE_M
    feet = "".join(
        f'<geom type="sphere" size="0.01" pos="{x} {y} {z}" mass="0"/>'
        for x, y, z in FEET_M
    )
    at_body = f"{place_m} 0 0" if motion in ON_AN_ARC else "0 0 0"
    offset_m = 0.0 if motion in ON_AN_ARC else place_m
    sides = "".join(
        f'<geom type="box" size="0.1 0.01 0.1" pos="{offset_m} {side * (HALF_M + 0.02 - PRESSED_M)} 0" mass="0.1"/>'
        for side in (-1, 1)
    )
    return f"""<mujoco><option timestep="0.002" cone="elliptic" integrator="implicitfast" gravity="0 0 0"/><worldbody>
      <body pos="{at_body}">{JOINTS[motion]}{sides}</body>
      <body pos="{place_m} 0 0"><freejoint/>
        <geom type="box" size="{HALF_M} {HALF_M} {HALF_M}" mass="{MASS_KG}" contype="0" conaffinity="0"/>{feet}
      </body>
    </worldbody><keyframe><key {STARTS[motion]}/></keyframe></mujoco>"""


def measure(conditions: Conditions) -> list[dict]:
    """Return a row with the creep after settling for each control and engine."""
    return [
        row_of(motion, engine, conditions)
        for motion in JOINTS
        for engine in ("warp", "c")
    ]


def row_of(motion: str, engine: str, conditions: Conditions) -> dict[str, object]:
    path, contacts = turntable.run(
        engine, walls(motion), SECONDS[conditions.profile], conditions.device
    )
    outward = (
        path[:, 0]
        if motion == "straight"
        else np.hypot(*path[:, [0, 2 if motion in ON_AN_ARC else 1]].T)
    )
    settled = outward[round(SETTLE_S / SAMPLE_S) :]
    row = {
        "case": f"control-{motion}-plain-{engine}",
        "control": motion,
        "backend": engine,
        "contact_bias": False,
    }
    row["drift_mm_s"] = float(
        1e3 * (settled[-1] - settled[0]) / (SAMPLE_S * (len(settled) - 1))
    )
    if motion != "turning":
        return row
    row["growth_per_s"] = turntable.growth_per_s(outward, SETTLE_S)
    return row | {
        "predicted_growth_per_s": turntable.predicted_growth_per_s(
            turntable.Variant(), contacts
        )
    }


def measure_jacobians(conditions: Conditions) -> list[dict]:
    """Return a row for the shake in MuJoCo's C engine with each type of Jacobian."""
    case = replace(
        AS_SHIPPED,
        backend="mujoco",
        frame_count=conditions.frame_count(AS_SHIPPED.frame_count),
    )
    [start] = starts_of(
        pilot_at_shake([AS_SHIPPED], wp.get_device(conditions.device)), case.frame_count
    )
    rows = []
    for form, number in JACOBIANS.items():
        shake = NativeShake(case, start)
        shake.model.opt.jacobian = number
        row = summarize(replace(case, name=f"jacobian-{form}"), shake.run())
        rows.append(row | {"contact_bias": False, "jacobian": form})
    return rows
