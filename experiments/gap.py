"""The contact gap: how many contacts it makes, how many of them ever carry force."""

from dataclasses import replace

import numpy as np

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED
from experiments.facts.trace import Trace
from experiments.simulation.measurement import Conditions, Measurement, absent, summarize

CASES = (
    replace(AS_SHIPPED, name="cube-gap-default"),
    replace(AS_SHIPPED, name="cube-gap-0.005", cube_gap_m=0.005),
    replace(AS_SHIPPED, name="all-gaps-zero", cube_gap_m=0.0, robot_gap_m=0.0, ground_gap_m=0.0),
)


def measure(conditions: Conditions) -> Measurement:
    traces = conditions.simulate(CASES, title="gap")
    return Measurement(
        [summarize(case, trace) | contact_columns(trace) for case, trace in zip(CASES, traces, strict=True)]
    )


def contact_columns(trace: Trace) -> dict[str, object]:
    """Return the contacts through the shake: mean number, mean number that carry force, distances of those that
    don't."""
    shaking = trace.phase == metrics.SHAKE
    near, far = trace.column("unloaded_near_m")[shaking], trace.column("unloaded_far_m")[shaking]
    columns: dict[str, object] = {
        "mean_row_count": metrics.shake_mean(trace, "contact_count"),
        "mean_loaded_row_count": metrics.shake_mean(trace, "loaded_count"),
    }
    if np.isnan(near).all():
        return columns | absent(("unloaded_near_mm", "unloaded_far_mm"), "every contact carries force")
    return columns | {"unloaded_near_mm": 1e3 * float(np.nanmin(near)), "unloaded_far_mm": 1e3 * float(np.nanmax(far))}
