"""Map the slip over amplitude and frequency, with and without the fix."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from experiments.facts.case import AS_SHIPPED, STIFF_PADS, Case
from experiments.simulation.measurement import Conditions, Measurement, summarize
from measured_report.measuring.batch import Batch, Plan

FRAME_COUNT = 660
MAP_SIZE = {"full": 32, "quick": 3}
AMPLITUDES_M = (0.005, 0.12)
FREQUENCIES_HZ = (0.25, 5.0)  # range of the map, with logarithmic spacing
SIDES = {"as-shipped": AS_SHIPPED, "stiff": STIFF_PADS}
# Pairs of amplitude [m] and frequency [Hz].
ROUND = [(0.03, f) for f in (0.5, 1.0, 2.0, 3.0)] + [
    (a, 1.0) for a in (0.01, 0.06, 0.1)
]
COLUMNS = (
    "shake_amplitude_m",
    "shake_frequency_hz",
    "slip_mm",
    "cube_height_m",
    "dropped",
    "failure",
)


def shaken(case: Case, name: str, amplitude_m: float, frequency_hz: float) -> Case:
    shake: dict = {"shake_amplitude_m": amplitude_m, "shake_frequency_hz": frequency_hz}
    return replace(case, name=name, frame_count=FRAME_COUNT, **shake)


def measure(conditions: Conditions) -> Plan:
    rows, table = yield [
        Batch("round", measure_round, (conditions,)),
        Batch("map", measure_map, (conditions, SIDES)),
    ]
    return Measurement(rows, {"map": table})


def map_cells(sides: Mapping[str, Case], size: int) -> list[Case]:
    """Return all cells of a map, first one side and then the other.

    Each side has ``size`` amplitudes and ``size`` frequencies.
    """
    grid = [
        (a, f)
        for a in np.geomspace(*AMPLITUDES_M, size)
        for f in np.geomspace(*FREQUENCIES_HZ, size)
    ]
    return [
        shaken(case, f"{side}-map-{index}", float(a), float(f))
        for side, case in sides.items()
        for index, (a, f) in enumerate(grid)
    ]


def measure_round(conditions: Conditions) -> list[dict]:
    """Return a row for each shake with round numbers, including the scene's own shake.

    These runs are as long as the runs of the map.
    """
    cases = [
        shaken(case, f"{side}-{100 * a:g}cm-{f:g}hz", a, f)
        for side, case in SIDES.items()
        for a, f in ROUND
    ]
    traces = conditions.simulate(cases, title="envelope")
    return [summarize(case, trace) for case, trace in zip(cases, traces, strict=True)]


def measure_map(
    conditions: Conditions, sides: Mapping[str, Case]
) -> dict[str, np.ndarray]:
    """Return a table of all cells in a map, which form one batch."""
    cells = map_cells(sides, MAP_SIZE[conditions.profile])
    traces = conditions.simulate(cells, title="envelope map")
    summaries = [
        summarize(case, trace) for case, trace in zip(cells, traces, strict=True)
    ]
    table = {"side": np.repeat(list(sides), len(cells) // len(sides))}
    return table | {
        name: np.array([row[name] for row in summaries]) for name in COLUMNS
    }
