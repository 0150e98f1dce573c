"""Scenes of which others published numbers, built anew; their numbers are on the page's side.

What the texts leave open was chosen before anything was run. Critical friction (MotrixSim's documentation): the robot
is the Panda of ``scenes/pick.py``. Shaken cube and ball (phys-bench): as in that module, in MotrixSim. The cube at a
wall (Genesis pull request 2872): an edge of 0.1 m, a plane as wall, MuJoCo's own contacts, cone and integrator, and
gravity for the push. The orbit (SimReady FET005): the capsule of ``scenes/capsule.py`` between its pads at impratio 1,
seen from the gripper, where an orbit is gravity that turns.
"""

from collections.abc import Callable, Sequence
from functools import partial

import mujoco
import numpy as np

from experiments.engines.engine import Engine, run_apart
from experiments.scenes import capsule, pick
from experiments.simulation.c_warnings import RunFailed, refuse_warned
from experiments.simulation.measurement import Conditions, absent
from experiments.simulation.mjcf_engines import ENGINES, GRAVITY_M_S2, STEPS, InC, numbers
from measured_report.files.root import ROOT

WITH_MOTRIXSIM = ("motrixsim==0.10.0", "numpy==2.4.6")
MOTRIXSIM = Engine("MotrixSim", "0.10.0", "experiments/engines/apart/motrix_run.py", WITH_MOTRIXSIM)
STEP_S = 0.002
START = (*pick.READY, pick.OPEN_M, pick.OPEN_M)
TOUCH = '<contact name="finger{0}" body1="finger{0}" body2="object" data="found force" num="4"/>'
"""A sensor of what a finger presses the object with."""
CUBE = 'type="box" size="0.02 0.02 0.02" solref="0.005 1" solimp="0.99 0.99 0.5"'
CUBE_N = 0.064 * GRAVITY_M_S2
HOLD_S, FORCE_S, FACTOR = 5.0, 0.2, 1.1
"""How long the cube is lifted, and held again; in whose end its force is taken; friction then, of the critical one."""
DROPPED_M = 0.03
WALL_STEP_S, WALL_S, WALL_SETTLE_S = 0.01, 3.0, 1.0
WALL = f"""
<mujoco>
  <option timestep="{WALL_STEP_S}" gravity="-20 0 {-GRAVITY_M_S2}"/>
  <worldbody>
    <geom type="plane" size="1 1 0.1" zaxis="1 0 0" friction="1"/>
    <body pos="0.05 0 0"><freejoint/><geom type="box" size="0.05 0.05 0.05" mass="1" friction="1"/></body>
  </worldbody>
</mujoco>"""
ORBIT_M, ORBIT_RAD_S = 0.01, 4.0 * np.pi
ORBIT_S = (1.0, 2.5, 3.5)  # ends of the holding before the orbit, of the orbit, and of the holding after it
Shown = tuple[Sequence[tuple[float, float]], Sequence[float]]
"""The object's height [m] and the fingers' normal force [N] after each step, and the last joints."""


def rows(conditions: Conditions) -> list[dict[str, object]]:
    """Make a row for each scene, with the reason in the place of a number where an engine cannot run it."""
    runs: dict[str, Callable[[], dict[str, object]]] = {
        "friction-motrixsim": partial(hold, in_motrixsim),
        "friction-euler": partial(hold, in_c),
        "friction-implicitfast": partial(hold, in_c, "implicitfast"),
        **{f"shake-{kind}": partial(shake, kind, conditions) for kind in pick.OBJECTS},
        **{f"wall-{engine}": partial(press, engine, conditions.device) for engine in ("c", "warp")},
        "orbit": orbit,
    }
    columns = {"friction": "fall_mm", "shake": "dropped_count", "wall": "creep_mm_s", "orbit": "creep_mm"}
    found = []
    for name, run in runs.items():
        row: dict[str, object] = {"case": name}
        try:
            found.append(row | run())
        except (RunFailed, ValueError) as error:
            found.append(row | absent([columns[name.partition("-")[0]]], str(error)))
    return found


def in_c(mjcf: str, state: Sequence[float], controls: np.ndarray) -> Shown:
    """Give MuJoCo's C engine the controls of each step, from these joints and the others as the file has them."""
    model = mujoco.MjModel.from_xml_string(mjcf)
    data, readings = mujoco.MjData(model), []
    data.qpos[: len(state)] = state
    for control in controls:
        data.ctrl[:] = control
        mujoco.mj_step(model, data)
        refuse_warned(data)
        felt = data.sensordata.reshape(-1, 4)  # whether there is a contact, and its force
        readings.append((float(data.body("object").xpos[2]), float(felt[felt[:, 0] > 0.0, 1].sum())))
    return readings, data.qpos.tolist()


def in_motrixsim(mjcf: str, state: Sequence[float], controls: np.ndarray) -> Shown:
    """Do the same in MotrixSim; ValueError where that cannot be."""
    scene = {"mjcf": mjcf, "state": state, "controls": controls.tolist()}
    [shown] = run_apart(MOTRIXSIM, [{"scene": scene, "step_s": STEP_S, "options": {}}])
    if isinstance(shown, dict):
        raise ValueError(shown["reason"])
    return shown


def sensed(mjcf: str) -> str:
    return mjcf.replace("</mujoco>", f"<sensor>{TOUCH.format(1)}{TOUCH.format(2)}</sensor></mujoco>")


def hold(run: Callable[[str, Sequence[float], np.ndarray], Shown], integrator: str = "Euler") -> dict[str, object]:
    """Lift the cube, find the friction at which its weight is all that is carried, and hold it with a little more."""

    def grasp(friction: float) -> str:
        robot = (ROOT / pick.SCENE).read_text(encoding="utf-8").replace('friction="1 ', f'friction="{friction} ')
        cube, option = f'{CUBE} friction="{friction}"', f'timestep="{STEP_S}" integrator="{integrator}"'
        return sensed(robot.format(object_geom=cube, option=option, pad_solref=numbers(pick.PAD_SOLREF)))

    controls = np.array([pick.command(time_s) for time_s in np.arange(0.0, HOLD_S, STEP_S)])
    lifted, state = run(grasp(1.0), START, controls)
    critical = CUBE_N / float(np.mean(lifted[-round(FORCE_S / STEP_S) :], axis=0)[1])
    holding, _ = run(grasp(FACTOR * critical), state, np.repeat(controls[-1:], len(controls), axis=0))
    return {"fall_mm": 1e3 * (lifted[-1][0] - min(holding)[0]), "critical_friction": critical}


def shake(kind: str, conditions: Conditions) -> dict[str, object]:
    """Shake an object in MotrixSim, its targets at random in every second step, and count the drops."""
    count, end_s = pick.SEED_COUNT[conditions.profile], pick.END_S[conditions.profile]
    lifting = np.array([pick.command(time_s) for time_s in np.arange(STEP_S, end_s, STEP_S)])
    begin, dropped = round(pick.PHASES_S[-1] / STEP_S) - 1, 0
    for seed in range(count):
        jerks = np.random.default_rng(seed).normal(0.0, pick.SPREAD_RAD, (len(lifting), 7))
        controls = lifting.copy()
        controls[begin:, :7] += np.repeat(jerks, 2, axis=0)[: len(lifting) - begin]
        shown, _ = in_motrixsim(sensed(pick.Pick(kind, object=kind).mjcf()), START, controls)
        dropped += min(shown[begin:])[0] < DROPPED_M
    return {"seed_count": count, "dropped_count": dropped}


def press(name: str, device: str) -> dict[str, object]:
    """Press the cube at the wall: how fast it creeps down."""
    engine, height = ENGINES[name](WALL, 1, device), []
    for _ in range(round(WALL_S / WALL_STEP_S / STEPS)):
        engine.advance()
        height.append(float(engine.body()[0][0, 2]))
    settled = round(WALL_SETTLE_S / WALL_STEP_S / STEPS)
    return {"creep_mm_s": 1e3 * (height[settled - 1] - height[-1]) / (WALL_S - WALL_SETTLE_S)}


def orbit() -> dict[str, object]:
    """Hold the capsule, carry it around, and hold it: how far it creeps down in all."""
    engine, travel = InC(capsule.Pinch("orbit", impratio=1.0).mjcf()), capsule.GAP_M + capsule.SQUEEZE_M
    engine.command(np.array([[travel, -travel]]))
    height = []
    for time_s in np.arange(-capsule.SETTLE_S, ORBIT_S[-1], STEPS * STEP_S):
        turn, is_moving = ORBIT_RAD_S * time_s, ORBIT_S[0] <= time_s < ORBIT_S[1]
        engine.model.opt.gravity[:2] = is_moving * ORBIT_M * ORBIT_RAD_S**2 * np.array([np.cos(turn), np.sin(turn)])
        engine.advance()
        height.append(float(engine.body()[0][0, 2]))
    return {"creep_mm": 1e3 * (height[round(capsule.SETTLE_S / STEP_S / STEPS) - 1] - height[-1])}
