"""Makes advice: the attributes to change, their values and places, and the effect."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from newton_lint.findings import Advice, Change, distinct
from newton_lint.law import clamped
from newton_lint.scene import Scene

# A damping ratio or timeconst is far from another one at this ratio.
FAR = 4.0
# An elliptic cone needs at least this many solver iterations.
FEW = 10


def for_geom(
    scene: Scene, geom: int, attributes: Mapping[str, str], gain: str
) -> Advice:
    """Return advice to set attributes of a geom, at the tag that sets the first one."""
    element = scene.source.geom(geom)
    authored = scene.source.authored(geom, next(iter(attributes)))
    items = tuple(attributes.items())
    single = Change(scene.names[geom], items, element)
    if authored in (None, element):
        return Advice(gain, (single,))
    # The default is probably the right place. If the change harms another geom of the
    # class, the geom itself is the alternative.
    shared = Change(f"the default of {scene.names[geom]}", items, authored)
    return either(Advice(gain, (shared,)), Advice("", (single,)))


def for_option(scene: Scene, attributes: Mapping[str, str], gain: str) -> Advice:
    """Return advice to set attributes of ``<option>``, which is added if necessary."""
    if not attributes:
        return Advice(gain)
    return Advice(
        gain,
        (
            Change(
                "option",
                tuple(attributes.items()),
                scene.source.option(next(iter(attributes))),
            ),
        ),
    )


def ways_of(advice: Advice | None) -> tuple[Advice, ...]:
    """Return the alternatives of an advice that have changes."""
    return (
        tuple(way for way in (advice, *advice.alternatives) if way.changes)
        if advice
        else ()
    )


def either(first: Advice, *alternatives: Advice) -> Advice:
    return replace(first, alternatives=(*first.alternatives, *alternatives))


def for_contact(
    scene: Scene, pair: int, solref: Callable[[Sequence[float]], str | None], gain: str
) -> Advice:
    """Return advice to set the solref of a contact.

    Args:
        solref: Computes the new solref from the old one, or None to keep it.
    """
    contacts = scene.contacts
    model = scene.model
    first = int(contacts.first[pair])
    second = int(contacts.second[pair])
    if contacts.named[pair] >= 0:
        new = solref(model.pair_solref[contacts.named[pair]])
        subject = f"the pair of {scene.names[first]} and {scene.names[second]}"
        return Advice(
            gain,
            (Change(subject, (("solref", new),), scene.pair_element(pair)),)
            if new
            else (),
        )
    geoms = (first,) if contacts.outranked[pair] else (first, second)
    solrefs = [(geom, solref(model.geom_solref[geom])) for geom in geoms]
    advices = [
        for_geom(scene, geom, {"solref": new}, gain) for geom, new in solrefs if new
    ]
    changes = distinct(change for advice in advices for change in advice.changes)
    singles = tuple(
        change for advice in advices for change in ways_of(advice)[-1].changes
    )
    return either(
        Advice(gain, changes), *([Advice("", singles)] if singles != changes else [])
    )


def longer_solref(
    scene: Scene,
    pair: int,
    timeconst_s: float,
    gain: str = "writes down the value that is used, and changes nothing else",
) -> Advice:
    """Return advice to lengthen shorter timeconsts to a given one."""

    def longer(solref: Sequence[float]) -> str | None:
        return (
            f"{timeconst_s:.6g} {solref[1]:g}"
            if 0.0 < solref[0] < timeconst_s
            else None
        )

    return for_contact(scene, pair, longer, gain)


def softer_solref(scene: Scene, pair: int, dmax: float) -> Advice:
    """Return advice to use a direct solref that the time step can bear."""
    damping = dmax / scene.option.timestep_s

    def softer(solref: Sequence[float]) -> str | None:
        # The minimum of both solrefs counts, so a timeconst never does.
        if solref[0] > 0.0 or solref[1] > 0.0:
            return None
        return (
            f"{-min(-solref[0], 0.25 * damping**2):.4g} {-min(-solref[1], damping):.4g}"
        )

    return for_contact(
        scene, pair, softer, "is the stiffest that the time step permits"
    )


def elliptic(scene: Scene, steepest: float) -> Advice:
    """Return advice to use an elliptic cone, alone or with an impratio of 10."""
    impratio = scene.option.impratio
    iterations = {"iterations": f"{FEW}"} if scene.model.opt.iterations < FEW else {}
    # mj_diagApprox: an edge of a pyramid has (1 + μ²) times the weight.
    candidates = [(iterations, 1.0 + steepest**2)]
    candidates += (
        [({"impratio": "10", **iterations}, 10.0 * (1.0 + steepest**2) / impratio)]
        if impratio <= 1.0
        else []
    )
    gain = (
        "reduces creep under load by a factor of {:.3g} at a friction of {:g}"
        " (predicted)"
    )
    cone = {"cone": "elliptic"}
    return either(
        *(
            for_option(scene, cone | iterations, gain.format(less, steepest))
            for iterations, less in candidates
        )
    )


def rank(scene: Scene) -> dict[str, str]:
    """Return the attribute of a priority above all priorities of the scene."""
    return {"priority": str(int(scene.model.geom_priority.max(initial=0)) + 1)}


def of_higher_priority(scene: Scene, geom: int, mixed_s: np.ndarray) -> Advice:
    """Return advice to give a geom a higher priority than all others.

    Args:
        mixed_s: For each geom, the timeconst that comes out without a priority.
    """
    option = scene.option
    authored, ratio = scene.model.geom_solref[geom].tolist()
    timeconst = max(authored, 2.0 * option.timestep_s if option.refsafe else 0.0)
    attributes = rank(scene)
    # Otherwise the next run would report the clamped timeconst.
    if timeconst > authored:
        attributes["solref"] = f"{timeconst:g} {ratio:g}"
    gain = (
        "makes its solref, friction, condim and solimp count alone, and reduces creep"
        f" by a factor of up to {mixed_s[geom] / timeconst:.2g} (predicted)"
    )
    return for_geom(scene, geom, attributes, gain)


def whole_solref(scene: Scene, pair: int) -> Advice:
    """Return advice to use a solref of one form with critical damping."""

    def sound(solref: Sequence[float]) -> str | None:
        first, second = solref
        if first == 0.0:
            return "0.02 1"
        critical = 1.0 if first > 0.0 else -2.0 * math.sqrt(-first)
        if 0.25 <= second / critical <= FAR:
            return None
        return f"{first:g} {critical:.3g}"

    return for_contact(scene, pair, sound, "keeps the stiffness, with critical damping")


def in_order(scene: Scene, geom: int) -> Advice:
    """Return advice to raise dmax to dmin, so that contacts become stiffer."""
    dmin, dmax, *shape = scene.model.geom_solimp[geom].tolist()
    high = min(max(dmin, dmax), 1.0)
    # R/b of a deep contact contains (1 - dmax) / dmax · dmax.
    less = (1.0 - clamped(dmax)) / (1.0 - clamped(high))
    entries = " ".join(f"{entry:g}" for entry in (min(dmin, 1.0), high, *shape))
    return for_geom(
        scene,
        geom,
        {"solimp": entries},
        f"reduces creep of a deep contact under load by a factor of {less:.3g}"
        " (predicted)",
    )
