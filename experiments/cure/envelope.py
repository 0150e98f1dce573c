"""The map of section envelope with the term, and with the whole cure: how hard can one shake?"""

from dataclasses import replace

from experiments.envelope import MAP_SIZE, map_cells, map_table
from experiments.facts.case import AS_SHIPPED
from experiments.facts.variants import BEST, TERMS
from experiments.simulation.measurement import Conditions, summarize

SIDES = {"term": replace(AS_SHIPPED, **TERMS["term"]), "best": replace(AS_SHIPPED, **BEST)}


def measure(conditions: Conditions) -> tuple[list[dict], dict]:
    """Measure a row for each side with how many cells it loses, and a table of all cells."""
    cells = map_cells(SIDES, MAP_SIZE[conditions.profile])
    traces = conditions.simulate(cells, title="cure, map")
    summaries = [summarize(case, trace) for case, trace in zip(cells, traces, strict=True)]
    count = len(cells) // len(SIDES)
    rows = []
    for number, side in enumerate(SIDES):
        mine = summaries[number * count : (number + 1) * count]
        row = {"case": f"map-{side}", "contact_bias": True, "cell_count": count, "frame_count": len(traces[0].phase)}
        row["dropped_count"] = sum(bool(cell["dropped"]) for cell in mine)
        row["failed_count"] = sum(cell["failure"] is not None for cell in mine)
        rows.append(row)
    return rows, map_table(SIDES, summaries)
