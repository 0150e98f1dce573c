"""The rules: what a scene says and MuJoCo does not do. A function each, over arrays of geoms and pairs."""

from collections.abc import Callable, Iterator
from functools import partial

import mujoco
import numpy as np

from newton_lint import advice
from newton_lint.advice import FAR
from newton_lint.findings import Advice, Finding, Hits, Wording, findings_of
from newton_lint.law import DEFAULT_SOLREF, clamped
from newton_lint.scene import Scene
from newton_lint.scene_rules import closed, engine, fixed, lost, pyramid, unread, visual
from newton_lint.source import Element

# Difference up to which parameters are the same, and b h + k h²/2 from which MuJoCo's step throws bodies off.
SAME = 1e-5
STIFF = 1.9
Advise = Callable[[int], Advice | None]


def lint(scene: Scene) -> list[Finding]:
    """Return everything that the rules find, in their order."""
    rules = (
        solref_format,
        solimp,
        timeconst,
        too_stiff,
        dampratio,
        one_sided,
        friction,
    )
    names = scene.names
    with np.errstate(
        divide="ignore", invalid="ignore"
    ):  # some divide by parts of a solref that may be 0
        findings = [
            finding
            for rule in rules
            for hits in rule(scene)
            for finding in findings_of(hits, names)
        ]
    scene_rules = (lost, fixed, visual, closed, pyramid, unread, engine)
    return findings + [finding for rule in scene_rules for finding in rule(scene)]


def solref_format(scene: Scene) -> Iterator[Hits]:
    """Yield solrefs that are half timeconst and half damping."""
    solref = scene.model.geom_solref
    contacts = scene.contacts
    geoms = np.flatnonzero(
        scene.counts & ((solref[:, 0] > 0.0) != (solref[:, 1] > 0.0))
    )
    wording = Wording(
        "solref-format",
        "solref[1]",
        "is half a timeconst and half a damping, where both have to be above 0 or both below: the default is used",
        severity="error",
    )  # getsolparam, with a warning in the log

    def advise(geom: int) -> Advice | None:
        plain = (contacts.named < 0) & (
            (contacts.first == geom) | (contacts.second == geom) & ~contacts.outranked
        )
        return (
            advice.whole_solref(scene, int(np.flatnonzero(plain)[0]))
            if plain.any()
            else None
        )

    yield _geom_hits(scene, wording, geoms, solref[:, 1], DEFAULT_SOLREF[1], advise)


def solimp(scene: Scene) -> Iterator[Hits]:
    """Yield a dmin above dmax, as getsolparam takes both."""
    dmin, dmax = np.clip(
        scene.model.geom_solimp[:, :2], mujoco.mjMINIMP, mujoco.mjMAXIMP
    ).T
    geoms = np.flatnonzero(scene.counts & (dmin > dmax))
    yield _geom_hits(
        scene,
        Wording(
            "solimp",
            "solimp",
            "is larger than dmax: the deeper, the softer, and creep grows with load",
        ),
        geoms,
        dmin,
        dmax,
        partial(advice.in_order, scene),
    )


def timeconst(scene: Scene) -> Iterator[Hits]:
    """Yield a timeconst below what the engine takes: two steps, or with ``discrete`` one over the dampratio."""
    contacts = scene.contacts
    option = scene.option
    if not option.refsafe:
        return
    authored, ratio = contacts.solref.T
    limit = (
        option.timestep_s / ratio
        if option.discrete
        else np.full(len(authored), 2.0 * option.timestep_s)
    )
    below = (authored > 0.0) & (ratio > 0.0) & (authored < limit * (1.0 - SAME))
    least = "one step over the dampratio" if option.discrete else "two steps"
    wording = Wording(
        "timeconst",
        "timeconst",
        f"is below {least}, which the engine clamps it to",
        "s",
    )
    pairs = np.flatnonzero(
        below & (authored != DEFAULT_SOLREF[0])
    )  # which nobody wrote

    def advise(pair: int) -> Advice:
        more = limit[pair] / authored[pair]
        step = f'timestep="{option.timestep_s / more:.3g}"'
        text = f"{step}: the contact is as stiff as it says, for {more:.2g} times the steps"
        longer = advice.longer_solref(scene, pair, limit[pair])
        return advice.either(longer, Advice(text)) if more <= FAR else longer

    yield _pair_hits(scene, wording, pairs, authored, limit, advise)


def too_stiff(scene: Scene) -> Iterator[Hits]:
    """Yield direct solrefs that are too stiff for the time step; refsafe leaves them alone."""
    contacts = scene.contacts
    step = scene.option.timestep_s
    first, second = contacts.solref.T
    gain = (
        -second * step - 0.5 * first * step**2
    )  # a contact accelerates by dmax · b and dmax² · k
    taken = (first <= 0.0) & (second <= 0.0)
    if not scene.option.refsafe:
        is_short = (first > 0.0) & (second > 0.0)
        own = 2.0 * step / first + 0.5 * (step / (first * second)) ** 2
        taken = taken | is_short
        gain = np.where(is_short, own, gain)
    # The integrator discrete takes both terms implicitly, and bears any.
    stiff = np.flatnonzero(taken & (gain >= STIFF) & (not scene.option.discrete))
    why = "leaves it alone" if scene.option.refsafe else "is off"
    wording = Wording(
        "stiff",
        "solref",
        f"is too stiff for the time step: b·h + k·h²/2 from {STIFF} on throws bodies off; refsafe {why}",
        severity="error",
    )

    def softer(pair: int) -> Advice:
        if first[pair] > 0.0:
            return advice.longer_solref(
                scene, pair, 2.0 * step, "as stiff as the time step bears"
            )
        return advice.softer_solref(scene, pair, clamped(contacts.solimp[pair, 1]))

    yield _pair_hits(
        scene, wording, stiff, np.where(first > 0.0, first, second), np.nan, softer
    )


def dampratio(scene: Scene) -> Iterator[Hits]:
    """Yield a contact that yields as the square of its damping ratio."""
    first, second = scene.contacts.solref.T
    ratio = np.where(first > 0.0, second, -second / (2.0 * np.sqrt(-first)))
    sound = (first > 0.0) == (
        second > 0.0
    )  # a mixed one is replaced, which solref-format says
    yield _pair_hits(
        scene,
        Wording(
            "dampratio", "dampratio", "is far above 1: the contact yields by its square"
        ),
        np.flatnonzero(sound & (ratio > FAR) & np.isfinite(ratio)),
        ratio,
        1.0,
        partial(advice.whole_solref, scene),
    )


def one_sided(scene: Scene) -> Iterator[Hits]:
    """Yield stiff geoms that meet only soft ones: solmix makes their contacts about half as soft."""
    contacts = scene.contacts
    authored = scene.model.geom_solref[:, 0]
    differ = ~np.isclose(authored[contacts.first], authored[contacts.second], rtol=SAME)
    # Direct solrefs are not mixed: the element-wise minimum counts.
    plain = (contacts.named < 0) & (contacts.solref > 0.0).all(axis=1) & differ
    ranked = np.concatenate([contacts.first, contacts.second])[
        np.tile(contacts.outranked, 2)
    ]
    stiffest = -_largest(scene, plain, -contacts.solref[:, 0])
    softest = _largest(scene, plain, contacts.solref[:, 0])
    # a priority was given: it is meant so
    stiffest[ranked] = 0.0
    softest[ranked] = np.inf
    is_stiff = (
        (authored > 0.0) & (authored * FAR <= DEFAULT_SOLREF[0]) & np.isfinite(stiffest)
    )
    softer = stiffest > np.maximum(2.0 * authored, 4.0 * scene.option.timestep_s)
    shape = np.flatnonzero(is_stiff & softer)
    message = (
        "is {} on this side only: the other geom's {} solref is mixed in, in every pair"
    )
    wording = Wording("one-sided", "solref", message.format("stiff", "soft"), "s")
    yield _geom_hits(
        scene,
        wording,
        shape,
        authored,
        stiffest,
        lambda geom: advice.of_higher_priority(scene, geom, stiffest[geom]),
    )
    shape = np.flatnonzero(
        (authored >= FAR * DEFAULT_SOLREF[0])
        & (softest > 0.0)
        & (1.5 * softest < authored)
    )
    wording = Wording(
        "one-sided", "solref", message.format("soft", "stiff"), "s", "note"
    )
    advise = partial(
        advice.for_geom,
        scene,
        attributes=advice.rank(scene),
        gain="its solref, solimp, friction and condim alone count; or the same solref and solimp on the other geom",
    )
    yield _geom_hits(scene, wording, shape, authored, softest, advise)


def friction(scene: Scene) -> Iterator[Hits]:
    """Yield geoms whose low friction counts nowhere: the larger of two is taken."""
    contacts = scene.contacts
    authored = scene.model.geom_friction[:, 0]
    plain = (contacts.named < 0) & (contacts.condim > 1)
    least = -_largest(scene, plain, -contacts.friction[:, 0])
    # The compiled model does not tell a default from the same number that somebody wrote.
    yield _geom_hits(
        scene,
        Wording(
            "friction",
            "friction",
            "counts nowhere: of two geoms the larger friction is taken, or that of the geom of higher priority",
        ),
        np.flatnonzero(
            (authored * FAR <= least) & np.isfinite(least) & (authored != 1.0)
        ),
        authored,
        least,
        partial(
            advice.for_geom,
            scene,
            attributes=advice.rank(scene),
            gain="its friction alone counts, with its solref, solimp and condim",
        ),
    )


def _largest(scene: Scene, pairs: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the largest value that each geom has in some of the pairs; -inf of what is in none."""
    largest = np.full(scene.model.ngeom, -np.inf)
    for geoms in (scene.contacts.first, scene.contacts.second):
        np.maximum.at(largest, geoms[pairs], values[pairs])
    return largest


def _geom_hits(
    scene: Scene,
    wording: Wording,
    geoms: np.ndarray,
    authored: np.ndarray,
    used: np.ndarray | float,
    advise: Advise,
) -> Hits:
    """Return hits of some geoms, with values of all as authored and as used, at the tag that says the parameter."""
    used = np.broadcast_to(used, authored.shape)
    return Hits(
        wording,
        geoms,
        authored[geoms],
        used[geoms],
        None,
        geoms,
        partial(scene.source.authored, attribute=wording.parameter.partition("[")[0]),
        advise,
    )


def _pair_hits(
    scene: Scene,
    wording: Wording,
    pairs: np.ndarray,
    authored: np.ndarray,
    used: np.ndarray | float,
    advise: Advise,
) -> Hits:
    """Return hits of some pairs, with values of all, at the tag with the solref of the stiffer geom."""
    contacts = scene.contacts
    timeconst = scene.model.geom_solref[:, 0]
    swap = (
        timeconst[contacts.second] < timeconst[contacts.first]
    ) & ~contacts.outranked
    shape = np.where(swap, contacts.second, contacts.first)
    partner = np.where(swap, contacts.first, contacts.second)
    used = np.broadcast_to(used, authored.shape)

    def element(pair: int) -> Element | None:
        is_named = contacts.named[pair] >= 0
        return (
            scene.pair_element(pair)
            if is_named
            else scene.source.authored(int(shape[pair]), "solref")
        )

    return Hits(
        wording,
        shape[pairs],
        authored[pairs],
        used[pairs],
        partner[pairs],
        pairs,
        element,
        advise,
    )
