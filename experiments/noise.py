"""Run the same cases many times, in one batch and one at a time (an A/A test).

The scatter is the noise floor of the report.
"""

from dataclasses import replace

import warp as wp

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.simulation.measurement import Conditions, Measurement, summarize
from experiments.simulation.simulation import Simulation, run

BATCH_COUNT = {"full": 32, "quick": 4}
ALONE_COUNT = {"full": 8, "quick": 2}


def measure(conditions: Conditions) -> Measurement:
    """Return a row for each run.

    The worlds of the batch share one simulation. Each of the other runs has its own
    simulation.
    """
    device = wp.get_device(conditions.device)
    shipped, stiff = (
        replace(case, frame_count=conditions.frame_count(case.frame_count))
        for case in (AS_SHIPPED, STIFF_PADS)
    )
    batch = [shipped] * BATCH_COUNT[conditions.profile] + [stiff] * BATCH_COUNT[
        conditions.profile
    ]
    alone = [shipped] * ALONE_COUNT[conditions.profile]
    simulations = [
        Simulation(batch, device),
        *(Simulation([case], device) for case in alone),
    ]
    first, *repeats = run(simulations, title="noise")
    rows = []
    for members, traces, kind in (
        (batch, first, "batch"),
        (alone, [world for [world] in repeats], "alone"),
    ):
        for index, (case, trace) in enumerate(zip(members, traces, strict=True)):
            rows.append(
                summarize(case, trace)
                | {"of": case.name, "kind": kind, "case": f"{case.name}-{kind}-{index}"}
            )
    return Measurement(rows)
