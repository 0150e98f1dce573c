"""MuJoCo Warp, in single precision."""

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
    """The same as ``mujoco_c.InC``."""

    def __init__(self, mjcf: str, world_count: int = 1, device: str = "cpu"):
        self.model = mujoco.MjModel.from_xml_string(mjcf)
        self.world_count = world_count
        self.device = wp.get_device(device)
        self.free = free_joint(self.model)
        self.graph = None
        with wp.ScopedDevice(self.device):
            self._build(mjcf)

    def _build(self, mjcf: str) -> None:
        self.engine = mjw.put_model(self.model)
        self.data = mjw.put_data(
            self.model,
            start(self.model),
            nworld=self.world_count,
            nconmax=CONTACT_MAX,
            njmax=CONSTRAINT_MAX,
        )

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
        return (
            self.data.qpos.numpy()[:, position].astype(float),
            self.data.qvel.numpy()[:, velocity].astype(float),
        )

    def contacts(self) -> Contacts:
        pairs = self.data.contact
        count = int(self.data.nacon.numpy()[0])
        is_mine = pairs.worldid.numpy()[:count] == 0
        arrays = (
            pairs.efc_address,
            pairs.friction,
            pairs.solref,
            pairs.solimp,
            pairs.dist,
        )
        rows, *parameters = (array.numpy()[:count][is_mine] for array in arrays)
        efc = self.data.efc
        return Contacts.of(
            self.model, rows[:, 0], *parameters, efc.force.numpy()[0], efc.D.numpy()[0]
        )
