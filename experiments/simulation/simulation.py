"""Run cases and return their traces. Compatible cases are worlds of one batch."""

import time
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from copy import copy
from dataclasses import replace
from functools import partial

import newton
import numpy as np
import warp as wp
from newton.solvers import SolverBase
from tqdm import tqdm

from experiments.facts.case import RUN_TIME_FIELDS, Case, CaseError, build_key
from experiments.facts.trace import Trace
from experiments.simulation.scene import ARM_DOF_COUNT, build_scene
from experiments.simulation.stepper import Stepper
from experiments.simulation.stepper_c import (
    MuJoCoStepper,
    batches,
    device_of,
    update_data_interval,
)
from experiments.simulation.task import FRAME_RATE, Task
from measured_report.measuring.pool import gather, processes, start

# Frames between two updates of the progress bar, which wait for the devices.
PROGRESS_FRAMES = 30


class Simulation:
    """Run cases with the same ``batch_key`` as the worlds of one batch."""

    # Creates the stepper from the scene and the cases.
    stepper_of: Callable[..., Stepper] = MuJoCoStepper

    def __init__(self, cases: Sequence[Case], device: wp.Device):
        newton.use_coord_layout_targets = True
        case, cases = cases[0], list(cases)
        self.case, self.cases, self.world_count, self.device = (
            case,
            cases,
            len(cases),
            device,
        )
        self.frame_dt = 1.0 / FRAME_RATE
        self.substep_dt = self.frame_dt / case.substeps
        self.stream = wp.Stream(device) if device.is_cuda else None
        self.stream_beside = wp.Stream(device) if device.is_cuda else None
        with wp.ScopedDevice(device):
            self.scene = build_scene(cases, device)
            self.model = self.scene.model
            self.stepper = self.stepper_of(self.scene, cases)
            self.pipeline, self.contacts = self.stepper.pipeline, self.stepper.contacts
            self._build_state()
            if case.ik_beside:
                self.task.plan(self.body_q)
                self.task.solve()
        # The arrays were written on the device's own stream and are used on another.
        wp.synchronize_device(device)
        self._start_uncaptured()

    def _build_state(self) -> None:
        """Build all state that frames change, except for the stepper's contacts."""
        self.task = Task(self.scene, self.cases)
        self._start_at_approach_pose()
        # A simulation that is built again has its own contacts.
        self.stepper = copy(self.stepper)
        self.stepper.contacts = self.contacts
        self.stepper.build(self.state, self.case.frame_count)
        self.solver, self.recorder = self.stepper.solver, self.stepper.recorder
        self._set_flags(self.solver)

    def _start_uncaptured(self) -> None:
        """Let the next step be captured again."""
        self.parts = [self.queue_targets, self.queue_physics]
        self.part_beside = self.task.solve if self.case.ik_beside else None
        self.captured = False

    def vary(self, case: Case) -> None:
        """Continue as another case that differs only in RUN_TIME_FIELDS.

        Its first step is captured again. The state does not change; see
        ``timing.put_in_state_of``.
        """
        case = replace(case, frame_count=self.case.frame_count)
        if build_key(case) != build_key(self.case):
            raise CaseError(
                f"{case.name} takes a simulation of its own: it differs in more than {RUN_TIME_FIELDS}"
            )
        self.case = case
        self.task.ik_iterations = case.ik_iterations
        self.solver.update_data_interval = update_data_interval(case)
        self._set_flags(self.solver)
        self._start_uncaptured()

    def _start_at_approach_pose(self) -> None:
        model = self.model
        joint_q = model.joint_q.numpy().reshape(self.world_count, -1)
        joint_q[:, :ARM_DOF_COUNT] = self.task.solution.numpy()[:, :ARM_DOF_COUNT]
        model.joint_q.assign(joint_q.reshape(-1))
        self.state = model.state()
        # There are no external forces. None means that the solver does not copy them in
        # every substep.
        self.state.body_f = None
        self.control = model.control()
        wp.copy(self.control.joint_target_q, model.joint_q)
        newton.eval_fk(model, model.joint_q, model.joint_qd, self.state)
        self.body_q = self.state.body_q.reshape((self.world_count, -1))
        self.joint_target = self.control.joint_target_q.reshape((self.world_count, -1))
        tcp = self.scene.links["fr3_hand_tcp"]
        poses, world = np.unique(
            self.body_q.numpy()[:, tcp.body], axis=0, return_inverse=True
        )
        starts = np.array([wp.transform(*pose) * tcp.pose for pose in poses])
        self.task.phase_start.assign(starts[world.reshape(-1)])

    def _set_flags(self, solver: SolverBase) -> None:
        self.stepper.case = self.case
        self.stepper.set_flags(solver)

    def queue_targets(self) -> None:
        """Queue the joint targets of this frame."""
        if self.case.ik_beside:
            self.task.command(self.body_q, self.joint_target)
            self.task.plan(self.body_q)
        else:
            self.task.plan(self.body_q)
            self.task.solve()
            self.task.command(self.body_q, self.joint_target)

    def queue_physics(self) -> None:
        """Queue collisions, substeps and recording of one frame."""
        self.recorder.begin_frame()
        for substep in range(self.case.substeps):
            self.stepper.step(substep, self.control, self.substep_dt)
            self.recorder.watch_substep()
        self.recorder.end_frame(self.body_q, self.task.phase)

    def frame(self) -> None:
        """Queue one frame, and run the IK of the next frame in parallel.

        The frame consists of targets, substeps and recording.
        """
        command, physics = self.parts
        command()
        if self.part_beside is not None:
            if self.stream_beside:  # the CPU has no streams
                self.stream_beside.wait_stream(self.stream)
            with wp.ScopedStream(self.stream_beside):
                # This must be first, because the long graph would block others on the
                # device.
                self.part_beside()
        physics()
        if self.part_beside is not None and self.stream_beside:
            self.stream.wait_stream(self.stream_beside)

    def step(self) -> None:
        """Run one frame, as graphs from the second frame on.

        The first step compiles and must not be captured. The work in parallel with the
        physics is a separate graph. The loops of the solver are conditional nodes, and
        Warp cannot capture these while a second stream is part of the capture. Warp
        also replays graphs on the CPU, which saves the cost of launching from Python.
        MuJoCo's C engine is not a kernel and is called frame by frame.
        """
        with wp.ScopedDevice(self.device), wp.ScopedStream(self.stream):
            self.frame()
            if self.case.graph and self.stepper.is_queued and not self.captured:
                self.parts = [captured(part) for part in self.parts]
                self.part_beside = self.part_beside and captured(self.part_beside)
                self.captured = True


def run(
    simulations: Sequence[Simulation],
    title: str = "",
    contact_frames: Sequence[int] = (),
) -> list[list[Trace]]:
    """Run all frames of all simulations side by side and return the traces by world.

    On CUDA, each simulation has a separate stream. A few worlds leave most of the
    device idle, so batches overlap. For the same reason, the frames of a shorter
    simulation are spread over the duration of the longest.

    Args:
        title: Title of the progress bar.
        contact_frames: Frames of the longest simulation after which all live contacts
            are kept.
    """
    for simulation in simulations:
        simulation.step()  # this compiles and captures, so the clock starts after it
    _synchronize(simulations)
    start = time.perf_counter()
    frame_count = max(
        (simulation.case.frame_count for simulation in simulations), default=0
    )
    for frame in tqdm(
        range(frame_count),
        desc=title,
        unit="frame",
        delay=3.0,
        miniters=PROGRESS_FRAMES,
    ):
        for simulation in simulations:
            if is_due(frame, simulation.case.frame_count, frame_count):
                simulation.step()
        if frame in contact_frames:
            _synchronize(simulations)
            for simulation in simulations:
                simulation.recorder.keep_contact_rows(frame)
        if (frame + 1) % PROGRESS_FRAMES == 0:
            _synchronize(simulations)
    _synchronize(simulations)
    wall_s = time.perf_counter() - start
    return [simulation.recorder.traces(wall_s) for simulation in simulations]


def is_due(frame: int, count: int, longest: int) -> bool:
    """Return whether a simulation of ``count`` frames runs at this frame.

    The first frame is not counted, because it runs before.
    """
    return frame * count // longest > max(0, frame - 1) * count // longest


def simulate(
    cases: Sequence[Case],
    *,
    device: str | None = None,
    contact_frames: Sequence[int] = (),
    title: str = "",
) -> list[Trace]:
    """Run every case and return its trace, in the order of the cases.

    Cases with the same ``batch_key`` are worlds of one simulation. Cases of MuJoCo's C
    engine have one simulation each, on the CPU. To time a case, run it in a separate
    call, because the simulations of a call run side by side. If there is a GPU,
    simulations on the CPU run in separate processes.

    Args:
        device: Warp device; None uses CUDA if it is available.
        contact_frames: Frames after which all live contacts are kept in the traces.
        title: Title of the progress bar.
    """
    has_away = wp.get_device(device).is_cuda and not contact_frames
    every = batches(cases)
    # Runs on the CPU have their own processes, in parallel with the GPU and with each
    # other.
    away = [
        members
        for members in every
        if has_away and device_of(cases[members[0]], device) == "cpu"
    ]
    nearby = [members for members in every if members not in away]
    near, far = (
        [[cases[index] for index in members] for members in side]
        for side in (nearby, away)
    )
    with processes(len(away)) if away else nullcontext() as pool:
        waiting = start(pool, run_groups, [([group], "cpu") for group in far])
        found = run_groups(near, device, title, contact_frames)
        found += [worlds for [worlds] in gather(waiting, f"{title}, on the CPU")]
    traces = {
        index: trace
        for members, worlds in zip(nearby + away, found, strict=True)
        for index, trace in zip(members, worlds, strict=True)
    }
    return [traces[index] for index in range(len(cases))]


def run_groups(
    groups: Sequence[Sequence[Case]],
    device: str | None,
    title: str = "",
    contact_frames: Sequence[int] = (),
) -> list[list[Trace]]:
    """Run groups of cases with the same ``batch_key`` side by side."""
    simulations = [
        Simulation(group, wp.get_device(device_of(group[0], device)))
        for group in groups
    ]
    return run(simulations, title, contact_frames)


def captured(queue: Callable[[], None]) -> Callable[[], None]:
    """Return a function that replays ``queue`` as a graph on the current stream."""
    with wp.ScopedCapture() as capture:
        queue()
    return partial(wp.capture_launch, capture.graph)


def _synchronize(simulations: Sequence[Simulation]) -> None:
    for alias in {simulation.device.alias for simulation in simulations}:
        wp.synchronize_device(alias)
