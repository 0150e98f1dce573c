"""A cube between two walls: shaken along a straight line, and turned at constant speed with no shake at all.

If compliance and the cycle of the load made a grasp creep, the straight shake would too, whose acceleration is that of
the arm's. If it is the term that rows leave out, only what turns creeps, by the law in ``turntable``.

And the shake itself in MuJoCo's C engine with a dense and a sparse Jacobian, which should be the same: MuJoCo 4.0.0
has a bug in its sparse Cholesky factorization (google-deepmind/mujoco issue #3767).
"""

from dataclasses import replace
from functools import partial

import mujoco
import numpy as np
import warp as wp

from experiments.cure import bodies
from experiments.cure.turntable import MASS_KG, SAMPLE_S, TURN_RAD_S, Run, Turntable, path_in_c, predicted_growth_per_s
from experiments.facts.case import AS_SHIPPED
from experiments.simulation import contact_place_c
from experiments.simulation.measurement import Conditions, summarize
from experiments.simulation.mjcf_engines import contacts_in_c
from experiments.simulation.reference import NativeShake, pilot_at_shake, starts_of

SHAKE_M, SHAKE_RAD_S = 0.03, 2.0 * np.pi
"""The arm's own shake."""
PLACE_M = SHAKE_M * SHAKE_RAD_S**2 / TURN_RAD_S**2
"""Distance from the axis at which what turns is accelerated by as much as the shake at its most."""
SECONDS = {"full": 6.0, "quick": 3.0}
SETTLE_S = 1.0
"""Time in which the cube settles, a whole period of the shake."""
JACOBIANS = {"dense": mujoco.mjtJacobian.mjJAC_DENSE, "sparse": mujoco.mjtJacobian.mjJAC_SPARSE}
HALF_M, PRESSED_M = 0.025, 0.002
FEET_M = [(x, y, z) for x in (-0.02, 0.02) for y in (-HALF_M, HALF_M) for z in (-0.02, 0.02)]
JOINTS = {
    "straight": f'<joint type="slide" axis="1 0 0" stiffness="{1e3 * SHAKE_RAD_S**2}" armature="1000"/>',
    "turning": '<joint axis="0 0 1" armature="1000"/>',
}


def walls(joint: str) -> str:
    """Write the scene: walls on a joint, and between them a cube on feet, without gravity."""
    place = PLACE_M if joint == "turning" else 0.0
    feet = "".join(f'<geom type="sphere" size="0.01" pos="{x} {y} {z}" mass="0"/>' for x, y, z in FEET_M)
    sides = "".join(
        f'<geom type="box" size="0.1 0.01 0.1" pos="{place} {side * (HALF_M + 0.02 - PRESSED_M)} 0" mass="0.1"/>'
        for side in (-1, 1)
    )
    return f"""<mujoco><option timestep="0.002" cone="elliptic" integrator="implicitfast" gravity="0 0 0"/><worldbody>
      <body>{JOINTS[joint]}{sides}</body>
      <body pos="{place} 0 0"><freejoint/>
        <geom type="box" size="{HALF_M} {HALF_M} {HALF_M}" mass="{MASS_KG}" contype="0" conaffinity="0"/>{feet}
      </body>
    </worldbody></mujoco>"""


def shaken(data: mujoco.MjData) -> None:
    """Move walls and cube to an end of the shake, at rest; the spring of the walls does the rest."""
    data.qpos[:2] = SHAKE_M


def turned(data: mujoco.MjData) -> None:
    data.qvel[:] = TURN_RAD_S, 0.0, TURN_RAD_S * PLACE_M, 0.0, 0.0, 0.0, TURN_RAD_S


MOTIONS = [
    bodies.Motion(name, "cube", "table", walls(name), start)
    for name, start in (("straight", shaken), ("turning", turned))
]


def measure(conditions: Conditions) -> list[dict]:
    """Make a row for each control, variant and engine: how fast the cube creeps along the walls."""
    chosen = [(motion, variant) for motion in MOTIONS for variant in bodies.COMPARED]
    seconds = SECONDS[conditions.profile]
    in_warp = bodies.run_in_warp([(*run, seconds) for run in chosen], wp.get_device(conditions.device))
    rows = []
    for (motion, variant), path in zip(chosen, in_warp, strict=True):
        in_c, predicted = run_in_c(motion, variant, seconds)
        for engine, walked in (("warp", path), ("c", in_c)):
            row = {"case": f"control-{motion.name}-{variant}-{engine}", "control": motion.name, "variant": variant}
            row |= {"backend": engine, "contact_bias": variant != "plain"} | columns_of(motion, walked)
            rows.append(row | ({} if predicted is None else {"predicted_growth_per_s": predicted}))
    return rows


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


def columns_of(motion: bodies.Motion, path: np.ndarray) -> dict[str, float]:
    """Tell how the cube creeps once it has settled: along a straight shake over its whole periods, or outward."""
    settled = path[round(SETTLE_S / SAMPLE_S) :]
    time_s = SAMPLE_S * np.arange(len(settled))
    outward = settled[:, 0] if motion.name == "straight" else np.hypot(settled[:, 0], settled[:, 1])
    found = {"drift_mm_s": float(1e3 * (outward[-1] - outward[0]) / time_s[-1])}
    if motion.name == "turning":
        found["growth_per_s"] = float(np.polyfit(time_s, np.log(outward), 1)[0])
    return found


def run_in_c(motion: bodies.Motion, variant: str, seconds: float) -> tuple[np.ndarray, float | None]:
    """Return the cube's path, and the growth by the law where the walls turn."""
    model, data = bodies.started(motion)
    options = bodies.options_of(motion, variant)
    control = None if options is None else partial(contact_place_c.subtract_bias, **options)
    path = path_in_c(model, data, control, seconds)
    law = Turntable(motion.name, contact_bias=options is not None, bias_centred=options is not None)
    found = Run(np.hypot(*path[:, :2].T), contacts_in_c(model, data))
    return path, predicted_growth_per_s(law, found) if motion.name == "turning" else None
