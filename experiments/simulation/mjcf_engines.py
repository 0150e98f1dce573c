"""A scene in MJCF in MuJoCo's C engine, in MuJoCo Warp, and in MuJoCo Warp through Newton: the same few calls.

A scene has one free body, its last one, which is what is held, and actuators that take a control each. Two steps are
run at a time, because Newton goes from one state into another and back.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import mujoco
import mujoco_warp as mjw
import newton
import numpy as np
import warp as wp
from newton.solvers import SolverMuJoCo

import contact_bias_c
from experiments.simulation.c_warnings import RunFailed, refuse_warned
from newton_lint.newton_models.compat import make_solver

STEPS = 2  # steps that ``advance`` runs
CONTACT_MAX = 48
CONSTRAINT_MAX = 256
SOLIMP = (0.9, 0.95, 0.001, 0.5, 2.0)  # MuJoCo's own
GRAVITY_M_S2 = 9.81


def numbers(values: Sequence[float]) -> str:
    """Write numbers as MJCF has them."""
    return " ".join(map(str, values))


@dataclass(frozen=True)
class Contacts:
    """Contacts of a world that carry force, together."""

    count: int
    normal_n: float  # sum of the normal forces [N]
    softness_1_kg: float  # R of their friction rows as one row: 1 / Σ 1/R [1/kg]; 0 where nothing is touched
    damping_per_s: float  # b of the rows [1/s], the least where they are not alike; 0 where nothing is touched
    depth_m: float  # how deep they are on average [m]

    @classmethod
    def of(cls, model: mujoco.MjModel, rows, friction, solref, solimp, dist, force, stiffness) -> "Contacts":
        """Sum up contacts by their first rows, parameters and distance, and by force and D (1 / R) of all rows."""
        loaded = [index for index, row in enumerate(rows) if row >= 0 and force[row] > 0.0]
        if not loaded:
            return cls(0, 0.0, 0.0, 0.0, 0.0)
        if model.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC:
            stiff = [stiffness[rows[index] + 1] for index in loaded]
            normal = [force[rows[index]] for index in loaded]
        else:
            # Opposite edges pull with mu (f - f') and see mu times the sliding; condim 3 has two pairs of them.
            stiff = [2.0 * friction[index][0] ** 2 * stiffness[rows[index]] for index in loaded]
            normal = [np.sum(force[rows[index] : rows[index] + 4]) for index in loaded]
        damping = min(contact_bias_c.damping(model, solref[index], solimp[index]) for index in loaded)
        depth = -np.mean([dist[index] for index in loaded])
        return cls(len(loaded), float(np.sum(normal)), float(1.0 / np.sum(stiff)), float(damping), float(depth))

    def creep_m_s(self, load_n: float) -> float:
        """Predict how fast a held body slides under a constant load [m/s]: each row yields R f = b v."""
        return load_n * self.softness_1_kg / self.damping_per_s


def free_joint(model: mujoco.MjModel) -> tuple[slice, slice]:
    """Find position and velocity of the one free body in qpos and qvel."""
    [joint] = np.flatnonzero(model.jnt_type == mujoco.mjtJoint.mjJNT_FREE)
    qpos, qvel = model.jnt_qposadr[joint], model.jnt_dofadr[joint]
    return slice(qpos, qpos + 3), slice(qvel, qvel + 3)


class InC:
    """Worlds of one scene in MuJoCo's C engine, in double precision; they begin in its initial state."""

    def __init__(self, mjcf: str, world_count: int = 1, device: str = "cpu"):
        self.model = mujoco.MjModel.from_xml_string(mjcf)
        self.worlds = [start(self.model) for _ in range(world_count)]
        self.free = free_joint(self.model)

    def command(self, control: np.ndarray) -> None:
        """Set the actuators' controls, shape [world, actuator]."""
        for data, values in zip(self.worlds, control, strict=True):
            data.ctrl[:] = values

    def advance(self) -> None:
        """Run two steps; RunFailed where a world shows no measurement any more."""
        for data in self.worlds:
            mujoco.mj_step(self.model, data, nstep=STEPS)
            refuse_warned(data)

    def body(self) -> tuple[np.ndarray, np.ndarray]:
        """Return position [m] and velocity [m/s] of the free body, shape [world, 3] each."""
        position, velocity = self.free
        return (
            np.array([data.qpos[position] for data in self.worlds]),
            np.array([data.qvel[velocity] for data in self.worlds]),
        )

    def contacts(self) -> Contacts:
        """Return what carries force in the first world after the last step."""
        return contacts_in_c(self.model, self.worlds[0])


class InWarp:
    """The same in MuJoCo Warp, in single precision."""

    def __init__(self, mjcf: str, world_count: int = 1, device: str = "cpu"):
        self.model = mujoco.MjModel.from_xml_string(mjcf)
        self.world_count = world_count
        self.device = wp.get_device(device)
        self.free = free_joint(self.model)
        self.graph = None
        with wp.ScopedDevice(self.device):
            self._build(mjcf)

    def _build(self, mjcf: str) -> None:
        sizes = {"nworld": self.world_count, "nconmax": CONTACT_MAX, "njmax": CONSTRAINT_MAX}
        self.engine = mjw.put_model(self.model)
        self.data = mjw.put_data(self.model, start(self.model), **sizes)

    def command(self, control: np.ndarray) -> None:
        self.data.ctrl.assign(np.asarray(control, dtype=np.float32))

    def advance(self) -> None:
        with wp.ScopedDevice(self.device):
            if self.graph is None:
                self._steps()  # compiles, which must not happen inside a capture
                with wp.ScopedCapture() as capture:
                    self._steps()
                self.graph = capture.graph
            else:
                wp.capture_launch(self.graph)
        if not np.isfinite(self.data.qpos.numpy()).all():
            raise RunFailed("not finite")

    def _steps(self) -> None:
        for _ in range(STEPS):
            mjw.step(self.engine, self.data)

    def body(self) -> tuple[np.ndarray, np.ndarray]:
        position, velocity = self.free
        return (self.data.qpos.numpy()[:, position].astype(float), self.data.qvel.numpy()[:, velocity].astype(float))

    def contacts(self) -> Contacts:
        return contacts_in_warp(self.model, self.data)


class ThroughNewton(InWarp):
    """The same as Newton's ``SolverMuJoCo`` sets MuJoCo Warp up from the MJCF; the contacts are MuJoCo's."""

    def _build(self, mjcf: str) -> None:
        newton.use_coord_layout_targets = True
        builder, scene = newton.ModelBuilder(), newton.ModelBuilder()
        SolverMuJoCo.register_custom_attributes(scene)
        scene.add_mjcf(mjcf)
        builder.replicate(scene, self.world_count)
        newton_model = builder.finalize(device=self.device)
        newton_model.joint_q.assign(np.tile(_in_newton(self.model), self.world_count))
        self.actuated = [self.model.jnt_qposadr[joint] for joint in self.model.actuator_trnid[:, 0]]
        self.solver = make_solver(
            newton_model, use_mujoco_contacts=True, nconmax=CONTACT_MAX, njmax=CONSTRAINT_MAX, update_data_interval=0
        )
        self.states = newton_model.state(), newton_model.state()
        self.control: Any = newton_model.control()  # which has what the solver's attributes add to it
        self.time_step = float(self.model.opt.timestep)
        self.model = self.solver.mj_model
        self.model.opt.timestep = self.time_step  # Newton sets it where it steps in C alone
        self.engine, self.data = self.solver.mjw_model, self.solver.mjw_data

    def command(self, control: np.ndarray) -> None:
        targets = self.control.joint_target_q.numpy().reshape((self.world_count, -1))
        targets[:, self.actuated] = control
        self.control.joint_target_q.assign(targets.ravel())
        self.control.mujoco.ctrl.assign(np.asarray(control, dtype=np.float32).ravel())

    def _steps(self) -> None:
        first, second = self.states
        self.solver.step(first, second, self.control, None, self.time_step)
        self.solver.step(second, first, self.control, None, self.time_step)


ENGINES = {"c": InC, "warp": InWarp, "newton": ThroughNewton}  # type: dict[str, type]
"""Engines by the names that cases say."""


def contacts_in_c(model: mujoco.MjModel, data: mujoco.MjData) -> Contacts:
    pairs = data.contact
    rows = np.asarray(pairs.efc_address).reshape(-1)
    return Contacts.of(model, rows, pairs.friction, pairs.solref, pairs.solimp, pairs.dist, data.efc_force, data.efc_D)


def contacts_in_warp(model: mujoco.MjModel, data: mjw.Data) -> Contacts:
    pairs = data.contact
    count = int(data.nacon.numpy()[0])
    mine = pairs.worldid.numpy()[:count] == 0
    arrays = (pairs.efc_address, pairs.friction, pairs.solref, pairs.solimp, pairs.dist)
    rows, friction, solref, solimp, dist = (array.numpy()[:count][mine] for array in arrays)
    force, stiffness = data.efc.force.numpy()[0], data.efc.D.numpy()[0]
    return Contacts.of(model, rows[:, 0], friction, solref, solimp, dist, force, stiffness)


def _in_newton(model: mujoco.MjModel) -> np.ndarray:
    """Return the initial qpos as Newton has it: the free body's quaternion ends with its real part."""
    qpos = start(model).qpos.copy()
    position, _ = free_joint(model)
    turn = slice(position.stop, position.stop + 4)
    qpos[turn] = np.roll(qpos[turn], -1)
    return qpos


def start(model: mujoco.MjModel) -> mujoco.MjData:
    """Make the initial state, which is that of the first keyframe where there is one."""
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    return data
