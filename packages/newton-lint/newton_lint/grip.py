"""Finds free bodies that friction holds in a grip or on a slope, and that slip."""

import copy
import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

import mujoco
import numpy as np

from newton_lint.advice import either, for_geom, for_option
from newton_lint.findings import Advice, Finding
from newton_lint.scene import ELLIPTIC, Scene, changed
from newton_lint.settle import (
    READ_SHARE,
    SETTLE_S,
    Hold,
    Touch,
    Work,
    predicted_hold,
    touches_of,
)
from newton_lint.stepped import Run, Start, contact_forces, free_joints

SLIP_MM_S = 1.0
"""A body slips if it creeps at least this fast under its own weight."""
# A body must move at this share of its predicted creep to be reported.
AGREES = 0.3
# Friction must bear this share of the weight of a body on a slope.
LEAST = 0.015
# Two contacts oppose each other if the cosine of their normals is below this.
OPPOSE = -0.5
# At most this many bodies are checked, those with the most friction first.
MOST_BODIES = 6


def gripped(scene: Scene, runs: Sequence[Run], skip: str = "") -> Iterator[Finding]:
    """Yield bodies that slip out of a grip, slip down a slope or turn in a grip.

    Args:
        skip: A body to leave out.
    """
    reported: set[int] = set()
    for run in runs:
        for body in () if run.bad else _burdened(scene, run):
            if scene.bodies[body] != skip and body not in reported:
                data = copy.copy(run.data)  # Other rules read the original.
                steps = max(1, round(READ_SHARE * SETTLE_S / scene.model.opt.timestep))
                if touches := touches_of(scene, data, body, steps):
                    findings = list(
                        _grip_findings(scene, body, touches, data, run.start)
                    )
                    if findings:
                        reported.add(body)
                    yield from findings


def _burdened(scene: Scene, run: Run) -> list[int]:
    """Return free, single bodies with a share of their weight borne by friction."""
    model = scene.model
    data = run.data
    friction = np.zeros((model.nbody, 3))
    contacts = np.flatnonzero(
        (data.contact.geom.min(axis=1, initial=0) >= 0) & (data.contact.dim >= 3)
    )
    axes = data.contact.frame[contacts].reshape(-1, 3, 3)[:, 1:]
    acts = np.einsum("ni,nij->nj", contact_forces(model, data, contacts)[:, 1:3], axes)
    # The force acts on the second geom.
    for geoms, sign in zip(data.contact.geom[contacts].T, (-1.0, 1.0), strict=True):
        np.add.at(friction, model.body_weldid[model.geom_bodyid[geoms]], sign * acts)
    free = model.jnt_bodyid[free_joints(model)]
    weight = model.body_mass * np.linalg.norm(model.opt.gravity)
    alone = free[np.isclose(model.body_subtreemass[free], model.body_mass[free])]
    share = np.linalg.norm(friction, axis=1)[alone] / np.maximum(weight[alone], 1e-12)
    first = np.argsort(-share)[:MOST_BODIES]
    return [int(body) for body in alone[first[share[first] > LEAST]] if weight[body]]


def _is_between(touches: Sequence[Touch]) -> bool:
    return (
        _least_cosine(touches) < OPPOSE and len({touch.geoms for touch in touches}) > 1
    )


def _least_cosine(touches: Sequence[Touch]) -> float:
    normals = np.array([touch.normal for touch in touches])
    return (normals @ normals.T).min()


def _grip_findings(
    scene: Scene, body: int, touches: list[Touch], data: mujoco.MjData, start: Start
) -> Iterator[Finding]:
    """Yield a body that turns in its grip, or slips."""
    hold = predicted_hold(scene, body, touches, Work(scene.bodies[body]), data)
    between = _is_between(touches)
    is_sloped = _least_cosine(touches) > -OPPOSE
    if between:
        yield from _turns(scene, hold, start)
    least_n = scene.model.body_subtreemass[body] * np.linalg.norm(
        scene.model.opt.gravity
    )
    least_n *= AGREES if between else LEAST
    if (
        not (between or is_sloped)
        or hold.slides
        or not hold.rests
        or hold.load_n < least_n
    ):
        return
    if hold.mm_s >= SLIP_MM_S and hold.moves_mm_s >= AGREES * hold.mm_s:
        where = "between" if between else "down a slope on"
        impratio = max(scene.option.impratio, 1.0) * 10.0
        mended = replace(
            scene, model=changed(scene.model, cone=ELLIPTIC, impratio=impratio)
        )
        after = predicted_hold(mended, body, touches, Work(hold.name), data).mm_s
        gain = (
            f"reduces the creep from {hold.mm_s:.2g} to {after:.2g} mm/s at the same"
            " time step (predicted)"
        )
        holds = math.isfinite(after)
        firmer = for_option(
            scene, {"cone": "elliptic", "impratio": f"{impratio:g}"}, gain
        )
        friction = Advice("Increase the friction along both of its axes")
        candidates = [firmer if holds else friction]
        if scene.engine.name == "mujoco":
            noslip = {"noslip_iterations": "10"}
            gain = "removes the creep, but only MuJoCo C has the pass in all releases"
            candidates.append(for_option(scene, noslip, gain))
        yield Finding(
            "slip",
            hold.name,
            "creep",
            hold.mm_s,
            message=f"$shape creeps at $value {where} $against because friction rows"
            f" yield to its load of {hold.load_n:.3g} N on {hold.point_count:.3g}"
            f" points (from {start.name})",
            against=tuple(scene.names[geom] for geom in _supports(scene, hold)),
            used=after if holds else None,
            unit="mm/s",
            element=scene.source.option("impratio"),
            advice=either(*candidates),
        )


def _turns(scene: Scene, hold: Hold, start: Start) -> Iterator[Finding]:
    """Yield a body that turns in a grip because each side holds it in one point."""
    points: Counter[int] = Counter(touch.support for touch in hold.touches)
    index = scene.pair_indices
    condims = {int(scene.contacts.condim[index[touch.geoms]]) for touch in hold.touches}
    if len(points) == 2 and max(points.values()) == 1 and condims == {3}:
        pads = _supports(scene, hold)
        yield Finding(
            "condim",
            hold.name,
            "condim",
            3.0,
            message="$shape turns between $against because each side touches it in one"
            f" point and condim $value has no torsional friction (from {start.name})",
            against=tuple(scene.names[pad] for pad in pads),
            used=4.0,
            element=scene.source.authored(pads[0], "condim"),
            advice=for_geom(
                scene,
                pads[0],
                {"condim": "4"},
                "adds torsional friction, with friction[1] as its coefficient",
            ),
        )


def _supports(scene: Scene, hold: Hold) -> list[int]:
    """Return the geoms that hold a body, in the order of its touches."""
    is_held = (
        scene.model.body_weldid[scene.model.geom_bodyid]
        == scene.model.body_weldid[hold.body]
    )
    geoms = (
        geom for touch in hold.touches for geom in touch.geoms if not is_held[geom]
    )
    return list(dict.fromkeys(geoms))
