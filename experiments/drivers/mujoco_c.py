"""MuJoCo's C engine, in double precision."""

import mujoco
import numpy as np

from experiments.drivers.contacts import Contacts
from experiments.simulation.c_warnings import refuse_warned

STEPS = 2  # of an ``advance``: Newton goes from one state into another and back


def start(model: mujoco.MjModel) -> mujoco.MjData:
    """Return the initial state: that of the first keyframe where there is one."""
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    return data


def free_joint(model: mujoco.MjModel) -> tuple[slice, slice]:
    """Return where position and velocity of the one free body are in qpos and qvel."""
    [joint] = np.flatnonzero(model.jnt_type == mujoco.mjtJoint.mjJNT_FREE)
    qpos = model.jnt_qposadr[joint]
    qvel = model.jnt_dofadr[joint]
    return slice(qpos, qpos + 3), slice(qvel, qvel + 3)


class InC:
    """Worlds of one scene in MJCF, which has one free body and begins as ``start`` says."""

    def __init__(self, mjcf: str, world_count: int = 1, device: str = "cpu"):
        self.model = mujoco.MjModel.from_xml_string(mjcf)
        self.worlds = [start(self.model) for _ in range(world_count)]
        self.free = free_joint(self.model)

    def command(self, control: np.ndarray) -> None:
        """Set the actuators' controls, shape [world, actuator]."""
        for data, values in zip(self.worlds, control, strict=True):
            data.ctrl[:] = values

    def advance(self, step_count: int = STEPS) -> None:
        """Run steps; RunFailed where a world shows no measurement any more."""
        for data in self.worlds:
            mujoco.mj_step(self.model, data, nstep=step_count)
            refuse_warned(data)

    def body(self) -> tuple[np.ndarray, np.ndarray]:
        """Return position [m] and velocity [m/s] of the body, shape [world, 3] each."""
        position, velocity = self.free
        return (
            np.array([data.qpos[position] for data in self.worlds]),
            np.array([data.qvel[velocity] for data in self.worlds]),
        )

    def contacts(self) -> Contacts:
        """Return what carries force in the first world after the last step."""
        data = self.worlds[0]
        pairs = data.contact
        return Contacts.of(
            self.model,
            np.asarray(pairs.efc_address).reshape(-1),
            pairs.friction,
            pairs.solref,
            pairs.solimp,
            pairs.dist,
            data.efc_force,
            data.efc_D,
        )
