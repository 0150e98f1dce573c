"""The box on the turning table, the pinched capsule and the shake itself in other engines.

Each other engine is in an environment of its own. The capsule is one that ends between the pads, which is held by the
balls at its ends. NVIDIA's SimReady test FET028 (2 cm at 2 Hz for 2 s, slip below 3 cm) is done with our own shake.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain

import numpy as np
from tqdm import tqdm

from experiments.cure.turntable import SAMPLE_S, SETTLE_S
from experiments.engines import published, robot
from experiments.engines.engine import Engine, run_apart
from experiments.engines.scenes import FOOT_M, pinch, turntable
from experiments.facts.case import AS_SHIPPED
from experiments.scenes import capsule
from experiments.simulation.measurement import SETUP_FRAME_COUNT, Conditions, Measurement, absent
from measured_report.measuring.batch import Batch, Plan

NEEDS_GPU = False  # read by ``measured_report.measuring.machine``: small scenes, and engines that run on a CPU
SECONDS = {"full": {"turntable": 4.0, "pinch": 2.0}, "quick": {"turntable": 1.5, "pinch": 1.5}}
STEPS_S = (0.002, 0.001)
STICTION_M_S = 1e-3  # Drake's own
TEST_SHAKE = {"shake_amplitude_m": 0.02, "shake_frequency_hz": 2.0}  # type: dict
TEST_FRAMES = SETUP_FRAME_COUNT + 121  # the last one is 2 s after the first of the shake
TEST_PADS_KD = (100.0, 5.0)  # as shipped, and softer ones


@dataclass(frozen=True)
class Model:
    """One of an engine's contact models."""

    name: str
    engine: Engine
    options: dict[str, object] = field(default_factory=dict)
    steps_s: Sequence[float] = STEPS_S
    scenes: Sequence[str] = ("turntable", "pinch")
    armature: str = ""
    """Where a robot's armature is: its ``own``, or added to the ``links``; empty where it loads no robot."""


DRAKE = Engine("Drake", "1.51.1", "experiments/engines/apart/drake_run.py", ("drake==1.51.1", "numpy==2.4.6"))
BULLET = Engine("PyBullet", "3.2.7", "experiments/engines/apart/bullet_run.py", ("pybullet==3.2.7", "numpy==2.4.6"))
DART = Engine("DART", "6.20.0", "experiments/engines/apart/dart_run.py", ("dartpy==6.20.0", "numpy==2.4.6"))
WITH_SAPIEN = ("sapien==3.0.3", "numpy==2.4.6", "setuptools==81.0.0")
PHYSX = Engine("PhysX", "SAPIEN 3.0.3", "experiments/engines/apart/physx_run.py", WITH_SAPIEN)
WITH_MJX = ("mujoco-mjx==3.17.0", "mujoco==4.0.0", "jax==0.10.2", "jaxlib==0.10.2")
MJX = Engine("MJX", "3.17.0", "experiments/engines/apart/mujoco_run.py", WITH_MJX)
MUJOCO = Engine("MuJoCo", "4.0.0", "experiments/engines/apart/mujoco_run.py", ("mujoco==4.0.0", "numpy==2.4.6"))
POINT = {"contact": "point", "stiction_m_s": STICTION_M_S}
HYDROELASTIC = {"contact": "hydroelastic", "stiction_m_s": STICTION_M_S}
TAMSI = {"approximation": "tamsi"}
MODELS = (
    Model("mjx", MJX),
    Model("drake-sap-point", DRAKE, POINT, armature="own"),
    Model("drake-sap-hydroelastic", DRAKE, HYDROELASTIC, armature="own"),
    Model("drake-tamsi-point", DRAKE, POINT | TAMSI),
    Model("drake-tamsi-hydroelastic", DRAKE, HYDROELASTIC | TAMSI),
    Model("drake-tamsi-strict", DRAKE, POINT | TAMSI | {"stiction_m_s": 1e-4}),
    Model("drake-lagged-point", DRAKE, POINT | {"approximation": "lagged"}),
    Model("drake-continuous-point", DRAKE, POINT, (0.0,)),
    Model("dart", DART, armature="links"),
    Model("pybullet", BULLET, armature="links"),
    Model("physx", PHYSX, armature="own"),
    Model("discrete-20ms", MUJOCO, {"discrete": True, "timeconst_s": 0.02}, scenes=("turntable",)),
)


def measure(conditions: Conditions) -> Plan:
    """Make a row for each model, scene and step, for each shake, of a robot too, and for what others published."""
    parts = model_rows, shake_rows, published.rows
    names = "models", "shakes", "published"
    batches = [Batch(name, function, (conditions,)) for name, function in zip(names, parts, strict=True)]
    robots = [(each.name, each.engine, each.options, each.armature) for each in models_of(conditions) if each.armature]
    found = yield [*batches, Batch("robots", robot.rows, (conditions, robots))]
    return Measurement(list(chain.from_iterable(found)))


def model_rows(conditions: Conditions) -> list[dict[str, object]]:
    seconds = SECONDS[conditions.profile]
    return [row for model in tqdm(models_of(conditions), desc="engines", delay=3.0) for row in rows_of(model, seconds)]


def models_of(conditions: Conditions) -> list[Model]:
    return [model for model in MODELS if not conditions.quick or model.engine in (BULLET, DART)]


def rows_of(model: Model, seconds: Mapping[str, float]) -> Iterator[dict[str, object]]:
    scenes = {"turntable": turntable(seconds["turntable"]), "pinch": pinch(seconds["pinch"])}
    runs = [(name, step_s) for name in model.scenes for step_s in model.steps_s]
    questions = [{"scene": scenes[name], "step_s": step_s, "options": model.options} for name, step_s in runs]
    for (name, step_s), result in zip(runs, run_apart(model.engine, questions), strict=True):
        row: dict = {"case": f"{model.name}-{name}-{1e3 * step_s:g}ms", "model": model.name, "scene": name}
        row |= {"step_ms": 1e3 * step_s, "engine": model.engine.name, "release": model.engine.release}
        column, number = ("growth_per_s", growth_per_s) if name == "turntable" else ("creep_mm_s", creep_mm_s)
        try:
            yield row | {column: number(result)}
        except ValueError as error:
            yield row | absent([column], str(error))


def settled(result: dict) -> tuple[np.ndarray, np.ndarray]:
    """Return times [s] and places [m] of the body after the settling, shape [sample, 3]; ValueError without any."""
    if "reason" in result:
        raise ValueError(result["reason"])
    path = np.array(result["path"], dtype=float)
    if not np.isfinite(path).all():
        raise ValueError("a position is not finite")
    time_s = SAMPLE_S * np.arange(len(path))
    return time_s[time_s >= SETTLE_S], path[time_s >= SETTLE_S]


def growth_per_s(result: dict) -> float:
    """Say how fast the distance of the box from the axis grows [1/s]."""
    time_s, path = settled(result)
    if abs(path[-1, 2] - result["path"][0][2]) > FOOT_M:
        raise ValueError("the box is not on the table any more")
    return float(np.polyfit(time_s, np.log(np.hypot(path[:, 0], path[:, 1])), 1)[0])


def creep_mm_s(result: dict) -> float:
    """Say how fast the capsule sinks [mm/s]."""
    time_s, path = settled(result)
    if abs(path[-1, 2]) > capsule.PAD_HALF_SIZE_M[2]:
        raise ValueError("the capsule is lost")
    return -1e3 * float(np.polyfit(time_s, path[:, 2], 1)[0])


def shake_rows(conditions: Conditions) -> Sequence[Mapping[str, object]]:
    """Do the shake by the rule of FET028."""
    shipped = replace(AS_SHIPPED, frame_count=TEST_FRAMES, **TEST_SHAKE)
    cases = [replace(shipped, name=f"fet028-pad-kd-{kd:g}", pad_kd=kd) for kd in TEST_PADS_KD]
    return conditions.measure(cases, "engines").rows
