"""Measure which side's contact parameters matter.

The stiffness of the cube is varied over the same range as the stiffness of the pads.
The pads are also run without their priority.
"""

from dataclasses import replace

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.simulation.measurement import (
    Conditions,
    Measurement,
    grasp_columns,
    summarize,
)

CASES = (
    replace(AS_SHIPPED, name="cube-ke-8e3", cube_ke=8e3),
    replace(AS_SHIPPED, name="cube-ke-8e4"),
    replace(AS_SHIPPED, name="cube-ke-8e5", cube_ke=8e5),
    replace(STIFF_PADS, name="pad-ke-2.5e5"),
    replace(AS_SHIPPED, name="priority-0", pad_priority=0),
    replace(AS_SHIPPED, name="priority-0-cube-ke-8e5", pad_priority=0, cube_ke=8e5),
)


def measure(conditions: Conditions) -> Measurement:
    middle = conditions.contact_frames()[1]
    traces = conditions.simulate(CASES, contact_frames=(middle,), title="priority")
    return Measurement(
        [
            summarize(case, trace) | grasp_columns(trace.contact_rows[0])
            for case, trace in zip(CASES, traces, strict=True)
        ]
    )
