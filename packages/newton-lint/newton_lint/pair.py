"""Implements ``newton-lint pair``: prints the contact parameters of two geoms."""

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
"""Whether forces act from margin on; before MuJoCo 3.9 it was margin − gap."""


def main(arguments: Sequence[str]) -> int:
    parser = Parser(
        prog="newton-lint pair",
        description="Explain which parameters the contact of two geoms gets, and why.",
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
        help="name of a geom, or of a body with a single geom",
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
                f"{' and '.join(options.geoms)} make no contact because"
                f" {_separation(scene, geoms)}"
            )
        )
        return FOUND
    print(
        "\n".join(map(printable, _table(scene, scene.contacts, int(pairs[0]), *geoms)))
    )
    return CLEAN


def _geom(scene: Scene, target: str, name: str) -> int:
    """Return the geom with a name, or the single geom of the body with that name."""
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
            f"{target}: {len(geoms) or 'no'} geoms are called {name}; the scene has"
            f" {', '.join(scene.names[:12])}"
        )
    return geoms[0]


def _separation(scene: Scene, geoms: Sequence[int]) -> str:
    """Return why two geoms never touch, by the filters of mj_collision in order."""
    model = scene.model
    weld = model.body_weldid[model.geom_bodyid[geoms]]
    types = model.geom_contype[geoms]
    affinities = model.geom_conaffinity[geoms]
    if weld[0] == weld[1] or not (model.body_dofnum[weld] > 0).any():
        return "their bodies cannot move relative to each other"
    if not (types[0] & affinities[1] or types[1] & affinities[0]):
        return f"contype {types} and conaffinity {affinities} have no bit in common"
    return (
        "contacts are disabled, one body is the parent of the other, or an <exclude>"
        " names them"
    )


def _table(
    scene: Scene, contacts: Contacts, pair: int, geom1: int, geom2: int
) -> Iterator[str]:
    model = scene.model
    option = scene.option
    contact = contacts.contact(pair)
    ranked = ""
    if contacts.named[pair] >= 0:
        ranked = "from the <pair> that names them"
    elif contacts.outranked[pair]:
        winner = scene.names[contacts.first[pair]]
        ranked = f"from {winner}, which has the higher priority"
    mixed = (
        f"mixed by solmix, {model.geom_solmix[geom1]:g} to {model.geom_solmix[geom2]:g}"
    )
    # mj_contactParam does not mix a timeconst with a stiffness.
    least = (
        "the minimum of each number, because one solref is direct"
        if contact.solref[0] <= 0.0
        else mixed
    )
    combined = np.max
    margin = "the larger"
    gap = (
        "the larger; a contact bears force below margin − gap and is listed below"
        " margin"
    )
    if NEW_GAP:
        combined = np.sum
        margin = "the sum"
        gap = (
            "the sum; a contact bears force below margin and is listed below"
            " margin + gap"
        )

    def row(name: str, used: object, rule: str) -> tuple[object, ...]:
        values = getattr(model, f"geom_{name}")
        return name, values[geom1], values[geom2], used, rule

    rows = [
        ("", scene.names[geom1], scene.names[geom2], "contact", ""),
        row("priority", "", ranked),
        row("solref", contact.solref, ranked or least),
        row("solimp", contact.solimp, ranked or mixed),
        row("friction", contacts.friction[pair], ranked or "the larger"),
        row("condim", contact.condim, ranked or "the larger"),
        row("margin", combined(model.geom_margin[[geom1, geom2]]), margin),
        row("gap", combined(model.geom_gap[[geom1, geom2]]), gap),
    ]

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
    yield (
        f"as Newton's ke and kd: {ke:.4g} and {kd:.4g}, which are accelerations per m"
        " and per m/s, not forces"
    )
    depth = M * settled_depth_m(contact, option, 1.0)
    slide = M * response_of(contact, option).load_m_s_n
    yield (
        f"a normal force of 1 N presses one point {depth:.3g} mm deep; with a"
        f" tangential load of 1 N, it creeps at {slide:.3g} mm/s"
    )


def _formatted(value: Any) -> str:
    return (
        value
        if isinstance(value, str)
        else " ".join(f"{float(number):.4g}" for number in np.atleast_1d(value))
    )
