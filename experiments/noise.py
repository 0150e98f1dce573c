"""An A/A test: the same case many times, in one batch and alone, and the same batch twice, to the last bit.

The spread of the former is the report's noise floor. The latter is tried with each switch that a release has for it.
"""

from collections.abc import Sequence
from dataclasses import fields, replace

import mujoco_warp
import newton
import numpy as np
import warp as wp
from newton.solvers import SolverMuJoCo

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.facts.trace import Trace
from experiments.simulation.measurement import Conditions, Measurement, absent, summarize
from experiments.simulation.simulation import CONTACT_MAX, Simulation, run
from measured_report.measuring.batch import NOT_COMPILED, Batch, Plan

BATCH_COUNT = {"full": 32, "quick": 4}
ALONE_COUNT = {"full": 8, "quick": 2}
TWICE_COUNT = {"full": 16, "quick": 2}
"""Worlds of the batch that is run twice."""
CONTACTS, CONSTRAINT, ATOMICS = 1, 2, 4
"""Bits of ``Option.deterministic`` (mujoco-warp 3.17, ``DeterminismType``)."""
SWITCHES = {
    "plain": (False, 0),
    "sorted": (True, 0),
    "ordered": (True, CONTACTS | CONSTRAINT),
    "all": (True, CONTACTS | CONSTRAINT | ATOMICS),
}
"""Whether Newton's contacts are sorted, and what MuJoCo Warp is asked to do in a fixed order.

What would put contacts and rows in order is empty yet in mujoco-warp 3.17. Newton's own
``SolverMuJoCo(deterministic=)`` asks for its kernels what the last asks for MuJoCo Warp's.
"""
LIKENESS_COLUMNS = ("slip_mm", "run_spread_mm", "world_spread_mm", "differing_world_count", "peak_contact_count")


def measure(conditions: Conditions) -> Plan:
    """Measure a row for each run, and one for each switch."""
    twice = [Batch(switch, measure_likeness, (conditions, switch)) for switch in SWITCHES]
    runs, *likenesses = yield [Batch("runs", measure_runs, (conditions,)), *twice]
    return Measurement([*runs, *likenesses])


def measure_runs(conditions: Conditions) -> list[dict[str, object]]:
    """Run all the worlds of the batch in one simulation, and each of the others in one of its own."""
    device = wp.get_device(conditions.device)
    shipped, stiff = (
        replace(case, frame_count=conditions.frame_count(case.frame_count)) for case in (AS_SHIPPED, STIFF_PADS)
    )
    batch = [shipped] * BATCH_COUNT[conditions.profile] + [stiff] * BATCH_COUNT[conditions.profile]
    alone = [shipped] * ALONE_COUNT[conditions.profile]
    simulations = [Simulation(batch, device), *(Simulation([case], device) for case in alone)]
    first, *others = run(simulations, title="noise")
    rows = []
    for members, traces, kind in ((batch, first, "batch"), (alone, [world for [world] in others], "alone")):
        for index, (case, trace) in enumerate(zip(members, traces, strict=True)):
            rows.append(summarize(case, trace) | {"of": case.name, "kind": kind, "case": f"{case.name}-{kind}-{index}"})
    return rows


class Deterministic(Simulation):
    """A simulation that is told to do the same in every run."""

    def __init__(self, world_count: int, frame_count: int, device: wp.Device, switch: str):
        self.is_sorted, self.bits = SWITCHES[switch]
        super().__init__([replace(AS_SHIPPED, name=switch, frame_count=frame_count)] * world_count, device)

    def _build_collision(self):
        if not self.is_sorted:
            return super()._build_collision()
        pipeline = newton.CollisionPipeline(
            self.model,
            broad_phase=self.case.broad_phase,
            reduce_contacts=True,
            rigid_contact_max=self.world_count * CONTACT_MAX,
            deterministic=True,
        )
        return pipeline, pipeline.contacts()

    def _build_solver(self) -> SolverMuJoCo:
        solver = super()._build_solver()
        if self.bits:
            solver.mjw_model.opt.deterministic = self.bits
        return solver


def engine_has_it() -> bool:
    """Tell whether MuJoCo Warp of the installed release has ``Option.deterministic``."""
    return any(field.name == "deterministic" for field in fields(mujoco_warp.Option))


def measure_likeness(conditions: Conditions, switch: str) -> dict[str, object]:
    """Run one batch twice, one after the other, so that nothing but chance can tell them apart."""
    row = {"case": switch, "worlds": TWICE_COUNT[conditions.profile]}
    is_asked = SWITCHES[switch][1] != 0
    if is_asked and not engine_has_it():
        return row | absent(LIKENESS_COLUMNS, "MuJoCo Warp here has no Option.deterministic")
    frame_count, device = conditions.frame_count(AS_SHIPPED.frame_count), wp.get_device(conditions.device)
    try:
        simulations = (Deterministic(row["worlds"], frame_count, device, switch) for _ in range(2))
        [first], [second] = (run([simulation], title=f"noise, {switch}") for simulation in simulations)
    except Exception as error:  # a release that has it need not be able to compile it
        if not is_asked or not NOT_COMPILED.search(str(error)):
            raise
        return row | absent(LIKENESS_COLUMNS, " ".join(str(error).split())[:120])
    return row | likeness(first, second)


def likeness(first: Sequence[Trace], second: Sequence[Trace]) -> dict[str, object]:
    """Compare the worlds of two runs of one batch, run against run and world against world."""
    failure = next((str(trace.failure) for trace in (*first, *second) if trace.failure), None)
    if failure:
        return {"failure": failure} | absent(LIKENESS_COLUMNS, failure)
    slips = np.array([[metrics.slip_mm(metrics.displacement(trace)) for trace in worlds] for worlds in (first, second)])
    differs = [not np.array_equal(a.poses, b.poses) for a, b in zip(first, second, strict=True)]
    return {
        "failure": None,
        "slip_mm": float(slips.mean()),
        "run_spread_mm": float(np.abs(slips[0] - slips[1]).max()),
        "world_spread_mm": float(np.ptp(slips)),
        "differing_world_count": sum(differs),
        "peak_contact_count": max(trace.peak_contact_count for trace in (*first, *second)),
    }
