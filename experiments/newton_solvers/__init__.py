"""Newton's own solvers beside MuJoCo Warp: a box on a table in each, and the shake itself in SolverSteel.

The solvers are those that the release offers. Where it has no SolverSteel there is nothing of the shake.
"""

import gc
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import warp as wp

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case
from experiments.facts.trace import Trace
from experiments.newton_solvers import box
from experiments.newton_solvers.steel import VARIANTS, SteelSimulation
from experiments.simulation import frame_benchmark
from experiments.simulation.frame_benchmark import BLOCK_FRAME_COUNT, LARGE_BATCH, TIMES, untimed
from experiments.simulation.measurement import Conditions, Measurement, absent, summarize
from experiments.simulation.paired_timing import time_in_turn
from experiments.simulation.simulation import Simulation, run
from experiments.simulation.task import FRAME_RATE, LIFT, PHASE_SECONDS
from experiments.simulation.timing import SHAKE_FRAME_COUNT, batch_invalid_reason, elapsed_ms, run_frames
from measured_report.measuring.batch import Batch, Plan, is_out_of_memory

WEIGHTLESS = replace(AS_SHIPPED, gravity_m_s2=0.0, cube_mu=AS_SHIPPED.pad_mu)
"""Without what Steel lacks: gravity compensation, and a priority that says whose friction counts."""
SHAKES = {
    "3cm": WEIGHTLESS,
    "10cm": replace(WEIGHTLESS, shake_amplitude_m=0.1),
    "held": replace(WEIGHTLESS, shake_amplitude_m=0.0),
    "weight": replace(WEIGHTLESS, gravity_m_s2=AS_SHIPPED.gravity_m_s2),
}
QUICK_VARIANTS = ("steel", "steel-points", "steel-32-rows")
TIMED_VARIANTS = ("steel", "steel-points")
WORLD_COUNTS = {"cuda": (1, 4096, 16384), "cpu": (1,)}
START_FRAME_COUNT = round(PHASE_SECONDS[LIFT] * FRAME_RATE) + SHAKE_FRAME_COUNT
"""Frames from a cube in the hand into the shake."""
GRASP = ("creep_mm_per_cycle", "friction_share", "normal_force_n", "penetration_mm")


def measure(conditions: Conditions) -> Plan:
    """Make a row for each solver, scene and step, for each variant of Steel and shake, and for each time of a frame."""
    boxes = box.variants()
    batches = [Batch(f"box-{variant.name}", box.rows_of, (conditions, variant)) for variant in boxes]
    if any(variant.solver == "SolverSteel" for variant in boxes):
        counts = WORLD_COUNTS["cuda" if conditions.is_cuda and not conditions.quick else "cpu"]
        batches.append(Batch("shakes", measure_shakes, (conditions,)))
        batches += [Batch(f"worlds-{count}", measure_times, (conditions, count), exclusive=True) for count in counts]
    found = yield batches
    return Measurement([*box.excused_rows(), *(row for rows in found for row in rows)])


def measure_shakes(conditions: Conditions) -> list[dict[str, object]]:
    """Return a row for each variant and shake, MuJoCo Warp first; each variant is one simulation of all shakes."""
    variants = [each for each in VARIANTS if not conditions.quick or each.name in QUICK_VARIANTS]
    cases = [replace(case, frame_count=conditions.frame_count(case.frame_count)) for case in SHAKES.values()]
    device = wp.get_device(conditions.device)
    steels = [SteelSimulation(variant, cases, device, is_counting=True) for variant in variants]
    mujoco, *found = run([Simulation(cases, device), *steels], title="steel")
    rows = [row_of("warp", *each) for each in zip(SHAKES, cases, mujoco, strict=True)]
    for variant, simulation, traces in zip(variants, steels, found, strict=True):
        peak = simulation.solver.constraint_row_watermarks()["articulation_raw_high_water"]
        counted = {"peak_constraint_count": peak}  # of all its worlds: those that had room, and those that asked for it
        rows += [row_of(variant.name, *each) | counted for each in zip(SHAKES, cases, traces, strict=True)]
    return rows


def row_of(variant: str, shake: str, case: Case, trace: Trace) -> dict[str, object]:
    """Make a row: slip, drift, and means over the shake of what the grasp takes."""
    case = replace(case, name=f"{variant}-{shake}")
    row = {**summarize(case, trace), "backend": variant.split("-")[0], "variant": variant, "shake": shake}
    if row["slip_mm"] is None:
        return row | absent(GRASP, row["slip_mm_reason"])
    normal_n, tangential_n, depth_m = (
        metrics.shake_mean(trace, column) for column in ("normal_force_n", "tangential_force_n", "penetration_m")
    )
    drift_mm = metrics.cycle_drift_mm(metrics.displacement(trace), case.shake_frequency_hz)
    share = tangential_n / (case.pad_mu * normal_n) if normal_n > 0.0 else np.nan
    numbers = dict(zip(GRASP, map(float, (drift_mm, share, normal_n, 1e3 * depth_m)), strict=True))
    untouched = [name for name, number in numbers.items() if not np.isfinite(number)]
    return row | numbers | absent(untouched, "the fingers did not touch the cube")


def measure_times(conditions: Conditions, world_count: int) -> list[dict[str, object]]:
    """Return a row for MuJoCo Warp, which the others are compared with, and for each of Steel's variants."""
    variants = [None, *(each for each in VARIANTS if each.name in TIMED_VARIANTS)]
    rows, blocks = {}, {}
    for variant in variants:
        name = variant.name if variant else "warp"
        rows[name] = {"case": f"{name}-worlds-{world_count}", "variant": name, "worlds": world_count}
        try:
            blocks[name] = Blocks(variant, world_count, wp.get_device(conditions.device))
        except (RuntimeError, MemoryError) as error:
            if not is_out_of_memory(error):
                raise
            rows[name] |= absent(TIMES, " ".join(str(error).split())[:120])
    for name, times in zip(blocks, time_in_turn(list(blocks.values())), strict=True):
        reason = batch_invalid_reason(blocks[name].simulation)
        rows[name] |= untimed(TIMES, reason) if reason else frame_benchmark.time_columns(times)
    blocks.clear()
    gc.collect()
    return list(rows.values())


class Blocks:
    """Blocks of frames of the shake, one after the other, in worlds that all do the same."""

    def __init__(self, variant: box.Variant | None, world_count: int, device: wp.Device):
        case = replace(WEIGHTLESS, name="timed", cube_in_hand=True, frame_count=1)
        cases: Sequence[Case] = [case] * world_count
        self.simulation = SteelSimulation(variant, cases, device) if variant else Simulation(cases, device)
        self.frame_count = max(1, min(BLOCK_FRAME_COUNT, LARGE_BATCH // world_count)) if device.is_cuda else 1
        run_frames(self.simulation, START_FRAME_COUNT)

    def __call__(self, _: int) -> float:
        """Time a frame [ms], mean of a block."""
        ms = elapsed_ms(self.simulation.device, lambda: run_frames(self.simulation, self.frame_count))
        return ms / self.frame_count
