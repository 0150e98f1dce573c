"""A box that creeps down a slope, over decades of timeconst and impratio: measured, and predicted from parameters."""

from itertools import product

from experiments.scenes.slope import Slope, creep_mm_s
from experiments.simulation.c_warnings import RunFailed
from measured_report.measuring.measurement import Conditions, Measurement, absent

NEEDS_GPU = False
"""Read by ``measured_report.editions.devices``: a small scene, which a CPU measures in minutes."""
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
        row: dict[str, object] = {"case": case.name, "backend": "c", "cone": case.cone, "impratio": case.impratio}
        row["timeconst_s"] = case.timeconst_s
        names = ("creep_mm_s", "forecast_creep_mm_s")
        try:
            rows.append(row | dict(zip(names, creep_mm_s(case), strict=True)))
        except RunFailed as failed:
            rows.append(row | absent(names, str(failed)))
    return Measurement(rows)
