"""Run the tasks that a release changed, each with one changed setting.

The setting that restores the old behaviour shows the cause of the change.
"""

import mujoco
import numpy as np

from experiments.episodes import FINGERS, FRESH_SEEDS, Change, columns, episodes
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.measurement import Conditions, Measurement

TASKS = (
    "dial-turn-v3",
    "door-lock-v3",
    "peg-insert-side-v3",
    "push-back-v3",
    "stick-push-v3",
)


def with_option(name: str, value: float) -> Change:
    return lambda model: setattr(model.opt, name, value)


def own_invweight(model: mujoco.MjModel) -> None:
    """Set the inverse weight of each body to 0 for the motion that it cannot make.

    A body that only rotates about its centre of mass cannot translate, and one that only slides cannot rotate.
    """
    data, moves, turns = (
        mujoco.MjData(model),
        np.zeros((3, model.nv)),
        np.zeros((3, model.nv)),
    )
    mujoco.mj_forward(model, data)
    for body in range(1, model.nbody):
        mujoco.mj_jacBodyCom(model, data, moves, turns, body)
        model.body_invweight0[body] *= [
            np.abs(moves).max() > 1e-9,
            np.abs(turns).max() > 1e-9,
        ]


def like_pads(*names: str) -> Change:
    """Return a change that gives these contact parameters of the robot's pads to all moving objects."""

    def change(model: mujoco.MjModel) -> None:
        pad, bodies = model.body(FINGERS[0]), model.geom_bodyid
        things = (model.body_rootid[bodies] != model.body_rootid[pad.id]) & (
            model.body_jntnum[bodies] > 0
        )
        for name in names:
            values = getattr(model, f"geom_{name}")
            values[things] = values[pad.geomadr[0]]

    return change


SETTINGS: dict[str, Change] = {
    "no-nativeccd": with_option(
        "disableflags", int(mujoco.mjtDisableBit.mjDSBL_NATIVECCD)
    ),
    "noslip-10": with_option("noslip_iterations", 10),
    "impratio-10": with_option("impratio", 10.0),
    "own-invweight": own_invweight,
    "margin": like_pads("margin"),
    "solref-solimp": like_pads("solref", "solimp"),
    "friction": like_pads("friction"),
    "condim": like_pads("condim"),
    "all-of-pads": like_pads(
        "margin", "solref", "solimp", "friction", "condim"
    ),  # as in Meta-World's pull request 578
}


def run(task: str, setting: str, seeds: range) -> dict[str, object]:
    """Run one task with one setting."""
    found = list(episodes(task, seeds, SETTINGS[setting]))
    return {
        "case": f"{task}.{setting}",
        "task": task,
        "setting": setting,
        **columns(found),
    }


def measure(conditions: Conditions) -> Plan:
    seeds = FRESH_SEEDS[:2] if conditions.quick else FRESH_SEEDS
    rows = yield [
        Batch(f"{task}-{each}", run, (task, each, seeds))
        for task in TASKS
        for each in SETTINGS
    ]
    return Measurement(rows)
