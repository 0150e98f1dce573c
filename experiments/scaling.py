"""Time and memory from one world to many, with the engine's own steps in the same frames as the floor."""

import gc
from dataclasses import replace

import numpy as np
import warp as wp

from experiments.facts.case import FIXED
from experiments.simulation.comparing import RATIO, TIMED, Frames, Pilot
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.simulation.resolving import in_turn
from experiments.simulation.simulation import Simulation
from experiments.simulation.timing import EngineSteps, batch_invalid_reason, spread
from measured_report.measuring.batch import Plan, timing

WORLD_COUNTS = {"full": (1, 4, 16, 64, 256, 1024, 4096, 16384), "quick": (1, 4, 16)}
STEPS = ("mjw_step_ms", "mjw_step_ms_p5", "mjw_step_ms_p95")
ABSENT = (*(name for name in TIMED if name != "buffer_bytes_per_world"), "world_substeps_per_s")


def measure(conditions: Conditions) -> Plan:
    [rows] = yield [timing("worlds", measure_worlds, conditions)]
    return Measurement(rows)


def measure_worlds(conditions: Conditions) -> list[dict[str, object]]:
    """A row for each number of worlds."""
    device = wp.get_device(conditions.device)
    pilot = Pilot([FIXED], device)
    counts = WORLD_COUNTS["quick" if conditions.quick or not conditions.is_cuda else "full"]
    return [time_worlds(pilot, world_count) for world_count in counts]


def time_worlds(pilot: Pilot, world_count: int) -> dict[str, object]:
    """Time whole frames against what the engine's own steps take of them, in the same batch in turn."""
    case = replace(FIXED, frame_count=1)  # the recorder keeps the last frame only
    gc.collect()  # frees the batch before
    before = memory_bytes(pilot.device)
    simulation = Simulation([case] * world_count, pilot.device)
    frames = Frames(simulation, case, pilot)
    after = memory_bytes(pilot.device)
    row: dict[str, object] = {"case": f"worlds-{world_count}", "worlds": world_count}
    if before is None or after is None:
        row |= absent(["bytes_per_world"], "warp counts memory on CUDA devices only")
        [found] = in_turn([frames])
        row |= frames.columns(found) | absent(
            ("mjw_step_ms", *RATIO), "steps within a frame are timed on CUDA devices only"
        )
    else:
        row["bytes_per_world"] = (after - before) // world_count
        steps = EngineSteps(simulation)

        def steps_ms(number: int) -> float:
            pilot.put(simulation, case, number)
            return steps.frame_ms(frames.frame_count)

        of_steps, found = in_turn([steps_ms, frames])
        row |= frames.columns(found) | spread("mjw_step_ms", of_steps.times)
    if reason := frames.reason or batch_invalid_reason(simulation):
        return row | absent((*ABSENT, *STEPS), f"not timed: {reason}")
    rate = world_count * case.substeps / (1e-3 * float(np.median(found.times)))
    return row | {"world_substeps_per_s": rate}


def memory_bytes(device: wp.Device) -> int | None:
    """Memory that warp has taken on a CUDA device [B]; None on the CPU."""
    if not device.is_cuda:
        return None
    wp.synchronize_device(device)
    return wp.get_mempool_used_mem_current(device)
