"""A Panda picks up a cube or a ball and shakes it: as published, and with what is said to help."""

from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
from tqdm import tqdm

from experiments.scenes.pick import END_S, HOLD_S, OBJECTS, Held, Pick, Picked, hold, shake
from experiments.simulation.c_warnings import RunFailed
from measured_report.measuring.measurement import Conditions, Measurement, absent

NEEDS_GPU = False
"""Read by ``measured_report.editions.devices``: a small scene, which a CPU measures in minutes."""
SEED_COUNT = {"full": 8, "quick": 2}
SETTINGS: dict[str, dict[str, Any]] = {
    "published": {},
    "elliptic": {"cone": "elliptic", "impratio": 10.0},
    "short": {"timeconst_s": 0.004},
}
COUNTS, DROPS = ("lifted_count", "held_count"), ("first_drop_s", "median_drop_s", "last_drop_s")
HELD = ("creep_mm_s", "predicted_creep_mm_s", "forecast_creep_mm_s", "normal_force_n", "margin_mm", "forecast_drop_s")
STEPS_S = {"2ms": 0.002, "10ms": 0.01}


def cases() -> list[Pick]:
    """Every setting with either step in C and through Newton; and in C with another integrator."""
    found = []
    for kind, (step, step_s), (name, setting) in product(OBJECTS, STEPS_S.items(), SETTINGS.items()):
        case = Pick(f"{kind}-{step}-{name}", object=kind, timestep_s=step_s, **setting)
        found += [replace(case, name=f"{case.name}-{engine}", engine=engine) for engine in ("c", "newton")]
        if name != "short":
            found.append(replace(case, name=f"{case.name}-implicitfast", integrator="implicitfast"))
    return found


def measure(conditions: Conditions) -> Measurement:
    """A row for each case, and one for each setting with the grasp held still."""
    rows = [shaken(case, conditions) for case in tqdm(cases(), desc="pick", unit="case", delay=3.0)]
    for kind in OBJECTS:
        rows += [held_still(Pick(f"{kind}-{name}-held", object=kind, **setting)) for name, setting in SETTINGS.items()]
    return Measurement(rows)


def shaken(case: Pick, conditions: Conditions) -> dict[str, object]:
    """The row of a case."""
    seeds = range(SEED_COUNT[conditions.profile])
    row = described(case) | {"seed_count": len(seeds)}
    try:
        return row | shake_columns(shake(case, seeds, END_S[conditions.profile], conditions.device))
    except RunFailed as failed:
        return row | absent((*COUNTS, *DROPS), str(failed))


def held_still(case: Pick) -> dict[str, object]:
    """The row of a grasp held still."""
    try:
        return described(case) | hold_columns(hold(case))
    except RunFailed as failed:
        return described(case) | absent(HELD, str(failed))


def described(case: Pick) -> dict[str, object]:
    """What a case sets."""
    row: dict[str, object] = {"case": case.name, "backend": case.engine, "object": case.object, "cone": case.cone}
    row |= {"impratio": case.impratio, "integrator": case.integrator, "timestep": case.timestep_s}
    return row | {"timeconst_s": case.solrefs[0][0]}


def shake_columns(picked: Picked) -> dict[str, object]:
    """How many shakes the grasp stood, and when it dropped the object in the others."""
    dropped = picked.drop_s[~np.isnan(picked.drop_s)]
    row = dict(zip(COUNTS, (int(picked.lifted.sum()), len(picked.drop_s) - len(dropped)), strict=True))
    if not len(dropped):
        return row | absent(DROPS, "it was never dropped")
    return row | dict(zip(DROPS, map(float, (dropped.min(), np.median(dropped), dropped.max())), strict=True))


def hold_columns(held: Held) -> dict[str, float]:
    """The creep of a grasp held still, by its contacts' law and by the parameters, and when it would be through."""
    row = {
        "creep_mm_s": 1e3 * held.creep_m_s,
        "predicted_creep_mm_s": 1e3 * held.law_m_s,
        "forecast_creep_mm_s": 1e3 * held.forecast_m_s,
        "normal_force_n": held.contacts.normal_n,
        "loaded_contact_count": held.contacts.count,
        "margin_mm": 1e3 * held.margin_m,
    }
    return row | {"forecast_drop_s": HOLD_S[0] + held.margin_m / held.forecast_m_s}
