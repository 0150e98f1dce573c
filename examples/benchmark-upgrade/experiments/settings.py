"""Tasks that a release changed, with one setting otherwise each: which of them brings the old behaviour back."""

from collections.abc import Sequence

import mujoco
import numpy as np

from experiments.episodes import CHANGED, FINGERS, FRESH_SEEDS, Change, columns, episodes
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.measurement import Conditions, Measurement

SEEDS = FRESH_SEEDS[:10]


def without(flag: str) -> Change | None:
    """Set a flag that disables; None in a release that has none of the name."""
    bit = getattr(mujoco.mjtDisableBit, f"mjDSBL_{flag}", None)
    return None if bit is None else lambda model: setattr(model.opt, "disableflags", model.opt.disableflags | int(bit))


def with_option(name: str, value: float) -> Change:
    return lambda model: setattr(model.opt, name, value)


def own_invweight(model: mujoco.MjModel) -> None:
    """Let each body's inverse weight be 0 along what it cannot do: one that turns about its centre of mass moves by
    nothing, one that slides does not turn."""
    data, moves, turns = mujoco.MjData(model), np.zeros((3, model.nv)), np.zeros((3, model.nv))
    mujoco.mj_forward(model, data)
    for body in range(1, model.nbody):
        mujoco.mj_jacBodyCom(model, data, moves, turns, body)
        model.body_invweight0[body] *= [np.abs(moves).max() > 1e-9, np.abs(turns).max() > 1e-9]


def contacts_of_pads(model: mujoco.MjModel) -> None:
    """Give all that is not the robot the contact parameters of its pads."""
    pad = model.body(FINGERS[0])
    others = model.body_rootid[model.geom_bodyid] != model.body_rootid[pad.id]
    for name in ("geom_solref", "geom_solimp"):
        getattr(model, name)[others] = getattr(model, name)[pad.geomadr[0]]


SETTINGS: dict[str, Change | None] = {
    "no-nativeccd": without("NATIVECCD"),
    "no-multiccd": without("MULTICCD"),
    "no-island": without("ISLAND"),
    "noslip-10": with_option("noslip_iterations", 10),
    "impratio-10": with_option("impratio", 10.0),
    "own-invweight": own_invweight,
    "contacts-of-pads": contacts_of_pads,
}


def run(task: str, setting: str, seeds: Sequence[int]) -> dict[str, object]:
    """Run one task with one setting."""
    found = list(episodes(task, seeds, SETTINGS[setting]))
    return {"case": f"{task}.{setting}", "task": task, "setting": setting, **columns(found)}


def measure(conditions: Conditions) -> Plan:
    seeds = SEEDS[:2] if conditions.quick else SEEDS
    there = [setting for setting, change in SETTINGS.items() if change]
    rows = yield [Batch(f"{task}-{setting}", run, (task, setting, seeds)) for task in CHANGED for setting in there]
    return Measurement(rows)
