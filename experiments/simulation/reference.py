"""Run the shake in MuJoCo's own loop in C, in double precision and without Newton.

This is the reference, and it shows the speed of one core.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import mujoco
import numpy as np
import warp as wp

import contact_bias_c
from experiments.facts import metrics
from experiments.facts.case import Case
from experiments.facts.trace import FRAME_COLUMNS, Trace
from experiments.simulation.c_warnings import failure_of
from experiments.simulation.scene import ROBOT_DOF_COUNT, TRACKED_BODIES
from experiments.simulation.simulation import Simulation
from experiments.simulation.task import FRAME_RATE
from newton_lint.newton_models.compat import kf_is_read

ENGINES_AGREE = {"pad_kf": -1.0} if kf_is_read() else {}  # type: dict
"""Parameters with which MuJoCo Warp and the C engine have the same model.

The C engine does not support the timeconst that kf sets for friction rows.
"""
SETUP_FRAME_LIMIT = 600
# The bodies in a trace of the native loop.
BODIES = TRACKED_BODIES[: max(metrics.CUBE, metrics.TCP) + 1]


@dataclass(frozen=True)
class Start:
    """The start state of a run in solver coordinates, and its joint targets."""

    qpos: np.ndarray
    qvel: np.ndarray
    qacc_warmstart: np.ndarray
    targets: np.ndarray  # joint position targets of each frame, shape [frames, 9]


def pilot_at_shake(cases: Sequence[Case], device: wp.Device) -> Simulation:
    """Return a simulation with a world for each case, at the start of the shake.

    Raises:
        RuntimeError: The shake was not reached within SETUP_FRAME_LIMIT frames.
    """
    pilot = Simulation(
        [replace(case, frame_count=SETUP_FRAME_LIMIT) for case in cases], device
    )
    for _ in range(SETUP_FRAME_LIMIT):
        pilot.step()
        wp.synchronize_device(device)
        if pilot.task.phase.numpy().min() >= metrics.SHAKE:
            return pilot
    raise RuntimeError(f"the shake was not reached within {SETUP_FRAME_LIMIT} frames")


def starts_of(pilot: Simulation, frame_count: int) -> list[Start]:
    """Return the state of each pilot world and the targets of the next frames.

    The pilot runs on to compute them. The targets of the shake depend only on time and
    on the place where the shake began, so all runs get the same targets.
    """
    data = pilot.solver.mjw_data
    state = {
        name: getattr(data, name).numpy().astype(float)
        for name in ("qpos", "qvel", "qacc_warmstart")
    }
    targets = np.zeros((frame_count, pilot.world_count, ROBOT_DOF_COUNT))
    for frame in range(frame_count):
        pilot.step()
        wp.synchronize_device(pilot.device)
        targets[frame] = pilot.joint_target.numpy()[:, :ROBOT_DOF_COUNT]
    return [
        Start(
            **{name: values[world] for name, values in state.items()},
            targets=targets[:, world],
        )
        for world in range(pilot.world_count)
    ]


class NativeShake:
    """Run one case in MuJoCo's C engine on one core, in Newton's model.

    A frame sets the joint targets and calls ``mj_step`` once for all its substeps. The
    state is not rounded to float32, as it would be with Newton. Other threads can run
    during ``mj_step``.
    """

    def __init__(self, case: Case, start: Start):
        simulation = Simulation([replace(case, backend="mujoco")], wp.get_device("cpu"))
        solver, links = simulation.solver, simulation.scene.links
        of_newton = solver.mjc_body_to_newton.numpy()[0].tolist()
        self.case, self.start = case, start
        self.model, self.data = solver.mj_model, solver.mj_data
        self.model.opt.timestep = 1.0 / FRAME_RATE / case.substeps
        self.bodies = [of_newton.index(links[name].body) for name in BODIES]
        self.offsets = np.array([links[name].pose for name in BODIES], dtype=float)
        self.pad = (
            solver.mjc_geom_to_newton_shape.numpy()[0]
            .tolist()
            .index(simulation.scene.pads[0])
        )
        self.frame_index = 0
        self.data.qpos[:], self.data.qvel[:] = start.qpos, start.qvel
        self.data.qacc_warmstart[:] = start.qacc_warmstart

    def frame(self) -> None:
        """Run the next frame."""
        self.data.ctrl[:ROBOT_DOF_COUNT] = self.start.targets[self.frame_index]
        mujoco.mj_step(self.model, self.data, self.case.substeps)
        self.frame_index += 1

    def run(self) -> Trace:
        """Return the trace of the next ``case.frame_count`` frames.

        It contains the poses of BODIES, the cone use, and the iterations of each last
        substep.
        """
        frame_count = self.case.frame_count
        poses, phase = (
            np.zeros((frame_count, len(BODIES), 7)),
            np.zeros(frame_count, dtype=int),
        )
        contacts = np.full((frame_count, len(FRAME_COLUMNS)), np.nan)
        failure, peak_iteration = None, 0
        for frame in range(frame_count):
            self.frame()
            poses[frame], phase[frame] = self._poses(), self._phase()
            contacts[frame, FRAME_COLUMNS.index("cone_use")] = self._cone_use()
            peak_iteration = max(peak_iteration, int(self.data.solver_niter.max()))
            failure = failure or failure_of(self.data, frame)
        return Trace(
            frame_dt=1.0 / FRAME_RATE,
            phase=phase,
            poses=poses,
            contacts=contacts,
            failure=failure,
            peak_iteration_count=peak_iteration,
        )

    @property
    def pad_timeconst_s(self) -> float:
        """Return the timeconst of the pads' contacts in the model [s].

        MuJoCo later raises it to at least two substeps.
        """
        return float(self.model.geom_solref[self.pad, 0])

    def _phase(self) -> int:
        return metrics.SHAKE

    def _poses(self) -> np.ndarray:
        # A step updates the joint positions, but not yet the poses of the bodies.
        mujoco.mj_kinematics(self.model, self.data)
        poses, quaternion = np.zeros((len(self.bodies), 7)), np.zeros(4)
        for pose, body, offset in zip(poses, self.bodies, self.offsets, strict=True):
            pose[:3] = (
                self.data.xpos[body] + self.data.xmat[body].reshape(3, 3) @ offset[:3]
            )
            mujoco.mju_mulQuat(
                quaternion, self.data.xquat[body], np.roll(offset[3:], 1)
            )
            pose[3:] = np.roll(quaternion, -1)
        return poses

    def _cone_use(self) -> float:
        force, largest = np.zeros(6), 0.0
        for index in range(self.data.ncon):
            mujoco.mj_contactForce(self.model, self.data, index, force)
            if force[0] > 0.0:
                friction = self.data.contact[index].friction[0]
                largest = max(
                    largest, float(np.hypot(force[1], force[2]) / (friction * force[0]))
                )
        return largest


class DoubleShake(NativeShake):
    """Run a case from the approach to the end of the shake in double precision.

    Newton is used only to build the model and to plan.
    """

    def __init__(self, case: Case, *, has_midphase: bool):
        bare = replace(case, contact_bias=False, bias_centred=False, backend="mujoco")
        self.simulation = Simulation([bare], wp.get_device("cpu"))
        qpos = self.simulation.model.joint_q.numpy().astype(float)
        # The orientation of the cube, which MuJoCo writes with w first.
        qpos[ROBOT_DOF_COUNT + 3 :] = (
            1.0,
            0.0,
            0.0,
            0.0,
        )
        rest = np.zeros(len(qpos) - 1)
        super().__init__(
            bare, Start(qpos, rest, rest, targets=np.zeros((0, ROBOT_DOF_COUNT)))
        )
        self.term = (
            partial(contact_bias_c.subtract_bias, centred=case.bias_centred)
            if case.contact_bias
            else None
        )
        if not has_midphase:
            self.model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_MIDPHASE)
        self.newton_bodies = self.simulation.solver.mjc_body_to_newton.numpy()[0]

    def run(self) -> Trace:
        # The callback applies to all models, so it is set only while this one is
        # stepped.
        mujoco.set_mjcb_control(self.term)
        try:
            return super().run()
        finally:
            mujoco.set_mjcb_control(None)

    def _phase(self) -> int:
        return int(self.simulation.task.phase.numpy()[0])

    def frame(self) -> None:
        """Plan and run all substeps; the planner sees poses in single precision."""
        self.simulation.queue_targets()
        self.simulation.task.solve()
        self.data.ctrl[:ROBOT_DOF_COUNT] = self.simulation.joint_target.numpy()[
            0, :ROBOT_DOF_COUNT
        ]
        mujoco.mj_step(self.model, self.data, self.case.substeps)
        mujoco.mj_kinematics(self.model, self.data)
        body_q = self.simulation.body_q.numpy()[0]  # a view on the CPU
        for body, newton_body in enumerate(self.newton_bodies):
            if newton_body >= 0:
                body_q[newton_body] = (
                    *self.data.xpos[body],
                    *np.roll(self.data.xquat[body], -1),
                )
