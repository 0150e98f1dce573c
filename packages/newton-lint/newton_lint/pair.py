"""``newton-lint pair``: what two geoms say of their contact, what it gets, and by which rule of this release."""

from collections.abc import Iterator, Sequence

import numpy as np

from newton_lint.combined import Contacts
from newton_lint.command import CLEAN, FOUND, Parser, add_work, engine_of
from newton_lint.law import M, clamped, response_of, settled_depth_m, stiffness
from newton_lint.output import shown
from newton_lint.report import scene_of
from newton_lint.scene import Scene
from newton_lint.scene_rules import NEW_GAP
from newton_lint.target import TargetError, read_target

WIDTH = 22


def main(arguments: Sequence[str]) -> int:
    made = Parser(prog="newton-lint pair", description="Say what a contact of two geoms gets, and by which rule.")
    made.add_argument("target", metavar="TARGET", help="FILE.xml, or FILE.py:function that returns a model")
    made.add_argument("geoms", metavar="GEOM", nargs=2, help="names of geoms, or of bodies with one geom")
    add_work(made)
    given = made.parse_args(arguments)
    target = read_target(given.target)
    if target.model is None:
        raise TargetError(f"{given.target}: is no model of MuJoCo's")
    scene = scene_of(target, engine_of(given, {}))
    one, other = (_geom(scene, target.name, name) for name in given.geoms)
    contacts = scene.contacts
    found = np.flatnonzero((contacts.first == one) & (contacts.second == other))
    found = np.append(found, np.flatnonzero((contacts.first == other) & (contacts.second == one)))
    lines = _table(scene, contacts, int(found[0]), one, other) if len(found) else [_apart(scene, one, other)]
    print("\n".join(map(shown, lines)))
    return CLEAN if len(found) else FOUND


def _geom(scene: Scene, target: str, name: str) -> int:
    """Return the geom of a name, or the only one of a body of that name."""
    own = [index for index in range(scene.model.ngeom) if name in (scene.model.geom(index).name, scene.names[index])]
    bodies = scene.model.geom_bodyid
    own = own or [index for index in range(scene.model.ngeom) if scene.bodies[bodies[index]] == name]
    if len(own) != 1:
        raise TargetError(
            f"{target}: has {len(own) or 'no'} geom{'s' * (len(own) > 1)} {name}; {', '.join(scene.names[:12])}"
        )
    return own[0]


def _apart(scene: Scene, one: int, other: int) -> str:
    """Say why two geoms never touch."""
    model, weld = scene.model, scene.model.body_weldid[scene.model.geom_bodyid[[one, other]]]
    types, affinities = model.geom_contype[[one, other]], model.geom_conaffinity[[one, other]]
    why = "a body of the one is the parent of the other's, or an <exclude> names their bodies"
    if weld[0] == weld[1]:
        why = "they are fixed to each other"
    elif not (model.body_dofnum[weld] > 0).any():
        why = "neither moves"
    elif not (types[0] & affinities[1] or types[1] & affinities[0]):
        why = f"contype {types.tolist()} and conaffinity {affinities.tolist()} have no bit in common"
    return f"{scene.names[one]} and {scene.names[other]} make no contact: {why}"


def _table(scene: Scene, contacts: Contacts, pair: int, one: int, other: int) -> Iterator[str]:
    model, option, contact = scene.model, scene.option, contacts.contact(pair)
    winner = scene.names[contacts.first[pair]]
    ranked = f"of {winner}, which has the higher priority" if contacts.outranked[pair] else ""
    ranked = "of the <pair> that names them" if contacts.named[pair] >= 0 else ranked
    mixed = f"mixed by solmix, {model.geom_solmix[one]:g} to {model.geom_solmix[other]:g}"
    least = "the smaller of each: one is direct" if contact.solref[0] <= 0.0 else mixed
    sums = "the sum", "the sum; forces act from margin on, and contacts are listed from margin + gap on"
    larger = "the larger", "the larger; forces act from margin − gap on, and contacts are listed from margin on"
    margins, wide = model.geom_margin[[one, other]], model.geom_gap[[one, other]]
    together = np.sum if NEW_GAP else np.max
    rules = sums if NEW_GAP else larger
    rows: list[tuple[str, object, object, object, str]] = [
        ("priority", model.geom_priority[one], model.geom_priority[other], "", ranked),
        ("solref", model.geom_solref[one], model.geom_solref[other], contact.solref, ranked or least),
        ("solimp", model.geom_solimp[one], model.geom_solimp[other], contact.solimp, ranked or mixed),
        *(
            (
                name,
                getattr(model, f"geom_{name}")[one],
                getattr(model, f"geom_{name}")[other],
                used,
                ranked or "the larger",
            )
            for name, used in (("friction", contacts.friction[pair]), ("condim", contact.condim))
        ),
        ("margin", *margins, together(margins), rules[0]),
        ("gap", *wide, together(wide), rules[1]),
    ]
    yield "  ".join([f"{'':8}", *(f"{name:{WIDTH}}" for name in (scene.names[one], scene.names[other], "contact"))])
    for name, *values, rule in rows:
        yield "  ".join([f"{name:8}", *(f"{_said(value):{WIDTH}}" for value in values), rule]).rstrip()
    dmax, response = clamped(contact.solimp[1]), response_of(contact, option)
    ke = stiffness(contact, option, dmax) * dmax**2
    kd = dmax / (response.acceleration_s + 0.5 * option.timestep_s)
    yield f"as Newton's ke and kd: {ke:.4g} and {kd:.4g}, an acceleration for each m and each m/s, and no N/m"
    depth, slide = M * settled_depth_m(contact, option, 1.0), M * response.load_m_s_n
    yield f"1 N on a point presses it {depth:.3g} mm deep; held against 1 N along it, it creeps at {slide:.3g} mm/s"


def _said(value: object) -> str:
    return value if isinstance(value, str) else " ".join(f"{float(each):.4g}" for each in np.atleast_1d(value))
