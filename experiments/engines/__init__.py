"""The box on the turning table and the pinched capsule in other engines, each in an environment of its own.

The capsule is one that ends between the pads, which is held by the balls at its ends. NVIDIA's SimReady test FET028
(2 cm at 2 Hz for 2 s, passed below 3 cm of slip) is done with the shake of this report.
"""

import json
import subprocess
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from tqdm import tqdm

from experiments.engines.laws import LAWS, Load, walk_per_s
from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.scenes import capsule
from experiments.simulation.measurement import SETUP_FRAME_COUNT, Conditions, Measurement, absent
from experiments.turntable import MASS_KG, MJCF, RADIUS_M, SAMPLE_S, SETTLE_S, TURN_RAD_S
from experiments.turntable_solvers import FEET, FOOT_M, HALF_EDGE_M, TABLE_INERTIA
from measured_report.editions.environment import python_with
from measured_report.files.errors import UsageError
from measured_report.files.root import ROOT

NEEDS_GPU = False
"""Read by ``measured_report.editions.devices``: small scenes, and engines that run on a CPU."""
SECONDS = {"full": {"turntable": 4.0, "pinch": 2.0}, "quick": {"turntable": 1.5, "pinch": 1.5}}
STEPS_S = (0.002, 0.001)
PRESS_N = 12.0
"""What each pad presses with, as in the report that section capsule is after."""
CAPSULE = capsule.Pinch("within-pads", half_length_m=0.02)
STICTION_M_S = 1e-3
"""Drake's own."""
SHARED = "assets/engines/apart.py"
GROWTHS = ("growth_per_s", "predicted_growth_per_s", "end_height_mm")
CREEPS = ("creep_mm_s", "predicted_creep_mm_s")
TEST_SHAKE = {"shake_amplitude_m": 0.02, "shake_frequency_hz": 2.0}
TEST_FRAMES = SETUP_FRAME_COUNT + 121
"""The last one is 2 s after the first of the shake."""
TEST_PADS_KD = (100.0, 50.0, 20.0, 10.0, 5.0, 2.0)


@dataclass(frozen=True)
class Engine:
    """An engine, what of it is installed, and the script that runs scenes in it."""

    name: str
    release: str
    script: str
    requirements: tuple[str, ...]


@dataclass(frozen=True)
class Model:
    """One of an engine's contact models."""

    name: str
    engine: Engine
    law: str = ""
    """Of ``LAWS``; empty where it is MuJoCo's, which sections turntable and capsule have."""
    options: dict[str, object] = field(default_factory=dict)
    steps_s: Sequence[float] = STEPS_S
    scenes: Sequence[str] = ("turntable", "pinch")


DRAKE = Engine("Drake", "1.51.1", "assets/engines/drake_run.py", ("drake==1.51.1", "numpy==2.4.6"))
BULLET = Engine("PyBullet", "3.2.7", "assets/engines/bullet_run.py", ("pybullet==3.2.7", "numpy==2.4.6"))
DART = Engine("DART", "6.20.0", "assets/engines/dart_run.py", ("dartpy==6.20.0", "numpy==2.4.6"))
PHYSX = Engine(
    "PhysX", "SAPIEN 3.0.3", "assets/engines/physx_run.py", ("sapien==3.0.3", "numpy==2.4.6", "setuptools==81.0.0")
)
WITH_MJX = ("mujoco-mjx==3.17.0", "mujoco==4.0.0", "jax==0.10.2", "jaxlib==0.10.2")
MJX = Engine("MJX", "3.17.0", "assets/engines/mujoco_run.py", WITH_MJX)
MUJOCO = Engine("MuJoCo", "4.0.0", "assets/engines/mujoco_run.py", ("mujoco==4.0.0", "numpy==2.4.6"))
POINT = {"contact": "point", "stiction_m_s": STICTION_M_S}
HYDROELASTIC = {"contact": "hydroelastic", "stiction_m_s": STICTION_M_S}
TAMSI = {"approximation": "tamsi"}
TIMECONSTS_S = (0.02, 0.01)
DISCRETE_STEPS_S = (0.001, 0.002, 0.005, 0.01)
MODELS = (
    Model("mjx", MJX),
    Model("drake-sap-point", DRAKE, "sap", POINT),
    Model("drake-sap-hydroelastic", DRAKE, "sap", HYDROELASTIC),
    Model("drake-tamsi-point", DRAKE, "tamsi", POINT | TAMSI),
    Model("drake-tamsi-hydroelastic", DRAKE, "tamsi", HYDROELASTIC | TAMSI),
    Model("drake-tamsi-strict", DRAKE, "tamsi", POINT | TAMSI | {"stiction_m_s": 1e-4}),
    Model("drake-lagged-point", DRAKE, "lagged", POINT | {"approximation": "lagged"}),
    Model("drake-continuous-point", DRAKE, "stribeck", POINT, (0.0,)),
    Model("dart", DART, "mixed"),
    Model("pybullet", BULLET, "rigid"),
    Model("physx", PHYSX, "anchored"),
    *(
        Model(f"discrete-{1e3 * timeconst_s:g}ms", MUJOCO, "discrete", options, DISCRETE_STEPS_S, ("turntable",))
        for timeconst_s in TIMECONSTS_S
        for options in [{"discrete": True, "timeconst_s": timeconst_s}]
    ),
)


def measure(conditions: Conditions) -> Measurement:
    """A row for each model, scene and step, and one for each shake of the test."""
    models = [model for model in MODELS if not conditions.quick or model.engine in (BULLET, DART)]
    rows = [
        row for model in tqdm(models, desc="engines", delay=3.0) for row in _rows(model, SECONDS[conditions.profile])
    ]
    return Measurement([*rows, *_test_rows(conditions)])


def _rows(model: Model, seconds: Mapping[str, float]) -> Iterator[dict[str, object]]:
    scenes = {"turntable": turntable(seconds["turntable"]), "pinch": pinch(seconds["pinch"])}
    runs = [(name, step_s) for name in model.scenes for step_s in model.steps_s]
    asked = [{"scene": scenes[name], "step_s": step_s, "options": model.options} for name, step_s in runs]
    for (name, step_s), result in zip(runs, run_apart(model.engine, asked), strict=True):
        row = {
            "case": f"{model.name}-{name}-{1e3 * step_s:g}ms",
            "model": model.name,
            "scene": name,
            "step_ms": 1e3 * step_s,
        }
        row |= {"engine": model.engine.name, "release": model.engine.release}
        columns = growth_columns if name == "turntable" else creep_columns
        try:
            yield row | columns(model, scenes[name], step_s, result)
        except ValueError as error:
            yield row | absent(GROWTHS if name == "turntable" else CREEPS, str(error))


def run_apart(engine: Engine, asked: Sequence[dict]) -> list[dict]:
    """What the runs show that an engine is asked for; ``reason`` in the place of it where it shows nothing."""
    try:
        python = python_with(f"engine-{engine.name.lower()}", engine.requirements)
    except UsageError as error:
        return [{"reason": str(error)}] * len(asked)
    with tempfile.TemporaryDirectory() as folder:
        question, answer = Path(folder) / "asked.json", Path(folder) / "answer.json"
        question.write_text(json.dumps(asked), encoding="utf-8")
        call = [python, ROOT / engine.script, question, answer]
        done = subprocess.run(call, cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode:
            last = done.stderr.strip().splitlines()[-1:] or [f"it ended with status {done.returncode}"]
            return [{"reason": last[0][:120]}] * len(asked)
        return json.loads(answer.read_text(encoding="utf-8"))


def turntable(seconds: float) -> dict[str, object]:
    """The box on four feet on the turning table, in rest on it."""
    inertia = [MASS_KG / 3.0 * (HALF_EDGE_M**2 + 0.04**2)] * 2 + [MASS_KG / 3.0 * 2.0 * HALF_EDGE_M**2]
    body = {"mass_kg": MASS_KG, "inertia_kg_m2": inertia, "feet": FEET, "foot_m": FOOT_M, "place": [RADIUS_M, 0.0, 0.1]}
    body |= {"velocity": [0.0, TURN_RAD_S * RADIUS_M, 0.0], "spin": [0.0, 0.0, TURN_RAD_S]}
    table = {"joint": "hinge", "axis": [0.0, 0.0, 1.0], "half_size": [0.5, 0.5, 0.05], "place": [0.0, 0.0, 0.0]}
    table |= {"mass_kg": TABLE_INERTIA, "inertia_kg_m2": TABLE_INERTIA, "speed": TURN_RAD_S, "force_n": 0.0}
    start = [TURN_RAD_S, 0.0, TURN_RAD_S * RADIUS_M, 0.0, 0.0, 0.0, TURN_RAD_S]
    return _scene(seconds, 1.0, body, [table]) | {"mjcf": MJCF, "qvel": start, "ctrl": []}


def pinch(seconds: float) -> dict[str, object]:
    """Two pads that press on a capsule's ends, which touch them."""
    mass, radius, half = capsule.MASS_KG, capsule.RADIUS_M, CAPSULE.half_length_m
    across, along = mass * (radius**2 / 4.0 + half**2 / 3.0), mass * radius**2 / 2.0
    body = {"mass_kg": mass, "inertia_kg_m2": [across, along, across], "foot_m": radius, "place": [0.0, 0.0, 0.0]}
    body |= {"feet": [[0.0, -half, 0.0], [0.0, half, 0.0]], "velocity": [0.0, 0.0, 0.0], "spin": [0.0, 0.0, 0.0]}
    size = capsule.PAD_HALF_SIZE_M
    pad = {"joint": "slide", "axis": [1.0, 0.0, 0.0], "half_size": size, "mass_kg": capsule.PAD_MASS_KG, "speed": 0.0}
    pads = [
        pad | {"inertia_kg_m2": 1e-3, "place": [side * (radius + size[0]), 0.0, 0.0], "force_n": -side * PRESS_N}
        for side in (-1.0, 1.0)
    ]
    travel = capsule.GAP_M + capsule.SQUEEZE_M
    start = {"mjcf": CAPSULE.mjcf(), "qvel": [0.0] * 8, "ctrl": [travel, -travel]}
    return _scene(seconds, capsule.FRICTION[0], body, pads) | start


def _scene(seconds: float, friction: float, body: dict, supports: list[dict]) -> dict[str, object]:
    scene = {"seconds": seconds, "sample_s": SAMPLE_S, "gravity_m_s2": capsule.GRAVITY_M_S2, "friction": friction}
    return scene | {"body": body, "supports": supports}


def settled(result: dict) -> tuple[np.ndarray, np.ndarray]:
    """Times [s] and places [m] of the body, shape [sample, 3], after the settling; ValueError where there are none."""
    if "reason" in result:
        raise ValueError(result["reason"])
    path = np.array(result["path"], dtype=float)
    if not np.isfinite(path).all():
        raise ValueError("a position is not finite")
    time_s = SAMPLE_S * np.arange(len(path))
    return time_s[time_s >= SETTLE_S], path[time_s >= SETTLE_S]


def growth_columns(model: Model, scene: dict, step_s: float, result: dict) -> dict[str, object]:
    """How fast the distance of the box from the axis grows, measured and by the model's law."""
    time_s, path = settled(result)
    if abs(path[-1, 2] - scene["body"]["place"][2]) > FOOT_M:
        raise ValueError("the box is not on the table any more")
    radius = np.hypot(path[:, 0], path[:, 1])
    row: dict[str, object] = {"growth_per_s": float(np.polyfit(time_s, np.log(radius), 1)[0])}
    row["end_height_mm"] = 1e3 * float(path[-1, 2])
    if not model.law:
        return row | absent(["predicted_growth_per_s"], "it is MuJoCo's, which section turntable has")
    middle = float(np.exp(np.mean(np.log(radius))))
    force, normal = MASS_KG * TURN_RAD_S**2 * middle, MASS_KG * capsule.GRAVITY_M_S2
    load = _load(model, scene, step_s, result, force, (1.0, 0.0, 0.0), normal, np.zeros((3, 3)))
    return row | {"predicted_growth_per_s": walk_per_s(model.law, load, TURN_RAD_S, middle)}


def creep_columns(model: Model, scene: dict, step_s: float, result: dict) -> dict[str, object]:
    """How fast the capsule sinks, measured and by the model's law."""
    time_s, path = settled(result)
    row: dict[str, object] = {"creep_mm_s": -1e3 * float(np.polyfit(time_s, path[:, 2], 1)[0])}
    if abs(path[-1, 2]) > capsule.PAD_HALF_SIZE_M[2]:
        raise ValueError("the capsule is lost")
    if not model.law:
        return row | absent(["predicted_creep_mm_s"], "it is MuJoCo's, which section capsule has")
    force, leaning = capsule.MASS_KG * capsule.GRAVITY_M_S2, np.diag([1.0 / capsule.PAD_MASS_KG, 0.0, 0.0])
    load = _load(model, scene, step_s, result, force, (0.0, 0.0, 1.0), 2.0 * PRESS_N, leaning)
    return row | {"predicted_creep_mm_s": 1e3 * LAWS[model.law](load)}


def _load(model, scene, step_s, result, force_n, direction, normal_n, support) -> Load:
    body, stiction_m_s = scene["body"], model.options.get("stiction_m_s", STICTION_M_S)
    carried = {"force_n": force_n, "direction": direction, "normal_n": normal_n, "friction": scene["friction"]}
    held = {name: body[name] for name in ("mass_kg", "inertia_kg_m2")} | {"support_inverse_mass_1_kg": support}
    held |= {"timeconst_s": model.options.get("timeconst_s"), "yields_1_kg": result.get("regularization_1_kg")}
    return Load(**carried, **held, step_s=step_s, stiction_m_s=stiction_m_s, contacts=result.get("contacts", ()))


def _test_rows(conditions: Conditions) -> list[dict[str, object]]:
    """The shake by the rule of FET028, with stiff pads and with ever softer ones."""
    cases = [replace(STIFF_PADS, name="fet028-stiff-pads")]
    cases += [replace(AS_SHIPPED, name=f"fet028-pad-kd-{kd:g}", pad_kd=kd) for kd in TEST_PADS_KD]
    return list(
        conditions.measure([replace(case, frame_count=TEST_FRAMES, **TEST_SHAKE) for case in cases], "engines").rows
    )
