"""Run the shake on every available engine and device.

The cases are the scene as shipped, the scene with stiff pads, and the scene with the
arm held still.
"""

from dataclasses import replace

from experiments.facts.case import AS_SHIPPED, HOLD, STIFF_PADS
from experiments.simulation.measurement import (
    Conditions,
    Measurement,
    displacement_table,
    summarize,
)
from experiments.simulation.timing import wall_time
from measured_report.measuring.batch import Batch, Plan

BATCH_SIZE = {"cuda": 64, "cpu": 16}
BATCH_FRAME_COUNT = {"cuda": 900, "cpu": 120}
QUICK_FRAME_COUNT = 24  # frames of a batch in a quick run


def measure(conditions: Conditions) -> Plan:
    runs, times = yield [
        Batch("runs", measure_runs, (conditions,)),
        Batch("times", batch_rows, (conditions,), exclusive=True),
    ]
    return replace(runs, rows=[*runs.rows, *times])


def measure_runs(conditions: Conditions) -> Measurement:
    cases = [AS_SHIPPED, STIFF_PADS, HOLD]
    cases += [
        replace(case, name=f"{case.name}-mujoco-c", backend="mujoco")
        for case in cases[:2]
    ]
    if conditions.is_cuda:
        cases += [
            replace(case, name=f"{case.name}-warp-cpu", device="cpu")
            for case in cases[:2]
        ]
    traces = conditions.simulate(cases, title="reproduction")
    rows = [summarize(case, trace) for case, trace in zip(cases, traces, strict=True)]
    tables = {
        case.name: displacement_table(trace)
        for case, trace in zip(cases[:3], traces[:3], strict=True)
    }
    return Measurement(rows, tables)


def batch_rows(conditions: Conditions) -> list[dict[str, object]]:
    """Return the wall time of one case in a batch of one and in every world of a larger
    batch. On the CPU, it is also measured without graphs. Launching kernels then takes
    longer than computing, and a batch shares the launches.
    """
    kind = "cuda" if conditions.is_cuda else "cpu"
    case = replace(
        AS_SHIPPED,
        frame_count=QUICK_FRAME_COUNT if conditions.quick else BATCH_FRAME_COUNT[kind],
    )
    rows = []
    for graph in (True,) if conditions.is_cuda else (True, False):
        for size in (1, BATCH_SIZE[kind]):
            name = f"batch-{size}" if graph else f"batch-{size}-launched"
            traces = conditions.simulate(
                [replace(case, name=name, graph=graph)] * size, title=name
            )
            row = {
                "case": name,
                "world_count": size,
                "frame_count": len(traces[0].phase),
            }
            rows.append(row | wall_time(traces))
    return rows
