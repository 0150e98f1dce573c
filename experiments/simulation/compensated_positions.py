# SPDX-License-Identifier: Apache-2.0
"""Sum joint positions of MuJoCo Warp with compensation for rounding, without a patch.

    import compensated_positions
    compensated_positions.install(solver)

The solver is a SolverMuJoCo on MuJoCo Warp, before its first step.

In single precision, a position of 1 rad changes in steps of 1e-7 rad. A joint that
creeps moves by less than half of that in a short time step, so its position never
changes, even if its velocity is not zero, while the held object moves on. Kahan's
summation keeps the rounding error of each sum and adds it to the next one ("Further
remarks on reducing truncation errors", Communications of the ACM 8, 1965). It is
applied to hinges, slides and the translation of free joints. MuJoCo Warp calls
``Model.callback.control`` in each step. There, the sum at the end of the previous step
is repeated with compensation.
"""

from collections.abc import Sequence

import mujoco
import mujoco_warp
import warp as wp

FREE, BALL = int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_BALL)
NO_ACTUATION = int(mujoco.mjtDisableBit.mjDSBL_ACTUATION)
RUNGE_KUTTA = int(mujoco.mjtIntegrator.mjINT_RK4)
STAGE_WEIGHTS = (1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0)
"""Weights of the stage velocities in a step of RK4."""
NEAR = wp.constant(1e-6)
"""Largest difference between a position and its sum, relative above 1 rad or 1 m.

A larger difference means that the position was set, for example by a reset. The sum
then starts again.
"""


def install(solver, *, worlds: Sequence[bool] | None = None) -> None:
    """Sum the joint positions of a solver with compensation.

    Args:
        solver: An object with ``mjw_model`` and ``mjw_data``, such as a
            ``newton.solvers.SolverMuJoCo`` without MuJoCo's C engine.
        worlds: Whether to compensate each world; all worlds if it is left out.

    An existing control callback is called first.

    Raises:
        ValueError: The solver does not run MuJoCo Warp, or its actuation is disabled,
            so that the callback is never called.
    """
    model = getattr(solver, "mjw_model", None)
    if model is None:
        raise ValueError(
            "compensated_positions needs a solver with a mjw_model, one that runs MuJoCo Warp"
        )
    if model.opt.disableflags & NO_ACTUATION:
        raise ValueError(
            "compensated_positions: MuJoCo Warp calls nothing while actuation is disabled; enable it"
        )
    data, before = solver.mjw_data, model.callback.control
    chosen = wp.array(
        [True] * data.nworld if worlds is None else list(worlds),
        dtype=bool,
        device=data.qpos.device,
    )
    sums = _Sums(data, chosen)

    def control(m: mujoco_warp.Model, d: mujoco_warp.Data) -> None:
        if before is not None:
            before(m, d)
        sums.add(m, d)

    model.callback.control = control


class _Sums:
    """Each position as a sum of two single-precision numbers.

    These are ``position`` and the lost remainder.
    """

    def __init__(self, d: mujoco_warp.Data, worlds: wp.array):
        self.worlds = worlds
        # NaN is not near any position, so that the first step takes the current one.
        self.position = wp.full_like(
            d.qpos,
            wp.nan,
        )
        self.lost = wp.zeros_like(d.qpos)
        # Mean velocity of the step so far, over the stages of RK4.
        self.velocity = wp.zeros_like(d.qvel)
        # Stage of RK4. It is counted while calls are queued, so a graph must contain
        # whole steps.
        self.stage = 0

    def add(self, m: mujoco_warp.Model, d: mujoco_warp.Data) -> None:
        """Queue the sum of the last step, and add the velocity of an RK4 stage."""
        staged = int(m.opt.integrator) == RUNGE_KUTTA
        if self.stage == 0:
            wp.launch(
                add_step,
                dim=(d.nworld, m.njnt),
                inputs=[
                    self.worlds,
                    m.opt.timestep,
                    m.jnt_type,
                    m.jnt_qposadr,
                    m.jnt_dofadr,
                ]
                + [self.velocity if staged else d.qvel],
                outputs=[d.qpos, self.position, self.lost],
                device=d.qpos.device,
            )
        if staged:
            wp.launch(
                add_stage,
                dim=(d.nworld, m.nv),
                inputs=[STAGE_WEIGHTS[self.stage], self.stage == 0, d.qvel],
                outputs=[self.velocity],
                device=d.qpos.device,
            )
            self.stage = (self.stage + 1) % len(STAGE_WEIGHTS)


@wp.kernel(enable_backward=False)
def add_stage(
    weight: float, first: bool, velocity: wp.array2d[float], mean: wp.array2d[float]
):
    world, dof = wp.tid()
    mean[world, dof] = (
        wp.where(first, 0.0, mean[world, dof]) + weight * velocity[world, dof]
    )


@wp.kernel(enable_backward=False)
def add_step(
    worlds: wp.array[bool],
    timestep: wp.array[float],
    joint_type: wp.array[int],
    joint_position: wp.array[int],
    joint_dof: wp.array[int],
    velocity: wp.array2d[float],
    qpos: wp.array2d[float],
    position: wp.array2d[float],
    lost: wp.array2d[float],
):
    world, joint = wp.tid()
    if not worlds[world]:
        return
    count = 1
    if joint_type[joint] == FREE:
        count = 3
    if joint_type[joint] == BALL:
        count = 0
    for i in range(count):
        at = joint_position[joint] + i
        before = position[world, at]
        step = (
            timestep[world % timestep.shape[0]] * velocity[world, joint_dof[joint] + i]
            + lost[world, at]
        )
        after = before + step
        missing = step - (after - before)
        if not wp.abs(after - qpos[world, at]) <= NEAR * wp.max(1.0, wp.abs(after)):
            after = qpos[world, at]
            missing = 0.0
        qpos[world, at] = after
        position[world, at] = after
        lost[world, at] = missing
