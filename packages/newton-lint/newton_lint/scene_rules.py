"""Rules on a whole scene: its options, masks, meshes, masses and free bodies."""

import contextlib
from collections.abc import Iterator

import mujoco
import numpy as np

from newton_lint.changes import of_element, of_geom, of_option
from newton_lint.findings import Finding, Remedy, number
from newton_lint.pairs import MESH, OFF, masks_of
from newton_lint.scene import FREE, WEIGHTLESS, Scene
from newton_lint.warp_engine import refusal

# Bodies sink visibly into a pyramidal cone from this friction on: 2 mm at 3, 100 mm at
# 8.
STEEP = 3.0
# Visual geoms are reported if they make a body this many times as heavy.
HEAVIER = 1.7
# A mass counts as doubled if its ratio differs from 2 by less than this.
TWICE = 0.1
# A mesh is reported if its convex hull has this many times its volume.
HOLLOW = 2.0
FEW = (4, 10)
"""An elliptic cone needs at least one of these numbers of solver iterations."""
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
    attached = np.flatnonzero(~scene.free[tree])
    is_off = model.opt.disableflags & (WEIGHTLESS | OFF)
    if is_off or not (model.opt.gravity.any() and len(attached)):
        return
    named = tree[np.append(model.pair_geom1, model.pair_geom2)]
    for body in np.setdiff1d(tree[scene.free[tree] & collides], named).tolist():
        own = tree == body
        bits, masks = (
            int(np.bitwise_or.reduce(values[~own])) for values in (contype, conaffinity)
        )
        if (contype[own] & masks | conaffinity[own] & bits).any():
            continue
        geom = int(np.flatnonzero(own)[0] if bits else attached[0])
        finding = Finding(
            "lost",
            scene.bodies[body],
            "contype",
            float(contype[geom]),
            message="$shape falls through every other body because the contype and"
            " conaffinity bits of its geoms match those of no other geom",
            element=scene.source.authored(geom, "contype") or scene.source.geom(geom),
        )
        changes = of_geom(
            scene, geom, {"contype": f"{bits or 1}", "conaffinity": f"{bits or 1}"}
        )
        yield finding, [(changes, "lets it collide")]


def damped(scene: Scene) -> Iterator[Found]:
    """Yield free joints with damping, which slows falling bodies like a thick fluid."""
    model = scene.model
    for joint in np.flatnonzero(model.jnt_type == FREE).tolist():
        damping = float(model.dof_damping[model.jnt_dofadr[joint]])
        if not damping:
            continue
        body = int(model.jnt_bodyid[joint])
        weight = model.body_subtreemass[body] * np.linalg.norm(model.opt.gravity)
        finding = Finding(
            "damping",
            scene.bodies[body],
            "damping",
            damping,
            message="$shape never falls faster than"
            f" {number(weight / damping)} m/s because its free joint has a damping of"
            " $value, which acts on it like a thick fluid",
            severity="warning" if weight < FAST_M_S * damping else "note",
            element=scene.source.find("joint", joint),
        )
        changes = of_element(scene, "joint", joint, damping="0")
        yield finding, [(changes, "lets it fall freely")]


def visual(scene: Scene) -> Iterator[Found]:
    """Yield bodies whose mass includes visual geoms, which collide with nothing."""
    model = scene.model
    root = scene.source.root
    is_bare = masks_of(model).all()
    if root is None or root.tag != "mujoco" or model.npair or is_bare:
        return
    # Old releases have no MjSpec, or one that cannot do this.
    with contextlib.suppress(ValueError, AttributeError):
        spec = mujoco.MjSpec.from_file(str(root.file))
        count = 0
        for body in () if spec.compiler.inertiagrouprange[0] else spec.bodies[1:]:
            visible = [
                geom for geom in body.geoms if not geom.contype and not geom.conaffinity
            ]
            if 0 < len(visible) < len(body.geoms) and not body.explicitinertial:
                for geom in visible:
                    geom.mass = 0.0
                    count = count + 1
        light = spec.compile() if count else model
        times = (
            model.body_mass
            / np.maximum(light.body_mass, mujoco.mjMINVAL)
            * (model.body_weldid > 0)
        )
        heavier = times > HEAVIER
        # Other ratios may be intended.
        is_twice = (np.abs(times[heavier] - 2.0) < TWICE).all()
        for body in np.flatnonzero(heavier).tolist():
            mass = model.body_mass[body]
            used = light.body_mass[body]
            finding = Finding(
                "visual",
                scene.bodies[body],
                "mass",
                mass,
                message=f"$shape weighs $value, which is {number(times[body], 2)} times its"
                " mass without the visual geoms, which collide with nothing",
                unit="kg",
                severity="warning" if is_twice else "note",
            )
            hint = (
                'Set mass="0" on the visual geoms, or add an <inertial> to the body;'
                f" its mass is then {number(used)} kg."
            )
            yield finding, [((), hint)]


def closed(scene: Scene) -> Iterator[Found]:
    """Yield hollow meshes, which collide as their convex hull."""
    model = scene.model
    for geom in np.flatnonzero(
        (masks_of(model) > 0) & (model.geom_type == MESH)
    ).tolist():
        mesh = int(model.geom_dataid[geom])
        if (start := int(model.mesh_graphadr[mesh])) < 0:  # The mesh has no hull.
            continue
        vertices = model.mesh_vert[model.mesh_vertadr[mesh] :][
            : model.mesh_vertnum[mesh]
        ].astype(float)
        corners = vertices[
            model.mesh_face[model.mesh_faceadr[mesh] :][: model.mesh_facenum[mesh]]
        ]
        count, faces = model.mesh_graph[start : start + 2].tolist()
        hull = vertices[
            model.mesh_graph[start + 2 + 3 * count + 3 * faces :][: 3 * faces].reshape(
                -1, 3
            )
        ]
        full = abs(np.linalg.det(hull).sum())
        hollow = abs(np.linalg.det(corners).sum())
        if full > HOLLOW * hollow > 0.0:
            finding = Finding(
                "closed",
                scene.names[geom],
                "hull",
                full / hollow,
                message="$shape collides as its convex hull, which has $value times the"
                " volume of the mesh, so other bodies cannot enter its hollow parts",
                severity="note",
                element=scene.source.geom(geom),
            )
            hint = (
                "Replace the mesh by several convex geoms, for example with CoACD or"
                " obj2mjcf."
            )
            yield finding, [((), hint)]


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
    remedy = []
    iterations = scene.model.opt.iterations
    for few in (
        (count for count in FEW if count > iterations) if iterations < 10 else (0,)
    ):
        attributes = {"cone": "elliptic"} | ({"iterations": str(few)} if few else {})
        remedy.append((of_option(scene, **attributes), effect.format(number(less))))
        if impratio <= 1.0:
            firm = of_option(scene, **attributes, impratio="10")
            remedy.append((firm, effect.format(number(10.0 * less / impratio))))
    if impratio > 1.0:
        finding = _scene_finding(
            scene,
            "pyramid",
            "impratio",
            impratio,
            message="impratio $value hardens the normal rows of a pyramidal cone like"
            " its friction; only an elliptic cone separates them",
        )
        yield finding, remedy
    if steepest > STEEP:
        # mj_makeImpedance gives this ratio of R to that of an elliptic cone (condim 3).
        softer = 0.5 * steepest**2 * (1.0 + steepest**2)
        finding = _scene_finding(
            scene,
            "pyramid",
            "friction",
            steepest,
            message=f"friction $value makes contacts {number(softer)} times softer with a"
            " pyramidal cone, so bodies sink and creep more",
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
