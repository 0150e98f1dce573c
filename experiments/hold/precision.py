"""Does rounding move the cube? The grasp held still, with positions in double and in single precision."""

import copy
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import mujoco
import numpy as np
import warp as wp

from experiments.facts import metrics
from experiments.facts.case import HOLD, Case
from experiments.simulation.measurement import SETUP_FRAME_COUNT, Conditions
from experiments.simulation.reference import ENGINES_AGREE
from experiments.simulation.scene import ARM_DOF_COUNT
from experiments.simulation.simulation import Simulation
from experiments.simulation.task import FRAME_RATE

SETTLE_FRAME_COUNT = SETUP_FRAME_COUNT + 5 * FRAME_RATE
"""Frames before the motion is measured: the set-up and what the arm takes to come to rest."""
SECONDS = {"full": 4, "quick": 1}


@dataclass(frozen=True)
class Held:
    """The held grasp at some moments, a second apart."""

    cube_m: list[np.ndarray] = field(default_factory=list)
    """The cube in the TCP frame."""
    arm_rad: list[np.ndarray] = field(default_factory=list)
    arm_rad_s: list[np.ndarray] = field(default_factory=list)

    def columns(self) -> dict[str, object]:
        """Return the rate [mm/s] of the cube, and of the arm's fastest joint how much of its velocity its position
        follows."""
        seconds = len(self.cube_m) - 1
        rate = 1e3 * (self.cube_m[-1] - self.cube_m[0]) / seconds
        velocity = np.mean(self.arm_rad_s, axis=0)
        joint = int(np.abs(velocity).argmax())
        moved = (self.arm_rad[-1] - self.arm_rad[0])[joint] / seconds
        return {
            "creep_mm_s": float(np.linalg.norm(rate)),
            "joint_velocity_mrad_s": 1e3 * float(velocity[joint]),
            "joint_motion_mrad_s": 1e3 * float(moved),
        }


def measure_precision(conditions: Conditions) -> list[dict[str, object]]:
    """Measure MuJoCo Warp, and MuJoCo's C engine on its own with positions kept in double and rounded to single
    precision."""
    seconds = SECONDS[conditions.profile]
    hold = replace(HOLD, frame_count=1, **ENGINES_AGREE)
    in_c = _settled(replace(hold, backend="mujoco"), "cpu")
    return [
        {"case": "precision-warp", **_in_warp(_settled(hold, conditions.device), seconds).columns()},
        {"case": "precision-c-double", **_in_c(in_c, seconds, lambda data: None).columns()},
        {"case": "precision-c-single", **_in_c(in_c, seconds, _round_positions).columns()},
    ]


def _settled(case: Case, device: str) -> Simulation:
    simulation = Simulation([case], wp.get_device(device))
    for _ in range(SETTLE_FRAME_COUNT):
        simulation.step()
    return simulation


def _in_warp(simulation: Simulation, seconds: int) -> Held:
    held = Held()
    for second in range(seconds + 1):
        for _ in range(FRAME_RATE if second else 0):
            simulation.step()
        poses = simulation.recorder.poses.numpy()[:, 0]
        data = simulation.solver.mjw_data
        held.cube_m.append(metrics.relative_position(poses, metrics.CUBE, metrics.TCP)[0])
        held.arm_rad.append(data.qpos.numpy()[0, :ARM_DOF_COUNT].astype(np.float64))
        held.arm_rad_s.append(data.qvel.numpy()[0, :ARM_DOF_COUNT])
    return held


def _in_c(simulation: Simulation, seconds: int, after_step: Callable[[mujoco.MjData], None]) -> Held:
    """Step a copy without Newton, which would hand its state over in single precision at every step."""
    engine, data = simulation.solver.mj_model, copy.copy(simulation.solver.mj_data)
    cube = engine.geom_bodyid[simulation.recorder.cube_geom]
    tcp = next(body for body in range(engine.nbody) if engine.body(body).name.endswith("fr3_hand_tcp"))
    held = Held()
    for second in range(seconds + 1):
        for _ in range(FRAME_RATE * simulation.case.substeps if second else 0):
            mujoco.mj_step(engine, data)
            after_step(data)
        mujoco.mj_kinematics(engine, data)
        held.cube_m.append(data.xmat[tcp].reshape(3, 3).T @ (data.xpos[cube] - data.xpos[tcp]))
        held.arm_rad.append(data.qpos[:ARM_DOF_COUNT].copy())
        held.arm_rad_s.append(data.qvel[:ARM_DOF_COUNT].copy())
    return held


def _round_positions(data: mujoco.MjData) -> None:
    data.qpos[:] = data.qpos.astype(np.float32)
