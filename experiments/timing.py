"""Timing of frames in the middle of the shake, without first simulating the way there in every world."""

import time
from collections.abc import Callable

import newton
import numpy as np
import warp as wp
from newton.solvers import SolverMuJoCo

from experiments.simulation import Simulation

TASK_ARRAYS = "phase elapsed phase_start_q goal target_position target_rotation target_finger solution".split()
STATE_ARRAYS = "joint_q joint_qd body_q body_qd".split()
ENGINE_ARRAYS = "qpos qvel qacc_warmstart".split()


def put_in_state_of(target: Simulation, source: Simulation, world: int = 0) -> None:
    """Put every world of ``target`` into the state of one world of ``source``, task and solver included."""
    pairs = [(getattr(target.task, name), getattr(source.task, name)) for name in TASK_ARRAYS]
    pairs += [(getattr(target.state, name), getattr(source.state, name)) for name in STATE_ARRAYS]
    pairs += [(getattr(target.solver.mjw_data, name), getattr(source.solver.mjw_data, name)) for name in ENGINE_ARRAYS]
    wp.synchronize()  # simulations run on streams of their own, these copies do not
    for to, of in pairs:
        one = of.numpy().reshape(source.world_count, -1)[world : world + 1]
        to.assign(np.repeat(one, target.world_count, axis=0).reshape(to.numpy().shape))
    wp.synchronize()


def replay_ms(device: wp.Device, queue: Callable[[], None], repeat_count: int, warmup_count: int = 3) -> np.ndarray:
    """Wall time [ms] of each replay of what ``queue`` queues, captured as one graph; shape [repeat_count]."""
    with wp.ScopedDevice(device):
        queue()
        with wp.ScopedCapture() as capture:
            queue()
        for _ in range(warmup_count):
            wp.capture_launch(capture.graph)
        return _timed(device, lambda: wp.capture_launch(capture.graph), repeat_count)


def frame_ms(simulation: Simulation, repeat_count: int, warmup_count: int = 3) -> np.ndarray:
    """Wall time [ms] of each of ``repeat_count`` frames as the simulation runs them."""
    for _ in range(warmup_count):
        simulation.step()
    return _timed(simulation.device, simulation.step, repeat_count)


def elapsed_ms(device: wp.Device, run: Callable[[], None]) -> float:
    """Wall time [ms] of one call, until the device is done with it."""
    wp.synchronize_device(device)
    start = time.perf_counter()
    run()
    wp.synchronize_device(device)
    return 1e3 * (time.perf_counter() - start)


def _timed(device: wp.Device, run: Callable[[], None], repeat_count: int) -> np.ndarray:
    return np.array([elapsed_ms(device, run) for _ in range(repeat_count)])


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
