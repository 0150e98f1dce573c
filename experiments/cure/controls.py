"""A cube between two walls: shaken along a straight line, and turned at constant speed with no shake at all.

If compliance and the cycle of the load made a grasp creep, the straight shake would too, whose acceleration is that of
the arm's. If it is the term that rows leave out, only what turns creeps, by the law in ``turntable``.

And the shake itself in MuJoCo's C engine with a dense and a sparse Jacobian, which should be the same: MuJoCo 4.0.0
has a bug in its sparse Cholesky factorization (google-deepmind/mujoco issue #3767).
"""

from dataclasses import replace

import mujoco
import numpy as np
import warp as wp

from experiments.cure import turntable
from experiments.cure.turntable import MASS_KG, SAMPLE_S, SETTLE_S, TURN_RAD_S
from experiments.facts.case import AS_SHIPPED
from experiments.simulation.measurement import Conditions, summarize
from experiments.simulation.mjcf_engines import numbers
from experiments.simulation.reference import NativeShake, pilot_at_shake, starts_of

SHAKE_M, SHAKE_RAD_S = 0.03, 2.0 * np.pi  # the arm's own shake, a period of which is the time in which the cube settles
PLACE_M = SHAKE_M * SHAKE_RAD_S**2 / TURN_RAD_S**2
"""Distance from the axis at which what turns is accelerated by as much as the shake at its most."""
SECONDS = {"full": 6.0, "quick": 3.0}
JACOBIANS = {"dense": mujoco.mjtJacobian.mjJAC_DENSE, "sparse": mujoco.mjtJacobian.mjJAC_SPARSE}
HALF_M, PRESSED_M = 0.025, 0.002
FEET_M = [(x, y, z) for x in (-0.02, 0.02) for y in (-HALF_M, HALF_M) for z in (-0.02, 0.02)]
JOINTS = {
    "straight": f'<joint type="slide" axis="1 0 0" stiffness="{1e3 * SHAKE_RAD_S**2}" armature="1000"/>',
    "turning": '<joint axis="0 0 1" armature="1000"/>',
}
STARTS = {  # at an end of the shake, at rest, from where the spring of the walls does the rest; and turning
    "straight": f'qpos="{SHAKE_M} {SHAKE_M} 0 0 1 0 0 0"',
    "turning": f'qvel="{numbers([TURN_RAD_S, 0.0, TURN_RAD_S * PLACE_M, 0.0, 0.0, 0.0, TURN_RAD_S])}"',
}


def walls(motion: str) -> str:
    """Write the scene: walls on a joint, and between them a cube on feet, without gravity."""
    offset_m = PLACE_M if motion == "turning" else 0.0
    feet = "".join(f'<geom type="sphere" size="0.01" pos="{x} {y} {z}" mass="0"/>' for x, y, z in FEET_M)
    sides = "".join(
        f'<geom type="box" size="0.1 0.01 0.1" pos="{offset_m} {side * (HALF_M + 0.02 - PRESSED_M)} 0" mass="0.1"/>'
        for side in (-1, 1)
    )
    return f"""<mujoco><option timestep="0.002" cone="elliptic" integrator="implicitfast" gravity="0 0 0"/><worldbody>
      <body>{JOINTS[motion]}{sides}</body>
      <body pos="{offset_m} 0 0"><freejoint/>
        <geom type="box" size="{HALF_M} {HALF_M} {HALF_M}" mass="{MASS_KG}" contype="0" conaffinity="0"/>{feet}
      </body>
    </worldbody><keyframe><key {STARTS[motion]}/></keyframe></mujoco>"""


def measure(conditions: Conditions) -> list[dict]:
    """Make a row for each control and engine: how fast the cube creeps along the walls, once it has settled."""
    return [row_of(motion, engine, conditions) for motion in JOINTS for engine in ("warp", "c")]


def row_of(motion: str, engine: str, conditions: Conditions) -> dict[str, object]:
    path, contacts = turntable.run(engine, walls(motion), SECONDS[conditions.profile], conditions.device)
    outward = path[:, 0] if motion == "straight" else np.hypot(*path[:, :2].T)
    settled = outward[round(SETTLE_S / SAMPLE_S) :]
    row = {"case": f"control-{motion}-plain-{engine}", "control": motion, "backend": engine, "contact_bias": False}
    row["drift_mm_s"] = float(1e3 * (settled[-1] - settled[0]) / (SAMPLE_S * (len(settled) - 1)))
    if motion == "straight":
        return row
    row["growth_per_s"] = turntable.growth_per_s(outward, SETTLE_S)
    return row | {"predicted_growth_per_s": turntable.predicted_growth_per_s(turntable.Variant(), contacts)}


def measure_jacobians(conditions: Conditions) -> list[dict]:
    """Make a row for the shake in MuJoCo's C engine with either form of the Jacobian."""
    case = replace(AS_SHIPPED, backend="mujoco", frame_count=conditions.frame_count(AS_SHIPPED.frame_count))
    [start] = starts_of(pilot_at_shake([AS_SHIPPED], wp.get_device(conditions.device)), case.frame_count)
    rows = []
    for form, number in JACOBIANS.items():
        shake = NativeShake(case, start)
        shake.model.opt.jacobian = number
        row = summarize(replace(case, name=f"jacobian-{form}"), shake.run())
        rows.append(row | {"contact_bias": False, "jacobian": form})
    return rows
