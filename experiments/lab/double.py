"""The whole task through MuJoCo's C engine in double precision: Newton makes the model and plans, and steps nothing."""

from dataclasses import replace
from functools import partial

import mujoco
import numpy as np
import warp as wp

from experiments.facts.case import Case
from experiments.facts.trace import Trace
from experiments.simulation import contact_bias_c
from experiments.simulation.reference import NativeShake, Start
from experiments.simulation.scene import ROBOT_DOF_COUNT
from experiments.simulation.simulation import Simulation


class DoubleShake(NativeShake):
    """One case, from the approach to the end of the shake."""

    def __init__(self, case: Case, *, has_midphase: bool):
        bare = replace(case, contact_bias=False, bias_centred=False, backend="mujoco")
        self.simulation = Simulation([bare], wp.get_device("cpu"))
        qpos = self.simulation.model.joint_q.numpy().astype(float)
        qpos[ROBOT_DOF_COUNT + 3 :] = 1.0, 0.0, 0.0, 0.0  # the cube's turn, which MuJoCo writes with w first
        rest = np.zeros(len(qpos) - 1)
        super().__init__(bare, Start(qpos, rest, rest, targets=np.zeros((0, ROBOT_DOF_COUNT))))
        self.term = partial(contact_bias_c.subtract_bias, centred=case.bias_centred) if case.contact_bias else None
        if not has_midphase:
            self.model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_MIDPHASE)
        self.newton_bodies = self.simulation.solver.mjc_body_to_newton.numpy()[0]

    def run(self) -> Trace:
        mujoco.set_mjcb_control(self.term)  # one for all models, so only for as long as this one is stepped
        try:
            return super().run()
        finally:
            mujoco.set_mjcb_control(None)

    def _phase(self) -> int:
        return int(self.simulation.task.phase.numpy()[0])

    def frame(self) -> None:
        """Plan, and step all substeps; the planner sees where the bodies are, in single precision."""
        self.simulation.queue_targets()
        self.simulation.task.solve()
        self.data.ctrl[:ROBOT_DOF_COUNT] = self.simulation.joint_target.numpy()[0, :ROBOT_DOF_COUNT]
        mujoco.mj_step(self.model, self.data, self.case.substeps)
        mujoco.mj_kinematics(self.model, self.data)
        seen = self.simulation.body_q.numpy()[0]  # on the CPU a view
        for body, newton_body in enumerate(self.newton_bodies):
            if newton_body >= 0:
                seen[newton_body] = *self.data.xpos[body], *np.roll(self.data.xquat[body], -1)
