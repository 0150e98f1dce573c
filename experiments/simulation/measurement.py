"""Measure the shake test: choose the frames to run, and compute the row of a run."""

from collections.abc import Iterator, Sequence
from dataclasses import asdict, fields, replace
from typing import Any

import numpy as np
import warp as wp

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case, differences
from experiments.facts.classes import cycle_increments
from experiments.facts.trace import ContactRows, Trace
from experiments.simulation.simulation import simulate
from measured_report.measuring import measurement as conditions
from measured_report.measuring.measurement import Measurement, absent

QUICK_FRAME_COUNT = 420  # frames of a quick run: the set-up and about 3.5 s of shake
# Frames between the three recordings of contacts: a quarter of a 1 Hz cycle.
CONTACT_FRAME_STEP = 15
# Frames before the shake if no phase has to wait for the TCP.
SETUP_FRAME_COUNT = 212
SHAKE_COLUMNS = (
    "slip_mm",
    "drift_mm_s",
    "oscillation_mm",
    "wander_mm",
    "cube_height_m",
    "shake_duration_s",
)
CYCLE_COLUMNS = ("increment_mean_mm", "increment_last_mm", "cycle_count")


class Conditions(conditions.Conditions):
    """The conditions under which a section measures."""

    def frame_count(self, full: int) -> int:
        """Return ``full``, or fewer frames when quick."""
        return min(full, QUICK_FRAME_COUNT) if self.quick else full

    def contact_frames(self) -> tuple[int, ...]:
        """Return three frames from the middle of the shake."""
        middle = (SETUP_FRAME_COUNT + self.frame_count(AS_SHIPPED.frame_count)) // 2
        return middle - CONTACT_FRAME_STEP, middle, middle + CONTACT_FRAME_STEP

    def simulate(self, cases: Sequence[Case], **options) -> list[Trace]:
        """Simulate the cases on this device, with shorter runs when quick."""
        cases = [
            replace(case, frame_count=self.frame_count(case.frame_count))
            for case in cases
        ]
        return simulate(cases, device=self.device, **options)

    def measure(self, cases: Sequence[Case], title: str) -> Measurement:
        """Measure one row for each case."""
        traces = self.simulate(cases, title=title)
        return Measurement(
            [summarize(case, trace) for case, trace in zip(cases, traces, strict=True)]
        )


def summarize(case: Case, trace: Trace) -> dict[str, Any]:
    """Return the row of a run.

    It contains the name of the case, its differences from the scene as shipped, and the
    metrics of its trace. A number that does not exist is None, with a reason under
    ``<name>_reason``.
    """
    row = {"case": case.name, "backend": case.backend, **differences(case)}
    row |= {
        "shake_amplitude_m": case.shake_amplitude_m,
        "shake_frequency_hz": case.shake_frequency_hz,
    }
    row |= {"failure": str(trace.failure) if trace.failure else None}
    row |= {"failure_frame": trace.failure.frame} if trace.failure else {}
    moved = metrics.displacement(trace)
    reason = str(trace.failure or "")
    if not reason and len(moved.time_s) < 2:
        reason = "the shake was never reached"
    row |= absent(SHAKE_COLUMNS, reason) if reason else _shake_numbers(moved, trace)
    increments = (
        np.zeros(0)
        if reason
        else cycle_increments(
            moved.time_s, 1e3 * moved.along_m, case.shake_frequency_hz
        )
    )
    cycle_reason = reason or "the shake is shorter than one cycle"
    row |= (
        _cycle_numbers(increments)
        if len(increments)
        else absent(CYCLE_COLUMNS, cycle_reason)
    )
    row["dropped"] = None if trace.failure else metrics.is_dropped(trace)
    return row | {
        "frame_count": len(trace.phase),
        "shake_start_s": float((trace.phase < metrics.SHAKE).sum() * trace.frame_dt),
        "peak_contact_count": trace.peak_contact_count,
        "peak_constraint_count": trace.peak_constraint_count,
        "world_count": trace.world_count,
        "wall_s": trace.wall_s,
    }


def _shake_numbers(moved: metrics.Displacement, trace: Trace) -> dict[str, float]:
    return {
        "slip_mm": metrics.slip_mm(moved),
        "drift_mm_s": metrics.drift_mm_s(moved),
        "oscillation_mm": metrics.oscillation_mm(moved),
        "wander_mm": metrics.wander_mm(moved),
        "cube_height_m": metrics.cube_height_m(trace),
        "shake_duration_s": float(moved.time_s[-1]),
    }


def _cycle_numbers(increments_mm: np.ndarray) -> dict[str, float]:
    return {
        "increment_mean_mm": float(increments_mm.mean()),
        "increment_last_mm": float(increments_mm[-1]),
        "cycle_count": len(increments_mm),
    }


def displacement_table(trace: Trace) -> dict[str, np.ndarray]:
    """Return the cube's displacement in the TCP frame over the shake [mm].

    The columns are the axes and the direction of the shake.
    """
    moved = metrics.displacement(trace)
    vector = 1e3 * moved.vector_m
    return {
        "time_s": moved.time_s,
        "x_mm": vector[:, 0],
        "y_mm": vector[:, 1],
        "z_mm": vector[:, 2],
        "along_mm": 1e3 * moved.along_m,
    }


def grasp_columns(rows: ContactRows) -> dict[str, object]:
    """Return ``metrics.grasp`` as columns of a row.

    The columns are None, with a reason, if no contact carries force.
    """
    grasp = metrics.grasp(rows)
    if grasp is not None:
        return asdict(grasp)
    counts = {"row_count": len(rows.distance_m), "loaded_row_count": 0}
    names = (field.name for field in fields(metrics.Grasp) if field.name not in counts)
    return counts | absent(names, "no contact carries force")


def numbers_of(holder: Any) -> Iterator[tuple[str, float]]:
    """Yield the name and value of each numeric field of a dataclass.

    If a field has a value for each world, the value of the first world is used.
    """
    for name in sorted(field.name for field in fields(holder)):
        value = getattr(holder, name)
        if isinstance(value, wp.array) and value.dtype is wp.float32:
            value = value.numpy()[0].item()
        if isinstance(value, (bool, int, float)):
            yield name, float(value)
