"""Grips and slopes: bodies that move freely between fingers or on an incline, and what would slip there."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import mujoco
import numpy as np

from newton_lint.advice import for_geom, for_option
from newton_lint.combined import Contacts
from newton_lint.findings import Finding
from newton_lint.law import M, Option, response_of, settled_impedance
from newton_lint.scene import Scene

SLIP_MM_S = 1.0
"""Creep under its own weight from which a gripped body is said to slip."""
REACH = 3
"""Moving bodies between a finger's pad and the palm."""
CLOSING = 0.5
"""Share of a finger's motion that goes toward the other, from which the two can pinch."""
MEET_M = 1e-3
"""Fingers whose centres are so close meet where they close."""
LEVEL = 0.01
"""Slope up to which a support is level."""
ROLL = (int(mujoco.mjtGeom.mjGEOM_SPHERE), int(mujoco.mjtGeom.mjGEOM_CAPSULE), int(mujoco.mjtGeom.mjGEOM_ELLIPSOID))
POINTS = {
    frozenset({"BOX"}): 4, frozenset({"MESH"}): 4, frozenset({"BOX", "MESH"}): 4, frozenset({"CAPSULE", "BOX"}): 2,
    frozenset({"CYLINDER", "BOX"}): 2, frozenset({"CAPSULE"}): 1, frozenset({"CYLINDER", "MESH"}): 2,
    frozenset({"PLANE", "BOX"}): 4, frozenset({"PLANE", "MESH"}): 3, frozenset({"PLANE", "CYLINDER"}): 4,
}  # fmt: skip
"""Contact points that two shapes have where they lie flat; 1 of others."""


@dataclass(frozen=True)
class Grip:
    """A body between two fingers, or on a slope."""

    body: int
    mass_kg: float
    pairs: tuple[int, ...]
    """A pair for each finger, that of the most points; the one with the slope."""
    points: tuple[int, ...]
    share: float = 1.0
    """Of its weight, that friction has to hold: the sine of a slope."""

    def slide_mm_s(self, scene: Scene, option: Option | None = None) -> float:
        """Return the creep under its own weight, shared by all points."""
        option, hold = option or scene.option, 0.0
        weight = self.mass_kg * float(np.linalg.norm(scene.model.opt.gravity))
        for pair, points in zip(self.pairs, self.points, strict=True):
            contact = scene.contacts.contact(pair)
            normal = weight * math.sqrt(1.0 - self.share**2) / points
            d = settled_impedance(contact, option, normal) if normal else None
            response = response_of(contact, option, d)
            if not response.load_m_s_n:
                return 0.0
            hold += points / response.load_m_s_n
        return M * self.share * weight / hold


def grips(scene: Scene) -> Iterator[Grip]:
    """Yield the bodies that fingers can grip: two that branch off a palm, or stand in the world on driven slides."""
    contacts, model = scene.contacts, scene.model
    if not model.nu:
        return
    weld, free = model.body_weldid[model.geom_bodyid], scene.free
    one, other = weld[contacts.first], weld[contacts.second]
    at = np.flatnonzero((free[one] != free[other]) & (contacts.condim > 1))
    body = np.where(free[one[at]], one[at], other[at])
    finger = np.where(free[one[at]], other[at], one[at])
    alone = (model.body_dofnum[body] == 6) & (finger != 0) & (model.body_rootid[body] != model.body_rootid[finger])
    best: dict[int, dict[int, tuple[int, int]]] = {}
    for pair, held, by in zip(at[alone].tolist(), body[alone].tolist(), finger[alone].tolist(), strict=True):
        fingers = best.setdefault(held, {})
        fingers[by] = max(fingers.get(by, (0, 0)), (_points(model, contacts, pair), pair))
    for held, fingers in best.items():
        scores = {(a, b): _pinch(scene, a, b) for a in fingers for b in fingers if a < b}
        found = max(scores, key=lambda pair: scores[pair], default=())
        if found and scores[found] > CLOSING:
            points, pairs = zip(*(fingers[each] for each in found), strict=True)
            yield Grip(held, float(model.body_subtreemass[held]), pairs, points)


def slopes(scene: Scene) -> Iterator[Grip]:
    """Yield the bodies that move freely, do not roll, and may stand on a tilted plane or box that stays where it is."""
    contacts, model = scene.contacts, scene.model
    weld, free = model.body_weldid[model.geom_bodyid], scene.free
    one, other = weld[contacts.first], weld[contacts.second]
    still = np.flatnonzero(weld == 0) if model.opt.gravity.any() else ()
    tilted = {int(geom): tangent for geom in still if (tangent := _slope(scene, int(geom))) > LEVEL}
    on = np.isin(contacts.first, list(tilted)) | np.isin(contacts.second, list(tilted))
    found: dict[int, Grip] = {}
    for pair in np.flatnonzero(on & (contacts.condim > 1) & (free[one] | free[other])).tolist():
        geoms = int(contacts.first[pair]), int(contacts.second[pair])
        body, support = geoms if weld[geoms[0]] else geoms[::-1]
        alone = model.body_subtreemass[weld[body]] == model.body_mass[weld[body]]
        if alone and model.geom_type[body] not in ROLL and tilted[support] < contacts.friction[pair, 0]:
            held = int(weld[body])
            share = tilted[support] / np.hypot(1.0, tilted[support])
            points = _points(model, contacts, pair)
            grip = Grip(held, float(model.body_subtreemass[held]), (pair,), (points,), share)
            found[held] = max(found.get(held, grip), grip, key=lambda each: each.share)
    yield from found.values()


def _slope(scene: Scene, geom: int) -> float:
    """Return the slope of a plane, or of the flattest face of a box; 0 of other shapes."""
    model = scene.model
    down = model.opt.gravity / np.linalg.norm(model.opt.gravity)
    up = np.abs(down @ scene.posed.geom_xmat[geom].reshape(3, 3))
    if model.geom_type[geom] == int(mujoco.mjtGeom.mjGEOM_PLANE):
        level = float(up[2])
    elif model.geom_type[geom] == int(mujoco.mjtGeom.mjGEOM_BOX):
        level = float(up.max())
    else:
        return 0.0
    return float(np.sqrt(max(1.0 - level**2, 0.0)) / max(level, 1e-9))


def _points(model: mujoco.MjModel, contacts: Contacts, pair: int) -> int:
    kinds = {
        mujoco.mjtGeom(int(model.geom_type[geom])).name.removeprefix("mjGEOM_")
        for geom in (contacts.first[pair], contacts.second[pair])
    }
    return POINTS.get(frozenset(kinds), 1)


def _pinch(scene: Scene, one: int, other: int) -> float:
    """Say how well two bodies can pinch: the lesser share of their motion that goes toward the other.

    They have to branch off a palm that is near, or to stand in the world on driven slides; it is 0 of others.
    """
    model = scene.model
    paths = [_path(model, one), _path(model, other)]
    while len(paths[0]) > 1 and len(paths[1]) > 1 and paths[0][:2] == paths[1][:2]:
        paths = [path[1:] for path in paths]
    palm, reach = paths[0][0], max(len(path) for path in paths) - 1
    if min(len(path) for path in paths) < 2 or scene.free[palm] or reach > REACH:
        return 0.0
    if palm == 0:
        slides = [model.jnt_type[model.body_jntadr[each]] == int(mujoco.mjtJoint.mjJNT_SLIDE) for each in (one, other)]
        if reach > 1 or not all(slides) or not scene.driven[[one, other]].all():
            return 0.0
    return min(_toward(scene, *ends) for ends in ((one, other), (other, one)))


def _toward(scene: Scene, finger: int, other: int) -> float:
    """Return the largest share of a finger's own motion that goes toward the other; 1 where they meet."""
    model, data = scene.model, scene.posed
    line = data.xipos[other] - data.xipos[finger]
    if np.linalg.norm(line) < MEET_M:
        return 1.0
    jacobian = np.zeros((3, model.nv))
    mujoco.mj_jac(model, data, jacobian, None, data.xipos[finger], finger)
    moves = jacobian[:, model.dof_bodyid == finger]
    size = np.linalg.norm(moves, axis=0)
    toward = np.abs(line @ moves[:, size > 0.0]) / (size[size > 0.0] * np.linalg.norm(line))
    return float(toward.max(initial=0.0))


def _path(model: mujoco.MjModel, body: int) -> list[int]:
    path = [body]
    while path[-1]:
        path.append(int(model.body_weldid[model.body_parentid[path[-1]]]))
    return path[::-1]


def gripped(scene: Scene) -> Iterator[Finding]:
    """Yield what fingers would let slip, or turn, and what creeps down a slope."""
    for grip in grips(scene):
        yield from _slips(scene, grip, "between fingers")
        yield from _turns(scene, grip)
    for grip in slopes(scene):
        yield from _slips(scene, grip, f"down a slope of {np.degrees(np.arcsin(grip.share)):.2g}°")


def _slips(scene: Scene, grip: Grip, where: str) -> Iterator[Finding]:
    creep = grip.slide_mm_s(scene)
    if creep >= SLIP_MM_S:
        impratio = max(scene.option.impratio, 1.0) * 10.0
        after = grip.slide_mm_s(scene, replace(scene.option, cone="elliptic", impratio=impratio))
        names = [scene.names[geom] for geom in _geoms(scene, grip)]
        body = scene.bodies[grip.body]
        attributes = {"cone": "elliptic", "impratio": f"{impratio:g}"}
        points = sum(grip.points)
        yield Finding(
            *("slip", body, tuple(names), "creep", creep, after, "mm/s"),
            f"{where}, by its weight of {grip.mass_kg:.3g} kg on {points} points",
            element=scene.source.option("impratio"),
            advice=for_option(scene, attributes, f"{creep:.2g} → {after:.2g} mm/s for the same time step"),
        )


def _turns(scene: Scene, grip: Grip) -> Iterator[Finding]:
    if max(grip.points) == 1 and all(scene.contacts.condim[pair] == 3 for pair in grip.pairs):
        body, pads = scene.bodies[grip.body], _geoms(scene, grip)
        yield Finding(
            *("condim", body, tuple(scene.names[geom] for geom in pads), "condim", 3.0, 4.0, "1"),
            "turns in the grip: each finger holds it in one point, and condim 3 has no row against turning",
            element=scene.source.authored(pads[0], "condim"),
            advice=for_geom(scene, pads[0], {"condim": "4"}, "the grip resists turning, by friction[1]"),
        )


def _geoms(scene: Scene, grip: Grip) -> list[int]:
    contacts, model = scene.contacts, scene.model
    sides = ((int(contacts.first[pair]), int(contacts.second[pair])) for pair in grip.pairs)
    return [one if model.body_weldid[model.geom_bodyid[one]] != grip.body else other for one, other in sides]
