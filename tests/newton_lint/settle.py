"""Predicts by the law how fast a held body creeps, from the forces on its contacts."""

import math
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import mujoco
import numpy as np
from mujoco import MjData, MjModel

from newton_lint.law import (
    M,
    Response,
    response_of,
    settled_impedance,
    shared_slide_m_s,
)
from newton_lint.scene import Scene
from newton_lint.target import Target, TargetError

# A scene comes to rest in this time by default.
SETTLE_S = 0.5
# Forces are averaged over this share at the end of the time.
READ_SHARE = 0.2
# The body is looked for in its grip after these shares of the time.
EARLIER = (1.0, 0.1, 0.01)
# A contact slides if it uses this share of its friction cone.
AT_THE_EDGE = 0.999
# A body has not settled if it moves faster than the first number times its creep
# plus the second number [mm/s].
UNSETTLED = 2.0
UNSETTLED_MM_S = 0.5
STIFFER = 1e4
"""Ratio of normal to tangential stiffness in the model of creep."""
# A body is not held if it moves faster than the first number times the sum of its
# creep and the second number [m/s].
RUNAWAY = 3.0
LEAST_M_S = 0.05
Points = Sequence[tuple[Response, float]]
EXACT = int(getattr(mujoco.mjtEnableBit, "mjENBL_DIAGEXACT", 0))
"""The flag diagexact, which is 0 in releases that do not have it."""
FORCES = ("normal_n", "tangential_n")
"""Readings that count as 0 in steps without the contact point."""


@dataclass(frozen=True)
class Work:
    """A held body, and the motions of its support that load it besides gravity."""

    body: str
    settle_s: float = SETTLE_S
    turn_rad_s: float = 0.0
    """Rate at which the support turns about the vertical through its root."""
    lift_m_s2: float = 0.0


@dataclass(frozen=True)
class Touch:
    """A contact point of a held body, averaged over the end of the settling time."""

    geoms: tuple[int, int]
    support: int
    """The body that touches the held body."""
    share: float
    """Share of the steps in which the point exists."""
    normal_n: float
    tangential_n: np.ndarray
    """Friction force on the held body, in the world frame."""
    normal: np.ndarray
    position: np.ndarray
    used: float
    """Share of the friction cone that is used."""
    weight_1_kg: float
    """The diagonal of A that the engine uses for the contact."""
    softer: float
    """Ratio of R along the friction force to R along the first axis.

    It differs from 1 in a ``<pair>``, which has one friction coefficient per axis.
    """


@dataclass(frozen=True)
class Hold:
    """A held body with its contacts and its predicted creep."""

    body: int
    name: str
    touches: Sequence[Touch]
    load_n: float
    mm_s: float
    """Predicted creep; infinite if the body slides."""
    acceleration_mm_s: float
    """The part of the creep that is caused by J̇·q̇."""
    moves_mm_s: float
    """Speed of the body relative to its support in the simulated state."""
    data: MjData = field(compare=False, repr=False)
    """The simulated state."""

    @property
    def slides(self) -> bool:
        return not math.isfinite(self.mm_s)

    @property
    def point_count(self) -> float:
        return sum(touch.share for touch in self.touches)

    @property
    def rests(self) -> bool:
        """Return whether the body moves no faster than it creeps."""
        return self.moves_mm_s <= UNSETTLED * self.mm_s + UNSETTLED_MM_S


def settled_hold(scene: Scene, target: Target, work: Work) -> Hold | None:
    """Let the scene settle and predict the creep of the held body.

    Returns:
        The prediction, or None if nothing touches the body.

    Raises:
        TargetError: The scene has no such body.
    """
    if work.body not in scene.bodies[1:]:
        bodies = ", ".join(scene.bodies[1:][:12])
        raise TargetError(
            f"{target.name}: the scene has no body {work.body}; it has {bodies}"
        )
    body = scene.bodies.index(work.body)
    for share in EARLIER:
        time_s = share * work.settle_s
        data = settled(
            scene.model, started(scene.model, target.data), time_s * (1.0 - READ_SHARE)
        )
        steps = max(1, round(time_s * READ_SHARE / scene.model.opt.timestep))
        if touches := touches_of(scene, data, body, steps):
            hold = predicted_hold(scene, body, touches, work, data)
            # If the body was only held earlier, it has been lost since.
            return hold if share == 1.0 else replace(hold, mm_s=math.inf)
    return None


def started(model: MjModel, state: MjData | None = None) -> MjData:
    """Return the start of a scene: a given state, its first keyframe or its default."""
    data = MjData(model)
    if state is not None:
        # mj_copyData would need the same model, but this one may have other options.
        data.time = state.time
        for name in (
            "qpos",
            "qvel",
            "act",
            "ctrl",
            "mocap_pos",
            "mocap_quat",
            "qacc_warmstart",
        ):
            getattr(data, name)[:] = getattr(state, name)
    elif model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    return data


def settled(model: MjModel, data: MjData, time_s: float) -> MjData:
    mujoco.mj_step(model, data, nstep=round(time_s / model.opt.timestep))
    return data


def touches_of(scene: Scene, data: MjData, body: int, step_count: int) -> list[Touch]:
    """Step on and return the averaged contact points of a body and its welded parts."""
    model = scene.model
    body_of = model.geom_bodyid
    is_held = model.body_weldid == model.body_weldid[body]
    readings: dict[Any, list[dict[str, Any]]] = defaultdict(list)
    for _ in range(step_count):
        mujoco.mj_step(model, data)
        counts: Counter[tuple[int, int]] = Counter()
        geoms = data.contact.geom
        # A flex has the geom -1.
        on_body = (geoms >= 0) & is_held[body_of[geoms]]
        for index in np.flatnonzero(on_body[:, 0] != on_body[:, 1]).tolist():
            # mj_contactForce returns the force on the second geom.
            if reading := _reading(
                scene, data, index, 1.0 if on_body[index, 1] else -1.0
            ):
                geom1, geom2 = sorted(geoms[index].tolist())
                readings[(geom1, geom2), counts[geom1, geom2]].append(reading)
                counts[geom1, geom2] += 1
    touches = []
    for (pair, _), series in readings.items():
        sums = {name: sum(reading[name] for reading in series) for name in series[0]}
        # Forces are averaged over all steps, other readings over those with the point.
        touches.append(
            Touch(
                geoms=pair,
                support=next(
                    int(side) for side in body_of[list(pair)] if not is_held[side]
                ),
                share=len(series) / step_count,
                **{
                    name: total / (step_count if name in FORCES else len(series))
                    for name, total in sums.items()
                },
            )
        )
    return touches


def _reading(
    scene: Scene, data: MjData, index: int, sign: float
) -> dict[str, Any] | None:
    """Return the readings of a contact, or None if it bears no force.

    Args:
        sign: 1 or -1, so that the friction acts on the held body.
    """
    model = scene.model
    contact = data.contact[index]
    force = np.zeros(6)
    # A contact within the gap, or between bodies that cannot move, has no rows.
    if contact.efc_address < 0:
        return None
    mujoco.mj_contactForce(model, data, index, force)
    if force[0] <= 0.0:
        return None
    frame = contact.frame.reshape(3, 3)  # The rows are the normal and both tangents.
    shares = np.abs(force[1:3]) / contact.friction[:2]
    used = (
        float(shares.sum() if scene.option.cone == "pyramidal" else np.hypot(*shares))
        / force[0]
    )
    along1, along2 = force[1:3] ** 2 / max(force[1:3] @ force[1:3], mujoco.mjMINVAL)
    # mj_makeImpedance: R μ² is the same along both tangents.
    softer = (
        along1 + along2 * (contact.friction[0] / contact.friction[1]) ** 2
        if along1 + along2
        else 1.0
    )
    return {
        "normal_n": force[0],
        "tangential_n": sign * (force[1:3] @ frame[1:]),
        "normal": frame[0].copy(),
        "position": contact.pos.copy(),
        "used": used,
        "weight_1_kg": _weight(scene, data, index),
        "softer": softer,
    }


def _weight(scene: Scene, data: MjData, index: int) -> float:
    """Return the diagonal of A that the engine uses for a contact with rows."""
    model = scene.model
    contact = data.contact[index]
    stiffness, damping, d = data.efc_KBIP[contact.efc_address, :3]
    # mj_makeImpedance: R = (1 - d) / d · weight
    weight = data.efc_R[contact.efc_address] * d / (1.0 - d)
    if scene.option.discrete:
        h = model.opt.timestep
        weight *= 1.0 + damping * h + stiffness * d * h * h
    if scene.option.cone == "pyramidal" and contact.dim > 1:
        mu = contact.friction[0]
        # An edge of the pyramid has this multiple of R and of the weight.
        weight *= model.opt.impratio / (2.0 * mu**2 * (1.0 + mu**2))
    return weight


def predicted_hold(
    scene: Scene, body: int, touches: Sequence[Touch], work: Work, data: MjData
) -> Hold:
    """Return the creep that the law predicts for a body held as in ``data``.

    Args:
        scene: The scene, possibly with other settings than those of ``data``.
        work: Further motions of the support.
    """
    model = scene.model
    option = scene.option
    mass = model.body_subtreemass[body]
    gravity = model.opt.gravity
    down = gravity / max(np.linalg.norm(gravity), 1e-12)
    flat = np.mean(
        [np.eye(3) - np.outer(touch.normal, touch.normal) for touch in touches], axis=0
    )

    turning = np.zeros(3)
    points = []
    for touch in touches:
        contact = replace(
            scene.contacts.contact(scene.pair_index(touch.geoms)),
            weight_1_kg=touch.weight_1_kg,
        )
        plain = response_of(
            contact, option, settled_impedance(contact, option, touch.normal_n)
        )
        mu = plain.mu / math.sqrt(touch.softer)
        response = replace(plain, load_m_s_n=plain.load_m_s_n * touch.softer, mu=mu)
        points.append((response, touch.normal_n))
        arm = touch.position - data.xpos[model.body_rootid[touch.support]]
        outward = work.turn_rad_s**2 * (arm - (arm @ down) * down)
        if work.turn_rad_s:
            across = outward - (outward @ touch.normal) * touch.normal
            turning = turning + response.acceleration_s * across / len(touches)
    arm = data.subtree_com[body] - data.xpos[model.body_rootid[touches[0].support]]
    centrifugal = work.turn_rad_s**2 * (arm - (arm @ down) * down)
    inertial_forces = flat @ (mass * (work.lift_m_s2 * down + centrifugal))
    # The load is the force that friction has to bear.
    load = inertial_forces - sum((touch.tangential_n for touch in touches), np.zeros(3))
    total = np.linalg.norm(load)
    grip = sum(touch.used * touch.normal_n for touch in touches) / sum(
        touch.normal_n for touch in touches
    )
    slide = shared_slide_m_s(points, total)
    creep = np.zeros(3)
    if all(response.load_m_s_n for response, _ in points) and slide < 1.0 and total:
        linear = total / sum(1.0 / response.load_m_s_n for response, _ in points)
        creep = _slide(model, data, touches, points, body, inertial_forces) * (
            slide / linear
        )
    rate = np.linalg.norm(turning + creep)
    speed = _speed(model, data, body, touches[0].support)
    if grip > AT_THE_EDGE or slide >= 1.0 or speed > RUNAWAY * (rate + LEAST_M_S):
        rate = math.inf
    return Hold(
        body=body,
        name=scene.bodies[body],
        touches=touches,
        load_n=total,
        mm_s=M * rate,
        acceleration_mm_s=M * np.linalg.norm(turning),
        moves_mm_s=M * speed,
        data=data,
    )


def _slide(
    model: MjModel,
    data: MjData,
    touches: Sequence[Touch],
    points: Points,
    body: int,
    more_n: np.ndarray,
) -> np.ndarray:
    """Return the velocity at which a body creeps [m/s].

    Only joints that do not move the support take part.
    """
    support = np.zeros((3, model.nv))
    mujoco.mj_jac(model, data, support, None, data.xpos[body], touches[0].support)
    # dofs that do not move the support
    alone = ~support.any(axis=0)
    jacobian = np.zeros((3, model.nv))
    mujoco.mj_jac(model, data, jacobian, None, data.subtree_com[body], body)
    centre = jacobian[:, alone].copy()
    bears = np.zeros((alone.sum(), alone.sum()))
    acts = centre.T @ more_n
    hard = STIFFER / min(response.load_m_s_n for response, _ in points)
    for touch, (response, _) in zip(touches, points, strict=True):
        mujoco.mj_jac(model, data, jacobian, None, touch.position, body)
        along = np.eye(3) - np.outer(touch.normal, touch.normal)
        stiffness = along / response.load_m_s_n + hard * np.outer(
            touch.normal, touch.normal
        )
        bears += jacobian[:, alone].T @ stiffness @ jacobian[:, alone]
        acts -= jacobian[:, alone].T @ touch.tangential_n
    # Two points let the body turn about the line between them, so the system may be
    # singular.
    return centre @ np.linalg.lstsq(bears, acts, rcond=1e-12)[0]


def _speed(model: MjModel, data: MjData, body: int, support: int) -> float:
    velocities = np.zeros((2, 6))  # Rotation comes first, then translation.
    kind = int(mujoco.mjtObj.mjOBJ_BODY)
    for moving, velocity in zip((body, support), velocities, strict=True):
        mujoco.mj_objectVelocity(model, data, kind, moving, velocity, 0)
    motion, carrier = velocities
    carried = carrier[3:] + np.cross(carrier[:3], data.xpos[body] - data.xpos[support])
    return np.linalg.norm(motion[3:] - carried)
