"""Run a box on a table and the shake in each of Newton's solvers and in MuJoCo Warp."""

import gc
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
import warp as wp

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case
from experiments.facts.trace import Trace
from experiments.newton_solvers import box
from experiments.newton_solvers.steel import VARIANTS, SteelStepper
from experiments.newton_solvers.stepper import SolverStepper
from experiments.simulation import frame_benchmark
from experiments.simulation.frame_benchmark import (
    BLOCK_FRAME_COUNT,
    LARGE_BATCH,
    TIMES,
    untimed,
)
from experiments.simulation.measurement import (
    Conditions,
    Measurement,
    absent,
    summarize,
)
from experiments.simulation.paired_timing import time_in_turn
from experiments.simulation.scene import TRACKED_BODIES
from experiments.simulation.simulation import Simulation, run
from experiments.simulation.task import FRAME_RATE, LIFT, PHASE_SECONDS
from experiments.simulation.timing import (
    SHAKE_FRAME_COUNT,
    batch_invalid_reason,
    elapsed_ms,
    run_frames,
)
from measured_report.measuring.batch import Batch, Plan

WEIGHTLESS = replace(
    AS_SHIPPED, gravity_m_s2=0.0, cube_mu=AS_SHIPPED.pad_mu, fixed_joints=False
)
"""The scene without features that some solvers lack.

These are gravity compensation, contact priority for friction, and links without mass.
"""
SHAKES = {
    "3cm": WEIGHTLESS,
    "10cm": replace(WEIGHTLESS, shake_amplitude_m=0.1),
    "held": replace(WEIGHTLESS, shake_amplitude_m=0.0),
    "weight": replace(WEIGHTLESS, gravity_m_s2=AS_SHIPPED.gravity_m_s2),
}
# The other solvers are compared with the solver of ``simulation``.
MUJOCO = box.Variant(
    "warp",
    "SolverMuJoCo",
)
QUICK_VARIANTS = ("warp", "xpbd", "steel", "steel-points", "steel-32-rows")
TIMED_VARIANTS = ("warp", "steel", "steel-points", "xpbd", "vbd", "kamino")
WORLD_COUNTS = {"cuda": (1, 4096, 16384), "cpu": (1,)}
START_FRAME_COUNT = round(PHASE_SECONDS[LIFT] * FRAME_RATE) + SHAKE_FRAME_COUNT
"""Number of frames, with the cube in the hand at the start, until the shake has begun.
"""
SLOW_MS = 100.0
"""Largest frame time of a solver that is also timed with more worlds.

Slower solvers would need minutes to reach the shake.
"""
FORCES = ("friction_share", "normal_force_n")
GRASP = ("creep_mm_per_cycle", *FORCES, "penetration_mm", "hand_amplitude_mm")


def measure(conditions: Conditions) -> Plan:
    """Return rows for each solver and scene, for each shake, and for each timing."""
    counts = WORLD_COUNTS[
        "cuda" if conditions.is_cuda and not conditions.quick else "cpu"
    ]
    shaken = [
        each
        for each in shaken_variants()
        if not conditions.quick or each.name in QUICK_VARIANTS
    ]
    timed = [each for name in TIMED_VARIANTS for each in shaken if each.name == name]
    batches = [
        Batch(f"box-{variant.name}", box.rows_of, (conditions, variant))
        for variant in box.variants()
    ]
    batches += [
        Batch(f"shakes-{variant.name}", measure_shakes, (conditions, variant))
        for variant in shaken
    ]
    batches.append(
        Batch("worlds", measure_times, (conditions, timed, counts), exclusive=True)
    )
    rows_by_batch = yield batches
    return Measurement(
        [*box.excused_rows(), *(row for rows in rows_by_batch for row in rows)]
    )


def shaken_variants() -> list[box.Variant]:
    """Return MuJoCo Warp, the other solvers, and Steel with single changes."""
    newton_variants = [
        variant
        for variant in box.variants()
        if variant.solver not in ("SolverMuJoCo", "SolverSteel")
    ]
    return [
        MUJOCO,
        *newton_variants,
        *(VARIANTS if "SolverSteel" in box.solver_classes() else ()),
    ]


def build(
    variant: box.Variant,
    cases: Sequence[Case],
    device: wp.Device,
    *,
    is_counting: bool = False,
) -> Simulation:
    """Return a simulation of the cases with a solver, one world for each.

    Steel may count the rows that it needs.
    """
    if variant == MUJOCO:
        return Simulation(cases, device)
    if variant.solver == "SolverSteel":
        return SolverSimulation(
            partial(SteelStepper, variant, is_counting=is_counting), cases, device
        )
    return SolverSimulation(partial(SolverStepper, variant), cases, device)


class SolverSimulation(Simulation):
    """Run a simulation with another stepper."""

    stepper: SolverStepper

    def __init__(
        self,
        stepper_of: Callable[..., SolverStepper],
        cases: Sequence[Case],
        device: wp.Device,
    ):
        self.stepper_of = stepper_of
        super().__init__(cases, device)

    @property
    def observed(self) -> object | None:
        return self.stepper.observed


def measure_shakes(
    conditions: Conditions, variant: box.Variant
) -> list[dict[str, object]]:
    """Return a row for each shake; all are worlds of one simulation."""
    cases = [
        replace(case, frame_count=conditions.frame_count(case.frame_count))
        for case in SHAKES.values()
    ]
    try:
        simulation = build(
            variant, cases, wp.get_device(conditions.device), is_counting=True
        )
        [traces] = run([simulation], title=variant.name)
    # As in ``box``.
    except Exception as error:
        empty = {
            "variant": variant.name,
            **absent(("slip_mm", *GRASP), box.reason_of(error)),
        }
        return [
            {"case": f"{variant.name}-{shake}", "shake": shake, **empty}
            for shake in SHAKES
        ]
    rows = [
        row_of(variant.name, *each) for each in zip(SHAKES, cases, traces, strict=True)
    ]
    untold = (
        simulation.stepper.row_peak()
        if isinstance(simulation, SolverSimulation)
        else {}
    )
    if isinstance(simulation, SolverSimulation) and simulation.observed is None:
        untold |= absent(
            FORCES, "this solver, or release, does not say the forces of contacts"
        )
    return [row | untold for row in rows]


def row_of(variant: str, shake: str, case: Case, trace: Trace) -> dict[str, object]:
    """Return the row of a run.

    It contains slip, drift, the mean load of the grasp, and the amplitude of the hand.
    """
    case = replace(case, name=f"{variant}-{shake}")
    row = {
        **summarize(case, trace),
        "backend": variant.split("-")[0],
        "variant": variant,
        "shake": shake,
    }
    if row["slip_mm"] is None:
        return row | absent(GRASP, row["slip_mm_reason"])
    normal_n, tangential_n, depth_m = (
        metrics.shake_mean(trace, column)
        for column in ("normal_force_n", "tangential_force_n", "penetration_m")
    )
    drift_mm = metrics.cycle_drift_mm(
        metrics.displacement(trace), case.shake_frequency_hz
    )
    hand_m = trace.poses[
        trace.phase == metrics.SHAKE, TRACKED_BODIES.index("fr3_hand_tcp"), 0
    ]
    share = tangential_n / (case.pad_mu * normal_n) if normal_n > 0.0 else np.nan
    means = (drift_mm, share, normal_n, 1e3 * depth_m, 1e3 * np.ptp(hand_m) / 2.0)
    numbers = dict(zip(GRASP, map(float, means), strict=True))
    untouched = [name for name, number in numbers.items() if not np.isfinite(number)]
    return row | numbers | absent(untouched, "the fingers did not touch the cube")


def measure_times(
    conditions: Conditions, variants: Sequence[box.Variant], counts: Sequence[int]
) -> list[dict[str, object]]:
    """Return a row for each variant and number of worlds.

    Each variant is timed in turn with the first one.
    """
    rows, device = [], wp.get_device(conditions.device)
    too_slow: dict[str, str] = {}
    for count in counts:
        reference = Blocks(variants[0], count, device)
        for variant in variants:
            row: dict = {
                "case": f"{variant.name}-worlds-{count}",
                "variant": variant.name,
                "worlds": count,
            }
            if variant.name in too_slow:
                rows.append(row | untimed(TIMES, too_slow[variant.name]))
                continue
            try:
                columns = time_columns(
                    reference,
                    Blocks(variant, count, device) if variant.name != "warp" else None,
                )
            # As in ``box``, or because memory runs out.
            except Exception as error:
                columns = absent(TIMES, box.reason_of(error))
            rows.append(row | columns)
            if (columns["frame_ms"] or 0.0) > SLOW_MS:
                too_slow[variant.name] = (
                    f"with {count} world{'s' * (count > 1)} a frame takes over {SLOW_MS:g} ms"
                )
        del reference
        gc.collect()
    return rows


def time_columns(reference: "Blocks", other: "Blocks | None") -> dict:
    """Return the frame times of ``other``, or of the reference, timed in turn."""
    blocks = [reference, other] if other else [reference]
    times = time_in_turn(blocks)[-1]
    reason = batch_invalid_reason(blocks[-1].simulation)
    return untimed(TIMES, reason) if reason else frame_benchmark.time_columns(times)


class Blocks:
    """Run blocks of frames from the shake in identical worlds."""

    def __init__(self, variant: box.Variant, world_count: int, device: wp.Device):
        case = replace(WEIGHTLESS, name="timed", cube_in_hand=True, frame_count=1)
        self.simulation = build(variant, [case] * world_count, device)
        self.frame_count = (
            max(1, min(BLOCK_FRAME_COUNT, LARGE_BATCH // world_count))
            if device.is_cuda
            else 1
        )
        run_frames(self.simulation, START_FRAME_COUNT)

    def __call__(self, _: int) -> float:
        """Return the mean time of a frame in a block [ms]."""
        ms = elapsed_ms(
            self.simulation.device,
            lambda: run_frames(self.simulation, self.frame_count),
        )
        return ms / self.frame_count
