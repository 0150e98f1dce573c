"""Time and memory from one world to many, with the engine's own step on the same batch as the floor."""

import gc
from dataclasses import replace

import numpy as np
import warp as wp

from experiments.case import FIXED
from experiments.measurement import SETUP_FRAME_COUNT, Conditions, Measurement
from experiments.simulation import Simulation
from experiments.timing import buffer_bytes_per_world, frame_ms, put_in_state_of, replay_ms

WORLD_COUNTS = {"full": (1, 4, 16, 64, 256, 1024, 4096, 16384), "quick": (1, 4, 16)}
SHAKE_FRAME = SETUP_FRAME_COUNT + 30
REPEAT_COUNT = 20


def measure(conditions: Conditions) -> Measurement:
    device = wp.get_device(conditions.device)
    pilot = Simulation([replace(FIXED, frame_count=SHAKE_FRAME + 1)], device)
    for _ in range(SHAKE_FRAME):
        pilot.step()
    counts = WORLD_COUNTS["quick" if conditions.quick or not conditions.is_cuda else "full"]
    return Measurement([time_worlds(pilot, world_count, device) for world_count in counts])


def time_worlds(pilot: Simulation, world_count: int, device: wp.Device) -> dict[str, object]:
    """Time whole frames and, on the same batch in the same state, as many bare steps of the engine."""
    case = replace(FIXED, frame_count=REPEAT_COUNT + 8)
    gc.collect()  # frees the batch before
    before = memory_bytes(device)
    simulation = Simulation([case] * world_count, device)
    put_in_state_of(simulation, pilot)
    frames = frame_ms(simulation, REPEAT_COUNT)
    after = memory_bytes(device)

    def bare_steps() -> None:
        for _ in range(case.substeps):
            simulation.solver._mujoco_warp_step()

    steps = replay_ms(device, bare_steps, REPEAT_COUNT)
    row = {
        "case": f"worlds-{world_count}",
        "worlds": world_count,
        "frame_ms": float(np.median(frames)),
        "frame_ms_p5": float(np.percentile(frames, 5)),
        "frame_ms_p95": float(np.percentile(frames, 95)),
        "mjw_step_ms": float(np.median(steps)),
        "repeat_count": REPEAT_COUNT,
        "world_substeps_per_s": world_count * case.substeps / (1e-3 * float(np.median(frames))),
        "buffer_bytes_per_world": buffer_bytes_per_world(simulation.solver, simulation.contacts),
        "bytes_per_world": None if before is None else (after - before) // world_count,
    }
    if before is None:
        row["bytes_per_world_reason"] = "warp counts memory on CUDA devices only"
    return row


def memory_bytes(device: wp.Device) -> int | None:
    """Memory that warp has taken on a CUDA device [B]; None on the CPU."""
    if not device.is_cuda:
        return None
    wp.synchronize_device(device)
    return wp.get_mempool_used_mem_current(device)
