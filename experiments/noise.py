"""An A/A test: the same case many times, in one batch and alone. The spread is the report's noise floor."""

from dataclasses import replace

import warp as wp

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.simulation.measurement import Conditions, Measurement, summarize
from experiments.simulation.simulation import Simulation, run

BATCH_COUNT = {"full": 32, "quick": 4}
ALONE_COUNT = {"full": 8, "quick": 2}


def measure(conditions: Conditions) -> Measurement:
    """Run all the worlds of the batch in one simulation, and each of the others in one of its own; a row for each."""
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
