"""With how little friction a grasp holds: what was published, and the least of it for each cone."""

from tqdm import tqdm

from experiments.measurement import Conditions, Measurement, absent
from experiments.scenes.least_friction import (
    DROP_M,
    HOLD_S,
    MOST,
    Setting,
    coulomb_factor,
    drop_m,
    least_factor,
    warm_up,
)

NEEDS_GPU = False
"""Read by ``report.records.devices``: a small scene, which a CPU measures in minutes."""
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


def measure(conditions: Conditions) -> Measurement:
    """A row for each setting, and one for each friction that was published."""
    rows: list[dict[str, object]] = []
    seconds = HOLD_S[conditions.profile]
    for setting in tqdm(SETTINGS, desc="least friction", unit="setting", delay=3.0):
        start = warm_up(setting)
        row: dict[str, object] = {"case": setting.name, "cone": setting.cone, "impratio": setting.impratio}
        row |= {"integrator": setting.integrator, "noslip_iterations": setting.noslip_iterations}
        rows.append(
            row
            | {
                "grip_force_n": start.force_n,
                "weight_n": start.weight_n,
                "rms_speed_mm_s": 1e3 * start.speed_m_s,
                "coulomb_factor": coulomb_factor(start, setting.cone),
            }
            | found(least_factor(start, seconds))
        )
        if setting.name.startswith("published"):
            for factor in TRIED:
                drop = drop_m(start, factor, seconds)
                rows.append(
                    row
                    | {"case": f"{setting.name}-{factor:.2f}", "factor": factor, "slip_mm": 1e3 * max(0.0, drop)}
                    | {"is_held": drop <= DROP_M}
                )
    return Measurement(rows)


def found(factor: float | None) -> dict[str, object]:
    """The least multiple as a column."""
    if factor is None:
        return absent(("least_factor",), f"{MOST:g} times m g / N do not hold it")
    return {"least_factor": factor}
