"""Time and memory from one world to many, with the engine's own steps in the same frames as the floor."""

import gc
from dataclasses import replace

import warp as wp

from experiments.facts.case import FIXED
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.simulation.simulation import Simulation
from experiments.simulation.timing import (
    batch_invalid_reason,
    buffer_bytes_per_world,
    engine_ms,
    frame_ms,
    in_the_shake,
    put_in_state_of,
    spread,
)
from measured_report.measuring.batch import Batch, Plan

WORLD_COUNTS = {"full": (1, 4, 16, 64, 256, 1024, 4096, 16384), "quick": (1, 4, 16)}
REPEAT_COUNT = 40
FRAMES = ("frame_ms", "frame_ms_p5", "frame_ms_p95", "world_substeps_per_s")
STEPS = ("mjw_step_ms", "mjw_step_ms_p5", "mjw_step_ms_p95")


def measure(conditions: Conditions) -> Plan:
    [rows] = yield [Batch("worlds", measure_worlds, (conditions,), alone=True)]
    return Measurement(rows)


def measure_worlds(conditions: Conditions) -> list[dict[str, object]]:
    """A row for each number of worlds."""
    device = wp.get_device(conditions.device)
    pilot = in_the_shake(FIXED, device)
    counts = WORLD_COUNTS["quick" if conditions.quick or not conditions.is_cuda else "full"]
    return [time_worlds(pilot, world_count, device) for world_count in counts]


def time_worlds(pilot: Simulation, world_count: int, device: wp.Device) -> dict[str, object]:
    """Time whole frames and, on the same batch, what the engine's own steps take of them."""
    case = replace(FIXED, frame_count=1)  # the recorder keeps the last frame only
    gc.collect()  # frees the batch before
    before = memory_bytes(device)
    simulation = Simulation([case] * world_count, device)
    put_in_state_of(simulation, pilot)
    frames = spread("frame_ms", frame_ms(simulation, REPEAT_COUNT))
    after = memory_bytes(device)
    row = {
        "case": f"worlds-{world_count}",
        "worlds": world_count,
        **frames,
        "world_substeps_per_s": world_count * case.substeps / (1e-3 * frames["frame_ms"]),
        "buffer_bytes_per_world": buffer_bytes_per_world(simulation.solver, simulation.contacts),
    }
    if before is None:
        row |= absent(["bytes_per_world"], "warp counts memory on CUDA devices only")
    else:
        row["bytes_per_world"] = (after - before) // world_count
    row |= engine_columns(simulation)
    reason = batch_invalid_reason(simulation)
    return row | absent((*FRAMES, *STEPS), f"not timed: {reason}") if reason else row


def engine_columns(simulation: Simulation) -> dict[str, object]:
    """Time of the engine's own steps within frames of the same batch; None on the CPU."""
    if not simulation.device.is_cuda:
        return absent(["mjw_step_ms"], "steps within a frame are timed on CUDA devices only")
    return spread("mjw_step_ms", engine_ms(simulation, REPEAT_COUNT))


def memory_bytes(device: wp.Device) -> int | None:
    """Memory that warp has taken on a CUDA device [B]; None on the CPU."""
    if not device.is_cuda:
        return None
    wp.synchronize_device(device)
    return wp.get_mempool_used_mem_current(device)
