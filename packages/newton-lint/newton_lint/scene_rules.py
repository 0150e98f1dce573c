"""Rules on a whole scene: its options, its masks and its free bodies."""

from collections.abc import Iterator

import numpy as np

from newton_lint.changes import elliptic, of_element, of_geom
from newton_lint.findings import Finding, Remedy, number
from newton_lint.pairs import OFF, masks_of, where
from newton_lint.scene import FREE, WEIGHTLESS, Scene
from newton_lint.warp_engine import refusal

# With a pyramidal cone, bodies sink visibly at this friction: 2 mm at 3, 100 mm at 8.
STEEP = 3.0
FAST_M_S = 20.0
"""Damping of a free joint hardly matters if it permits this speed of fall."""
Found = tuple[Finding, Remedy]


def lost(scene: Scene) -> Iterator[Found]:
    """Yield free bodies that collide with no other body, so that they fall forever."""
    model = scene.model
    tree = model.body_rootid[model.geom_bodyid]
    contype = model.geom_contype
    conaffinity = model.geom_conaffinity
    # If all masks are off, every geom counts.
    collides = (masks_of(model) > 0) | (scene.colliding == 0)
    attached = where(~scene.free[tree])
    is_off = model.opt.disableflags & (WEIGHTLESS | OFF)
    if is_off or not (model.opt.gravity.any() and attached):
        return
    named = tree[np.append(model.pair_geom1, model.pair_geom2)]
    for body in np.setdiff1d(tree[scene.free[tree] & collides], named).tolist():
        own = tree == body
        bits, masks = (
            np.bitwise_or.reduce(values[~own]) for values in (contype, conaffinity)
        )
        if (contype[own] & masks | conaffinity[own] & bits).any():
            continue
        geom = where(own)[0] if bits else attached[0]
        finding = Finding(
            "lost",
            scene.bodies[body],
            "contype",
            float(contype[geom]),
            "$shape falls through every other body because the contype and"
            " conaffinity bits of its geoms do not match those of any other geom",
            element=scene.source.authored(geom, "contype")
            or scene.source.find("geom", geom),
        )
        changes = of_geom(
            scene, geom, {"contype": f"{bits or 1}", "conaffinity": f"{bits or 1}"}
        )
        yield finding, [(changes, "lets it collide")]


def damped(scene: Scene) -> Iterator[Found]:
    """Yield free joints with damping, which slows falling bodies like a thick fluid."""
    model = scene.model
    for joint in where(model.jnt_type == FREE):
        damping = model.dof_damping[model.jnt_dofadr[joint]]
        if not damping:
            continue
        body = model.jnt_bodyid[joint]
        weight = model.body_subtreemass[body] * np.linalg.norm(model.opt.gravity)
        finding = Finding(
            "damping",
            scene.bodies[body],
            "damping",
            damping,
            "$shape never falls faster than"
            f" {number(weight / damping)} m/s because its free joint has a damping of"
            " $value, which acts on it like a thick fluid",
            severity="warning" if weight < FAST_M_S * damping else "note",
            element=scene.source.find("joint", joint),
        )
        changes = of_element(scene, "joint", joint, damping="0")
        yield finding, [(changes, "lets it fall freely")]


def pyramid(scene: Scene) -> Iterator[Found]:
    """Yield an impratio and a friction that soften or harden a pyramidal cone."""
    option = scene.option
    contacts = scene.contacts
    rows = contacts.condim > 1
    if option.cone != "pyramidal" or not rows.any():
        return
    steepest = contacts.friction[rows, 0].max()
    impratio = option.impratio
    # mj_diagApprox: an edge of a pyramid has (1 + μ²) times the weight.
    less = 1.0 + steepest**2
    effect = "reduces creep under load by a factor of {} (predicted)"
    remedy = [(elliptic(scene), effect.format(number(less)))]
    if impratio <= 1.0:
        firm = elliptic(scene, 10.0)
        remedy.append((firm, effect.format(number(10.0 * less / impratio))))
    if impratio > 1.0:
        finding = _scene_finding(
            scene,
            "pyramid",
            "impratio",
            impratio,
            message="The impratio of $value stiffens the normal direction of contacts as"
            " much as friction because the cone is pyramidal, not elliptic",
        )
        yield finding, remedy
    if steepest > STEEP:
        # mj_makeImpedance gives this ratio of R to the R of an elliptic cone (condim
        # 3).
        softer = 0.5 * steepest**2 * (1.0 + steepest**2)
        finding = _scene_finding(
            scene,
            "pyramid",
            "friction",
            steepest,
            message=f"The friction of $value makes contacts {number(softer)} times softer"
            " because the cone is pyramidal, so bodies sink and creep more",
        )
        yield finding, remedy


def engine(scene: Scene) -> Iterator[Found]:
    """Yield the error message with which MuJoCo Warp refuses the scene."""
    if scene.engine.name == "warp" and (refused := refusal(scene.model)):
        message = f"MuJoCo Warp refuses this model: {refused}"
        yield _scene_finding(scene, "engine", "", 1.0, message, "error"), ()


def _scene_finding(
    scene: Scene,
    rule: str,
    parameter: str,
    value: float,
    message: str,
    severity: str = "warning",
) -> Finding:
    return Finding(
        rule,
        "",
        parameter,
        value,
        message,
        severity=severity,
        element=scene.source.option(parameter) if parameter else None,
    )
