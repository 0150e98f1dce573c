"""What Newton's importer makes of MJCF otherwise than MuJoCo: two compiled models, compared by the names of geoms."""

import re
from collections.abc import Iterator

import mujoco
import numpy as np

from newton_lint.combined import OVERRIDE, REFSAFE_OFF
from newton_lint.findings import Finding
from newton_lint.newton_models.compat import make_solver
from newton_lint.newton_models.reader import imported
from newton_lint.pairs import pairs_of
from newton_lint.scene import Scene
from newton_lint.target import Target

SAME = 1e-4
"""Relative difference up to which a number is the same in single precision."""
OPTIONS = ("integrator", "cone", "impratio", "noslip_iterations")
OF_GEOMS = ("solref", "solimp", "friction", "condim", "priority", "margin", "gap", "solmix")
MADE = "is what the file says; Newton's importer makes another of it"


def dropped(scene: Scene, target: Target) -> list[Finding]:
    """Compare MuJoCo's model of a file with the one that ``SolverMuJoCo`` gets from Newton's importer."""
    solver = make_solver(imported(target.path), use_mujoco_cpu=True)
    theirs, ours = solver.mj_model, scene.model
    names = {_plain(theirs.geom(index).name): index for index in range(theirs.ngeom)}
    known = {index: names[name] for index in range(ours.ngeom) if (name := ours.geom(index).name) in names}
    return [*_counts(scene, theirs), *_options(scene, theirs), *_parameters(scene, theirs, known)]


def _plain(label: str) -> str:
    """Return a geom's name in MJCF: Newton puts the bodies before it, and its number behind."""
    return re.sub(r"_\d+$", "", label.rsplit("/", 1)[-1])


def _found(
    scene: Scene, shape: str, parameter: str, value: float, used: float | None, message: str, attribute: str = ""
) -> Finding:
    element = scene.source.option(parameter) if not shape else None
    if shape in scene.names and attribute:
        element = scene.source.authored(scene.names.index(shape), attribute)
    return Finding("import", shape, (), parameter, float(value), used, "1", message, element=element)


def _counts(scene: Scene, theirs: mujoco.MjModel) -> Iterator[Finding]:
    mine, other = scene.colliding, int(np.count_nonzero(theirs.geom_contype | theirs.geom_conaffinity))
    if mine != other:
        message = "can collide by the file; Newton's importer makes fewer or more, as of <replicate>"
        yield _found(scene, "", "geoms", mine, other, message)
    mine, other = len(scene.contacts), len(pairs_of(theirs)[0])
    if mine != other:
        yield _found(scene, "", "pairs", mine, other, "may touch by the file; Newton's importer makes fewer or more")


def _options(scene: Scene, theirs: mujoco.MjModel) -> Iterator[Finding]:
    ours = scene.model
    for name in OPTIONS:
        mine, other = float(getattr(ours.opt, name)), float(getattr(theirs.opt, name))
        if not np.isclose(mine, other, rtol=SAME):
            yield _found(scene, "", name, mine, other, MADE)
    for name, bit, flags in (("refsafe", REFSAFE_OFF, "disableflags"), ("override", OVERRIDE, "enableflags")):
        mine, other = (bool(getattr(model.opt, flags) & bit) for model in (ours, theirs))
        if mine != other:
            yield _found(scene, "", name, mine, float(other), "is set in the file; Newton's importer drops the flag")


def _parameters(scene: Scene, theirs: mujoco.MjModel, known: dict[int, int]) -> Iterator[Finding]:
    for name in OF_GEOMS:
        mine, other = (getattr(model, f"geom_{name}").reshape(model.ngeom, -1) for model in (scene.model, theirs))
        for index, twin in known.items():
            differs = np.flatnonzero(~np.isclose(mine[index], other[twin], rtol=SAME, atol=1e-9))
            for column in differs.tolist():
                parameter = name if mine.shape[1] == 1 else f"{name}[{column}]"
                values = float(mine[index, column]), float(other[twin, column])
                yield _found(scene, scene.names[index], parameter, *values, MADE, name)
