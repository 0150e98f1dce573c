"""Rules on bodies that friction holds, and that creep, slide or turn."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from mujoco import MjModel

from newton_lint.changes import (
    Changes,
    distinct,
    elliptic,
    of_contacts,
    of_element,
    of_geom,
    text_of,
)
from newton_lint.failures import origin
from newton_lint.findings import Finding, number
from newton_lint.law import M
from newton_lint.ledger import Run, Sample
from newton_lint.pairs import where
from newton_lint.scene import FREE, ON_JOINT, Scene
from newton_lint.trials import Symptom
from newton_lint.yielding import noslip, stiffest

SLIP_MM_S = 1.0
"""By default, a body that moves at least this fast on its support creeps."""
GRIPPED = 0.1
"""In a grip, this share of the speed is enough: the body is lost after a while."""
LEAST = 0.015
"""Friction must bear this share of the weight of a body that creeps."""
STEADY = 0.7
"""A creeping body moves in one direction for this share of its path."""
SLOWS = 0.5
"""A body comes to rest if its speed falls below this share of the speed before."""
ROLLS = 2.9
"""A body rolls if the trace of its rotation is below this one, which is 18°."""
AT_THE_EDGE = 0.99
"""A contact slides if it uses this share of its friction cone."""
OPPOSE = -0.5
"""Two contacts oppose each other if the cosine of their normals is below this."""
TURNS_DEG = 5.0
"""A held body turns if it turns by more than this angle in 2 s."""
EARLY = 0.25
"""A grip counts if it exists within this share of the run."""
FIRM = 1.5
"""A grip that is mended bears this multiple of the load."""
MOST_MU = 2.0
MOST_IMPRATIO = 1000.0
"""The solver converges badly with a higher impratio."""
TORSION = 0.02
"""Torsional friction of a soft fingertip with a radius of some centimetres [m]."""


@dataclass(frozen=True)
class Grip:
    """The contacts that hold a body in one sample."""

    geoms: list[int]
    """The geoms of the supports, one for each contact."""
    support: int
    """The body that presses most."""
    normals: np.ndarray
    """Directions in which the contacts push the body."""
    normal_n: np.ndarray
    used: float
    """Share of the friction cones that is used."""
    friction_n: np.ndarray
    slip_m_s: np.ndarray
    """Velocity along the support, in the frame of the support."""
    rotation: np.ndarray
    """Orientation of the body in the frame of the support."""
    opposed: bool
    """Whether two geoms press from opposite sides, and one of them is a finger's."""


def hold_of(model: MjModel, sample: Sample, body: int) -> Grip | None:
    """Return how a body is held in a sample, or None if nothing presses on it."""
    touches = sample.touches
    welds = model.body_weldid[model.geom_bodyid[touches.geoms]]
    weld = model.body_weldid[body]
    rows = np.flatnonzero((welds == weld).any(axis=1) & (touches.normal_n > 0.0))
    if not len(rows):
        return None
    is_second = welds[rows, 1] == weld
    # Contact forces act on the second geom, so they are reversed for the first one.
    signs = np.where(is_second, 1.0, -1.0)[:, None]
    others = np.where(is_second, touches.geoms[rows, 0], touches.geoms[rows, 1])
    normals = signs * touches.normal[rows]
    normal_n = touches.normal_n[rows]
    velocity = signs * touches.velocity_m_s[rows]
    # Only the part along the surface is slip; the rest is the contact settling.
    velocity -= (velocity * normals).sum(axis=1)[:, None] * normals
    weights = normal_n / normal_n.sum()
    geom = others[normal_n.argmax()]
    support = model.geom_bodyid[geom]
    # Loose bodies in a heap hold each other too, but only a grip has jointed fingers.
    joints = model.body_jntadr[model.body_weldid[model.geom_bodyid[others]]]
    has_finger = ((joints >= 0) & (model.jnt_type[joints] != FREE)).any()
    # In the frame of the support, a constant creep stays constant while it turns.
    frame = sample.arrays["xmat"][support].reshape(3, 3)
    return Grip(
        geoms=others.tolist(),
        support=support,
        normals=normals,
        normal_n=normal_n,
        used=weights @ touches.used[rows],
        friction_n=(signs * touches.friction_n[rows]).sum(axis=0),
        slip_m_s=frame.T @ (weights @ velocity),
        rotation=frame.T @ sample.arrays["xmat"][body].reshape(3, 3),
        opposed=bool(
            has_finger and (normals @ normals.T).min() < OPPOSE and len({*others}) > 1
        ),
    )


def grips(
    scene: Scene,
    run: Run,
    acceleration_m_s2: float = 0.0,
    below_mm_s: float = SLIP_MM_S,
) -> Iterator[Symptom]:
    """Yield bodies that creep on their support, slide out of a grip, or turn in it.

    Args:
        acceleration_m_s2: Acceleration that a grip has to bear besides gravity.
        below_mm_s: Lowest speed that counts as creep.
    """
    model = scene.model
    # Bodies that are welded to another one are counted with it. A body with children
    # is a robot, which holds itself by its joints.
    free = np.flatnonzero(scene.free & (model.body_weldid == np.arange(model.nbody)))
    alone = np.isclose(model.body_subtreemass, model.body_mass)
    for body in free[alone[free]].tolist():
        first = round(EARLY * len(run.samples))
        # The grip is judged early because a body that slides out of it has none later.
        early = [hold_of(model, sample, body) for sample in run.samples[:first]]
        gripping = [hold for hold in early if hold and hold.opposed]
        late = [hold_of(model, sample, body) for sample in run.late]
        late_holds = [hold for hold in late if hold]
        lasts = bool(gripping) and all(hold and hold.opposed for hold in late)
        if gripping:
            load = _weight_n(scene, body, acceleration_m_s2)
            # The friction of the grip is averaged, because normal forces swing while it closes.
            bears = np.mean([_bearable_n(scene, body, hold) for hold in gripping])
            lost = not lasts and (_edge(gripping) or bears < load)
            if lost or _edge(late_holds) or (acceleration_m_s2 and bears < load):
                under = acceleration_m_s2 if lasts else 0.0
                yield _sliding(scene, run, body, gripping, load, bears, under)
        if lasts:
            yield from _turning(scene, run, body, late_holds[-1])
        # A body that creeps out of its grip is judged while it is gripped.
        creeping = gripping if gripping and not lasts else late_holds
        if (gripping or len(late_holds) == len(late)) and not _edge(creeping):
            below = below_mm_s * (GRIPPED if gripping else 1.0)
            yield from _creeping(scene, run, body, creeping, bool(gripping), below)


def _edge(holds: list[Grip]) -> bool:
    return bool(holds) and bool(np.mean([hold.used for hold in holds]) > AT_THE_EDGE)


def slip_mm_s(model: MjModel, run: Run, body: int) -> float:
    """Return the speed at which a body moves on its support in the late samples."""
    holds = [hold_of(model, sample, body) for sample in run.late]
    if not all(holds):
        early = run.samples[: round(EARLY * len(run.samples))]
        holds = [hold_of(model, sample, body) for sample in early]
    slips = [hold.slip_m_s for hold in holds if hold]
    return M * np.linalg.norm(np.mean(slips, axis=0)) if slips else math.inf


def _creeping(
    scene: Scene,
    run: Run,
    body: int,
    holds: list[Grip],
    gripped: bool,
    below_mm_s: float,
) -> Iterator[Symptom]:
    slips = np.array([hold.slip_m_s for hold in holds])
    speed = M * np.linalg.norm(slips.mean(axis=0))
    path = M * np.linalg.norm(slips, axis=1).mean()
    # A body that shakes has a long path but a small mean velocity.
    if speed < below_mm_s or speed < STEADY * path:
        return
    first, last = (
        np.linalg.norm(half.mean(axis=0)) for half in np.array_split(slips, 2)
    )
    turned = holds[0].rotation.T @ holds[-1].rotation
    # A body that comes to rest, or that rolls, does not creep.
    if last < SLOWS * first or np.trace(turned) < ROLLS:
        return
    model = scene.model
    hold = holds[-1]
    supports = list(dict.fromkeys(hold.geoms))
    load = np.linalg.norm(hold.friction_n)
    # A body that lies level drifts at random, without any load.
    if load < LEAST * _weight_n(scene, body, 0.0):
        return
    turning = np.linalg.norm(run.samples[-1].arrays["cvel"][hold.support, :3]) > 0.1
    relation = "between" if gripped else "on the turning" if turning else "on"
    yield Symptom(
        Finding(
            "slip",
            scene.bodies[body],
            "creep",
            speed,
            f"$shape creeps at $value {relation} $against{origin(run)}",
            against=tuple(scene.names[geom] for geom in supports),
            unit="mm/s",
        ),
        lambda run: slip_mm_s(model, run, body),
        _firmer(scene, body, supports),
        # A body that creeps in a grip is lost after a while, whatever would help.
        needs_cure=not gripped,
        why=f"friction yields to its load of {number(load)} N like a damper, although"
        f" at most {math.ceil(100.0 * hold.used)}% of the friction is used",
    )


def _firmer(scene: Scene, body: int, supports: list[int]) -> list[Changes]:
    """Return changes that reduce the creep of a body on some geoms."""
    impratio = max(scene.option.impratio, 1.0)
    # impratio divides R, and with it the creep under load.
    ratios = (times * impratio for times in (10.0, 100.0))
    firm = [elliptic(scene, ratio) for ratio in ratios if ratio <= MOST_IMPRATIO]
    pairs = {pair for geom in supports for pair in _pairs(scene, geom, body)}
    stiff = of_contacts(scene, sorted(pairs), lambda _: stiffest(scene))
    combined = [way + stiff for way in firm[:1]]
    return [*firm, stiff, *combined, *noslip(scene)]


def _bearable_n(scene: Scene, body: int, grip: Grip) -> float:
    """Return the load that the friction of a grip can bear [N]."""
    total = 0.0
    for geom, normal in zip(grip.geoms, grip.normal_n.tolist(), strict=True):
        # A contact with condim 1 has no friction.
        indices = [
            pair
            for pair in _pairs(scene, geom, body)
            if scene.contacts.condim[pair] > 1
        ]
        total += scene.contacts.friction[indices, 0].max(initial=0.0) * normal
    return total


def _weight_n(scene: Scene, body: int, acceleration_m_s2: float) -> float:
    gravity = float(np.linalg.norm(scene.model.opt.gravity))
    return scene.model.body_mass[body] * (gravity + acceleration_m_s2)


def _sliding(
    scene: Scene,
    run: Run,
    body: int,
    gripping: list[Grip],
    load: float,
    bears: float,
    acceleration_m_s2: float,
) -> Symptom:
    """Return the symptom of a body that its grip is too weak to hold.

    Args:
        load: The force that the grip has to bear [N].
        bears: The force that its friction can bear [N].
    """
    model = scene.model
    grip = gripping[-1]
    pads = list(dict.fromkeys(geom for hold in gripping for geom in hold.geoms))
    # Grips with margin are recommended: at the exact limit the body would creep out.
    times = max(FIRM * load / max(bears, 1e-9), FIRM)
    rougher: Changes = ()
    mus = [
        scene.contacts.friction[index, 0]
        for pad in pads
        for index in _pairs(scene, pad, body)
    ]
    mu = times * max(mus, default=1.0)
    for pad in pads:
        friction = model.geom_friction[pad].copy()
        friction[0] = mu
        # Contacts use the larger of the two frictions, so it is enough to change the
        # pads.
        rougher += of_geom(scene, pad, {"friction": text_of(friction)})
    ways = [_stronger(scene, pads, share * times) for share in (1.0, 2.0, 4.0)]
    if mu <= MOST_MU:
        ways.append(distinct(rougher))

    def fall(run: Run) -> float:
        first = run.samples[0].arrays["xpos"]
        last = run.samples[-1].arrays["xpos"]
        # The support may move on purpose, so only the motion relative to it counts.
        moved = (last - first)[body] - (last - first)[grip.support]
        return M * np.linalg.norm(moved)

    message = "$shape slides"
    if acceleration_m_s2:
        message = f"$shape would slide under {acceleration_m_s2:g} m/s²"
    why = f"its load of {number(load)} N exceeds the {number(bears)} N that friction can bear"
    if not bears:
        why = "a contact with condim 1 has no friction"
        rows = (of_geom(scene, pad, {"condim": "3"}) for pad in pads)
        ways = [distinct(sum(rows, ()))]
    elif bears > load:
        why = "the grip opens, or its friction is used up"
    return Symptom(
        Finding(
            "slides",
            scene.bodies[body],
            "load",
            load,
            f"{message} out of the grip of $against{origin(run)} because {why}",
            against=tuple(scene.names[pad] for pad in pads),
            used=bears,
            unit="N",
            severity="error",
        ),
        fall,
        () if acceleration_m_s2 else ways,
        effect="keeps it within {} of its place",
        unit="mm",
    )


def _pairs(scene: Scene, geom: int, body: int) -> list[int]:
    """Return the indices of the pairs of a geom and a body."""
    model = scene.model
    geoms = where(model.body_weldid[model.geom_bodyid] == body)
    indices = [scene.pair_index((geom, partner)) for partner in geoms]
    return [index for index in indices if index is not None]


def _stronger(scene: Scene, pads: list[int], times: float) -> Changes:
    """Return changes that multiply the forces of the actuators of a grip."""
    model = scene.model
    bodies = {model.geom_bodyid[geom] for geom in pads}
    joints = where(np.isin(model.jnt_bodyid, [*bodies]))
    changes: Changes = ()
    for index in where(model.actuator_trntype == ON_JOINT):
        if model.actuator_trnid[index, 0] not in joints:
            continue
        if model.actuator_forcelimited[index]:
            span = times * model.actuator_forcerange[index]
            changes += of_element(scene, "actuator", index, forcerange=text_of(span))
        elif not model.actuator_biasprm[index].any():
            gear = times * model.actuator_gear[index, 0]
            changes += of_element(scene, "actuator", index, gear=f"{gear:.3g}")
        else:
            gain = times * model.actuator_gainprm[index, 0]
            changes += of_element(scene, "actuator", index, kp=f"{gain:.4g}")
    return changes


def turned_deg(model: MjModel, run: Run, body: int) -> float:
    """Return the largest angle by which a body turns in its grip [°]."""
    holds = [hold_of(model, sample, body) for sample in run.samples]
    rotations = [hold.rotation for hold in holds if hold and hold.opposed]
    if not rotations:
        return math.inf
    traces = [np.trace(rotations[0].T @ rotation) for rotation in rotations]
    cosines = [0.5 * (trace - 1.0) for trace in traces]
    return math.degrees(math.acos(min(1.0, max(-1.0, min(cosines)))))


def _turning(scene: Scene, run: Run, body: int, hold: Grip) -> Iterator[Symptom]:
    """Yield a body that turns about the line between two contact points."""
    model = scene.model
    angle = turned_deg(model, run, body)
    pads = list(dict.fromkeys(hold.geoms))
    down = model.opt.gravity / max(np.linalg.norm(model.opt.gravity), 1e-9)
    # A body on a shelf turns for other reasons than a grip by two points.
    lies = np.abs(hold.normals @ down).max() > -OPPOSE
    if angle < TURNS_DEG or lies or not len(pads) == len(hold.geoms) == 2:
        return
    indices = [pair for pad in pads for pair in _pairs(scene, pad, body)]
    condim = scene.contacts.condim[indices].max(initial=3)
    if condim < 4:
        why = f"condim {condim} has no torsional friction"
    elif scene.option.noslip:
        why = "the noslip pass does not solve torsional friction"
    else:
        why = "its torsional friction is too weak"
    ways: list[Changes] = []
    # condim 4 alone may be enough if the friction of the pads has a torsional part.
    for torsion in (0.0, TORSION, 5.0 * TORSION):
        changes: Changes = ()
        for pad in pads:
            friction = model.geom_friction[pad].copy()
            friction[1] = torsion
            attributes = {"condim": "4"} if condim < 4 else {}
            if torsion:
                attributes["friction"] = text_of(friction)
            if attributes:
                changes += of_geom(scene, pad, attributes)
        ways.append(distinct(changes))
        ways.append(distinct(changes) + elliptic(scene, 100.0))
    yield Symptom(
        Finding(
            "condim",
            scene.bodies[body],
            "condim",
            angle,
            f"$shape turns by $value between $against{origin(run)} because"
            f" they hold it at opposite points and {why}",
            against=tuple(scene.names[pad] for pad in pads),
            used=4.0,
            unit="°",
        ),
        lambda run: turned_deg(model, run, body),
        ways,
    )
