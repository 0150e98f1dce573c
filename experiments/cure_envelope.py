"""How hard can one shake with the cure? The map of section envelope with the term, and with all remedies."""

from dataclasses import replace

import numpy as np

from experiments.case import AS_SHIPPED, Case
from experiments.cure import BEST, TERMS
from experiments.envelope import AMPLITUDES_M, FRAME_COUNT, FREQUENCIES_HZ, MAP_SIZE
from experiments.measurement import Conditions, Measurement, summarize

SIDES = {"term": TERMS["term"], "best": BEST}
COLUMNS = ("shake_amplitude_m", "shake_frequency_hz", "slip_mm", "cube_height_m", "dropped", "failure")


def cases(size: int) -> list[Case]:
    """All cells of the map, side by side; ``size`` amplitudes by as many frequencies."""
    grid = [(a, f) for a in np.geomspace(*AMPLITUDES_M, size) for f in np.geomspace(*FREQUENCIES_HZ, size)]
    return [
        replace(
            AS_SHIPPED,
            name=f"{side}-map-{index}",
            shake_amplitude_m=float(amplitude),
            shake_frequency_hz=float(frequency),
            frame_count=FRAME_COUNT,
            **remedies,
        )
        for side, remedies in SIDES.items()
        for index, (amplitude, frequency) in enumerate(grid)
    ]


def measure(conditions: Conditions) -> Measurement:
    """A row for each side with how many cells it loses, and a table of all cells."""
    cells = cases(MAP_SIZE[conditions.profile])
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
    table: dict[str, np.ndarray] = {"side": np.repeat(list(SIDES), count)}
    return Measurement(rows, {"map": table | {name: np.array([row[name] for row in summaries]) for name in COLUMNS}})
