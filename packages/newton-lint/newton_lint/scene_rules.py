"""Rules of a whole scene: what its options, flags, pairs and bits make of contacts."""

import contextlib
from collections.abc import Iterator

import mujoco
import numpy as np

from newton_lint.advice import elliptic, for_geom
from newton_lint.findings import Advice, Finding
from newton_lint.pairs import MOST_PAIRS, OFF, read
from newton_lint.scene import WEIGHTLESS, Scene
from newton_lint.warp_engine import refusal

# Friction from which a body sinks into a pyramid's contacts, 2 mm at 3, 100 at 8; what is farther hangs in the air.
STEEP = 3.0
NEAR_M = 1e-3
# Times as heavy as without geoms that are only seen, how near to 2 is twice; times as large as its mesh a hull is.
HEAVIER = 1.7
TWICE = 0.1
HOLLOW = 2.0
MESH = int(mujoco.mjtGeom.mjGEOM_MESH)


def lost(scene: Scene) -> Iterator[Finding]:
    """Yield bodies that move freely, and that gravity takes through all that there is to stop them."""
    model = scene.model
    contacts = scene.contacts
    tree = model.body_rootid[model.geom_bodyid]
    collides = np.isin(np.arange(model.ngeom), read(model)) | (
        scene.colliding == 0
    )  # of all masks that are off
    is_whole = len(read(model)) == np.count_nonzero(
        model.geom_contype | model.geom_conaffinity
    )
    is_free = scene.free[tree]
    met = {*tree[contacts.first].tolist(), *tree[contacts.second].tolist()}
    falls = bool(model.opt.gravity.any()) and not model.opt.disableflags & (
        WEIGHTLESS | OFF
    )
    others = np.flatnonzero(~is_free)
    for body in (
        sorted({*tree[is_free & collides].tolist()} - met)
        if falls and is_whole and len(others)
        else ()
    ):
        bits = int(np.bitwise_or.reduce(model.geom_contype[tree != body]))
        geom = int(np.flatnonzero(tree == body)[0] if bits else others[0])
        yield Finding(
            "lost",
            scene.bodies[body],
            "contype",
            float(model.geom_contype[geom]),
            "meets no geom of another body, and falls through all of them: no geom's bits meet those of its geoms",
            element=scene.source.authored(geom, "contype") or scene.source.geom(geom),
            advice=for_geom(
                scene,
                geom,
                {"contype": f"{bits or 1}", "conaffinity": f"{bits or 1}"},
                "it is met",
            ),
        )


def fixed(scene: Scene) -> Iterator[Finding]:
    """Yield bodies that say their mass, have no joint and touch nothing: they hang in the air."""
    model = scene.model
    data = mujoco.MjData(scene.model)
    tree = scene.model.body_rootid[scene.model.geom_bodyid]
    mujoco.mj_kinematics(model, data)
    static = np.flatnonzero(
        ~np.isin(tree, model.body_rootid[model.jnt_bodyid])
    ).tolist()
    for body in np.flatnonzero((model.body_parentid == 0) & (model.body_mocapid < 0))[
        1:
    ].tolist():
        geoms = [
            geom for geom in static if tree[geom] == body and model.geom_contype[geom]
        ]
        elements = [
            element
            for geom in geoms
            if (element := scene.source.geom(geom)) and "mass" in element.attributes
        ]
        pairs = (
            (geom, other)
            for other in range(model.ngeom)
            for geom in geoms
            if tree[other] != body
        )
        near = (
            mujoco.mj_geomDistance(model, data, *pair, NEAR_M, None) < NEAR_M
            for pair in pairs
        )
        if elements and not any(near):
            element = elements[0]
            yield Finding(
                "fixed",
                scene.bodies[body],
                "mass",
                model.body_subtreemass[body],
                "has no joint: it is fixed to the world, where it hangs in the air",
                (),
                None,
                "kg",
                "note",
                element,
                Advice("a <freejoint/> in it lets it fall"),
            )


def visual(scene: Scene) -> Iterator[Finding]:
    """Yield bodies to whose mass geoms add that touch nothing, as those that are only seen do."""
    model = scene.model
    root = scene.source.root
    if root is None or root.tag != "mujoco" or model.npair:
        return
    with contextlib.suppress(
        ValueError, AttributeError
    ):  # an old release has no MjSpec that could
        spec = mujoco.MjSpec.from_file(str(root.file))
        count = 0
        for body in () if spec.compiler.inertiagrouprange[0] else spec.bodies[1:]:
            seen = [
                geom for geom in body.geoms if not geom.contype and not geom.conaffinity
            ]
            if 0 < len(seen) < len(body.geoms) and not body.explicitinertial:
                for geom in seen:
                    geom.mass = 0.0
                    count = count + 1
        light = spec.compile() if count else model
        times = (
            model.body_mass
            / np.maximum(light.body_mass, mujoco.mjMINVAL)
            * (model.body_weldid > 0)
        )
        heavier = times > HEAVIER
        is_twice = (np.abs(times[heavier] - 2.0) < TWICE).all()  # else it may be meant
        for body in np.flatnonzero(heavier).tolist():
            mass = model.body_mass[body]
            used = light.body_mass[body]
            yield Finding(
                "visual",
                scene.bodies[body],
                "mass",
                mass,
                f"is {times[body]:.2g} times that without geoms that touch nothing and are only seen",
                (),
                None,
                "kg",
                "warning" if is_twice else "note",
                advice=Advice(
                    f'mass="0" on them, or an <inertial> in the body: {mass:.3g} → {used:.3g} kg'
                ),
            )


def closed(scene: Scene) -> Iterator[Finding]:
    """Yield meshes that collide as their convex hull, which closes what is hollow."""
    model = scene.model
    touch = (scene.model.geom_contype | scene.model.geom_conaffinity) != 0
    for geom in np.flatnonzero(touch & (model.geom_type == MESH)).tolist():
        mesh = int(model.geom_dataid[geom])
        if (start := int(model.mesh_graphadr[mesh])) < 0:  # it has no hull
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
        full, hollow = (
            abs(np.linalg.det(triangles).sum()) for triangles in (hull, corners)
        )
        if full > HOLLOW * hollow > 0.0:
            yield Finding(
                "closed",
                scene.names[geom],
                "hull",
                full / hollow,
                "times its volume is its convex hull, which is what collides: nothing gets into what is hollow",
                (),
                None,
                "1",
                "note",
                scene.source.geom(geom),
                Advice("several convex geoms in its place, as CoACD or obj2mjcf make"),
            )


def pyramid(scene: Scene) -> Iterator[Finding]:
    """Yield what a pyramidal cone makes of a high impratio, and of high friction."""
    option = scene.option
    contacts = scene.contacts
    rows = contacts.condim > 1
    if option.cone != "pyramidal" or not rows.any():
        return
    steepest = contacts.friction[rows, 0].max()
    advice = elliptic(scene, steepest)
    if option.impratio > 1.0:
        yield _scene_finding(
            scene,
            "pyramid",
            "impratio",
            option.impratio,
            "makes all rows of a pyramid harder, those of the normal too; only an elliptic cone tells them apart",
            advice,
        )
    if steepest > STEEP:
        softer = (
            0.5 * steepest**2 * (1.0 + steepest**2)
        )  # its R by mj_makeImpedance, of condim 3, over an ellipse's
        yield _scene_finding(
            scene,
            "pyramid",
            "friction",
            steepest,
            f"makes a pyramid's contacts {softer:.3g} times softer: they sink and creep more",
            advice,
        )


def unread(scene: Scene) -> Iterator[Finding]:
    """Yield how many geoms are left out where all of them make too many pairs."""
    count = np.count_nonzero(
        scene.model.geom_contype | scene.model.geom_conaffinity
    ) - len(read(scene.model))
    if count:
        yield _scene_finding(
            scene,
            "unread",
            "geoms",
            float(count),
            f"are not read: all make over {MOST_PAIRS:,} pairs, and the others stand for them",
            severity="note",
        )


def engine(scene: Scene) -> Iterator[Finding]:
    """Yield what MuJoCo Warp says of a scene, in its words."""
    if scene.engine.name == "warp" and (refused := refusal(scene.model)):
        yield _scene_finding(
            scene,
            "engine",
            "",
            1.0,
            f"MuJoCo Warp refuses this model: {refused}",
            severity="error",
        )


def _scene_finding(
    scene: Scene,
    rule: str,
    parameter: str,
    value: float,
    message: str,
    advice=None,
    severity="warning",
) -> Finding:
    return Finding(
        rule,
        "",
        parameter,
        value,
        message,
        severity=severity,
        element=scene.source.option(parameter) if parameter else None,
        advice=advice,
    )
