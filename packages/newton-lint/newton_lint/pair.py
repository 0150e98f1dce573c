"""``newton-lint pair``: what two geoms say of their contact, what it gets, and by which rule of this release."""

from collections.abc import Iterator, Sequence
from typing import Any

import mujoco
import numpy as np

from newton_lint.combined import Contacts
from newton_lint.command import CLEAN, FOUND, Parser, add_work, engine_of
from newton_lint.law import (
    M,
    clamped,
    normal_damping,
    response_of,
    settled_depth_m,
    stiffness,
)
from newton_lint.output import printable
from newton_lint.report import scene_of
from newton_lint.scene import Scene
from newton_lint.target import TargetError, newtons, read_target

WIDTH = 22
NEW_GAP = tuple(map(int, mujoco.__version__.split(".")[:2])) >= (3, 9)
"""Whether this release presses from margin on, and not from margin − gap on."""


def main(arguments: Sequence[str]) -> int:
    parser = Parser(
        prog="newton-lint pair",
        description="Say what a contact of two geoms gets, and by which rule.",
    )
    parser.add_argument(
        "target",
        metavar="TARGET",
        help="FILE.xml, or FILE.py:function that returns a model",
    )
    parser.add_argument(
        "geoms",
        metavar="GEOM",
        nargs=2,
        help="names of geoms, or of bodies with one geom",
    )
    add_work(parser)
    options = parser.parse_args(arguments)
    target = read_target(options.target)
    engine = engine_of(options, {})
    if target.newton_model is None:
        scene = scene_of(target, engine)
    else:
        scene = newtons(
            target.name,
            "newton_lint.newton_models.rules",
            "Shapes.of",
            target.newton_model,
            engine,
        )
    geoms = [_geom(scene, target.name, name) for name in options.geoms]
    pairs = np.flatnonzero(
        np.isin(scene.contacts.first, geoms) & np.isin(scene.contacts.second, geoms)
    )
    if not len(pairs):
        print(
            printable(
                f"{' and '.join(options.geoms)} make no contact: {_separation(scene, geoms)}"
            )
        )
        return FOUND
    print(
        "\n".join(map(printable, _table(scene, scene.contacts, int(pairs[0]), *geoms)))
    )
    return CLEAN


def _geom(scene: Scene, target: str, name: str) -> int:
    """Return the geom of a name, or the only one of a body of that name."""
    model = scene.model
    geoms = [
        geom
        for geom, full_name in enumerate(scene.names)
        if name in (full_name, model.geom(geom).name)
    ]
    geoms = geoms or [
        geom
        for geom, body in enumerate(model.geom_bodyid)
        if scene.bodies[body] == name
    ]
    if len(geoms) != 1:
        raise TargetError(
            f"{target}: {len(geoms) or 'no'} geoms are {name}; it has {', '.join(scene.names[:12])}"
        )
    return geoms[0]


def _separation(scene: Scene, geoms: Sequence[int]) -> str:
    """Say why two geoms never touch: the filters of mj_collision, in its order."""
    model = scene.model
    weld = scene.model.body_weldid[scene.model.geom_bodyid[geoms]]
    types = model.geom_contype[geoms]
    affinities = model.geom_conaffinity[geoms]
    if weld[0] == weld[1] or not (model.body_dofnum[weld] > 0).any():
        return "they do not move against each other"
    if not (types[0] & affinities[1] or types[1] & affinities[0]):
        return f"contype {types.tolist()} and conaffinity {affinities.tolist()} have no bit in common"
    return "contacts are off, one hangs on the other's body, or an <exclude> names their bodies"


def _table(
    scene: Scene, contacts: Contacts, pair: int, geom1: int, geom2: int
) -> Iterator[str]:
    model = scene.model
    option = scene.option
    contact = contacts.contact(pair)
    winner = scene.names[contacts.first[pair]]
    ranked = (
        f"of {winner}, which has the higher priority"
        if contacts.outranked[pair]
        else ""
    )
    ranked = "of the <pair> that names them" if contacts.named[pair] >= 0 else ranked
    mixed = (
        f"mixed by solmix, {model.geom_solmix[geom1]:g} to {model.geom_solmix[geom2]:g}"
    )
    # mj_contactParam: a mean of a timeconst and a stiffness would be neither.
    least = "the smaller of each: one is direct" if contact.solref[0] <= 0.0 else mixed
    sums = (
        "the sum",
        "the sum; forces act from margin on, and contacts are listed from margin + gap on",
    )
    larger = (
        "the larger",
        "the larger; forces act from margin − gap on, and contacts are listed from margin on",
    )
    together, rules = (np.sum, sums) if NEW_GAP else (np.max, larger)

    def row(name: str, used: object, rule: str) -> tuple[object, ...]:
        values = getattr(model, f"geom_{name}")
        return name, values[geom1], values[geom2], used, rule

    rows = [
        row("priority", "", ranked),
        row("solref", contact.solref, ranked or least),
        row("solimp", contact.solimp, ranked or mixed),
        row("friction", contacts.friction[pair], ranked or "the larger"),
        row("condim", contact.condim, ranked or "the larger"),
        row("margin", together(model.geom_margin[[geom1, geom2]]), rules[0]),
        row("gap", together(model.geom_gap[[geom1, geom2]]), rules[1]),
    ]
    yield "  ".join(
        [
            f"{'':8}",
            *(
                f"{name:{WIDTH}}"
                for name in (scene.names[geom1], scene.names[geom2], "contact")
            ),
        ]
    )
    for name, *values, rule in rows:
        yield "  ".join(
            [
                f"{name:8}",
                *(f"{_formatted(value):{WIDTH}}" for value in values),
                str(rule),
            ]
        ).rstrip()
    dmax = clamped(contact.solimp[1])
    ke = stiffness(contact, option, dmax) * dmax**2
    kd = normal_damping(contact, option, dmax) * dmax
    yield f"as Newton's ke and kd: {ke:.4g} and {kd:.4g}, an acceleration for each m and each m/s, and no N/m"
    depth = M * settled_depth_m(contact, option, 1.0)
    slide = M * response_of(contact, option).load_m_s_n
    yield f"1 N on a point presses it {depth:.3g} mm deep; held against 1 N along it, it creeps at {slide:.3g} mm/s"


def _formatted(value: Any) -> str:
    return (
        value
        if isinstance(value, str)
        else " ".join(f"{float(number):.4g}" for number in np.atleast_1d(value))
    )
