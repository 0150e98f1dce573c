"""Provide start states in the middle of the shake for timing, and validate times."""

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
from experiments.simulation.simulation import Simulation

TASK_ARRAYS = "phase elapsed phase_start goal target_position target_rotation target_finger solution".split()
STATE_ARRAYS = "joint_q joint_qd".split()
ENGINE_ARRAYS = "qpos qvel qacc_warmstart ctrl".split()
WATCHED_ARRAYS = {  # sums of the recorder over all frames, with their start values
    "peak_constraint": 0,
    "peak_iteration": 0,
    "contact_overflow": NO_FRAME,
    "constraint_overflow": NO_FRAME,
}
SHAKE_FRAME_COUNT = 30  # frames of shake before the timed frames
WARMUP_COUNT = 3


def run_frames(simulation: Simulation, frame_count: int) -> None:
    for _ in range(frame_count):
        simulation.step()


def in_the_shake(cases: Sequence[Case], device: wp.Device) -> Simulation:
    """Return a simulation with a world for each case in the shake's first cycle.

    Other simulations copy their state from it.
    """
    simulation = Simulation([replace(case, frame_count=1) for case in cases], device)
    run_frames(simulation, SETUP_FRAME_COUNT + SHAKE_FRAME_COUNT)
    return simulation


def put_in_state_of(target: Simulation, source: Simulation, world: int = 0) -> None:
    """Put every world of ``target`` into the state of one world of ``source``.

    This includes the task and the solver. Earlier recordings are reset, because one
    simulation may run several cases in turn.
    """
    pairs = [
        (getattr(target.task, name), getattr(source.task, name)) for name in TASK_ARRAYS
    ]
    pairs += [
        (getattr(target.state, name), getattr(source.state, name))
        for name in STATE_ARRAYS
    ]
    pairs += [
        (getattr(target.solver.mjw_data, name), getattr(source.solver.mjw_data, name))
        for name in ENGINE_ARRAYS
    ]
    wp.synchronize()  # simulations have their own streams, but these copies do not
    for to, of in pairs:
        state = of.reshape((source.world_count, -1))[world]
        # A stride of 0 between worlds repeats this state, so that the copy never leaves
        # the device.
        shape, strides = (target.world_count, *state.shape), (0, *state.strides)
        repeated = wp.array(
            ptr=state.ptr,
            dtype=state.dtype,
            shape=shape,
            strides=strides,
            device=state.device,
        )
        wp.copy(to.reshape((target.world_count, -1)), repeated)
    for name, start in WATCHED_ARRAYS.items():
        getattr(target.recorder, name).fill_(start)
    newton.eval_fk(
        target.model, target.state.joint_q, target.state.joint_qd, target.state
    )
    wp.synchronize()


def elapsed_ms(device: wp.Device, run: Callable[[], None]) -> float:
    """Return the time of a call until the device is done [ms]."""
    wp.synchronize_device(device)
    start = time.perf_counter()
    run()
    wp.synchronize_device(device)
    return 1e3 * (time.perf_counter() - start)


def memory_bytes(device: wp.Device) -> int:
    """Return the memory that Warp uses on a CUDA device [B], or 0 on the CPU."""
    if not device.is_cuda:
        return 0
    wp.synchronize_device(device)
    return wp.get_mempool_used_mem_current(device)


def invalid_reason(case: Case, trace: Trace) -> str | None:
    """Return the reason why the frame times of a run are not valid, or None.

    A run that overflows, stops early or is not finite does not take a representative
    time.
    """
    if trace.failure:
        return trace.failure.detail
    if metrics.is_dropped(trace):
        return "the cube left the grasp"
    if trace.peak_iteration_count >= case.iterations:
        return f"the solver used all of its {case.iterations} iterations"
    return None


def batch_invalid_reason(simulation: Simulation) -> str | None:
    """Return the reason why the frame times of a simulation are not valid in one of its
    worlds, or None.
    """
    reasons = (
        invalid_reason(simulation.case, trace) for trace in simulation.recorder.traces()
    )
    return next(filter(None, reasons), None)


def wall_time(traces: Sequence[Trace]) -> dict[str, object]:
    """Return the wall time of a batch of whole runs, or a reason if one of them has
    failed.
    """
    reason = next((str(trace.failure) for trace in traces if trace.failure), None)
    return (
        absent(["wall_s"], f"not timed: {reason}")
        if reason
        else {"wall_s": traces[0].wall_s}
    )


def spread(name: str, values: np.ndarray) -> dict[str, float | int]:
    """Return the median, the 5th and 95th percentiles and the count as columns."""
    median, low, high = (float(value) for value in np.percentile(values, (50, 5, 95)))
    return {
        name: median,
        f"{name}_p5": low,
        f"{name}_p95": high,
        "repeat_count": len(values),
    }


def buffer_bytes_per_world(
    solver: SolverMuJoCo, contacts: newton.Contacts | None
) -> int:
    """Return the memory of the contact and constraint buffers per world [B].

    This includes the buffers of the engine and of Newton.
    """
    data = solver.mjw_data
    holders = [data.contact, data.efc] + ([contacts] if contacts is not None else [])
    arrays = {
        value.ptr: value.capacity
        for holder in holders
        for value in vars(holder).values()
        if isinstance(value, wp.array) and value.ptr
    }
    return sum(arrays.values()) // data.nworld
