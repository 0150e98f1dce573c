"""Grips and slopes: bodies that move freely and that friction holds when the scene is stepped, and what slips there."""

import copy
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

import mujoco
import numpy as np

from newton_lint.advice import either, for_geom, for_option
from newton_lint.findings import Finding
from newton_lint.scene import Scene
from newton_lint.settle import READ_SHARE, SETTLE_S, Hold, Touch, Work, pair_indices, predicted_hold, touches_of
from newton_lint.stepped import Run, changed, contact_forces, free_joints

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


def gripped(scene: Scene, runs: Sequence[Run], skip: str = "") -> Iterator[Finding]:
    """Yield what slips out of a grip or down a slope, and what turns between two points.

    Args:
        skip: A body that is asked for by name.
    """
    seen = set()
    for run in runs:
        for body in () if run.bad else _burdened(scene, run):
            if scene.bodies[body] != skip and body not in seen:
                data = copy.copy(run.data)
                steps = max(1, round(READ_SHARE * SETTLE_S / scene.model.opt.timestep))
                if touches := touches_of(scene, data, body, steps):
                    found = list(_found(scene, body, touches, data, run.start))
                    seen |= {body} if found else set()
                    yield from found


def _burdened(scene: Scene, run: Run) -> list[int]:
    """Return bodies that move freely and alone, and of whose weight friction bears a share."""
    model, data = scene.model, run.data
    friction = np.zeros((model.nbody, 3))
    there = np.flatnonzero((data.contact.geom.min(axis=1, initial=0) >= 0) & (data.contact.dim >= 3))
    axes = data.contact.frame[there].reshape(-1, 3, 3)[:, 1:]
    acts = np.einsum("ni,nij->nj", contact_forces(model, data, there)[:, 1:3], axes)
    for geoms, sign in zip(data.contact.geom[there].T, (-1.0, 1.0), strict=True):
        np.add.at(friction, model.body_weldid[model.geom_bodyid[geoms]], sign * acts)
    alone = model.jnt_bodyid[free_joints(model)]
    alone = alone[np.isclose(model.body_subtreemass[alone], model.body_mass[alone])]
    weight = model.body_mass * float(np.linalg.norm(model.opt.gravity))
    share = np.linalg.norm(friction, axis=1)[alone] / np.maximum(weight[alone], 1e-12)
    first = np.argsort(-share)[:MOST_BODIES]
    return [int(body) for body in alone[first[share[first] > LEAST]] if weight[body]]


def _found(scene: Scene, body: int, touches: list[Touch], data: mujoco.MjData, start: str) -> Iterator[Finding]:
    hold = predicted_hold(scene, body, touches, Work(scene.bodies[body]), data)
    normals = np.array([touch.normal for touch in touches])
    between = float((normals @ normals.T).min()) < OPPOSE
    if between:
        yield from _turns(scene, hold, start)
    weight_n = float(scene.model.body_subtreemass[body] * np.linalg.norm(scene.model.opt.gravity))
    if hold.slides or not hold.rests or hold.load_n < (AGREES if between else LEAST) * weight_n:
        return
    if hold.mm_s >= SLIP_MM_S and hold.moves_mm_s >= AGREES * hold.mm_s:
        yield _slips(scene, hold, "between fingers" if between else "down a slope", start)


def _slips(scene: Scene, hold: Hold, where: str, start: str) -> Finding:
    impratio = max(scene.option.impratio, 1.0) * 10.0
    other = changed(scene.model, cone=int(mujoco.mjtCone.mjCONE_ELLIPTIC), impratio=impratio)
    after = predicted_hold(replace(scene, model=other), hold.body, hold.touches, Work(hold.name), hold.data).mm_s
    attributes = {"cone": "elliptic", "impratio": f"{impratio:g}"}
    gain = f"{hold.mm_s:.2g} → {after:.2g} mm/s for the same time step"
    ways = [for_option(scene, attributes, gain)]
    if scene.engine.name == "mujoco":
        ways.append(for_option(scene, {"noslip_iterations": "10"}, "MuJoCo C alone has the pass in all releases"))
    return Finding(
        *("slip", hold.name, _names(scene, hold), "creep", hold.mm_s, after, "mm/s"),
        f"{where}, by {hold.load_n:.3g} N on {hold.point_count:.3g} points, from {start}",
        element=scene.source.option("impratio"),
        advice=either(*ways),
    )


def _turns(scene: Scene, hold: Hold, start: str) -> Iterator[Finding]:
    points: Counter[int] = Counter(touch.support for touch in hold.touches)
    index = pair_indices(scene)
    condims = {int(scene.contacts.condim[index[touch.geoms]]) for touch in hold.touches}
    if len(points) == 2 and max(points.values()) == 1 and condims == {3}:
        own = scene.model.body_weldid[scene.model.geom_bodyid] == hold.body
        pad = next(geom for geom in hold.touches[0].geoms if not own[geom])
        yield Finding(
            *("condim", hold.name, _names(scene, hold), "condim", 3.0, 4.0, "1"),
            f"turns in the grip from {start}: each side holds it in one point, and condim 3 has no row against turning",
            element=scene.source.authored(pad, "condim"),
            advice=for_geom(scene, pad, {"condim": "4"}, "the grip resists turning, by friction[1]"),
        )


def _names(scene: Scene, hold: Hold) -> tuple[str, ...]:
    own = scene.model.body_weldid[scene.model.geom_bodyid] == scene.model.body_weldid[hold.body]
    return tuple(dict.fromkeys(scene.names[geom] for touch in hold.touches for geom in touch.geoms if not own[geom]))
