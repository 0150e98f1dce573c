"""What to change: the attribute, its value and its place, with what it gains and costs by the law."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from newton_lint.findings import Advice, Change, distinct
from newton_lint.law import clamped
from newton_lint.scene import Scene

# Times another damping ratio or timeconst from which one is far, and iterations that solve an elliptic cone.
FAR = 4.0
FEW = 10


def for_geom(
    scene: Scene, geom: int, attributes: Mapping[str, str], gain: str
) -> Advice:
    """Return attributes of a geom, at the tag that says the first of them, or its own where none does."""
    element = scene.source.geom(geom)
    authored = scene.source.authored(geom, next(iter(attributes)))
    items = tuple(attributes.items())
    single = Change(scene.names[geom], items, element)
    if authored in (None, element):
        return Advice(gain, (single,))
    # The class is where it was meant to stand. That may harm another geom of the class: then this one alone.
    shared = Change(f"the default of {scene.names[geom]}", items, authored)
    return either(Advice(gain, (shared,)), Advice("", (single,)))


def for_option(scene: Scene, attributes: Mapping[str, str], gain: str) -> Advice:
    """Return attributes of ``<option>``; a scene without one gets it."""
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
    """Return each way of an advice that changes something."""
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
    """Return a solref, made of the old one, for the ``<pair>`` of a contact or for the geoms that count in it."""
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
    gain: str = "says what is used, and changes nothing",
) -> Advice:
    """Return a timeconst for what is authored shorter, by itself the one that is used."""

    def longer(solref: Sequence[float]) -> str | None:
        return (
            f"{timeconst_s:.6g} {solref[1]:g}"
            if 0.0 < solref[0] < timeconst_s
            else None
        )

    return for_contact(scene, pair, longer, gain)


def softer_solref(scene: Scene, pair: int, dmax: float) -> Advice:
    """Return a direct solref that the time step bears: b h is 1, and the damping no more than critical."""
    damping = dmax / scene.option.timestep_s

    def softer(solref: Sequence[float]) -> str | None:
        # Of a pair with one direct solref the minimum of both counts, and a timeconst is above any -stiffness.
        if solref[0] > 0.0 or solref[1] > 0.0:
            return None
        return (
            f"{-min(-solref[0], 0.25 * damping**2):.4g} {-min(-solref[1], damping):.4g}"
        )

    return for_contact(scene, pair, softer, "as stiff as the time step bears")


def elliptic(scene: Scene, steepest: float) -> Advice:
    """Return an elliptic cone, then one with an impratio of 10 where none above 1 is said; with enough iterations."""
    impratio = scene.option.impratio
    more = {"iterations": f"{FEW}"} if scene.model.opt.iterations < FEW else {}
    ways = [
        (more, 1.0 + steepest**2)
    ]  # mj_diagApprox: a pyramid's edge has (1 + μ²) times the weight
    ways += (
        [({"impratio": "10", **more}, 10.0 * (1.0 + steepest**2) / impratio)]
        if impratio <= 1.0
        else []
    )
    gain = "creep under load goes down by {:.3g} where μ is {:g}"
    cone = {"cone": "elliptic"}
    return either(
        *(
            for_option(scene, cone | more, gain.format(less, steepest))
            for more, less in ways
        )
    )


def rank(scene: Scene) -> dict[str, str]:
    """Return a priority that is higher than any."""
    return {"priority": str(int(scene.model.geom_priority.max(initial=0)) + 1)}


def of_higher_priority(scene: Scene, geom: int, mixed_s: float) -> Advice:
    option = scene.option
    authored, ratio = scene.model.geom_solref[geom].tolist()
    timeconst = max(authored, 2.0 * option.timestep_s if option.refsafe else 0.0)
    attributes = rank(scene)
    if (
        timeconst > authored
    ):  # or the next run would find the clamped timeconst in its place
        attributes["solref"] = f"{timeconst:g} {ratio:g}"
    less = f"creep goes down by up to {mixed_s / timeconst:.2g}"
    return for_geom(
        scene,
        geom,
        attributes,
        f"its solref alone counts, and {less}; its friction, condim and solimp as well",
    )


def whole_solref(scene: Scene, pair: int) -> Advice:
    """Return a solref of one form and critically damped, for one that mixes both or is far from it."""

    def sound(solref: Sequence[float]) -> str | None:
        first, second = solref
        ratio = (
            second
            if first > 0.0
            else -second / (2.0 * math.sqrt(-first))
            if first < 0.0
            else 0.0
        )
        if (first > 0.0) == (second > 0.0) and 0.25 <= ratio <= FAR:
            return None
        return (
            f"{first:g} 1"
            if first > 0.0
            else f"{first:g} {-2.0 * math.sqrt(-first):.3g}"
            if first
            else "0.02 1"
        )

    return for_contact(scene, pair, sound, "as stiff as it says, and critically damped")


def in_order(scene: Scene, geom: int) -> Advice:
    """Return a solimp whose dmax is no less than its dmin, softer at no depth."""
    dmin, dmax, *shape = scene.model.geom_solimp[geom].tolist()
    high = min(max(dmin, dmax), 1.0)
    less = (1.0 - clamped(dmax)) / (
        1.0 - clamped(high)
    )  # R/b of a deep contact has (1 - dmax) / dmax · dmax
    entries = " ".join(f"{entry:g}" for entry in (min(dmin, 1.0), high, *shape))
    return for_geom(
        scene,
        geom,
        {"solimp": entries},
        f"creep of a deep contact under load goes down by {less:.3g}",
    )
