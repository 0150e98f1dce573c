"""A box that creeps down a slope, over decades of timeconst and impratio: measured, and predicted from parameters."""

from itertools import product

from experiments.measurement import Conditions, Measurement
from experiments.scenes.slope import Slope, creep_mm_s

NEEDS_GPU = False
"""Read by ``report.records.devices``: a small scene, which a CPU measures in minutes."""
TIMECONSTS_S = (0.002, 0.02, 0.1)
IMPRATIOS = (1.0, 10.0, 100.0)
CASES = (
    *(
        Slope(f"slope-{1e3 * timeconst:g}ms-impratio-{impratio:g}", timeconst, impratio)
        for timeconst, impratio in product(TIMECONSTS_S, IMPRATIOS)
    ),
    Slope("slope-20ms-pyramidal", cone="pyramidal"),
)


def measure(_: Conditions) -> Measurement:
    """A row for each run; they take a second, whatever the profile."""
    rows: list[dict[str, object]] = []
    for case in CASES:
        measured, forecast = creep_mm_s(case)
        row: dict[str, object] = {"case": case.name, "backend": "c", "cone": case.cone, "impratio": case.impratio}
        row |= {"timeconst_s": case.timeconst_s, "creep_mm_s": measured, "forecast_creep_mm_s": forecast}
        rows.append(row)
    return Measurement(rows)
