"""Grips and slopes: bodies that move freely and that friction holds when the scene is stepped, and what slips there.

Of a body that no hand holds yet it is said what it would do, of two fingers that close on each other.
"""

import copy
import itertools
import math
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

import mujoco
import numpy as np

from newton_lint.advice import either, for_geom, for_option
from newton_lint.findings import Advice, Finding
from newton_lint.law import M, response_of, settled_impedance, shared_slide_m_s
from newton_lint.scene import Scene, changed
from newton_lint.settle import READ_SHARE, SETTLE_S, Hold, Touch, Work, pair_indices, predicted_hold, touches_of
from newton_lint.stepped import Run, contact_forces, free_joints

SLIP_MM_S = 1.0
"""Creep under its own weight from which a body is said to slip."""
AGREES = 0.3
"""Least share of the predicted creep that a body moves by, and of a weight that friction bears in a grip."""
LEAST = 0.015
"""The same on a slope."""
OPPOSE = -0.5
"""Cosine between two normals up to which a body is held from two sides."""
MOST_BODIES = 20
"""Bodies that are looked at closely, those with the most friction first."""
FIRM = 2.0
"""Times the least force that holds a body with which it is taken to be gripped."""
WEAK_M_S2 = 100.0
"""A grip that bears less acceleration is said to."""
CLOSES = 0.7
"""Cosine to each other up to which the ways of two fingers close."""
MOST_FINGERS = 40
WELD = int(mujoco.mjtEq.mjEQ_WELD)


def gripped(scene: Scene, runs: Sequence[Run], skip: str = "") -> Iterator[Finding]:
    """Yield what slips out of a grip or down a slope, or turns in it, and what would slip if gripped; but one body."""
    reported, in_grip = set(), {skip}
    for run in runs:
        for body in () if run.bad else _burdened(scene, run):
            if scene.bodies[body] != skip and body not in reported:
                data = copy.copy(run.data)  # other rules read the run's own
                steps = max(1, round(READ_SHARE * SETTLE_S / scene.model.opt.timestep))
                if touches := touches_of(scene, data, body, steps):
                    findings = list(_grip_findings(scene, body, touches, data, run.start))
                    reported |= {body} if findings else set()
                    in_grip |= {scene.bodies[body]} if _is_between(touches) else set()
                    yield from findings
    yield from _if_gripped(scene, in_grip)


def _is_between(touches: Sequence[Touch]) -> bool:
    normals = np.array([touch.normal for touch in touches])
    return float((normals @ normals.T).min()) < OPPOSE and len({touch.geoms for touch in touches}) > 1


def _burdened(scene: Scene, run: Run) -> list[int]:
    """Return bodies that move freely and alone, and of whose weight friction bears a share."""
    model, data = scene.model, run.data
    friction = np.zeros((model.nbody, 3))
    contacts = np.flatnonzero((data.contact.geom.min(axis=1, initial=0) >= 0) & (data.contact.dim >= 3))
    axes = data.contact.frame[contacts].reshape(-1, 3, 3)[:, 1:]
    acts = np.einsum("ni,nij->nj", contact_forces(model, data, contacts)[:, 1:3], axes)
    for geoms, sign in zip(data.contact.geom[contacts].T, (-1.0, 1.0), strict=True):  # it acts on the second geom
        np.add.at(friction, model.body_weldid[model.geom_bodyid[geoms]], sign * acts)
    alone, weight = _alone(model), model.body_mass * float(np.linalg.norm(model.opt.gravity))
    share = np.linalg.norm(friction, axis=1)[alone] / np.maximum(weight[alone], 1e-12)
    first = np.argsort(-share)[:MOST_BODIES]
    return [int(body) for body in alone[first[share[first] > LEAST]] if weight[body]]


def _alone(model: mujoco.MjModel) -> np.ndarray:
    """Return bodies that move freely and carry nothing."""
    free = model.jnt_bodyid[free_joints(model)]
    return free[np.isclose(model.body_subtreemass[free], model.body_mass[free])]


def _grip_findings(scene: Scene, body: int, touches: list[Touch], data: mujoco.MjData, start: str) -> Iterator[Finding]:
    hold = predicted_hold(scene, body, touches, Work(scene.bodies[body]), data)
    normals = np.array([touch.normal for touch in touches])
    between, one_sided = _is_between(touches), float((normals @ normals.T).min()) > -OPPOSE
    if between:
        yield from (*_turns(scene, hold, start), *_bears(scene, hold, start))
    least_n = float(scene.model.body_subtreemass[body] * np.linalg.norm(scene.model.opt.gravity))
    least_n *= AGREES if between else LEAST
    if not (between or one_sided) or hold.slides or not hold.rests or hold.load_n < least_n:
        return
    if hold.mm_s >= SLIP_MM_S and hold.moves_mm_s >= AGREES * hold.mm_s:
        where = "between fingers" if between else "down a slope"
        message = f"{where}, by {hold.load_n:.3g} N on {hold.point_count:.3g} points, from {start}"
        after = predicted_hold(_mended(scene), body, touches, Work(hold.name), data).mm_s
        yield _slips(scene, hold.name, _names(scene, hold), hold.mm_s, after, message)


def _mended(scene: Scene) -> Scene:
    impratio = max(scene.option.impratio, 1.0) * 10.0
    return replace(scene, model=changed(scene.model, cone=int(mujoco.mjtCone.mjCONE_ELLIPTIC), impratio=impratio))


def _slips(
    scene: Scene, body: str, against: tuple[str, ...], mm_s: float, after: float, message: str, severity="warning"
) -> Finding:
    attributes = {"cone": "elliptic", "impratio": f"{_mended(scene).option.impratio:g}"}
    holds = math.isfinite(after)
    gain = f"{mm_s:.2g} → {after:.2g} mm/s for the same time step"
    advices = [for_option(scene, attributes, gain) if holds else Advice((), "more friction, along both of its axes")]
    if scene.engine.name == "mujoco":
        advices.append(for_option(scene, {"noslip_iterations": "10"}, "MuJoCo C alone has the pass in all releases"))
    element, advice = scene.source.option("impratio"), either(*advices)
    return Finding(
        "slip", body, "creep", mm_s, message, against, after if holds else None, "mm/s", severity, element, advice
    )


def _if_gripped(scene: Scene, in_grip: Collection[str]) -> Iterator[Finding]:
    """Yield bodies that nothing grips, and that would slip between two fingers that could."""
    model, contacts = scene.model, scene.contacts
    weld, pairs = model.body_weldid[model.geom_bodyid], np.flatnonzero(contacts.condim >= 3)
    free = [body for body in _alone(model).tolist() if model.body_mass[body] and scene.bodies[body] not in in_grip]
    fingers_of: dict[int, dict[int, tuple[int, int]]] = {body: {} for body in free}
    for geoms, partners in ((contacts.first, contacts.second), (contacts.second, contacts.first)):
        for pair in pairs[np.isin(weld[geoms[pairs]], free)].tolist():
            partner = int(partners[pair])
            fingers_of[int(weld[geoms[pair]])].setdefault(int(weld[partner]), (pair, partner))
    hands = _closing(model, sorted({finger for fingers in fingers_of.values() for finger in fingers}))
    for body, fingers in fingers_of.items():
        if hand := next((pair for pair in hands if fingers.keys() >= {*pair}), None):
            sides, pads = zip(*(fingers[finger] for finger in hand), strict=True)
            creep, after = (_creep_m_s(variant, sides, model.body_mass[body]) for variant in (scene, _mended(scene)))
            if SLIP_MM_S <= M * creep < M:  # faster it falls, as what is too heavy for such a hand does
                message = f"if gripped between them, {FIRM:g} times as firmly as it takes"
                against = tuple(scene.names[geom] for geom in pads)
                yield _slips(scene, scene.bodies[body], against, M * creep, M * after, message, "note")


def _closing(model: mujoco.MjModel, bodies: Sequence[int]) -> list[tuple[int, int]]:
    """Return pairs of fingers: links of one hand, of which each moves towards the other, the outermost first."""
    data, ways = mujoco.MjData(model), {}
    mujoco.mj_forward(model, data)
    driven = np.zeros(model.nv, dtype=bool)
    driven[data.moment_colind] = model.nu > 0
    welded = {*model.eq_obj1id[model.eq_type == WELD], *model.eq_obj2id[model.eq_type == WELD]}
    floats = {int(body) for body in model.jnt_bodyid[free_joints(model)] if body not in welded}
    for body in bodies[-MOST_FINGERS:]:
        if model.body_rootid[body] not in floats | {0}:
            ways[body] = np.zeros((3, model.nv))
            mujoco.mj_jac(model, data, ways[body], None, data.xipos[body], body)
    hands = []
    for left, right in itertools.combinations(ways, 2):
        distance = data.xipos[right] - data.xipos[left]
        moves = [ways[left].any(axis=0), ways[right].any(axis=0)]
        alone = [moves[0] & ~moves[1], moves[1] & ~moves[0]]  # the arm's joints carry both, and close no hand
        if (driven & (alone[0] | alone[1])).any() and all(dofs.any() for dofs in alone):
            velocities = [ways[body][:, dofs] for body, dofs in zip((left, right), alone, strict=True)]
            cosines = [np.abs(distance @ columns) / np.linalg.norm(columns, axis=0) for columns in velocities]
            if min(cosine.max() for cosine in cosines) > CLOSES * np.linalg.norm(distance) > 0.0:
                hands.append((-alone[0].sum() - alone[1].sum(), float(np.linalg.norm(distance)), left, right))
    return [(left, right) for _, _, left, right in sorted(hands)]


def _creep_m_s(scene: Scene, pairs: Sequence[int], mass: float) -> float:
    """Return how fast a body creeps by its weight between two fingers that press it."""
    contacts, weight_n = scene.contacts, mass * float(np.linalg.norm(scene.model.opt.gravity))
    grip_n, points = FIRM * weight_n / sum(contacts.contact(pair).mu for pair in pairs), []
    for pair in pairs:
        count = min(scene.point_counts[contacts.first[pair]], scene.point_counts[contacts.second[pair]])
        contact, normal_n = contacts.contact(pair), grip_n / count
        d = settled_impedance(contact, scene.option, normal_n)
        points += [(response_of(contact, scene.option, d), normal_n)] * int(count)
    return shared_slide_m_s(points, weight_n)


def _turns(scene: Scene, hold: Hold, start: str) -> Iterator[Finding]:
    points: Counter[int] = Counter(touch.support for touch in hold.touches)
    index = pair_indices(scene)
    condims = {int(scene.contacts.condim[index[touch.geoms]]) for touch in hold.touches}
    if len(points) == 2 and max(points.values()) == 1 and condims == {3}:
        is_held = scene.model.body_weldid[scene.model.geom_bodyid] == hold.body
        pad = next(geom for geom in hold.touches[0].geoms if not is_held[geom])
        why = "each side holds it in one point, and condim 3 has no row against turning"
        message, against = f"turns in the grip from {start}: {why}", _names(scene, hold)
        element = scene.source.authored(pad, "condim")
        advice = for_geom(scene, pad, {"condim": "4"}, "the grip resists turning, by friction[1]")
        yield Finding("condim", hold.name, "condim", 3.0, message, against, 4.0, element=element, advice=advice)


def _bears(scene: Scene, hold: Hold, start: str) -> Iterator[Finding]:
    index, contacts = pair_indices(scene), scene.contacts
    most_n = sum(contacts.friction[index[touch.geoms], 0] * touch.normal_n for touch in hold.touches)
    more = float(most_n - hold.load_n) / float(scene.model.body_subtreemass[hold.body])
    if hold.rests and not hold.slides and more < WEAK_M_S2:
        message = f"is what the grip bears besides its load, from {start}: a hand that accelerates by more loses it"
        finding = Finding("grip", hold.name, "acceleration", more, message, _names(scene, hold), None, "m/s²", "note")
        yield replace(finding, advice=Advice((), "press harder, or accelerate less; --lift predicts"))


def _names(scene: Scene, hold: Hold) -> tuple[str, ...]:
    is_held = scene.model.body_weldid[scene.model.geom_bodyid] == scene.model.body_weldid[hold.body]
    geoms = (geom for touch in hold.touches for geom in touch.geoms if not is_held[geom])
    return tuple(dict.fromkeys(scene.names[geom] for geom in geoms))
