"""Measure the box on the turntable, the capsule and the shake in other engines.

The capsule ends between the pads, so that the balls at its ends hold it. NVIDIA's
SimReady test FET028 (2 cm at 2 Hz for 2 s, slip below 3 cm) uses the shake of this
report.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, product

import numpy as np
from tqdm import tqdm

from experiments.cure.turntable import SAMPLE_S, SETTLE_S, growth_per_s
from experiments.drivers.engine import Engine, run
from experiments.drivers.scene import Trace
from experiments.engines import published, robot
from experiments.facts.case import AS_SHIPPED
from experiments.scenes.capsule import PAD_HALF_SIZE_M
from experiments.scenes.pinch import pinch
from experiments.scenes.turntable import FOOT_M, turntable
from experiments.simulation.measurement import (
    SETUP_FRAME_COUNT,
    Conditions,
    Measurement,
    absent,
)
from measured_report.measuring.batch import Batch, Plan

# ``measured_report.measuring.machine`` reads this; the section takes minutes
NEEDS_GPU = False
SECONDS = {
    "full": {"turntable": 4.0, "pinch": 2.0},
    "quick": {"turntable": 1.5, "pinch": 1.5},
}
SCENES = {"turntable": turntable, "pinch": pinch}
LOST = {  # the column, the fall [m] after which it cannot be measured, and the reason
    "turntable": ("growth_per_s", FOOT_M, "the box is not on the table any more"),
    "pinch": ("creep_mm_s", PAD_HALF_SIZE_M[2], "the capsule is lost"),
}
STICTION_M_S = 1e-3  # Drake's default
NUMPY = "numpy==2.4.6"
DRAKE = Engine(
    "Drake",
    "1.51.1",
    "experiments/drivers/apart/drake_run.py",
    ("drake==1.51.1", NUMPY),
)
BULLET = Engine(
    "PyBullet",
    "3.2.7",
    "experiments/drivers/apart/bullet_run.py",
    ("pybullet==3.2.7", NUMPY),
)
DART = Engine(
    "DART", "6.20.0", "experiments/drivers/apart/dart_run.py", ("dartpy==6.20.0", NUMPY)
)
PHYSX = Engine(
    "PhysX",
    "SAPIEN 3.0.3",
    "experiments/drivers/apart/physx_run.py",
    ("sapien==3.0.3", NUMPY, "setuptools==81.0.0"),
)
MJX = Engine(
    "MJX",
    "3.17.0",
    "experiments/drivers/apart/mujoco_run.py",
    ("mujoco-mjx==3.17.0", "mujoco==4.0.0", "jax==0.10.2", "jaxlib==0.10.2"),
)
MUJOCO = Engine(
    "MuJoCo",
    "4.0.0",
    "experiments/drivers/apart/mujoco_run.py",
    ("mujoco==4.0.0", NUMPY),
    {"discrete": True, "timeconst_s": 0.02},
)


def drake(
    contact: str, approximation: str = "sap", stiction_m_s=STICTION_M_S
) -> Engine:
    options = {
        "contact": contact,
        "approximation": approximation,
        "stiction_m_s": stiction_m_s,
    }
    return replace(DRAKE, options=options)


@dataclass(frozen=True)
class Model:
    """Describe one of an engine's contact models."""

    name: str
    engine: Engine
    steps_s: Sequence[float] = (0.002, 0.001)
    scenes: Sequence[str] = ("turntable", "pinch")
    # How the robot gets armature (see ``robot.write_robot``); empty if it is not
    # shaken.
    armature: str = ""


MODELS = (
    Model("mjx", MJX),
    Model("drake-sap-point", drake("point"), armature="own"),
    Model("drake-sap-hydroelastic", drake("hydroelastic"), armature="own"),
    Model("drake-tamsi-point", drake("point", "tamsi")),
    Model("drake-tamsi-hydroelastic", drake("hydroelastic", "tamsi")),
    Model("drake-tamsi-strict", drake("point", "tamsi", 1e-4)),
    Model("drake-lagged-point", drake("point", "lagged")),
    Model("drake-continuous-point", drake("point"), (0.0,)),
    Model("dart", DART, armature="links"),
    Model("pybullet", BULLET, armature="links"),
    Model("physx", PHYSX, armature="own"),
    Model("discrete-20ms", MUJOCO, scenes=("turntable",)),
)
QUICK = ("dart", "pybullet")
# Damping of the pads in FET028: the default, and a lower one.
PADS_KD = (100.0, 5.0)


def measure(conditions: Conditions) -> Plan:
    """Return rows for each model, scene and step, for the shakes, and for the published
    scenes.
    """
    models = [each for each in MODELS if not conditions.quick or each.name in QUICK]
    found = yield [
        Batch("models", model_rows, (models, conditions.profile)),
        Batch("shakes", shake_rows, (conditions,)),
        Batch("published", published.rows, (conditions,)),
        Batch("robots", robot.rows, (conditions, models)),
    ]
    return Measurement(list(chain.from_iterable(found)))


def model_rows(models: Sequence[Model], profile: str) -> list[dict[str, object]]:
    """Return a row for each model, scene and step."""
    rows = []
    for model in tqdm(models, desc="engines", delay=3.0):
        runs = list(product(model.scenes, model.steps_s))
        seconds = SECONDS[profile]
        scenes = [SCENES[name](step_s, seconds[name]) for name, step_s in runs]
        traces = run(scenes, model.engine)
        for (name, step_s), trace in zip(runs, traces, strict=True):
            row = {
                "case": f"{model.name}-{name}-{1e3 * step_s:g}ms",
                "model": model.name,
                "scene": name,
                "step_ms": 1e3 * step_s,
                "engine": model.engine.name,
                "release": model.engine.release,
            }
            rows.append(row | columns(name, trace))
    return rows


def columns(name: str, trace: Trace | str) -> dict[str, object]:
    """Return the growth of the box's radius, or the creep of the capsule."""
    column, drop_m, lost = LOST[name]
    if isinstance(trace, str):
        return absent([column], trace)
    if not np.isfinite(trace.path_m).all():
        return absent([column], "a position is not finite")
    x, y, height_m = trace.path_m.T
    if abs(height_m[-1] - height_m[0]) > drop_m:
        return absent([column], lost)
    if name == "turntable":
        return {column: growth_per_s(np.hypot(x, y), SETTLE_S)}
    time_s = SAMPLE_S * np.arange(len(height_m))
    is_settled = time_s >= SETTLE_S
    slope = np.polyfit(time_s[is_settled], height_m[is_settled], 1)[0]
    return {column: -1e3 * float(slope)}


def shake_rows(conditions: Conditions) -> Sequence[Mapping[str, object]]:
    """Return the rows of the FET028 shake, which ends 2 s after its first frame."""
    shipped = replace(
        AS_SHIPPED,
        shake_amplitude_m=0.02,
        shake_frequency_hz=2.0,
        frame_count=SETUP_FRAME_COUNT + 121,
    )
    cases = [
        replace(shipped, name=f"fet028-pad-kd-{kd:g}", pad_kd=kd) for kd in PADS_KD
    ]
    return conditions.measure(cases, "engines").rows
