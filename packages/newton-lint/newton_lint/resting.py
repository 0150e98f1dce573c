"""Rules on bodies that should rest: they wander, or parts of them fall through."""

import math
from collections.abc import Iterator

import numpy as np
from mujoco import MjModel

from newton_lint.changes import Changes, of_geom
from newton_lint.failures import origin
from newton_lint.findings import Finding
from newton_lint.law import M
from newton_lint.ledger import Run
from newton_lint.pairs import MESH, PLANE, where
from newton_lint.scene import FREE, Scene
from newton_lint.trials import Symptom

WANDERS_DEG_S = 1.0
"""A body wanders if it turns faster than this while it should rest."""
SWINGS_DEG_S = 60.0
"""A body that turns faster than this is not about to rest."""
FEW_POINTS = 3
"""MuJoCo finds at most this many points between a mesh and a plane."""
BELOW_MM = 10.0
"""A part has fallen through if its centre is this deep below a plane."""


def wandering(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield bodies that turn slowly on too few points, or on a border of two geoms."""
    model = scene.model
    static = model.body_weldid[model.geom_bodyid] == 0
    for joint in where(model.jnt_type == FREE):
        body = model.jnt_bodyid[joint]
        dof = model.jnt_dofadr[joint] + 3

        def turning(run: Run, dof=dof) -> float:
            spins = [sample.arrays["qvel"][dof : dof + 3] for sample in run.late]
            return math.degrees(np.linalg.norm(spins, axis=1).mean())

        value = turning(run)
        is_alone = np.isclose(model.body_subtreemass[body], model.body_mass[body])
        if not (is_alone and WANDERS_DEG_S < value < SWINGS_DEG_S):
            continue
        geoms = [
            pair
            for sample in run.samples
            for pair in sample.touches.geoms.tolist()
            if body in model.body_weldid[model.geom_bodyid[pair]]
        ]
        own = {geom for pair in geoms for geom in pair if not static[geom]}
        under = {geom for pair in geoms for geom in pair if static[geom]}
        # Mean number of contact points per sample.
        points = len(geoms) / len(run.samples)
        meshes = [geom for geom in own if model.geom_type[geom] == MESH]
        ways: list[Changes] = []
        names = [scene.names[geom] for geom in sorted(under)]
        if meshes and points < FEW_POINTS + 0.5 and len(under) == 1:
            mesh = meshes[0]
            ways = [
                of_geom(scene, mesh, {"type": kind}) for kind in ("box", "cylinder")
            ]
            hint = "Use a box or several spheres in place of the flat mesh."
            why = f"MuJoCo finds only {points:.2g} contact points on its flat mesh"
        elif len(under) == 2 and len(own) == 1:
            hint = f"Use one geom in place of {names[0]} and {names[1]}."
            why = "it lies on the border of two geoms, whose contact points shift and add up"
        else:
            continue
        yield Symptom(
            Finding(
                "wander",
                scene.bodies[body],
                "points",
                value,
                "$shape turns at $value on $against"
                f"{origin(run)} although it should rest, because {why}",
                against=tuple(names),
                unit="°/s",
                hint=hint,
            ),
            turning,
            ways,
        )


def fallen(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield parts of a free robot that pass a plane because only others collide."""
    model = scene.model
    pairs = scene.contacts.geoms
    tree = model.body_rootid[model.geom_bodyid]
    for plane in where(model.geom_type == PLANE):
        partners = np.unique(pairs[(pairs == plane).any(axis=1)])
        # Geoms of the same robot that never collide with this plane.
        is_part = np.isin(tree, tree[partners]) & scene.free[tree]
        is_part[partners] = False
        if not (others := where(is_part)):
            continue

        def below(run: Run, geoms=others, plane=plane) -> float:
            return M * max(0.0, _depths(run, geoms, plane).max())

        value = below(run)
        if value < BELOW_MM:
            continue
        deepest = others[_depths(run, others, plane).argmax()]
        masks = _masks(model, plane)
        yield Symptom(
            Finding(
                "through",
                scene.names[deepest],
                "contype",
                value,
                "$shape is $value below $against after 2 s"
                f"{origin(run)} because only other parts of the robot collide with it",
                against=(scene.names[plane],),
                unit="mm",
            ),
            below,
            [
                of_geom(scene, deepest, masks),
                sum((of_geom(scene, geom, masks) for geom in others), ()),
            ],
        )


def _depths(run: Run, geoms: list[int], plane: int) -> np.ndarray:
    """Return how far the centres of geoms are below a plane at the end [m]."""
    arrays = run.samples[-1].arrays
    normal = arrays["geom_xmat"][plane].reshape(3, 3)[:, 2]
    return -(arrays["geom_xpos"][geoms] - arrays["geom_xpos"][plane]) @ normal


def _masks(model: MjModel, plane: int) -> dict[str, str]:
    """Return masks that collide with a plane but not with each other, if possible."""
    affinity = model.geom_conaffinity[plane]
    return {"contype": str(affinity or 1), "conaffinity": "0" if affinity else "1"}
