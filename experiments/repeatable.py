"""Repeatable to the last bit: which of the ways that a release has to run deterministically do so."""

from collections.abc import Sequence
from dataclasses import fields, replace

import mujoco_warp
import newton
import numpy as np
import warp as wp
from newton.solvers import SolverMuJoCo

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case
from experiments.facts.trace import Trace
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.simulation.simulation import CONTACT_MAX, Simulation, run
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.error_text import NOT_COMPILED

CONTACTS, CONSTRAINT, ATOMICS = 1, 2, 4
"""Bits of ``Option.deterministic`` (mujoco-warp 3.17, ``DeterminismType``)."""
WAYS = {
    "plain": {},
    "sorted": {"is_sorted": True},
    "ordered": {"is_sorted": True, "bits": CONTACTS | CONSTRAINT},
    "all": {"is_sorted": True, "bits": CONTACTS | CONSTRAINT | ATOMICS},
}
"""Newton's contacts sorted, then MuJoCo Warp asked for contacts and rows in a fixed order, then for its sums as well.

What would put contacts and rows in order is empty yet in mujoco-warp 3.17. Newton's own
``SolverMuJoCo(deterministic=)`` asks for its kernels what the last asks for MuJoCo Warp's.
"""
BATCH_COUNT = {"full": 16, "quick": 2}
NUMBERS = ("slip_mm", "run_spread_mm", "world_spread_mm", "differing_world_count", "peak_contact_count")


class Deterministic(Simulation):
    """A simulation that is told to do the same in every run."""

    def __init__(self, cases: Sequence[Case], device: wp.Device, *, is_sorted: bool = False, bits: int = 0):
        self.is_sorted, self.bits = is_sorted, bits
        super().__init__(cases, device)

    def _build_collision(self):
        if not self.is_sorted:
            return super()._build_collision()
        pipeline = newton.CollisionPipeline(
            self.model,
            broad_phase=self.case.broad_phase,
            reduce_contacts=True,
            rigid_contact_max=self.world_count * (self.case.contact_max or CONTACT_MAX),
            deterministic=True,
        )
        return pipeline, pipeline.contacts()

    def _build_solver(self) -> SolverMuJoCo:
        solver = super()._build_solver()
        if self.bits:
            solver.mjw_model.opt.deterministic = self.bits
        return solver


def engine_has_it() -> bool:
    """Whether MuJoCo Warp of the installed release has ``Option.deterministic``."""
    return any(field.name == "deterministic" for field in fields(mujoco_warp.Option))


def measure(conditions: Conditions) -> Plan:
    """A row for each way, with what two runs of one batch have in common."""
    return Measurement((yield [Batch(way, measure_likeness, (conditions, way)) for way in WAYS]))


def measure_likeness(conditions: Conditions, way: str) -> dict[str, object]:
    """Run one batch twice, one after the other, so that nothing but chance can tell them apart."""
    row = {"case": way, "worlds": BATCH_COUNT[conditions.profile]}
    if WAYS[way].get("bits") and not engine_has_it():
        return row | absent(NUMBERS, "MuJoCo Warp here has no Option.deterministic")
    case = replace(AS_SHIPPED, name=way, frame_count=conditions.frame_count(AS_SHIPPED.frame_count))
    batch, device = [case] * row["worlds"], wp.get_device(conditions.device)
    try:
        first, second = (run([Deterministic(batch, device, **WAYS[way])], title=f"repeatable, {way}")[0] for _ in "ab")
    except Exception as error:  # a release that has it need not be able to compile it
        if not WAYS[way].get("bits") or not NOT_COMPILED.search(str(error)):
            raise
        return row | absent(NUMBERS, " ".join(str(error).split())[:120])
    return row | likeness(first, second)


def likeness(first: Sequence[Trace], second: Sequence[Trace]) -> dict[str, object]:
    """How far the worlds of two runs of one batch are apart, run against run and world against world."""
    failure = next((str(trace.failure) for trace in (*first, *second) if trace.failure), None)
    if failure:
        return {"failure": failure} | absent(NUMBERS, failure)
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
