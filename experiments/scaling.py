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
from experiments.simulation.timing import EngineSteps, batch_invalid_reason, memory_bytes, spread
from measured_report.measuring.batch import Batch, Plan

WORLD_COUNTS = {"full": (1, 4, 16, 64, 256, 1024, 4096, 16384), "quick": (1, 4, 16)}
STEPS = ("mjw_step_ms", "mjw_step_ms_p5", "mjw_step_ms_p95")
ABSENT = (*(name for name in TIMED if name != "buffer_bytes_per_world"), "world_substeps_per_s")


def measure(conditions: Conditions) -> Plan:
    [rows] = yield [Batch("worlds", measure_worlds, (conditions,), exclusive=True)]
    return Measurement(rows)


def measure_worlds(conditions: Conditions) -> list[dict[str, object]]:
    """A row for each number of worlds."""
    device = wp.get_device(conditions.device)
    pilot = Pilot([FIXED], device)
    counts = WORLD_COUNTS["quick" if conditions.quick or not conditions.is_cuda else "full"]
    built = [Worlds(pilot, world_count) for world_count in counts]
    return [worlds.row() for worlds in built]


class Worlds:
    """Whole frames in so many worlds, and what the engine's own steps take of them, ready to be timed."""

    def __init__(self, pilot: Pilot, world_count: int):
        self.world_count = world_count
        case = replace(FIXED, frame_count=1)  # the recorder keeps the last frame only
        gc.collect()  # what the one before left behind must not count
        before = memory_bytes(pilot.device)
        simulation = Simulation([case] * world_count, pilot.device)
        self.frames = Frames(simulation, case, pilot)
        self.bytes_per_world = (memory_bytes(pilot.device) - before) // world_count
        self.steps = EngineSteps(simulation) if pilot.device.is_cuda else None

    def steps_ms(self, number: int) -> float:
        """Time of the engine's steps in a frame [ms], in the round of that number."""
        frames = self.frames
        frames.pilot.put(frames.simulation, frames.case, number)
        return self.steps.frame_ms(frames.frame_count)

    def row(self) -> dict[str, object]:
        """Time both in turn."""
        frames, case = self.frames, self.frames.case
        row: dict[str, object] = {"case": f"worlds-{self.world_count}", "worlds": self.world_count}
        if self.steps is None:
            row |= absent(["bytes_per_world"], "warp counts memory on CUDA devices only")
            [found] = in_turn([frames])
            row |= frames.columns(found) | absent(
                ("mjw_step_ms", *RATIO), "steps within a frame are timed on CUDA devices only"
            )
        else:
            row["bytes_per_world"] = self.bytes_per_world
            of_steps, found = in_turn([self.steps_ms, frames])
            row |= frames.columns(found) | spread("mjw_step_ms", of_steps.times)
        if reason := frames.reason or batch_invalid_reason(frames.simulation):
            return row | absent((*ABSENT, *STEPS), f"not timed: {reason}")
        return row | {"world_substeps_per_s": self.world_count * case.substeps / (1e-3 * float(np.median(found.times)))}
