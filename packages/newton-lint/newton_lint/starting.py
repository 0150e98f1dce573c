"""Rules on starts from which a scene moves at once: targets, mocap bodies, loops."""

import math
from collections.abc import Iterator

import mujoco
import numpy as np
from mujoco import MjData

from newton_lint.changes import Changes, of_element, text_of
from newton_lint.failures import is_servo, origin
from newton_lint.findings import Finding, number
from newton_lint.ledger import Run
from newton_lint.pairs import where
from newton_lint.scene import HINGE, Scene
from newton_lint.trials import Symptom
from newton_lint.yielding import SITE, coupled, equality_unit, past, scale

LEAVES = 3.0
"""A start is reported if a motion of this speed begins there [m/s or rad/s]."""
EARLY = 11
"""The motion must begin within this number of samples, which is 0.2 s."""
APART_MM = 5.0
"""An equality is reported if it is at least this far open at the start [mm or °]."""
FULL_TURN = 2.0 * math.pi


def ill_posed(scene: Scene, run: Run) -> bool:
    """Return whether a joint is beyond its range at the start itself."""
    model = scene.model
    limited = where(model.jnt_limited & (model.jnt_type >= 2))
    values = run.samples[0].arrays["qpos"][model.jnt_qposadr[limited]]
    low, high = model.jnt_range[limited].T
    return bool((np.maximum(low - values, values - high) > math.radians(1.0)).any())


def fastest(run: Run) -> float:
    """Return the fastest speed within 0.2 s of the start [m/s or rad/s]."""
    speeds = [sample.speed for sample in run.samples[:EARLY]]
    return math.inf if run.bad else max(speeds)


def leaving(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield a keyframe without ctrl or act, whose servos pull their joints to 0."""
    model = scene.model
    key = run.start.key
    if key is None:
        return
    element = scene.source.find("key", key)
    authored = element.attributes if element else {}
    servos = np.flatnonzero(is_servo(model))
    data = run.start.data(model)
    mujoco.mj_forward(model, data)
    # Servos with a filter start from act, all others from ctrl.
    filtered = model.actuator_dyntype[servos] > 0
    missing = {}
    for name, values, group in (
        ("ctrl", data.ctrl.copy(), servos[~filtered]),
        ("act", data.act.copy(), servos[filtered]),
    ):
        places = model.actuator_actadr[group] if name == "act" else group
        if name not in authored and len(group) and not values[places].any():
            values[places] = data.actuator_length[group]
            missing[name] = text_of(values, 6)
    speed = fastest(run)
    if not missing or speed < LEAVES:
        return
    way = of_element(scene, "key", key, **missing)
    finding = Finding(
        "keyframe",
        run.start.name,
        "speed",
        speed,
        "$shape sets the scene in motion at $value because it has no"
        f" {' and no '.join(missing)}, so the servos pull their joints to 0",
        unit="m/s or rad/s",
        element=element,
    )
    yield Symptom(finding, fastest, [way], needs_cure=True)


def misled(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield servos of hinges whose targets are in degrees."""
    model = scene.model
    ctrl = run.start.data(model).ctrl
    for servo in where(is_servo(model)):
        joint = model.actuator_trnid[servo, 0]
        target = ctrl[servo] * model.actuator_gear[servo, 0]
        span = model.jnt_range[joint] if model.jnt_limited[joint] else (-7.0, 7.0)
        # Without a range, angles of up to a turn are plausible.
        in_range = span[0] <= math.radians(target) <= span[1]
        if model.jnt_type[joint] != HINGE:
            continue
        yield from _narrow(scene, run, joint, target)
        if abs(target) <= FULL_TURN or not in_range:
            continue
        changes: Changes = ()
        if model.actuator_ctrllimited[servo]:
            radians = np.radians(model.actuator_ctrlrange[servo])
            if np.abs(model.actuator_ctrlrange[servo]).max() > FULL_TURN:
                changes += of_element(
                    scene, "actuator", servo, ctrlrange=text_of(radians)
                )
        if run.start.key is not None:
            new = ctrl.copy()
            new[servo] = math.radians(ctrl[servo])
            changes += of_element(scene, "key", run.start.key, ctrl=text_of(new, 6))
        address = model.jnt_qposadr[joint]
        goal = math.radians(target)
        read = past("qpos", address, goal, goal, "°")
        finding = Finding(
            "degrees",
            scene.name("actuator", servo),
            "ctrl",
            math.degrees(abs(target - goal)),
            f"$shape drives its joint $value past {target:g}°{origin(run)} because ctrl"
            f" is in radians, and {target:g} was probably meant in degrees",
            unit="°",
            severity="error",
        )
        yield Symptom(finding, read, [changes])


def _narrow(scene: Scene, run: Run, joint: int, target: float) -> Iterator[Symptom]:
    """Yield a range in radians, which the compiler reads in degrees."""
    model = scene.model
    # The numbers of the file, if the compiler takes angles in degrees.
    low, high = np.degrees(model.jnt_range[joint]).tolist()
    reaches = low <= math.degrees(target) <= high
    if reaches or not low <= target <= high or high - low > FULL_TURN:
        return
    read = past("qpos", model.jnt_qposadr[joint], target, target, "°")
    finding = Finding(
        "degrees",
        scene.name("joint", joint),
        "range",
        high,
        f"$shape stops at $value and does not reach its target of"
        f" {math.degrees(target):.3g}°{origin(run)} because its range is in degrees,"
        f" and {low:g} to {high:g} was probably meant in radians",
        unit="°",
        severity="error",
    )
    wide = text_of(np.degrees([low, high]))
    yield Symptom(finding, read, [of_element(scene, "joint", joint, range=wide)])


def torn(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield equalities that are open at the start, and snap shut."""
    model = scene.model
    data = run.start.data(model)
    mujoco.mj_forward(model, data)
    for equality, gap in run.samples[0].gaps.items():
        unit = equality_unit(model, equality)
        value = scale(unit) * gap
        speed = fastest(run)
        if value < APART_MM:
            continue

        def apart(run: Run, equality=equality, unit=unit) -> float:
            return scale(unit) * run.samples[0].gaps.get(equality, 0.0)

        bodies = coupled(scene, equality)
        mocap = [body for body in bodies if model.body_mocapid[body] >= 0]
        why = ""
        if mocap:
            why = f" because its mocap body {scene.bodies[mocap[0]]} starts elsewhere"
        finding = Finding(
            "apart",
            scene.name("equality", equality),
            "gap",
            value,
            f"$shape is $value open at {run.start.name}{why}, and this equality jerks"
            f" the scene to {number(speed, 2)} m/s or rad/s",
            unit=unit,
            severity="warning" if speed > LEAVES else "note",
        )
        ways = list(_joining(scene, run, data, equality, bodies))
        yield Symptom(finding, apart, ways)


def _joining(
    scene: Scene, run: Run, data: MjData, equality: int, bodies: list[int]
) -> Iterator[Changes]:
    """Yield changes that close an equality at the start."""
    model = scene.model
    rows = data.efc_id == equality
    rows &= data.efc_type == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)
    # The first three rows are the position of the first side minus that of the second.
    gap = data.efc_pos[rows][:3]
    for body, shift in zip(bodies, (-gap, gap), strict=False):
        moved = data.xpos[body] + shift
        # Either side could move to the other one, but only a mocap body can be placed
        # freely.
        mocap = model.body_mocapid[body]
        if mocap < 0:
            continue
        if run.start.key is None:
            yield of_element(scene, "body", body, pos=text_of(moved))
        else:
            mpos = model.key_mpos[run.start.key].reshape(-1, 3).copy()
            mpos[mocap] = moved
            yield of_element(scene, "key", run.start.key, mpos=text_of(mpos.ravel(), 6))
    if model.eq_objtype[equality] == SITE and run.start.key is None:
        sites = (model.eq_obj1id[equality], model.eq_obj2id[equality])
        for site, shift in zip(sites, (-gap, gap), strict=True):
            frame = data.xmat[model.site_bodyid[site]].reshape(3, 3)
            place = model.site_pos[site] + frame.T @ shift
            yield of_element(scene, "site", site, pos=text_of(place))
