"""What to change: the attribute, its value and its place, with what it gains and costs by the law."""

import math
from collections.abc import Mapping

from newton_lint.findings import Advice, Change
from newton_lint.law import clamped
from newton_lint.scene import Scene


def for_geom(scene: Scene, geom: int, attributes: Mapping[str, str], gain: str) -> Advice:
    """Return attributes of a geom, at the tag that says the first of them, or its own where none does."""
    first = next(iter(attributes))
    own = scene.source.geom(geom)
    said = scene.source.authored(geom, first)
    subject = scene.names[geom] if said in (None, own) else f"the default of {scene.names[geom]}"
    return Advice((Change(subject, tuple(attributes.items()), said or own),), gain)


def for_option(scene: Scene, attributes: Mapping[str, str], gain: str) -> Advice:
    """Return attributes of ``<option>``; a scene without one gets it."""
    if not attributes:
        return Advice((), gain)
    element = scene.source.option(next(iter(attributes)))
    return Advice((Change("option", tuple(attributes.items()), element),), gain)


def resolved(*ways: Advice) -> Advice:
    """Return several ways, of which one is enough: the first is what a fix takes."""
    return Advice(ways[0].changes, "; or ".join([ways[0].gain, *map(str, ways[1:])]))


def shorter_step(scene: Scene, timeconst_s: float) -> Advice:
    step = 0.5 * timeconst_s
    more = scene.option.timestep_s / step
    gain = f"the contact is as stiff as it says, for {more:.2g} times the steps"
    return for_option(scene, {"timestep": f"{step:.3g}"}, gain)


def longer_solref(scene: Scene, geom: int, timeconst_s: float) -> Advice:
    ratio = scene.model.geom_solref[geom, 1]
    return for_geom(scene, geom, {"solref": f"{timeconst_s:.3g} {ratio:g}"}, "says what is used, and changes nothing")


def elliptic(scene: Scene, steepest: float) -> Advice:
    """Return an elliptic cone, with an impratio of 10 where none above 1 is said."""
    impratio = scene.option.impratio
    asked = impratio if impratio > 1.0 else 10.0
    less = (1.0 + steepest**2) * asked / impratio
    gain = f"creep under load goes down by {less:.3g} where μ is {steepest:g}"
    return for_option(scene, {"cone": "elliptic", "impratio": f"{asked:g}"}, gain)


def of_higher_priority(scene: Scene, geom: int, mixed_s: float) -> Advice:
    option = scene.option
    says, ratio = scene.model.geom_solref[geom].tolist()
    own = max(says, 2.0 * option.timestep_s if option.refsafe else 0.0)
    attributes = {"priority": str(int(scene.model.geom_priority.max()) + 1)}
    if own > says:
        attributes["solref"] = f"{own:g} {ratio:g}"
    less = f"creep goes down by up to {mixed_s / own:.2g}"
    gain = f"its solref alone counts, and {less}; its friction, condim and solimp as well"
    return for_geom(scene, geom, attributes, gain)


def whole_solref(scene: Scene, geom: int) -> Advice:
    """Return a solref of one form in place of one that mixes both: as stiff as it says, and critically damped."""
    first = float(scene.model.geom_solref[geom, 0])
    solref = f"{first:g} 1" if first > 0.0 else f"{first:g} {-2.0 * math.sqrt(-first):.3g}" if first else "0.02 1"
    return for_geom(scene, geom, {"solref": solref}, "as stiff as it says, and critically damped")


def in_order(scene: Scene, geom: int) -> Advice:
    """Return a solimp with its entries between 0 and 1 and dmax no less than dmin, softer at no depth."""
    dmin, dmax, width, midpoint, power = scene.model.geom_solimp[geom].tolist()
    low, high = (min(max(each, 0.0), 1.0) for each in (dmin, max(dmin, dmax)))
    entries = (low, high, max(width, 0.0), min(max(midpoint, 0.0), 1.0), max(power, 1.0))
    less = (1.0 - clamped(dmax)) / (1.0 - clamped(high))  # R/b of a deep contact has (1 - dmax) / dmax · dmax
    gain = f"creep of a deep contact under load goes down by {less:.3g}" if less > 1.0 else "says what is used"
    return for_geom(scene, geom, {"solimp": " ".join(f"{each:g}" for each in entries)}, gain)
