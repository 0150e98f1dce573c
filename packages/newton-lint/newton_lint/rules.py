"""The rules: what a scene says and MuJoCo does not do. A function each, over arrays of geoms and pairs."""

from collections.abc import Iterator

import mujoco
import numpy as np

from newton_lint.advice import (
    FAR,
    either,
    for_contact,
    for_geom,
    in_order,
    longer_solref,
    of_higher_priority,
    shorter_step,
    softer_solref,
    whole_solref,
)
from newton_lint.findings import Advice, Finding
from newton_lint.grouping import Hits, findings_of
from newton_lint.law import DEFAULT_SOLREF, M
from newton_lint.scene import Scene
from newton_lint.scene_rules import engine, gap, lost, override, pyramid, unread

SAME = 1e-5
"""Relative difference up to which two parameters are the same."""
STIFF = 1.9
"""b h + k h²/2 of a contact from which MuJoCo's step throws bodies off."""
DEEP_M = 1e-3
"""Depth from which what lies is said to sink in."""
DEFAULT_FRICTION = (1.0, 0.005, 0.0001)
SLIDING, SPINNING, ROLLING = 3, 4, 6
"""Least condim with which a contact resists to each."""


def lint(scene: Scene) -> list[Finding]:
    """Return everything that the rules find, in their order."""
    rules = (solref_format, solimp, timeconst, too_stiff, dampratio, one_sided, friction, depth, unused)
    names = scene.names
    found = [finding for rule in rules for each in rule(scene) for finding in findings_of(each, names)]
    of_the_whole = (lost, pyramid, gap, unread, override, engine)
    return found + [finding for rule in of_the_whole for finding in rule(scene)]


def solref_format(scene: Scene) -> Iterator[Hits]:
    """Yield solrefs that are half timeconst and half damping."""
    own = scene.model.geom_solref
    shape = np.flatnonzero(scene.counts & ((own[:, 0] > 0.0) != (own[:, 1] > 0.0)))
    message = "is half a timeconst and half a damping, where both have to be above 0 or both below: the default is used"
    yield Hits(
        *("solref-format", "solref[1]", shape, None, own[shape, 1], DEFAULT_SOLREF[1], message),
        severity="error",
        element=lambda index: scene.source.authored(int(shape[index]), "solref"),
        advise=lambda index: _whole(scene, int(shape[index])),
    )


def _whole(scene: Scene, geom: int) -> Advice | None:
    contacts = scene.contacts
    plain = (contacts.named < 0) & ((contacts.first == geom) | (contacts.second == geom) & ~contacts.outranked)
    return whole_solref(scene, int(np.flatnonzero(plain)[0])) if plain.any() else None


def solimp(scene: Scene) -> Iterator[Hits]:
    """Yield entries of solimp beyond 0 and 1, or in the wrong order."""
    geoms = np.flatnonzero(scene.counts)
    dmin, dmax, width, midpoint, power = scene.model.geom_solimp[geoms].T
    faults = {
        "solimp[0]": ((dmin < 0.0) | (dmin > 1.0), dmin, np.clip(dmin, 0.0001, 0.9999), "is no share of 0 to 1"),
        "solimp[1]": ((dmax < 0.0) | (dmax > 1.0), dmax, np.clip(dmax, 0.0001, 0.9999), "is no share of 0 to 1"),
        "solimp[2]": (width < 0.0, width, np.maximum(width, 0.0), "is no width"),
        "solimp[3]": ((midpoint < 0.0) | (midpoint > 1.0), midpoint, np.clip(midpoint, 0.0, 1.0), "is no share"),
        "solimp[4]": (power < 1.0, power, np.maximum(power, 1.0), "is below 1, the least power"),
        "solimp": (dmin > dmax, dmin, dmax, "is larger than dmax: the deeper, the softer, and creep grows with load"),
    }
    for name, (wrong, values, used, message) in faults.items():
        shape = geoms[wrong]
        yield Hits(
            *("solimp", name, shape, None, values[wrong], used[wrong], message),
            element=lambda index, shape=shape: scene.source.authored(int(shape[index]), "solimp"),
            advise=lambda index, shape=shape: in_order(scene, int(shape[index])),
        )


def timeconst(scene: Scene) -> Iterator[Hits]:
    """Yield a timeconst below what the engine takes: two steps, or with ``discrete`` one over the dampratio."""
    contacts, option = scene.contacts, scene.option
    if not option.refsafe:
        return
    taken, ratio = contacts.solref.T
    with np.errstate(divide="ignore", invalid="ignore"):
        limit = option.timestep_s / ratio if option.discrete else np.full(len(taken), 2.0 * option.timestep_s)
        below = np.flatnonzero((taken > 0.0) & (ratio > 0.0) & (taken < limit * (1.0 - SAME)))
    shape, other = _stiffer_first(scene, below)
    said = "one step over the dampratio" if option.discrete else "two steps"
    yield Hits(
        *("timeconst", "timeconst", shape, other, taken[below], limit[below]),
        f"is below {said}, which the engine clamps it to",
        unit="s",
        element=lambda index: _says(scene, int(below[index]), int(shape[index]), "solref"),
        advise=lambda index: either(
            longer_solref(scene, int(below[index]), float(limit[below[index]])),
            shorter_step(scene, float(taken[below[index]])),
        ),
    )


def too_stiff(scene: Scene) -> Iterator[Hits]:
    """Yield direct solrefs that are too stiff for the time step; refsafe leaves them alone."""
    contacts, step = scene.contacts, scene.option.timestep_s
    dmax = np.clip(contacts.solimp[:, 1], mujoco.mjMINIMP, mujoco.mjMAXIMP)
    first, second = contacts.solref.T
    far = -second / dmax * step - 0.5 * first / dmax**2 * step**2
    there = np.flatnonzero((first <= 0.0) & (second <= 0.0) & (far >= STIFF) & (not scene.option.discrete))
    shape, other = _stiffer_first(scene, there)
    message = f"is too stiff for the time step: b·h + k·h²/2 from {STIFF} on throws bodies off; refsafe leaves it alone"
    yield Hits(
        *("stiff", "solref[1]", shape, other, second[there], np.nan, message),
        severity="error",
        element=lambda index: _says(scene, int(there[index]), int(shape[index]), "solref"),
        advise=lambda index: softer_solref(scene, int(there[index]), float(dmax[there[index]])),
    )


def dampratio(scene: Scene) -> Iterator[Hits]:
    """Yield a contact that yields as the square of its damping ratio, or, as may be meant, one that bounces."""
    contacts = scene.contacts
    first, second = contacts.solref.T
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(first > 0.0, second, -second / (2.0 * np.sqrt(-first)))
    sound = (first > 0.0) == (second > 0.0)
    message = "is far above 1: the contact yields by its square"
    for far, severity, said in (
        (sound & (ratio > FAR) & np.isfinite(ratio), "warning", message),
        (sound & (ratio < 1.0 / FAR), "note", "is far below 1: the contact bounces"),
    ):
        there = np.flatnonzero(far)
        shape, other = _stiffer_first(scene, there)
        yield Hits(
            *("dampratio", "dampratio", shape, other, ratio[there], 1.0, said),
            severity=severity,
            element=lambda index, there=there, shape=shape: _says(
                scene, int(there[index]), int(shape[index]), "solref"
            ),
            advise=lambda index, there=there: whole_solref(scene, int(there[index])),
        )


def one_sided(scene: Scene) -> Iterator[Hits]:
    """Yield stiff geoms that meet only soft ones: solmix makes their contacts about half as soft."""
    contacts, own = scene.contacts, scene.model.geom_solref[:, 0]
    differ = ~np.isclose(own[contacts.first], own[contacts.second], rtol=SAME)
    plain = (contacts.named < 0) & (contacts.solref > 0.0).all(axis=1) & differ
    stiffest = np.full(len(own), np.inf)
    for side in (contacts.first, contacts.second):
        np.minimum.at(stiffest, side[plain], contacts.solref[plain, 0])
        stiffest[side[contacts.outranked]] = 0.0
    alone = (own > 0.0) & (own * FAR <= DEFAULT_SOLREF[0]) & np.isfinite(stiffest)
    shape = np.flatnonzero(alone & (stiffest > np.maximum(2.0 * own, 4.0 * scene.option.timestep_s)))
    message = "is stiff on this side only: the other geom's soft solref is mixed in, in every pair"
    yield Hits(
        *("one-sided", "solref", shape, None, own[shape], stiffest[shape], message),
        unit="s",
        element=lambda index: scene.source.authored(int(shape[index]), "solref"),
        advise=lambda index: of_higher_priority(scene, int(shape[index]), stiffest[shape[index]]),
    )


def friction(scene: Scene) -> Iterator[Hits]:
    """Yield geoms whose low friction counts nowhere: the larger of two is taken."""
    contacts, own = scene.contacts, scene.model.geom_friction[:, 0]
    plain = (contacts.named < 0) & (contacts.condim > 1)
    least = np.full(len(own), np.inf)
    for side in (contacts.first, contacts.second):
        np.minimum.at(least, side[plain], contacts.friction[plain, 0])
    shape = np.flatnonzero((own * FAR <= least) & np.isfinite(least) & (own != DEFAULT_FRICTION[0]))
    rank = {"priority": str(int(scene.model.geom_priority.max(initial=0)) + 1)}
    yield Hits(
        *("friction", "friction", shape, None, own[shape], least[shape]),
        "counts nowhere: of two geoms the larger friction is taken, or that of the geom of higher priority",
        element=lambda index: scene.source.authored(int(shape[index]), "friction"),
        advise=lambda index: for_geom(
            scene, int(shape[index]), rank, "its friction alone counts, with its solref, solimp and condim"
        ),
    )


def depth(scene: Scene) -> Iterator[Hits]:
    """Yield bodies that their own weight presses far into what they lie on: by (1 - dmax) g (timeconst dampratio)²."""
    contacts, model, option = scene.contacts, scene.model, scene.option
    own = np.where(scene.free[model.geom_bodyid[contacts.first]], contacts.first, contacts.second)
    other, body = contacts.first + contacts.second - own, model.body_weldid[model.geom_bodyid[own]]
    first, second = contacts.solref.T
    lies = scene.free[body] & ~scene.free[model.geom_bodyid[other]] & (first * second > 0.0)
    lies &= np.isclose(model.body_subtreemass[body], model.body_mass[body])
    is_clamped = option.refsafe and not option.discrete
    timeconst = np.maximum(first, 2.0 * option.timestep_s) if is_clamped else first
    with np.errstate(divide="ignore"):
        inverse_k = np.where(first > 0.0, (timeconst * second) ** 2, -1.0 / first)
    soft = (1.0 - np.clip(contacts.solimp[:, 1], 0.0, 1.0)) * inverse_k
    mu, rows = contacts.friction[:, 0], np.maximum(contacts.condim - 1, 1)
    is_pyramid = (option.cone == "pyramidal") & (contacts.condim > 1)
    steep = np.where(is_pyramid, (1.0 + mu**2) * mu**2 / option.impratio / rows, 1.0)
    deep_m = float(np.linalg.norm(model.opt.gravity)) * soft * steep / scene.point_counts[own]
    there = np.flatnonzero(lies & (deep_m > DEEP_M))

    def shallower(pair: int) -> Advice:
        share = DEEP_M / deep_m[pair]
        less = max(timeconst[pair] * share**0.5, 2.0 * option.timestep_s)
        new = f"{first[pair] / share:.4g} {second[pair] / share**0.5:.3g}" if first[pair] < 0.0 else ""
        said = f"{M * deep_m[pair]:.3g} → {M * DEEP_M:.3g} mm: depth goes by the square of the timeconst"
        return for_contact(scene, pair, lambda solref: new or f"{less:.3g} {solref[1]:g}", said)

    yield Hits(
        *("depth", "depth", own[there], other[there], M * deep_m[there], np.nan),
        "is how deep its weight presses it in, whatever its mass: stiffness grows with mass; solref and solimp decide",
        unit="mm",
        severity="note",
        element=lambda index: _says(scene, int(there[index]), int(other[there[index]]), "solref"),
        advise=lambda index: shallower(int(there[index])),
    )


def unused(scene: Scene) -> Iterator[Hits]:
    """Yield friction of a kind for which a geom's contacts have no rows."""
    contacts, model = scene.contacts, scene.model
    largest = np.zeros(model.ngeom, dtype=int)
    plain = contacts.named < 0
    np.maximum.at(largest, contacts.first[plain], contacts.condim[plain])
    both = plain & ~contacts.outranked
    np.maximum.at(largest, contacts.second[both], contacts.condim[both])
    for column, least, kind in ((0, SLIDING, "sliding"), (1, SPINNING, "spinning"), (2, ROLLING, "rolling")):
        values = model.geom_friction[:, column]
        authored = ~np.isclose(values, DEFAULT_FRICTION[column], rtol=SAME) & (values != 0.0)
        shape = np.flatnonzero((largest > 0) & (largest < least) & authored)
        yield Hits(
            *("unused", f"friction[{column}]", shape, None, values[shape], np.nan),
            f"against {kind} has no rows in its contacts: their condim is below {least}",
            severity="note",
            element=lambda index, shape=shape: scene.source.authored(int(shape[index]), "friction"),
            advise=lambda index, shape=shape, least=least, kind=kind: for_geom(
                scene, int(shape[index]), {"condim": str(least)}, f"its contacts resist {kind}"
            ),
        )


def _stiffer_first(scene: Scene, pairs: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    contacts, own = scene.contacts, scene.model.geom_solref[:, 0]
    first, second = contacts.first[pairs], contacts.second[pairs]
    swap = (own[second] < own[first]) & ~contacts.outranked[pairs]
    return np.where(swap, second, first), np.where(swap, first, second)


def _says(scene: Scene, pair: int, geom: int, attribute: str):
    contacts, model = scene.contacts, scene.model
    if contacts.named[pair] >= 0:
        return scene.source.pair(*(model.geom(int(each[pair])).name for each in (contacts.first, contacts.second)))
    return scene.source.authored(geom, attribute)
