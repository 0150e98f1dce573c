"""Measure how many contacts each contact gap creates, and how many carry force."""

from dataclasses import replace

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED
from experiments.simulation.measurement import Conditions, Measurement, summarize

CASES = (
    replace(AS_SHIPPED, name="cube-gap-default"),
    replace(AS_SHIPPED, name="cube-gap-0.005", cube_gap_m=0.005),
    replace(
        AS_SHIPPED,
        name="all-gaps-zero",
        cube_gap_m=0.0,
        robot_gap_m=0.0,
        ground_gap_m=0.0,
    ),
)


def measure(conditions: Conditions) -> Measurement:
    traces = conditions.simulate(CASES, title="gap")
    return Measurement(
        [
            summarize(case, trace)
            | {
                "mean_row_count": metrics.shake_mean(trace, "contact_count"),
                "mean_loaded_row_count": metrics.shake_mean(trace, "loaded_count"),
            }
            for case, trace in zip(CASES, traces, strict=True)
        ]
    )
