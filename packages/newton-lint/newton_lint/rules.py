"""Rules on contact parameters that MuJoCo does not use as they are written.

Each rule is a function over arrays of geoms and pairs.
"""

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

# Parameters that differ by less than this are equal.
SAME = 1e-5
# From this value of b h + k h²/2 on, MuJoCo's time step throws bodies off.
STIFF = 1.9
Advise = Callable[[int], Advice | None]


def lint(scene: Scene) -> list[Finding]:
    """Return the findings of all rules, in the order of the rules."""
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
    # Some rules divide by parts of a solref that may be 0.
    with np.errstate(divide="ignore", invalid="ignore"):
        findings = [
            finding
            for rule in rules
            for hits in rule(scene)
            for finding in findings_of(hits, names)
        ]
    scene_rules = (lost, fixed, visual, closed, pyramid, unread, engine)
    return findings + [finding for rule in scene_rules for finding in rule(scene)]


def solref_format(scene: Scene) -> Iterator[Hits]:
    """Yield solrefs with one positive and one negative number."""
    solref = scene.model.geom_solref
    contacts = scene.contacts
    geoms = np.flatnonzero(
        scene.counts & ((solref[:, 0] > 0.0) != (solref[:, 1] > 0.0))
    )
    # getsolparam replaces such a solref and writes a warning to the log.
    wording = Wording(
        "solref-format",
        "solref[1]",
        "solref of $shapes has only one positive number (the second number is $value),"
        " so the engine uses its default; make both positive or both negative",
        severity="error",
    )

    def advise(geom: int) -> Advice:
        plain = (contacts.named < 0) & (
            (contacts.first == geom) | (contacts.second == geom) & ~contacts.outranked
        )
        return advice.whole_solref(scene, int(np.flatnonzero(plain)[0]))

    yield _geom_hits(scene, wording, geoms, solref[:, 1], DEFAULT_SOLREF[1], advise)


def solimp(scene: Scene) -> Iterator[Hits]:
    """Yield solimps whose dmin, as clamped by getsolparam, is above dmax."""
    dmin, dmax = np.clip(
        scene.model.geom_solimp[:, :2], mujoco.mjMINIMP, mujoco.mjMAXIMP
    ).T
    geoms = np.flatnonzero(scene.counts & (dmin > dmax))
    yield _geom_hits(
        scene,
        Wording(
            "solimp",
            "solimp",
            "solimp of $shapes has a dmin of $value above its dmax of $used, so"
            " contacts get softer with depth and creep grows with the load",
        ),
        geoms,
        dmin,
        dmax,
        partial(advice.in_order, scene),
    )


def timeconst(scene: Scene) -> Iterator[Hits]:
    """Yield timeconsts that the engine clamps, because they are short for the step."""
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
    least = "one time step over the dampratio" if option.discrete else "two time steps"
    wording = Wording(
        "timeconst",
        "timeconst",
        f"timeconst $value of $shapes against $against is below {least}, so the engine"
        " uses $used",
        "s",
    )
    # Nobody wrote a timeconst that equals the default.
    pairs = np.flatnonzero(below & (authored != DEFAULT_SOLREF[0]))

    def advise(pair: int) -> Advice:
        factor = limit[pair] / authored[pair]
        step = f'timestep="{option.timestep_s / factor:.3g}"'
        text = (
            f"Set {step}: this makes the contact as stiff as written, for"
            f" {factor:.2g} times as many steps"
        )
        longer = advice.longer_solref(scene, pair, limit[pair])
        return advice.either(longer, Advice(text)) if factor <= FAR else longer

    yield _pair_hits(scene, wording, pairs, authored, limit, advise)


def too_stiff(scene: Scene) -> Iterator[Hits]:
    """Yield solrefs that are too stiff for the time step and that refsafe permits."""
    contacts = scene.contacts
    step = scene.option.timestep_s
    first, second = contacts.solref.T
    # A contact accelerates by dmax · b and dmax² · k.
    gain = -second * step - 0.5 * first * step**2
    taken = (first <= 0.0) & (second <= 0.0)
    if not scene.option.refsafe:
        is_short = (first > 0.0) & (second > 0.0)
        own = 2.0 * step / first + 0.5 * (step / (first * second)) ** 2
        taken = taken | is_short
        gain = np.where(is_short, own, gain)
    # The integrator discrete is stable with any of them, as both terms are implicit.
    stiff = np.flatnonzero(taken & (gain >= STIFF) & (not scene.option.discrete))
    why = "does not clamp it" if scene.option.refsafe else "is off"
    wording = Wording(
        "stiff",
        "solref",
        "solref $value of $shapes against $against is too stiff for the time step:"
        f" contacts throw bodies off if b·h + k·h²/2 is above {STIFF}; refsafe {why}",
        severity="error",
    )

    def softer(pair: int) -> Advice:
        if first[pair] > 0.0:
            return advice.longer_solref(
                scene, pair, 2.0 * step, "is the stiffest that the time step permits"
            )
        return advice.softer_solref(scene, pair, clamped(contacts.solimp[pair, 1]))

    yield _pair_hits(
        scene, wording, stiff, np.where(first > 0.0, first, second), np.nan, softer
    )


def dampratio(scene: Scene) -> Iterator[Hits]:
    """Yield contacts with a high damping ratio."""
    first, second = scene.contacts.solref.T
    ratio = np.where(first > 0.0, second, -second / (2.0 * np.sqrt(-first)))
    # A solref of both forms is replaced by the default, and has a rule of its own.
    sound = (first > 0.0) == (second > 0.0)
    yield _pair_hits(
        scene,
        Wording(
            "dampratio",
            "dampratio",
            "dampratio $value of $shapes against $against is far above the critical"
            " one, and the contact yields with its square",
        ),
        np.flatnonzero(sound & (ratio > FAR) & np.isfinite(ratio)),
        ratio,
        1.0,
        partial(advice.whole_solref, scene),
    )


def one_sided(scene: Scene) -> Iterator[Hits]:
    """Yield stiff geoms that only meet soft ones, and soft geoms among stiff ones."""
    contacts = scene.contacts
    authored = scene.model.geom_solref[:, 0]
    differ = ~np.isclose(authored[contacts.first], authored[contacts.second], rtol=SAME)
    # Direct solrefs are not mixed: the engine uses the element-wise minimum.
    plain = (contacts.named < 0) & (contacts.solref > 0.0).all(axis=1) & differ
    first = contacts.first[contacts.outranked]
    ranked = np.append(first, contacts.second[contacts.outranked])
    stiffest = -_largest(scene, plain, -contacts.solref[:, 0])
    softest = _largest(scene, plain, contacts.solref[:, 0])
    # A geom with a priority decides on purpose.
    stiffest[ranked] = 0.0
    softest[ranked] = np.inf
    is_stiff = (
        (authored > 0.0) & (authored * FAR <= DEFAULT_SOLREF[0]) & np.isfinite(stiffest)
    )
    softer = stiffest > np.maximum(2.0 * authored, 4.0 * scene.option.timestep_s)
    shape = np.flatnonzero(is_stiff & softer)
    message = (
        "solref $value of $shapes is {} only on this side: each contact mixes it with"
        " the {} solref of the other geom, which gives at {} $used"
    )
    wording = Wording(
        "one-sided", "solref", message.format("stiff", "soft", "least"), "s"
    )
    yield _geom_hits(
        scene,
        wording,
        geoms=shape,
        authored=authored,
        used=stiffest,
        advise=partial(advice.of_higher_priority, scene, mixed_s=stiffest),
    )
    shape = np.flatnonzero(
        (authored >= FAR * DEFAULT_SOLREF[0])
        & (softest > 0.0)
        & (1.5 * softest < authored)
    )
    wording = Wording(
        "one-sided",
        "solref",
        message.format("soft", "stiff", "most"),
        unit="s",
        severity="note",
    )
    advise = partial(
        advice.for_geom,
        scene,
        attributes=advice.rank(scene),
        gain="makes its solref, solimp, friction and condim count alone; or set the"
        " same solref and solimp on the other geom",
    )
    yield _geom_hits(scene, wording, shape, authored, softest, advise)


def friction(scene: Scene) -> Iterator[Hits]:
    """Yield geoms with a low friction that every contact ignores."""
    contacts = scene.contacts
    authored = scene.model.geom_friction[:, 0]
    plain = (contacts.named < 0) & (contacts.condim > 1)
    least = -_largest(scene, plain, -contacts.friction[:, 0])
    # The compiled model does not distinguish a default from the same written number.
    yield _geom_hits(
        scene,
        Wording(
            "friction",
            "friction",
            "friction $value of $shapes counts nowhere because a contact uses the"
            " larger friction of its two geoms, or that of the geom with the higher"
            " priority; here it is at least $used",
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
            gain="makes its friction count alone, with its solref, solimp and condim",
        ),
    )


def _largest(scene: Scene, pairs: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the largest value of each geom among some pairs; -inf without a pair."""
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
    """Return hits of some geoms, located at the tags that set the parameter.

    Args:
        authored: The written value of each geom.
        used: The value that the engine uses for each geom.
    """
    return Hits(
        wording,
        geoms,
        value=authored,
        used=used,
        element=partial(
            scene.source.authored, attribute=wording.parameter.partition("[")[0]
        ),
        advise=advise,
    )


def _pair_hits(
    scene: Scene,
    wording: Wording,
    pairs: np.ndarray,
    authored: np.ndarray,
    used: np.ndarray | float,
    advise: Advise,
) -> Hits:
    """Return hits of some pairs, located at the solref of the stiffer geom."""
    contacts = scene.contacts
    timeconst = scene.model.geom_solref[:, 0]
    swap = (
        timeconst[contacts.second] < timeconst[contacts.first]
    ) & ~contacts.outranked
    shape = np.where(swap, contacts.second, contacts.first)

    def element(pair: int) -> Element | None:
        is_named = contacts.named[pair] >= 0
        return (
            scene.pair_element(pair)
            if is_named
            else scene.source.authored(int(shape[pair]), "solref")
        )

    return Hits(
        wording,
        pairs,
        value=authored,
        used=used,
        shape=shape,
        partner=np.where(swap, contacts.first, contacts.second),
        element=element,
        advise=advise,
    )
