"""A minute with the arm held still: what creeps once positions are summed with what rounding takes from them kept?"""

from dataclasses import replace

from experiments.facts.case import HOLD, STIFF_PADS
from experiments.facts.variants import BEST, IMPRATIO, POSITIONS
from experiments.hold import LONG_FRAME_COUNT, creep
from experiments.simulation.measurement import Conditions, displacement_table, summarize

MINUTE = replace(HOLD, frame_count=LONG_FRAME_COUNT)
CASES = (
    replace(MINUTE, name="rounded"),
    replace(MINUTE, name="kept", **POSITIONS["kept"]),
    replace(MINUTE, name="kept-stiff", pad_ke=STIFF_PADS.pad_ke, pad_kd=STIFF_PADS.pad_kd, **POSITIONS["kept"]),
    replace(MINUTE, name="rounded-impratio", impratio=IMPRATIO),
    replace(MINUTE, name="kept-impratio", impratio=IMPRATIO, **POSITIONS["kept"]),
    replace(MINUTE, name="best", **BEST),
)


def measure(conditions: Conditions) -> tuple[list[dict], dict[str, dict]]:
    """Measure a row for each case, with the creep in its first and in its last second, and the way of the cube."""
    traces = conditions.simulate(CASES, title="cure, held")
    runs = list(zip(CASES, traces, strict=True))
    rows = [summarize(case, trace) | {"contact_bias": case.contact_bias} | creep(trace) for case, trace in runs]
    return rows, {case.name: displacement_table(trace) for case, trace in runs}
