"""Timing of frames in the middle of the shake, without first simulating the way there in every world, and of whole
runs; and whether a time counts."""

import time
from collections.abc import Callable, Sequence
from dataclasses import replace

import newton
import numpy as np
import warp as wp
from newton.solvers import SolverMuJoCo

from experiments.facts import metrics
from experiments.facts.case import Case
from experiments.facts.trace import Trace
from experiments.simulation.measurement import SETUP_FRAME_COUNT, absent
from experiments.simulation.recorder import NO_FRAME
from experiments.simulation.simulation import Simulation, captured

TASK_ARRAYS = "phase elapsed phase_start goal target_position target_rotation target_finger solution".split()
STATE_ARRAYS = "joint_q joint_qd".split()
ENGINE_ARRAYS = "qpos qvel qacc_warmstart ctrl".split()
WATCHED_ARRAYS = {
    "peak_constraint": 0,
    "peak_iteration": 0,
    "contact_overflow": NO_FRAME,
    "constraint_overflow": NO_FRAME,
}
"""What the recorder adds up over all frames, and what it starts from."""
SHAKE_FRAME_COUNT = 30
"""Frames of shake before the frames that are timed."""
WARMUP_COUNT = 3


def in_the_shake(case: Case, device: wp.Device) -> Simulation:
    """A simulation of one world in the first cycle of the shake, from which others take their state."""
    simulation = Simulation([replace(case, frame_count=1)], device)
    for _ in range(SETUP_FRAME_COUNT + SHAKE_FRAME_COUNT):
        simulation.step()
    return simulation


def put_in_state_of(target: Simulation, source: Simulation, world: int = 0) -> None:
    """Put every world of ``target`` into the state of one world of ``source``, task and solver included.

    What was watched before does not count: one simulation may run several cases, one after the other.
    """
    pairs = [(getattr(target.task, name), getattr(source.task, name)) for name in TASK_ARRAYS]
    pairs += [(getattr(target.state, name), getattr(source.state, name)) for name in STATE_ARRAYS]
    pairs += [(getattr(target.solver.mjw_data, name), getattr(source.solver.mjw_data, name)) for name in ENGINE_ARRAYS]
    wp.synchronize()  # simulations run on streams of their own, these copies do not
    for to, of in pairs:
        one = of.reshape((source.world_count, -1))[world]
        # A step of 0 from one world to the next repeats this one, so the copy never leaves the device.
        shape, strides = (target.world_count, *one.shape), (0, *one.strides)
        every = wp.array(ptr=one.ptr, dtype=one.dtype, shape=shape, strides=strides, device=one.device)
        wp.copy(to.reshape((target.world_count, -1)), every)
    for name, start in WATCHED_ARRAYS.items():
        getattr(target.recorder, name).fill_(start)
    newton.eval_fk(target.model, target.state.joint_q, target.state.joint_qd, target.state)
    wp.synchronize()


def elapsed_ms(device: wp.Device, run: Callable[[], None]) -> float:
    """Wall time [ms] of one call, until the device is done with it."""
    wp.synchronize_device(device)
    start = time.perf_counter()
    run()
    wp.synchronize_device(device)
    return 1e3 * (time.perf_counter() - start)


def memory_bytes(device: wp.Device) -> int:
    """Memory that warp has taken on a CUDA device [B]; 0 on the CPU, where it doesn't count."""
    if not device.is_cuda:
        return 0
    wp.synchronize_device(device)
    return wp.get_mempool_used_mem_current(device)


def invalid_reason(case: Case, trace: Trace) -> str | None:
    """Why the time of frames of the shake does not count; None when it does. What overflows, stops early or is not
    finite does not take the time that the case takes."""
    if trace.failure:
        return trace.failure.detail
    if metrics.is_dropped(trace):
        return "the cube left the grasp"
    if trace.peak_iteration_count >= case.iterations:
        return f"the solver used all of its {case.iterations} iterations"
    return None


def batch_invalid_reason(simulation: Simulation) -> str | None:
    """The same of the frames that a simulation has run, in any of its worlds."""
    traces = simulation.recorder.traces(simulation.frame_dt, simulation.case.frame_count, wall_s=0.0)
    return next(filter(None, (invalid_reason(simulation.case, trace) for trace in traces)), None)


def wall_time(traces: Sequence[Trace]) -> dict[str, object]:
    """Wall time of a batch of whole runs as a column; None, with the reason, where it is not that of all its worlds.

    A cube that is dropped is what a hard shake may make of it, and its time counts.
    """
    reason = next((str(trace.failure) for trace in traces if trace.failure), None)
    if traces[0].world_count != len(traces):
        reason = "the memory is too small for all worlds at once"
    return absent(["wall_s"], f"not timed: {reason}") if reason else {"wall_s": traces[0].wall_s}


def spread(name: str, values: np.ndarray) -> dict[str, float | int]:
    """Measured values as columns: their median under ``name``, their 5th and 95th percentiles, and how many."""
    median, low, high = (float(value) for value in np.percentile(values, (50, 5, 95)))
    return {name: median, f"{name}_p5": low, f"{name}_p95": high, "repeat_count": len(values)}


class EngineSteps:
    """What the engine's own steps take of a frame, all substeps together; CUDA only.

    CUDA events around each ``mjw.step``, inside the graph of whole frames; the IK runs before the physics here, so that
    the engine has the device for itself.
    """

    def __init__(self, simulation: Simulation):
        self.simulation = simulation
        self.events: list[tuple[wp.Event, wp.Event]] = []
        solver, step = simulation.solver, simulation.solver._mujoco_warp_step

        def timed_step() -> None:
            start, end = (wp.Event(simulation.device, enable_timing=True) for _ in range(2))
            self.events.append((start, end))
            wp.record_event(start)
            step()
            wp.record_event(end)

        command, physics, solve = simulation.queue_targets, simulation.queue_physics, simulation.task.solve
        with wp.ScopedDevice(simulation.device), wp.ScopedStream(simulation.stream):
            solver._mujoco_warp_step = timed_step
            self.parts = [captured(command), captured(solve), captured(physics)]
            del solver._mujoco_warp_step

    def frame_ms(self, frame_count: int) -> float:
        """Time [ms] of the engine's steps in a frame, mean of ``frame_count``."""
        device, total = self.simulation.device, 0.0
        with wp.ScopedDevice(device), wp.ScopedStream(self.simulation.stream):
            for _ in range(frame_count):
                for part in self.parts:
                    part()
                wp.synchronize_device(device)
                total += sum(wp.get_event_elapsed_time(start, end) for start, end in self.events)
        return total / frame_count


def buffer_bytes_per_world(solver: SolverMuJoCo, contacts: newton.Contacts | None) -> int:
    """Memory of the contact and constraint buffers, the engine's and Newton's, per world [B]."""
    data = solver.mjw_data
    holders = [data.contact, data.efc] + ([contacts] if contacts is not None else [])
    arrays = {
        value.ptr: value.capacity
        for holder in holders
        for value in vars(holder).values()
        if isinstance(value, wp.array) and value.ptr
    }
    return sum(arrays.values()) // data.nworld
