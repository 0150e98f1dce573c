"""The peg with contact parameters of the robot's pads: all that Meta-World's pull request 578 gives it, and each."""

from collections.abc import Sequence

import mujoco

from experiments.episodes import FINGERS, FRESH_SEEDS, columns, episodes
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.measurement import Conditions, Measurement

TASK = "peg-insert-side-v3"
SETTINGS = {
    "margin": ("margin",),
    "solref-solimp": ("solref", "solimp"),
    "friction": ("friction",),
    "condim": ("condim",),
    "all": ("margin", "solref", "solimp", "friction", "condim"),
}


def run(setting: str, seeds: Sequence[int]) -> dict[str, object]:
    """Run the task with these parameters of a pad on the peg."""

    def change(model: mujoco.MjModel) -> None:
        peg, pad = (model.body(name).geomadr[0] for name in ("peg", FINGERS[0]))
        for name in SETTINGS[setting]:
            values = getattr(model, f"geom_{name}")
            values[peg] = values[pad]

    return {"case": setting, "setting": setting, **columns(list(episodes(TASK, seeds, change)))}


def measure(conditions: Conditions) -> Plan:
    seeds = FRESH_SEEDS[:2] if conditions.quick else FRESH_SEEDS  # as many as tell three of four from nine of ten
    rows = yield [Batch(setting, run, (setting, seeds)) for setting in SETTINGS]
    return Measurement(rows)
