"""MuJoCo Warp as Newton's ``SolverMuJoCo`` sets it up from MJCF; contacts are MuJoCo's."""

from typing import Any

import newton
import numpy as np
from newton.solvers import SolverMuJoCo

from experiments.drivers.mujoco_c import free_joint, start
from experiments.drivers.mujoco_warp import CONSTRAINT_MAX, CONTACT_MAX, InWarp
from newton_lint.newton_models.compat import make_solver


class ThroughNewton(InWarp):
    """The same as ``mujoco_c.InC``."""

    def _build(self, mjcf: str) -> None:
        newton.use_coord_layout_targets = True
        scene = newton.ModelBuilder()
        SolverMuJoCo.register_custom_attributes(scene)
        scene.add_mjcf(mjcf)
        builder = newton.ModelBuilder()
        builder.replicate(scene, self.world_count)
        newton_model = builder.finalize(device=self.device)
        qpos = start(self.model).qpos.copy()
        end = free_joint(self.model)[0].stop
        qpos[end : end + 4] = np.roll(
            qpos[end : end + 4], -1
        )  # its real part comes last
        newton_model.joint_q.assign(np.tile(qpos, self.world_count))
        self.actuated = self.model.jnt_qposadr[self.model.actuator_trnid[:, 0]]
        self.solver = make_solver(
            newton_model,
            use_mujoco_contacts=True,
            nconmax=CONTACT_MAX,
            njmax=CONSTRAINT_MAX,
            update_data_interval=0,
        )
        self.states = newton_model.state(), newton_model.state()
        self.control: Any = newton_model.control()  # its attributes are the solver's
        self.time_step = float(self.model.opt.timestep)
        self.model = self.solver.mj_model
        self.model.opt.timestep = (
            self.time_step
        )  # Newton sets it where it steps in C alone
        self.engine = self.solver.mjw_model
        self.data = self.solver.mjw_data

    def command(self, control: np.ndarray) -> None:
        targets = self.control.joint_target_q.numpy().reshape((self.world_count, -1))
        targets[:, self.actuated] = control
        self.control.joint_target_q.assign(targets.ravel())
        self.control.mujoco.ctrl.assign(np.asarray(control, dtype=np.float32).ravel())

    def _steps(self) -> None:
        first, second = self.states
        self.solver.step(first, second, self.control, None, self.time_step)
        self.solver.step(second, first, self.control, None, self.time_step)
