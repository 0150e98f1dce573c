"""Measure the time and the memory of one to 16,384 worlds.

They are compared with the engine's own steps, which are a lower bound, and with its
benchmark.
"""

import gc

from experiments.facts.case import FIXED
from experiments.scaling.testspeed import STEP_COUNTS, measure_ways
from experiments.simulation.frame_benchmark import (
    RATIO,
    TIMES,
    EngineSteps,
    WarmState,
    build_frames,
    untimed,
    warm_state,
    world_rate,
)
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.simulation.paired_timing import time_in_turn
from experiments.simulation.timing import batch_invalid_reason, memory_bytes, spread
from measured_report.measuring.batch import Batch, Plan

WORLD_COUNTS = {"full": (1, 4, 16, 64, 256, 1024, 4096, 16384), "quick": (1, 4, 16)}
STEPS = ("mjw_step_ms", "mjw_step_ms_p5", "mjw_step_ms_p95")
# Columns without a number if the frames are not valid.
ABSENT = (
    *TIMES,
    *STEPS,
    "world_substeps_per_s",
)


def measure(conditions: Conditions) -> Plan:
    timed = [Batch("worlds", measure_worlds, (conditions,), exclusive=True)]
    if conditions.is_cuda:  # the engine's benchmark needs CUDA
        yield [Batch("compile", measure_ways, (conditions, 1, 2))]
        for count, step_count in STEP_COUNTS.items():
            timed.append(
                Batch(
                    f"ways-{count}",
                    measure_ways,
                    (conditions, count, step_count),
                    exclusive=True,
                )
            )
    rows_by_batch = yield timed
    return Measurement([row for rows in rows_by_batch for row in rows])


def measure_worlds(conditions: Conditions) -> list[dict[str, object]]:
    """Return a row for each number of worlds; all are built before one is timed."""
    warm = warm_state(conditions.device)
    counts = WORLD_COUNTS[
        "quick" if conditions.quick or not conditions.is_cuda else "full"
    ]
    built = [Worlds(warm, world_count) for world_count in counts]
    return [worlds.row() for worlds in built]


class Worlds:
    """A batch of ``world_count`` worlds whose frames and engine steps are timed."""

    def __init__(self, warm: WarmState, world_count: int):
        self.world_count = world_count
        gc.collect()  # the memory of the previous batch must not count
        before = memory_bytes(warm.device)
        self.frames = build_frames(FIXED, world_count, warm)
        self.bytes_per_world = (memory_bytes(warm.device) - before) // world_count
        self.steps = EngineSteps(self.frames) if warm.device.is_cuda else None

    def row(self) -> dict[str, object]:
        """Return a row with the times of frames and steps, measured in turn."""
        frames = self.frames
        row: dict[str, object] = {
            "case": f"worlds-{self.world_count}",
            "worlds": self.world_count,
        }
        if self.steps is None:
            [found] = time_in_turn([frames])
            row |= absent(
                ["bytes_per_world"], "warp counts memory on CUDA devices only"
            )
            reason = "steps within a frame are timed on CUDA devices only"
            row |= frames.columns(found) | absent(("mjw_step_ms", *RATIO), reason)
        else:
            row["bytes_per_world"] = self.bytes_per_world
            of_steps, found = time_in_turn([self.steps, frames])
            row |= frames.columns(found) | spread("mjw_step_ms", of_steps.times)
        if reason := frames.reason or batch_invalid_reason(frames.simulation):
            return row | untimed(ABSENT, reason)
        return row | world_rate(FIXED, self.world_count, found)
