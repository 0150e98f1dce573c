"""Rules of a whole scene: what its options, flags, pairs and bits make of contacts."""

from collections.abc import Iterator

import mujoco
import numpy as np

from newton_lint.advice import elliptic, for_geom, for_option
from newton_lint.combined import OVERRIDE
from newton_lint.findings import Advice, Finding
from newton_lint.pairs import MOST_PAIRS, OFF, read
from newton_lint.scene import Scene
from newton_lint.warp_engine import refusal

STEEP = 3.0
"""Friction from which a body sinks into a pyramid's contacts by its own weight: by 2 mm at 3, by 100 mm at 8."""
NEW_GAP = tuple(map(int, mujoco.__version__.split(".")[:2])) >= (3, 9)
"""Whether this release presses from margin on, and not from margin − gap on."""
WEIGHTLESS = int(mujoco.mjtDisableBit.mjDSBL_GRAVITY)


def lost(scene: Scene) -> Iterator[Finding]:
    """Yield bodies that move freely, and that gravity takes through all that there is to stop them."""
    model, contacts = scene.model, scene.contacts
    weld = model.body_weldid[model.geom_bodyid]  # what is fixed together falls together
    collides = np.isin(np.arange(model.ngeom), read(model))
    met, loose = np.zeros(model.nbody, dtype=bool), np.zeros(model.nbody, dtype=bool)
    met[weld[contacts.first]] = met[weld[contacts.second]] = True
    loose[weld[collides & scene.free[model.geom_bodyid]]] = True
    falls = bool(model.opt.gravity.any()) and not model.opt.disableflags & WEIGHTLESS
    stops = bool((collides & ~scene.free[model.geom_bodyid]).any())
    off = bool(model.opt.disableflags & OFF)  # without constraints mj_collision finds none either
    why = 'contacts are disabled by <flag contact="disable"/>' if off else "no geom's bits meet those of its geoms"
    for body in np.flatnonzero(loose & ~met).tolist() if falls and stops else ():
        geom = int(np.flatnonzero(collides & (weld == body))[0])
        value = float(model.geom_contype[geom])
        message = f"meets no geom of another body, and falls through all of them: {why}"
        bits = int(np.bitwise_or.reduce(model.geom_contype[weld != body], initial=0)) or 1
        advice = None if off else for_geom(scene, geom, {"contype": f"{bits}", "conaffinity": f"{bits}"}, "it is met")
        element = scene.source.authored(geom, "contype") or scene.source.geom(geom)
        yield Finding("lost", scene.bodies[body], "contype", value, message, element=element, advice=advice)


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
        yield _scene_finding(scene, "pyramid", "impratio", option.impratio, message, advice)
    if steepest > 1.0:
        softer = 0.5 * steepest**2 * (1.0 + steepest**2)  # its R by mj_makeImpedance, of condim 3, over an ellipse's
        message = f"makes a pyramid's contacts {softer:.3g} times softer: they sink and creep more"
        severity = "warning" if steepest > STEEP else "note"
        yield _scene_finding(scene, "pyramid", "friction", steepest, message, advice, severity)


def gap(scene: Scene) -> Iterator[Finding]:
    """Yield geoms with a margin and a gap, of which MuJoCo 3.9 changed the meaning."""
    model = scene.model
    for geom in np.flatnonzero(scene.counts & (model.geom_gap > 0.0) & (model.geom_margin >= model.geom_gap))[:1]:
        margin, wide = float(model.geom_margin[geom]), float(model.geom_gap[geom])
        old = f"presses from margin − gap, {margin - wide:.3g} m, on and lists contacts from margin on"
        new = f"presses from margin, {margin:.3g} m, on and lists contacts from margin + gap on"
        now, then = (new, f"before 3.9 it {old}") if NEW_GAP else (old, f"from 3.9 on it {new}")
        gain = f'for what it was before 3.9 write margin="{margin - wide:.6g}"' if NEW_GAP else "see MuJoCo's changelog"
        message = f"beside a margin of {margin:.3g} m: this release {now}; {then}"
        element, shape = scene.source.authored(int(geom), "gap"), scene.names[geom]
        yield Finding("gap", shape, "gap", wide, message, (), None, "m", "note", element, Advice((), gain))


def unread(scene: Scene) -> Iterator[Finding]:
    """Yield how many geoms are left out where all of them make too many pairs."""
    count = np.count_nonzero(scene.model.geom_contype | scene.model.geom_conaffinity) - len(read(scene.model))
    if count:
        message = f"are not read: all make over {MOST_PAIRS:,} pairs, and the first of those alike stand for them"
        yield _scene_finding(scene, "unread", "geoms", float(count), message, severity="note")


def override(scene: Scene) -> Iterator[Finding]:
    """Yield the override flag, which leaves all that geoms say of contacts unread."""
    opt = scene.model.opt
    if opt.enableflags & OVERRIDE and len(scene.contacts):
        message = "is on: all contacts have the option's solref, solimp and friction, whatever their geoms say"
        advice = for_option(scene, {}, 'take <flag override="enable"/> away: geoms count again')
        yield _scene_finding(scene, "override", "o_solref", float(opt.o_solref[0]), message, advice)
    # Their values don't tell whether they were authored: a scene without them has the geoms' defaults there.
    element = scene.source.option("o_solimp") or scene.source.option("o_solref")
    names = [name for name in element.attributes if name.startswith("o_")] if element else []
    if names and not opt.enableflags & OVERRIDE:
        message = 'counts nowhere without <flag override="enable"/>, and with it for all contacts'
        advice = Advice((), "say it of the geoms whose contacts are meant")
        yield _scene_finding(scene, "override", names[0], float(getattr(opt, names[0])[0]), message, advice)


def engine(scene: Scene) -> Iterator[Finding]:
    """Yield what MuJoCo Warp says of a scene, in its words."""
    if scene.engine.name != "warp":
        return
    if refused := refusal(scene.model):
        message = f"MuJoCo Warp refuses this model: {refused}"
        yield _scene_finding(scene, "engine", "", 1.0, message, severity="error")
    elif refused is None:
        message = "MuJoCo Warp is not installed, and cannot be asked: pip install mujoco-warp"
        yield _scene_finding(scene, "engine", "", 0.0, message)


def _scene_finding(
    scene: Scene, rule: str, parameter: str, value: float, message: str, advice=None, severity="warning"
) -> Finding:
    element = scene.source.option(parameter) if parameter else None
    return Finding(rule, "", parameter, value, message, severity=severity, element=element, advice=advice)
