"""A capsule that is pinched and sinks: what was published of it, measured anew in three ways."""

from dataclasses import replace

from tqdm import tqdm

from experiments.scenes.capsule import SECONDS, Pinch, columns, run
from experiments.simulation.c_warnings import RunFailed
from measured_report.measuring.measurement import Conditions, Measurement, absent
from newton_lint.newton_models.compat import warp_has_noslip

CREEPS = ("creep_mm_s", "steady_creep_mm_s", "predicted_creep_mm_s", "forecast_creep_mm_s")
NEEDS_GPU = False
"""Read by ``measured_report.editions.devices``: a small scene, which a CPU measures in minutes."""
VARIANTS = (
    Pinch("recipe"),
    Pinch("impratio-1", impratio=1.0),
    Pinch("impratio-100", impratio=100.0),
    Pinch("impratio-1000", impratio=1000.0),
    Pinch("pyramidal", cone="pyramidal", impratio=1.0),
    Pinch("stiff", timeconst_s=0.004),
    Pinch("noslip", noslip_iterations=10),
    Pinch("condim-6", condim=6),
    Pinch("within-pads", half_length_m=0.02),
)
CASES = [
    replace(case, name=f"{case.name}-{engine}", engine=engine)
    for engine in ("c", "warp", "newton")
    for case in VARIANTS
]


def measure(conditions: Conditions) -> Measurement:
    """A row for each run: how fast the capsule sinks, measured and predicted."""
    rows = []
    for case in tqdm(CASES, desc="capsule", unit="run", delay=3.0):
        row: dict[str, object] = {"case": case.name, "backend": case.engine, "cone": case.cone}
        row |= {"impratio": case.impratio, "noslip_iterations": case.noslip_iterations, "condim": case.condim}
        row |= {"timeconst_s": case.timeconst_s, "half_length_m": case.half_length_m}
        if case.engine != "c" and case.noslip_iterations and not warp_has_noslip():
            rows.append(row | absent(CREEPS, "MuJoCo Warp here has no noslip"))
            continue
        try:
            rows.append(row | columns(case, run(case, SECONDS[conditions.profile], conditions.device)))
        except RunFailed as failed:
            rows.append(row | absent(CREEPS, str(failed)))
    return Measurement(rows)
