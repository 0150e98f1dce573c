"""Rules of a whole scene: what its options, flags, pairs and bits make of contacts."""

from collections.abc import Iterator

import mujoco
import numpy as np

from newton_lint.advice import elliptic, for_geom, for_option, shorter_step
from newton_lint.combined import OVERRIDE
from newton_lint.findings import Advice, Finding
from newton_lint.law import DEFAULT_SOLREF, DISCRETE
from newton_lint.pairs import OFF, collidable
from newton_lint.scene import Scene

WARP_SOLVERS = (int(mujoco.mjtSolver.mjSOL_CG), int(mujoco.mjtSolver.mjSOL_NEWTON))
STEEP = 3.0
"""Friction from which a body sinks into a pyramid's contacts by its own weight: by 2 mm at 3, by 100 mm at 8."""
WEIGHTLESS = int(mujoco.mjtDisableBit.mjDSBL_GRAVITY)


def lost(scene: Scene) -> Iterator[Finding]:
    """Yield bodies that move freely, and that gravity takes through all that there is to stop them."""
    model, contacts = scene.model, scene.contacts
    weld = model.body_weldid[model.geom_bodyid]
    collides = (model.geom_contype | model.geom_conaffinity) != 0
    met, loose = np.zeros(model.nbody, dtype=bool), np.zeros(model.nbody, dtype=bool)
    met[weld[contacts.first]] = met[weld[contacts.second]] = True
    loose[weld[collides & scene.free[model.geom_bodyid]]] = True
    falls = bool(model.opt.gravity.any()) and not model.opt.disableflags & WEIGHTLESS
    stops = bool((collides & ~scene.free[model.geom_bodyid]).any())
    off = bool(model.opt.disableflags & OFF)
    why = 'contacts are disabled by <flag contact="disable"/>' if off else "no geom's bits meet those of its geoms"
    for body in np.flatnonzero(loose & ~met).tolist() if falls and stops else ():
        index = int(np.flatnonzero(collides & (weld == body))[0])
        value = float(model.geom_contype[index])
        message = f"meets no geom of another body, and falls through all of them: {why}"
        bits = int(np.bitwise_or.reduce(model.geom_contype[weld != body], initial=0)) or 1
        advice = None if off else for_geom(scene, index, {"contype": f"{bits}", "conaffinity": f"{bits}"}, "it is met")
        element = scene.source.authored(index, "contype") or scene.source.geom(index)
        yield Finding("lost", scene.bodies[body], (), "contype", value, None, "1", message, "warning", element, advice)


def pyramid(scene: Scene) -> Iterator[Finding]:
    """Yield what a pyramidal cone makes of a high impratio, and of friction above 1."""
    option, contacts = scene.option, scene.contacts
    rows = contacts.condim > 1
    if option.cone != "pyramidal" or not rows.any():
        return
    steepest = float(contacts.friction[rows, 0].max())
    advice = elliptic(scene, steepest)
    if option.impratio > 1.0:
        message = "makes all rows of a pyramid harder, those of the normal too; only an elliptic cone tells them apart"
        yield _whole(scene, "pyramid", "impratio", option.impratio, None, message, advice)
    if steepest > 1.0:
        softer = 0.5 * steepest**2 * (1.0 + steepest**2)
        message = f"makes a pyramid's contacts {softer:.3g} times softer: they sink and creep more"
        severity = "warning" if steepest > STEEP else "note"
        yield _whole(scene, "pyramid", "friction", steepest, None, message, advice, severity)


def named_pairs(scene: Scene) -> Iterator[Finding]:
    """Yield pairs that the scene names, and that make no contact or one without effect."""
    model = scene.model
    pairs = np.stack([model.pair_geom1, model.pair_geom2], axis=1)
    still = (model.body_dofnum[model.body_weldid[model.geom_bodyid[pairs]]] == 0).all(axis=1)
    for index, (pair, can, rests) in enumerate(zip(pairs, collidable(model, pairs), still, strict=True)):
        off = bool(model.opt.disableflags & OFF)
        if can and not rests and not off:
            continue
        reason = "contacts are disabled" if off else "neither geom moves" if can else "no two planes or fields collide"
        names = [scene.names[geom] for geom in pair]
        element = scene.source.pair(*(model.geom(int(geom)).name for geom in pair))
        message = f"makes no contact: {reason}"
        yield Finding("pair", names[0], (names[1],), "pair", float(index), None, "1", message, element=element)


def flags(scene: Scene) -> Iterator[Finding]:
    """Yield the override flag, which leaves all that geoms say of contacts unread."""
    model, opt = scene.model, scene.model.opt
    if opt.enableflags & OVERRIDE and len(scene.contacts):
        message = "is on: all contacts have the option's solref, solimp and friction, whatever their geoms say"
        advice = for_option(scene, {}, 'take <flag override="enable"/> away: geoms count again')
        yield _whole(scene, "override", "o_solref", float(opt.o_solref[0]), None, message, advice)
    authored = ~np.isclose(model.geom_solref[scene.counts], DEFAULT_SOLREF).all(axis=1)
    if not scene.option.refsafe and authored.any():
        short = scene.contacts.solref[:, 0]
        least = short[short > 0.0].min(initial=np.inf)
        if least < 2.0 * scene.option.timestep_s and scene.option.integrator != DISCRETE:
            message = "is below two steps and refsafe is off: contacts may go unstable"
            advice = shorter_step(scene, float(least))
            yield _whole(scene, "refsafe", "timeconst", float(least), None, message, advice, unit="s")


def engine(scene: Scene) -> Iterator[Finding]:
    """Yield what MuJoCo Warp refuses, or takes otherwise than MuJoCo C."""
    if scene.engine.name != "warp":
        return
    opt = scene.model.opt
    for name, value, refused in (
        ("noslip_iterations", opt.noslip_iterations, opt.noslip_iterations > 0),
        ("solver", opt.solver, opt.solver not in WARP_SOLVERS),
        ("integrator", opt.integrator, opt.integrator == DISCRETE),
        ("override", opt.enableflags & OVERRIDE, bool(opt.enableflags & OVERRIDE)),
    ):
        if refused:
            yield _whole(scene, "engine", name, float(value), None, "is not in all releases of MuJoCo Warp", None)


def _whole(
    scene: Scene,
    rule: str,
    parameter: str,
    value: float,
    used: float | None,
    message: str,
    advice: Advice | None,
    severity: str = "warning",
    unit: str = "1",
) -> Finding:
    element = scene.source.option(parameter)
    return Finding(rule, "", (), parameter, value, used, unit, message, severity, element, advice)
