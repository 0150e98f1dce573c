"""With how little friction a grasp holds: what was published, and the least of it for each cone."""

import math

from tqdm import tqdm

from experiments.scenes.least_friction import (
    DROP_M,
    HOLD_S,
    Setting,
    Start,
    coulomb_factor,
    drop_m,
    least_factors,
    warm_up,
)
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.measurement import Conditions, Measurement, absent

NEEDS_GPU = False
"""Read by ``measured_report.editions.devices``: a small scene, which a CPU measures in minutes."""
SETTINGS = (
    Setting("published-euler"),
    Setting("published-implicitfast", integrator="implicitfast"),
    *(
        Setting(f"{cone}-impratio-{impratio:g}", cone, impratio, "implicitfast")
        for cone, impratio in (("pyramidal", 10.0), ("elliptic", 1.0), ("elliptic", 10.0), ("elliptic", 100.0))
    ),
    Setting("elliptic-noslip", "elliptic", 1.0, "implicitfast", 10),
    Setting("elliptic-euler", "elliptic", 1.0),
)
TRIED = (0.90, 0.98, 1.00, 1.02, 1.10)
"""Multiples of m g / N that were tried and published."""
GRASP = ("grip_force_n", "weight_n", "rms_speed_mm_s", "coulomb_factor", "least_factor")


def measure(conditions: Conditions) -> Measurement:
    """A row for each setting, and one for each friction that was published."""
    rows: list[dict[str, object]] = []
    seconds = HOLD_S[conditions.profile]
    for setting in tqdm(SETTINGS, desc="least friction", unit="setting", delay=3.0):
        row: dict[str, object] = {"case": setting.name, "cone": setting.cone, "impratio": setting.impratio}
        row |= {"integrator": setting.integrator, "noslip_iterations": setting.noslip_iterations}
        try:
            start = warm_up(setting)
        except RunFailed as failed:
            rows.append(row | absent(GRASP, str(failed)))
            continue
        rows.append(row | grasp_columns(start, setting.cone) | least_columns(start, seconds))
        if setting.name.startswith("published"):
            for factor in TRIED:
                place = {"case": f"{setting.name}-{factor:.2f}", "factor": factor}
                rows.append(row | place | drop_columns(start, factor, seconds))
    return Measurement(rows)


def grasp_columns(start: Start, cone: str) -> dict[str, object]:
    """How the cube is held with ample friction, and what Coulomb's law asks for."""
    return {
        "grip_force_n": start.force_n,
        "weight_n": start.weight_n,
        "rms_speed_mm_s": 1e3 * start.speed_m_s,
        "coulomb_factor": coulomb_factor(start, cone),
    }


def least_columns(start: Start, seconds: float) -> dict[str, object]:
    """The least multiple that holds."""
    try:
        return found(*least_factors(start, seconds))
    except RunFailed as failed:
        return absent(("least_factor",), str(failed))


def found(low: float, high: float) -> dict[str, object]:
    """The upper end of the search as a column, where it has two."""
    if math.isinf(high):
        return absent(("least_factor",), f"{low:g} times m g / N do not hold it")
    if low == 0.0:
        return absent(("least_factor",), f"it holds with the least that was tried, {high:g} times m g / N")
    return {"least_factor": high}


def drop_columns(start: Start, factor: float, seconds: float) -> dict[str, object]:
    """How far the cube sinks with a multiple, and whether that counts as held."""
    try:
        drop = drop_m(start, factor, seconds)
    except RunFailed as failed:
        return {"is_held": None} | absent(("slip_mm",), str(failed))
    return {"slip_mm": 1e3 * max(0.0, drop), "is_held": drop <= DROP_M}
