"""A Panda picks up a cube or a ball and shakes it: as published, and with what is said to help."""

from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
from tqdm import tqdm

from experiments.measurement import Conditions, Measurement, absent
from experiments.scenes.pick import END_S, HOLD_S, OBJECTS, Held, Pick, Picked, hold, shake

NEEDS_GPU = False
"""Read by ``report.records.devices``: a small scene, which a CPU measures in minutes."""
SEED_COUNT = {"full": 8, "quick": 2}
SETTINGS: dict[str, dict[str, Any]] = {
    "published": {},
    "elliptic": {"cone": "elliptic", "impratio": 10.0},
    "short": {"timeconst_s": 0.004},
}
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
    seeds, rows = range(SEED_COUNT[conditions.profile]), []
    end_s = END_S[conditions.profile]
    for case in tqdm(cases(), desc="pick", unit="case", delay=3.0):
        rows.append(described(case) | shake_columns(shake(case, seeds, end_s, conditions.device)))
    for kind in OBJECTS:
        for name, setting in SETTINGS.items():
            case = Pick(f"{kind}-{name}-held", object=kind, **setting)
            rows.append(described(case) | hold_columns(hold(case)))
    return Measurement(rows)


def described(case: Pick) -> dict[str, object]:
    """What a case sets."""
    row: dict[str, object] = {"case": case.name, "backend": case.engine, "object": case.object, "cone": case.cone}
    row |= {"impratio": case.impratio, "integrator": case.integrator, "timestep": case.timestep_s}
    return row | {"timeconst_s": case.solrefs[0][0]}


def shake_columns(picked: Picked) -> dict[str, object]:
    """How many shakes the grasp stood, and when it dropped the object in the others."""
    dropped = picked.drop_s[~np.isnan(picked.drop_s)]
    row: dict[str, object] = {
        "seed_count": len(picked.drop_s),
        "lifted_count": int(picked.lifted.sum()),
        "held_count": len(picked.drop_s) - len(dropped),
    }
    names = ("first_drop_s", "median_drop_s", "last_drop_s")
    if not len(dropped):
        return row | absent(names, "it was never dropped")
    return row | dict(zip(names, map(float, (dropped.min(), np.median(dropped), dropped.max())), strict=True))


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
