"""Hold a cube, a can and a cup in hands of MuJoCo Menagerie, at rest and shaken.

The hand closes in MuJoCo's C engine without gravity. Both engines start from this grasp,
hold the object still with gravity, shake the hand, and let it rest again.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from itertools import product

import mujoco
import mujoco_warp as mjw
import numpy as np
import warp as wp

from experiments.drivers.mjcf import ENGINES, columns_of, numbers, run
from experiments.drivers.mujoco_c import STEPS, start
from experiments.drivers.mujoco_warp import InWarp
from experiments.drivers.scene import Scene
from experiments.grippers.hands import HANDS, Hand
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.frame_benchmark import untimed
from experiments.simulation.paired_timing import PairedTimes, time_in_turn
from experiments.simulation.timing import elapsed_ms, spread
from measured_report.files.errors import UsageError
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.measurement import Conditions, Measurement, absent
from measured_report.measuring.pool import gather, processes

OBJECTS = {
    "cube": 'type="box" size="0.02 0.02 0.02"',
    "can": 'type="cylinder" size="0.02 0.03"',
    "cup": 'type="mesh" mesh="cup"',
}
MASS_KG = 0.032  # of the cube in the shake test
RIM_M = ((0.017, -0.03), (0.022, 0.03))  # radius and height of the cup's ends
CORNERS = 16
SERVO = 'kp="20000" kv="400"'  # drives the base of the hand
# ``measured_report.measuring.machine`` reads this. A CPU measures all hands in minutes.
NEEDS_GPU = False
PREFIX = "hand-"  # of names in the hand
BASE = ("x", "y", "z")  # joints of the base
RULE_STEPS = 2.0  # timeconst of the rule in steps
CLOSE_S = 1.5
VISCOSITY = 10.0
HOLD_S = 2.0
WATCH_S = 1.0  # the creep at rest is measured at the end of the hold
REST_S = 0.5  # after the shake
AMPLITUDE_M = 0.03
SHAKES_S = {"full": 5.0, "quick": 1.0}  # at 1 Hz
LOST_M = 0.02  # an object that moves farther in the shake counts as dropped
ENGINES_OF = {"published": ("c", "warp"), "rule": ("c",), "firm": ("c", "warp")}
"""Engines by the kind of pads.

``rule`` are pads by the rule of stiffness, and ``firm`` adds an elliptic cone with
impratio 50, as in the shake test.
"""
IMPRATIO = 50.0
COLUMNS = ("moved_mm", "creep_mm_s", "penetration_mm", "contact_count")
BLOCK_STEPS = 50  # steps that are timed together, with the object held still
TIMES = ("ms_per_s", "ms_per_s_p5", "ms_per_s_p95")


class RoomyInWarp(InWarp):
    """Runs scenes in MuJoCo Warp, with room for fingers of many overlapping parts."""

    def _build(self, mjcf: str) -> None:
        self.engine = mjw.put_model(self.model)
        self.data = mjw.put_data(self.model, start(self.model), nconmax=128, njmax=512)


ENGINES["roomy-warp"] = RoomyInWarp


@dataclass(frozen=True)
class Grasp:
    """Describe one run, whose row has these columns."""

    hand: str
    object: str
    pads: str = "published"
    backend: str = "c"

    @property
    def case(self) -> str:
        return "-".join((self.hand, self.object, self.pads, self.backend))


def measure(conditions: Conditions) -> Plan:
    """Return rows for each grasp, and for the run times with the cube in each hand."""
    hands = HANDS[:1] if conditions.quick else HANDS
    found = yield [
        Batch("grasps", measure_grasps, (conditions, hands)),
        Batch("times", measure_times, (conditions, hands), exclusive=True),
    ]
    return Measurement([row for rows in found for row in rows])


def measure_grasps(
    conditions: Conditions, hands: Sequence[Hand]
) -> list[dict[str, object]]:
    objects = ["cube"] if conditions.quick else OBJECTS
    calls = [(*call, conditions) for call in product(hands, objects, ENGINES_OF)]
    with processes(len(calls)) as pool:
        found = gather([pool.submit(rows_of, *call) for call in calls], "grippers")
    return [row for rows in found for row in rows]


def rows_of(
    hand: Hand, kind: str, pads: str, conditions: Conditions
) -> list[dict[str, object]]:
    """Return a row for each engine, with reasons if the model cannot be downloaded."""
    reason = ""
    try:
        scene = scene_of(hand, kind, pads, SHAKES_S[conditions.profile])
    except UsageError as error:
        reason = str(error)
    rows = []
    for backend in ENGINES_OF[pads]:
        grasp = Grasp(hand.name, kind, pads, backend)
        if reason:
            columns = absent(COLUMNS, reason)
        else:
            measured = partial(hold, scene, backend, conditions.device)
            columns = columns_of(measured, COLUMNS)
        rows.append({"case": grasp.case} | asdict(grasp) | columns)
    return rows


def scene_of(hand: Hand, kind: str, pads: str, shake_s: float) -> Scene:
    """Return the scene of a hand that has closed around an object."""
    spec = spec_of(hand, kind, pads)
    gravity = spec.option.gravity.copy()
    spec.option.gravity = np.zeros(3)
    spec.option.viscosity = VISCOSITY
    model = spec.compile()
    data = mujoco.MjData(model)
    for name, position in hand.open.items():
        data.joint(PREFIX + name).qpos = position
    for name, control in hand.closed.items():
        data.actuator(PREFIX + name).ctrl = control
    mujoco.mj_step(model, data, nstep=round(CLOSE_S / model.opt.timestep))
    spec.option.gravity = gravity
    spec.option.viscosity = 0.0
    spec.add_key(qpos=data.qpos, ctrl=data.ctrl)
    sample_s = STEPS * model.opt.timestep
    targets = np.tile(data.ctrl, (round((HOLD_S + shake_s + REST_S) / sample_s), 1))
    time_s = sample_s * np.arange(round(shake_s / sample_s))
    begin = round(HOLD_S / sample_s)
    targets[begin : begin + len(time_s), : len(BASE)] = shake_m(time_s)
    return Scene(model.opt.timestep, sample_s, targets, spec.to_xml())


def shake_m(time_s: np.ndarray) -> np.ndarray:
    """Return the base's path in the shake test, shape [time, 3]."""
    angle = 2.0 * np.pi * time_s[:, None]
    return AMPLITUDE_M * np.array([1.0, 0.65, 0.35]) * np.sin(angle * [1.0, 2.0, 1.5])


def spec_of(hand: Hand, kind: str, pads: str) -> mujoco.MjSpec:
    """Return a hand on a base that slides along all axes, and an object."""
    angles = 2.0 * np.pi * np.arange(CORNERS) / CORNERS
    cup = [
        (radius * np.cos(angle), radius * np.sin(angle), height)
        for radius, height in RIM_M
        for angle in angles
    ]
    joints = "".join(
        f'<joint name="{name}" type="slide" axis="{numbers(axis)}"/>'
        for name, axis in zip(BASE, np.eye(3), strict=True)
    )
    servos = "".join(f'<position joint="{name}" {SERVO}/>' for name in BASE)
    spec = mujoco.MjSpec.from_string(f"""
        <mujoco>
          <asset><mesh name="cup" vertex="{numbers(np.ravel(cup))}"/></asset>
          <worldbody>
            <body>{joints}
              <geom size="0.001" mass="1" contype="0" conaffinity="0"/>
              <frame name="base" quat="{numbers(hand.turn)}"/>
            </body>
            <body pos="{numbers(hand.at_m)}">
              <freejoint/>
              <geom {OBJECTS[kind]} mass="{MASS_KG}"/>
            </body>
          </worldbody>
          <actuator>{servos}</actuator>
        </mujoco>""")
    file = hand.mjcf()
    robot = mujoco.MjSpec.from_file(str(file))
    spec.meshdir = spec.texturedir = str(file.parent / robot.meshdir)
    for name in ("cone", "impratio", "integrator", "timestep"):
        setattr(spec.option, name, getattr(robot.option, name))
    robot.option.noslip_iterations = 0  # MuJoCo Warp has none
    for key in list(robot.keys):
        robot.delete(key)
    body = robot.body(hand.body) if hand.body else robot.worldbody.bodies[0]
    body.pos = np.zeros(3)
    body.quat = (1.0, 0.0, 0.0, 0.0)
    for joint in list(body.joints):
        robot.delete(joint)
    spec.frame("base").attach_body(body, PREFIX, "")
    if pads == "firm":
        spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
        spec.option.impratio = IMPRATIO
    if pads != "published":
        for geom in spec.geoms:
            geom.solref = (RULE_STEPS * spec.option.timestep, 1.0)
    return spec


def hold(scene: Scene, backend: str, device: str) -> Mapping[str, object]:
    """Return how far the object moves, at rest and by the end of the shake."""
    trace = run(scene, "roomy-warp" if backend == "warp" else backend, device)
    begin, watched = (round(time / scene.sample_s) for time in (HOLD_S, WATCH_S))
    first_m, before_m, after_m = trace.path_m[[begin - watched, begin, -1]]
    moved_m = float(np.linalg.norm(after_m - before_m))
    return {
        "moved_mm": 1e3 * min(moved_m, LOST_M),
        "dropped": moved_m > LOST_M,
        "creep_mm_s": 1e3 * float(np.linalg.norm(before_m - first_m)) / WATCH_S,
        "penetration_mm": 1e3 * trace.contacts.depth_m,
        "contact_count": trace.contacts.count,
    }


def measure_times(
    conditions: Conditions, hands: Sequence[Hand]
) -> list[dict[str, object]]:
    """Return a row for each hand, engine and kind of pads that both engines run.

    The four runs of a hand are timed in turn.
    """
    rows: list[dict[str, object]] = []
    columns: list[dict[str, object]]
    for hand in hands:
        grasps = [
            Grasp(hand.name, "cube", pads, backend)
            for pads, backends in ENGINES_OF.items()
            for backend in backends
            if "warp" in backends
        ]
        try:
            blocks = [Steps(hand, grasp, conditions.device) for grasp in grasps]
            columns = [
                block.columns(times)
                for block, times in zip(blocks, time_in_turn(blocks), strict=True)
            ]
        except (UsageError, RunFailed) as error:
            columns = [untimed(TIMES, str(error))] * len(grasps)
        rows += [
            {"case": f"{grasp.case}/time"} | asdict(grasp) | found
            for grasp, found in zip(grasps, columns, strict=True)
        ]
    return rows


class Steps:
    """Run blocks of steps in which a hand holds the cube still."""

    def __init__(self, hand: Hand, grasp: Grasp, device: str):
        mjcf = scene_of(hand, grasp.object, grasp.pads, 0.0).mjcf
        is_warp = grasp.backend == "warp"
        self.world = ENGINES["roomy-warp" if is_warp else "c"](mjcf, 1, device)
        self.device = wp.get_device(device if is_warp else "cpu")
        self.start_m = self.world.body()[0]
        self.world.advance()
        graph = self.world.graph if is_warp else None
        self.advance = (
            partial(wp.capture_launch, graph) if graph else self.world.advance
        )
        self(0)

    def __call__(self, _: int) -> float:
        """Return the run time of a simulated second [ms]."""
        simulated_s = BLOCK_STEPS * self.world.model.opt.timestep
        return elapsed_ms(self.device, self._run) / simulated_s

    def _run(self) -> None:
        for _ in range(BLOCK_STEPS // STEPS):
            self.advance()

    def columns(self, times: PairedTimes) -> dict[str, object]:
        """Return the times, or the reason if the cube is not in the hand at the end."""
        moved_m = np.linalg.norm(self.world.body()[0] - self.start_m)
        if not moved_m < LOST_M:
            return untimed(TIMES, "the hand does not hold the cube still")
        return dict(spread("ms_per_s", times.times))
