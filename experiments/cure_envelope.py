"""How hard can one shake with the cure? The map of section envelope with the term, and with all remedies."""

from dataclasses import replace

from experiments.cure import BEST, TERMS
from experiments.envelope import MAP_SIZE, map_cells, map_table
from experiments.facts.case import AS_SHIPPED
from experiments.simulation.measurement import Conditions, Measurement, summarize

SIDES = {"term": replace(AS_SHIPPED, **TERMS["term"]), "best": replace(AS_SHIPPED, **BEST)}


def measure(conditions: Conditions) -> Measurement:
    """A row for each side with how many cells it loses, and a table of all cells."""
    cells = map_cells(SIDES, MAP_SIZE[conditions.profile])
    traces = conditions.simulate(cells, title="cure_envelope")
    summaries = [summarize(case, trace) for case, trace in zip(cells, traces, strict=True)]
    count = len(cells) // len(SIDES)
    rows = []
    for number, side in enumerate(SIDES):
        mine = summaries[number * count : (number + 1) * count]
        rows.append(
            {
                "case": side,
                "contact_bias": True,
                "cell_count": count,
                "frame_count": len(traces[0].phase),
                "dropped_count": sum(bool(row["dropped"]) for row in mine),
                "failed_count": sum(row["failure"] is not None for row in mine),
            }
        )
    return Measurement(rows, {"map": map_table(SIDES, summaries)})
