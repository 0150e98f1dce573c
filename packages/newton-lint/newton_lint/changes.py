"""Changes of a scene: their places in the files, and their application to a model."""

import copy
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import mujoco
import numpy as np
from mujoco import MjData, MjModel

from newton_lint.combined import CONES
from newton_lint.pairs import where
from newton_lint.scene import FREE, Scene
from newton_lint.source import Element

INTEGRATORS = ("Euler", "RK4", "implicit", "implicitfast")
ENUMS = {"cone": CONES, "integrator": INTEGRATORS}
PREFIXES = {"joint": "jnt", "equality": "eq"}
"""The prefix of the model's arrays, unless it is the kind of element itself."""
ARRAYS = {
    ("pair", "condim"): "pair_dim",
    ("joint", "solreflimit"): "jnt_solref",
    ("joint", "armature"): "dof_armature",
    ("joint", "damping"): "dof_damping",
    ("joint", "solimpfriction"): "dof_solimp",
    ("tendon", "solreflimit"): "tendon_solref_lim",
}
"""Arrays whose names do not follow from the kind and the attribute."""
FILED = {
    ("geom", "size"),
    ("geom", "type"),
    ("hfield", "nrow"),
    ("exclude", "body1"),
    ("joint", "range"),
}
"""Attributes that need the file to be compiled again."""


@dataclass(frozen=True)
class Change:
    """New attributes of one element of a file, or of elements of a model."""

    kind: str
    """The kind of element, such as option, exclude or geom."""
    ids: tuple[int, ...]
    """Indices in the compiled model of all elements that the change affects."""
    attributes: tuple[tuple[str, str], ...]
    subject: str
    """The name of the element in messages."""
    element: Element | None = field(default=None, compare=False)
    """The element to change, or None if no file defines it."""

    def __str__(self) -> str:
        return f"{self.text} on {self.subject}"

    @property
    def text(self) -> str:
        """Return the attributes as they are written in the file."""
        attributes = " ".join(f'{name}="{value}"' for name, value in self.attributes)
        tag = "<exclude {}/>" if self.kind == "exclude" else "{}"
        return f"`{tag.format(attributes)}`"

    @property
    def place(self) -> str:
        """Return the file and the line of the element, or an empty string."""
        return f"{self.element.file.name}:{self.element.line}" if self.element else ""


Changes = tuple[Change, ...]
Solref = Callable[[Sequence[float]], str | None]
"""Computes a new solref from the old one, or None to keep it."""


def applied(model: MjModel, changes: Changes) -> MjModel | None:
    """Return a copy of a model with changes, or None if they need the file."""
    if any(
        (change.kind, name) in FILED
        for change in changes
        for name, _ in change.attributes
    ):
        return None
    # Copying a compiled model is faster than compiling its file again.
    model = copy.copy(model)
    for change in changes:
        for name, text in change.attributes:
            if change.kind == "option":
                _set_option(model, name, text)
            else:
                _set(model, change, name, np.array(text.split(), dtype=float))
    # Inertia at the start depends on the armature.
    mujoco.mj_setConst(model, MjData(model))
    return model


def _set_option(model: MjModel, name: str, text: str) -> None:
    value = ENUMS[name].index(text) if name in ENUMS else float(text)
    old = getattr(model.opt, name)
    setattr(model.opt, name, type(old)(value))


def _set(model: MjModel, change: Change, name: str, values: np.ndarray) -> None:
    ids = list(change.ids)
    if change.kind == "actuator" and name in ("kp", "kv"):
        column = 1 + (name == "kv")
        model.actuator_biasprm[ids, column] = -values[0]
        if name == "kp":
            model.actuator_gainprm[ids, 0] = values[0]
        return
    if (change.kind, name) == ("body", "pos"):
        # The initial position of a free body is in qpos0, and not in body_pos.
        moved = np.isin(model.jnt_bodyid, ids) & (model.jnt_type == FREE)
        for address in model.jnt_qposadr[moved]:
            model.qpos0[address : address + 3] = values
    array = ARRAYS.get(
        (change.kind, name), f"{PREFIXES.get(change.kind, change.kind)}_{name}"
    )
    if array.startswith("dof_"):
        ids = where(np.isin(model.dof_jntid, ids))
    target = getattr(model, array)
    if target.ndim == 1:
        target[ids] = values[0]
    else:
        target[np.ix_(ids, range(len(values)))] = values
    if name == "ctrlrange":
        model.actuator_ctrllimited[ids] = 1
    if name in ("contype", "conaffinity"):
        # MuJoCo first compares the masks of bodies.
        whole = getattr(model, f"body_{name}")
        # The tree of the midphase was compiled without the geoms that could not
        # collide.
        model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_MIDPHASE)
        np.bitwise_or.at(whole, model.geom_bodyid[ids], target[ids])


def text_of(values: Iterable[float], digits: int = 4) -> str:
    """Return numbers as they are written in an attribute."""
    return " ".join(f"{value:.{digits}g}" for value in values)


def of_option(scene: Scene, **attributes: str) -> Changes:
    """Return changes of ``<option>``, which is added if the file has none."""
    element = scene.source.option(next(iter(attributes)))
    return (Change("option", (), tuple(attributes.items()), "option", element),)


def elliptic(scene: Scene, impratio: float = 0.0) -> Changes:
    """Return changes to an elliptic cone with an impratio and enough iterations."""
    attributes = {"cone": "elliptic"}
    if impratio:
        attributes["impratio"] = f"{impratio:g}"
    if scene.model.opt.iterations < 10:
        attributes["iterations"] = "10"
    return of_option(scene, **attributes)


def of_element(scene: Scene, kind: str, index: int, **attributes: str) -> Changes:
    """Return changes of one element other than a geom."""
    element = scene.source.find(kind, index)
    name = scene.name(kind, index)
    subject = name if name.startswith(f"{kind}_") else f"{kind} {name}"
    return (Change(kind, (int(index),), tuple(attributes.items()), subject, element),)


def of_geom(scene: Scene, geom: int, attributes: Mapping[str, str]) -> Changes:
    """Return changes of a geom, or of the default that sets the attribute for it.

    Such a change affects all geoms that have the attribute from this default.
    """
    items = tuple(attributes.items())
    source = scene.source
    element = source.find("geom", geom)
    authored = source.authored(geom, items[0][0])
    # Several attributes may come from several defaults, so all are set on the geom.
    # A priority in a default would apply to all of its geoms, so it would not help.
    if authored in (None, element) or len(items) > 1 or "priority" in attributes:
        return (Change("geom", (geom,), items, scene.names[geom], element),)
    ids = tuple(
        other
        for other in source.geoms
        if source.authored(other, items[0][0]) is authored
    )
    subject = f"the default of {scene.names[ids[0]]}"
    return (Change("geom", ids, items, subject, authored),)


def of_contact(scene: Scene, pair: int, solref: Solref, solimp: str = "") -> Changes:
    """Return changes of the solref of a contact, on the geoms that decide it."""
    contacts = scene.contacts
    model = scene.model
    geoms = [contacts.first[pair], contacts.second[pair]]
    more = {"solimp": solimp} if solimp else {}
    if (named := contacts.named[pair]) >= 0:
        new = solref(model.pair_solref[named].tolist())
        first, second = (scene.names[geom] for geom in geoms)
        subject = f"the pair of {first} and {second}"
        items = tuple({"solref": new, **more}.items()) if new else ()
        change = Change("pair", (named,), items, subject, scene.pair_element(pair))
        return (change,) if new else ()
    changes: Changes = ()
    for geom in geoms[:1] if contacts.outranked[pair] else geoms:
        if new := solref(model.geom_solref[geom].tolist()):
            changes += of_geom(scene, geom, {"solref": new, **more})
    return distinct(changes)


def of_contacts(
    scene: Scene, pairs: Iterable[int], solref: Solref, solimp: str = ""
) -> Changes:
    """Return changes of several contacts, each only once if they share geoms."""
    return distinct(
        change for pair in pairs for change in of_contact(scene, pair, solref, solimp)
    )


def of_servo(scene: Scene, servo: int, kp: float, kv: float) -> Changes:
    """Return changes of the gains of a position servo."""
    element = scene.source.find("actuator", servo)
    is_general = element is not None and element.tag == "general"
    if is_general:
        # <general> does not have kp and kv, but has the parameters that they set.
        bias = f"0 {-kp:.4g} {-kv:.4g}"
        return of_element(scene, "actuator", servo, gainprm=f"{kp:.4g}", biasprm=bias)
    more = {"kv": f"{kv:.4g}"} if kv else {}
    return of_element(scene, "actuator", servo, kp=f"{kp:.4g}", **more)


def distinct(changes: Iterable[Change]) -> Changes:
    """Return changes without duplicates, which arise from defaults of several geoms."""
    return tuple(dict.fromkeys(changes))
