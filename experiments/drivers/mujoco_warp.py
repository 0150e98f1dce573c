"""Run the same scenes in MuJoCo Warp."""

import mujoco
import mujoco_warp as mjw
import numpy as np
import warp as wp

from experiments.drivers.contacts import Contacts
from experiments.drivers.mujoco_c import STEPS, free_joint, start
from experiments.simulation.c_warnings import RunFailed

CONTACT_MAX = 48
CONSTRAINT_MAX = 256


class InWarp:
    """Run worlds of one scene in MuJoCo Warp, in single precision."""

    def __init__(self, mjcf: str, world_count: int = 1, device: str = "cpu"):
        self.model = mujoco.MjModel.from_xml_string(mjcf)
        self.world_count = world_count
        self.device = wp.get_device(device)
        self.free = free_joint(self.model)
        self.graph = None
        with wp.ScopedDevice(self.device):
            self._build(mjcf)

    def _build(self, mjcf: str) -> None:
        sizes = {
            "nworld": self.world_count,
            "nconmax": CONTACT_MAX,
            "njmax": CONSTRAINT_MAX,
        }
        self.engine = mjw.put_model(self.model)
        self.data = mjw.put_data(self.model, start(self.model), **sizes)

    def command(self, control: np.ndarray) -> None:
        self.data.ctrl.assign(np.asarray(control, dtype=np.float32))

    def advance(self) -> None:
        with wp.ScopedDevice(self.device):
            if self.graph is None:
                self._steps()  # compiles, which is not allowed during a capture
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
        return (
            self.data.qpos.numpy()[:, position].astype(float),
            self.data.qvel.numpy()[:, velocity].astype(float),
        )

    def contacts(self) -> Contacts:
        return contacts_in_warp(self.model, self.data)


def contacts_in_warp(model: mujoco.MjModel, data: mjw.Data) -> Contacts:
    pairs = data.contact
    count = int(data.nacon.numpy()[0])
    mine = pairs.worldid.numpy()[:count] == 0
    arrays = (pairs.efc_address, pairs.friction, pairs.solref, pairs.solimp, pairs.dist)
    rows, friction, solref, solimp, dist = (
        array.numpy()[:count][mine] for array in arrays
    )
    force, stiffness = data.efc.force.numpy()[0], data.efc.D.numpy()[0]
    return Contacts.of(
        model, rows[:, 0], friction, solref, solimp, dist, force, stiffness
    )
