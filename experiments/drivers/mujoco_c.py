"""Run MJCF with one free body in MuJoCo's C engine."""

import mujoco
import numpy as np

from experiments.drivers.contacts import Contacts
from experiments.simulation.c_warnings import refuse_warned

# Number of steps in one call of ``advance``. There are two because Newton steps from
# one state into another and back.
STEPS = 2


def start(model: mujoco.MjModel) -> mujoco.MjData:
    """Return the initial state, which is the first keyframe if there is one."""
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    return data


def free_joint(model: mujoco.MjModel) -> tuple[slice, slice]:
    """Return the slices of the free body's position in qpos and velocity in qvel."""
    [joint] = np.flatnonzero(model.jnt_type == mujoco.mjtJoint.mjJNT_FREE)
    qpos, qvel = model.jnt_qposadr[joint], model.jnt_dofadr[joint]
    return slice(qpos, qpos + 3), slice(qvel, qvel + 3)


class InC:
    """Run worlds of one scene in MuJoCo's C engine, in double precision.

    They start in the initial state of the scene.
    """

    def __init__(self, mjcf: str, world_count: int = 1, device: str = "cpu"):
        self.model = mujoco.MjModel.from_xml_string(mjcf)
        self.worlds = [start(self.model) for _ in range(world_count)]
        self.free = free_joint(self.model)

    def command(self, control: np.ndarray) -> None:
        """Set the controls of the actuators, shape [world, actuator]."""
        for data, values in zip(self.worlds, control, strict=True):
            data.ctrl[:] = values

    def advance(self) -> None:
        """Run two steps; raise RunFailed if a world has diverged."""
        for data in self.worlds:
            mujoco.mj_step(self.model, data, nstep=STEPS)
            refuse_warned(data)

    def body(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the position [m] and the velocity [m/s] of the free body, both of
        shape [world, 3].
        """
        position, velocity = self.free
        return (
            np.array([data.qpos[position] for data in self.worlds]),
            np.array([data.qvel[velocity] for data in self.worlds]),
        )

    def contacts(self) -> Contacts:
        """Return the loaded contacts of the first world after the last step."""
        return contacts_in_c(self.model, self.worlds[0])


def contacts_in_c(model: mujoco.MjModel, data: mujoco.MjData) -> Contacts:
    pairs = data.contact
    rows = np.asarray(pairs.efc_address).reshape(-1)
    return Contacts.of(
        model,
        rows,
        pairs.friction,
        pairs.solref,
        pairs.solimp,
        pairs.dist,
        data.efc_force,
        data.efc_D,
    )
