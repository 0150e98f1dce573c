"""Rebuild scenes for which others published numbers.

The published numbers are in the report. The details that the publications leave open
were chosen before the first run:

- Critical friction (MotrixSim's documentation): the robot is the Panda of
``scenes/pick.py``.
- Shaken cube and ball (phys-bench): they are built as in that module and run in
MotrixSim.
- Cube at a wall (Genesis pull request 2872): the cube has an edge of 0.1 m and the wall
is a plane. Contacts, cone and integrator are MuJoCo's defaults, and gravity provides
the push.
- Orbit (SimReady FET005): the capsule of ``scenes/capsule.py`` is held between its pads
at impratio 1. In the frame of the gripper, an orbit is a rotating gravity.
"""

from collections.abc import Callable, Sequence

import mujoco
import numpy as np

from experiments.drivers.engine import Engine, run
from experiments.drivers.mjcf import run as run_here
from experiments.drivers.mujoco_c import STEPS, InC
from experiments.drivers.scene import GRAVITY_M_S2, Scene
from experiments.scenes import capsule, pick
from experiments.simulation.c_warnings import RunFailed, refuse_warned
from experiments.simulation.measurement import Conditions, absent
from measured_report.files.root import ROOT

WITH_MOTRIXSIM = ("motrixsim==0.10.0", "numpy==2.4.6")
MOTRIXSIM = Engine(
    "MotrixSim", "0.10.0", "experiments/drivers/apart/motrix_run.py", WITH_MOTRIXSIM
)
STEP_S = 0.002
START = (*pick.READY, pick.OPEN_M, pick.OPEN_M)
TOUCH = """<sensor>
  <contact name="finger1" body1="finger1" body2="object" data="found force" num="4"/>
  <contact name="finger2" body1="finger2" body2="object" data="found force" num="4"/>
</sensor></mujoco>"""  # measures the forces of the fingers on the object
CUBE = 'type="box" size="0.02 0.02 0.02" solref="0.005 1" solimp="0.99 0.99 0.5"'
CUBE_N = 0.064 * GRAVITY_M_S2
HOLD_S = 5.0  # duration of the lift, and of the hold after it [s]
FORCE_S = 0.2  # end of the lift in which the fingers' force is measured [s]
FACTOR = 1.1  # friction during the hold, relative to the critical friction
DROPPED_M = 0.03
WALL_STEP_S = 0.01
WALL_S = 3.0
WALL_SETTLE_S = 1.0
WALL = f"""
<mujoco>
  <option timestep="{WALL_STEP_S}" gravity="-20 0 {-GRAVITY_M_S2}"/>
  <worldbody>
    <geom type="plane" size="1 1 0.1" zaxis="1 0 0" friction="1"/>
    <body pos="0.05 0 0">
      <freejoint/><geom type="box" size="0.05 0.05 0.05" mass="1" friction="1"/>
    </body>
  </worldbody>
</mujoco>"""
ORBIT_M = 0.01
ORBIT_RAD_S = 4.0 * np.pi
# ends of the first hold, of the orbit, and of the second hold [s]
ORBIT_S = (1.0, 2.5, 3.5)
Shown = tuple[np.ndarray, np.ndarray, Sequence[float]]
"""Height of the object [m] and normal force of the fingers [N] after each step, and the
final joint positions.
"""


def in_c(mjcf: str, qpos: Sequence[float], controls: np.ndarray) -> Shown:
    """Run MuJoCo's C engine from joint positions, with a control for each step."""
    model = mujoco.MjModel.from_xml_string(mjcf)
    data = mujoco.MjData(model)
    data.qpos[: len(qpos)] = qpos
    height_m = []
    force_n = []
    for control in controls:
        data.ctrl[:] = control
        mujoco.mj_step(model, data)
        refuse_warned(data)
        # For each contact: whether it exists, and its force.
        felt = data.sensordata.reshape(
            -1,
            4,
        )
        height_m.append(data.body("object").xpos[2])
        force_n.append(felt[felt[:, 0] > 0.0, 1].sum())
    return np.array(height_m), np.array(force_n), data.qpos.tolist()


def in_motrixsim(mjcf: str, qpos: Sequence[float], controls: np.ndarray) -> Shown:
    """Run the same positions and controls in MotrixSim; raise ValueError if it fails."""
    scene = Scene(STEP_S, STEP_S, controls.tolist(), mjcf, qpos)
    [trace] = run([scene], MOTRIXSIM)
    if isinstance(trace, str):
        raise ValueError(trace)
    return trace.path_m[1:, 2], trace.forces[:, 0], trace.joints.tolist()


def grasp_mjcf(friction: float, integrator: str) -> str:
    """Return the Panda and a cube with this friction, and sensors in the fingers."""
    robot = (ROOT / pick.SCENE).read_text(encoding="utf-8")
    robot = robot.replace('friction="1 ', f'friction="{friction} ')
    return robot.format(
        object_geom=f'{CUBE} friction="{friction}"',
        option=f'timestep="{STEP_S}" integrator="{integrator}"',
        pad_solref=f"{pick.PAD_TIMECONST_S} 1",
    ).replace("</mujoco>", TOUCH)


def hold(
    conditions: Conditions, show: Callable[..., Shown], integrator: str = "Euler"
) -> dict[str, object]:
    """Lift the cube, determine its critical friction, and hold it with a margin."""
    controls = pick.pick_controls(np.arange(0.0, HOLD_S, STEP_S))
    lifted_m, force_n, qpos = show(grasp_mjcf(1.0, integrator), START, controls)
    count = round(FORCE_S / STEP_S)
    critical = CUBE_N / float(sum(force_n[-count:]) / count)
    still = np.repeat(controls[-1:], len(controls), axis=0)
    held_m, _, _ = show(grasp_mjcf(FACTOR * critical, integrator), qpos, still)
    fall_mm = 1e3 * float(lifted_m[-1] - held_m.min())
    return {"fall_mm": fall_mm, "critical_friction": critical}


def shake(conditions: Conditions, kind: str) -> dict[str, object]:
    """Shake an object in MotrixSim with random targets and count the drops.

    A new target is set in every second step.
    """
    profile = conditions.profile
    lifting = pick.pick_controls(np.arange(STEP_S, pick.END_S[profile], STEP_S))
    mjcf = pick.Pick(kind, object=kind).mjcf().replace("</mujoco>", TOUCH)
    begin = round(pick.PHASES_S[-1] / STEP_S) - 1
    dropped_count = 0
    for seed in range(pick.SEED_COUNT[profile]):
        random = np.random.default_rng(seed)
        jerks = random.normal(0.0, pick.SPREAD_RAD, (len(lifting), 7))
        controls = lifting.copy()
        controls[begin:, :7] += np.repeat(jerks, 2, axis=0)[: len(lifting) - begin]
        height_m, _, _ = in_motrixsim(mjcf, START, controls)
        dropped_count += int(height_m[begin:].min() < DROPPED_M)
    return {"seed_count": pick.SEED_COUNT[profile], "dropped_count": dropped_count}


def press(conditions: Conditions, engine: str) -> dict[str, object]:
    """Press the cube against the wall and return its downward creep."""
    sample_s = STEPS * WALL_STEP_S
    targets = [()] * round(WALL_S / sample_s)
    trace = run_here(
        Scene(WALL_STEP_S, sample_s, targets, WALL), engine, conditions.device
    )
    height_m = trace.path_m[:, 2]
    crept_m = height_m[round(WALL_SETTLE_S / sample_s)] - height_m[-1]
    return {"creep_mm_s": 1e3 * float(crept_m) / (WALL_S - WALL_SETTLE_S)}


def orbit(_: Conditions) -> dict[str, object]:
    """Hold the capsule, move it on an orbit, and hold it again. Return its creep."""
    world = InC(capsule.Pinch("orbit", impratio=1.0).mjcf())
    world.command([capsule.TARGET])
    height_m = []
    times_s = np.arange(-capsule.SETTLE_S, ORBIT_S[-1], STEPS * STEP_S)
    for time_s in times_s:
        turn = ORBIT_RAD_S * time_s
        is_moving = ORBIT_S[0] <= time_s < ORBIT_S[1]
        pull = is_moving * ORBIT_M * ORBIT_RAD_S**2
        world.model.opt.gravity[:2] = pull * np.array([np.cos(turn), np.sin(turn)])
        world.advance()
        height_m.append(world.body()[0][0, 2])
    settled = round(capsule.SETTLE_S / STEP_S / STEPS) - 1
    return {"creep_mm": 1e3 * float(height_m[settled] - height_m[-1])}


RUNS = (  # case, column, function and its arguments
    ("friction-motrixsim", "fall_mm", hold, in_motrixsim),
    ("friction-euler", "fall_mm", hold, in_c),
    ("friction-implicitfast", "fall_mm", hold, in_c, "implicitfast"),
    ("shake-cube", "dropped_count", shake, "cube"),
    ("shake-ball", "dropped_count", shake, "ball"),
    ("wall-c", "creep_mm_s", press, "c"),
    ("wall-warp", "creep_mm_s", press, "warp"),
    ("orbit", "creep_mm", orbit),
)


def rows(conditions: Conditions) -> list[dict[str, object]]:
    """Return a row for each scene, with the reason if an engine cannot run it."""
    found = []
    for case, column, measure, *arguments in RUNS:
        try:
            found.append({"case": case} | measure(conditions, *arguments))
        except (RunFailed, ValueError) as error:
            found.append({"case": case} | absent([column], str(error)))
    return found
