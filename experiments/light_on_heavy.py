"""Measure how fast a light box creeps on a heavy turntable, in releases of MuJoCo C."""

import numpy as np

from experiments.cure.turntable import SAMPLE_S, SETTLE_S, STEP_S, growth_per_s
from experiments.drivers.engine import Engine, run
from experiments.drivers.scene import Scene
from measured_report.files.root import ROOT
from measured_report.measuring.measurement import Conditions, absent

# ``measured_report.measuring.machine`` reads this; the section takes seconds.
NEEDS_GPU = False
SCENE = "assets/light_on_heavy.xml"
RELEASES = {
    "full": ("3.10.0", "3.11.0", "3.14.0", "3.17.0", "4.0.0"),
    "quick": ("3.11.0",),
}
CHANGES = {  # texts of the scene that other texts replace
    "implicitfast": ("", ""),
    "strict": ("1e-8", "1e-10"),
    "cold": ("enable", "disable"),
    "euler": ("implicitfast", "Euler"),
}
SECONDS = 7.0


def measure(conditions: Conditions) -> list[dict[str, object]]:
    """Return a row for each release and setting."""
    text = (ROOT / SCENE).read_text(encoding="utf-8")
    targets = [()] * round(SECONDS / SAMPLE_S)
    scenes = [
        Scene(STEP_S, SAMPLE_S, targets, text.replace(*change))
        for change in CHANGES.values()
    ]
    rows = []
    for release in RELEASES[conditions.profile]:
        engine = Engine(
            f"mujoco-{release}",
            release,
            "experiments/drivers/apart/keyframe_run.py",
            (f"mujoco=={release}", "numpy==2.2.6"),
        )
        for setting, trace in zip(CHANGES, run(scenes, engine), strict=True):
            row = {"case": f"{release}-{setting}", "release": release}
            if isinstance(trace, str):
                rows.append(row | absent(["growth_per_s"], trace))
            else:
                radius_m = np.hypot(*trace.path_m[:, :2].T)
                rows.append(row | {"growth_per_s": growth_per_s(radius_m, SETTLE_S)})
    return rows
