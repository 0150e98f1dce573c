"""A minute with the arm held still: what creeps once positions are summed with what rounding takes from them kept?"""

from dataclasses import replace

from experiments.cure import BEST, IMPRATIO, POSITIONS
from experiments.facts.case import HOLD, STIFF_PADS
from experiments.hold import LONG_FRAME_COUNT, creep
from experiments.simulation.measurement import Conditions, Measurement, displacement_table, summarize

MINUTE = replace(HOLD, frame_count=LONG_FRAME_COUNT)
CASES = (
    replace(MINUTE, name="rounded"),
    replace(MINUTE, name="kept", **POSITIONS["kept"]),
    replace(MINUTE, name="kept-stiff", pad_ke=STIFF_PADS.pad_ke, pad_kd=STIFF_PADS.pad_kd, **POSITIONS["kept"]),
    replace(MINUTE, name="rounded-impratio", impratio=IMPRATIO),
    replace(MINUTE, name="kept-impratio", impratio=IMPRATIO, **POSITIONS["kept"]),
    replace(MINUTE, name="best", **BEST),
)


def measure(conditions: Conditions) -> Measurement:
    """A row for each case, with the creep in its first and in its last second, and the way of the cube."""
    traces = conditions.simulate(CASES, title="cure_hold")
    rows = [
        summarize(case, trace) | {"contact_bias": case.contact_bias} | creep(trace)
        for case, trace in zip(CASES, traces, strict=True)
    ]
    return Measurement(rows, {case.name: displacement_table(trace) for case, trace in zip(CASES, traces, strict=True)})
