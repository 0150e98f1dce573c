"""Run the same scenes in MuJoCo Warp through Newton."""

from typing import Any

import mujoco
import newton
import numpy as np
from newton.solvers import SolverMuJoCo

from experiments.drivers.mujoco_c import free_joint, start
from experiments.drivers.mujoco_warp import CONSTRAINT_MAX, CONTACT_MAX, InWarp
from experiments.simulation.compat import make_solver


class ThroughNewton(InWarp):
    """Run worlds of one scene in Newton's ``SolverMuJoCo``, which imports the MJCF.

    MuJoCo generates the contacts.
    """

    def _build(self, mjcf: str) -> None:
        newton.use_coord_layout_targets = True
        builder, scene = newton.ModelBuilder(), newton.ModelBuilder()
        SolverMuJoCo.register_custom_attributes(scene)
        scene.add_mjcf(mjcf)
        builder.replicate(scene, self.world_count)
        newton_model = builder.finalize(device=self.device)
        newton_model.joint_q.assign(np.tile(_in_newton(self.model), self.world_count))
        self.actuated = [
            self.model.jnt_qposadr[joint] for joint in self.model.actuator_trnid[:, 0]
        ]
        self.solver = make_solver(
            newton_model,
            use_mujoco_contacts=True,
            nconmax=CONTACT_MAX,
            njmax=CONSTRAINT_MAX,
            update_data_interval=0,
        )
        self.states = newton_model.state(), newton_model.state()
        # This has the attributes that the solver adds.
        self.control: Any = newton_model.control()
        self.time_step = float(self.model.opt.timestep)
        self.model = self.solver.mj_model
        # Newton sets the time step only if it steps in C.
        self.model.opt.timestep = self.time_step
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


def _in_newton(model: mujoco.MjModel) -> np.ndarray:
    """Return the initial qpos in Newton's format.

    The real part of the free body's quaternion is the last component there.
    """
    qpos = start(model).qpos.copy()
    position, _ = free_joint(model)
    turn = slice(position.stop, position.stop + 4)
    qpos[turn] = np.roll(qpos[turn], -1)
    return qpos
