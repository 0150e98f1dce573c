"""Rules on contact parameters that MuJoCo does not use as they are written.

Each rule is a function over arrays of geoms and pairs.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial

import mujoco
import numpy as np

from newton_lint.changes import (
    Changes,
    distinct,
    of_contact,
    of_geom,
    text_of,
)
from newton_lint.findings import Finding, Hits, Remedy, findings_of
from newton_lint.law import DEFAULT_SOLREF, clamped
from newton_lint.ledger import Run
from newton_lint.pairs import keys_of
from newton_lint.scene import Scene
from newton_lint.scene_rules import damped, engine, lost, pyramid
from newton_lint.trials import Trials

# Parameters that differ by less than this are equal.
SAME = 1e-5
# If b h + k h²/2 is at least this, MuJoCo's time step throws bodies off.
STIFF = 1.9
FAR = 4.0
"""Two timeconsts or friction coefficients are far apart at this ratio."""
Advise = Callable[[int], Remedy]


def lint(trials: Trials) -> list[Finding]:
    """Return the findings of all rules, in the order of the rules.

    A change is recommended if it does no harm within 2 s from all starts.
    """
    scene = trials.scene
    groups = list(faults(scene, trials.runs))
    groups += [([finding], remedy) for finding, remedy in engine(scene)]
    return [
        finding for group, remedy in groups for finding in trials.advised(group, remedy)
    ]


def faults(scene: Scene, runs: Sequence[Run]) -> Iterator[tuple[list[Finding], Remedy]]:
    """Yield groups of findings on the parameters of a scene, with their remedies."""
    near = scene
    if runs and not any(run.bad for run in runs):
        pairs = [pair for run in runs for pair in run.pairs]
        keys = keys_of(np.array(pairs, dtype=int).reshape(-1, 2))
        near = replace(scene, touching=keys)
    # Errors count for all pairs, the other rules only for those that touch.
    rules = (
        (solref_format, scene),
        (too_stiff, scene),
        (solimp, near),
        (timeconst, near),
        (one_sided, near),
        (friction, near),
    )
    # Some rules divide by parts of a solref that may be 0.
    with np.errstate(divide="ignore", invalid="ignore"):
        for rule, part in rules:
            for hits in rule(part):
                yield from findings_of(hits, scene.names)
    for scene_rule in (lost, damped, pyramid):
        for finding, remedy in scene_rule(scene):
            yield [finding], remedy


def solref_format(scene: Scene) -> Iterator[Hits]:
    """Yield solrefs with one positive and one negative number."""
    solref = scene.model.geom_solref
    geoms = scene.counts & ((solref[:, 0] > 0.0) != (solref[:, 1] > 0.0))
    # getsolparam replaces such a solref and writes a warning to the log.
    wording = Finding(
        "solref-format",
        "",
        "solref[1]",
        0.0,
        "$shape has a solref with only one positive number (the second one is $value),"
        " so MuJoCo uses the default solref",
        severity="error",
    )

    default = {"solref": text_of(DEFAULT_SOLREF)}

    def advise(geom: int) -> Remedy:
        return [(of_geom(scene, geom, default), "states the value that MuJoCo uses")]

    yield Hits(wording, geoms, solref[:, 1], DEFAULT_SOLREF[1], advise)


def solimp(scene: Scene) -> Iterator[Hits]:
    """Yield solimps whose dmin, as clamped by getsolparam, is above dmax."""
    dmin, dmax = np.clip(
        scene.model.geom_solimp[:, :2], mujoco.mjMINIMP, mujoco.mjMAXIMP
    ).T
    geoms = scene.counts & (dmin > dmax)
    yield Hits(
        Finding(
            "solimp",
            "",
            "solimp",
            0.0,
            "$shape has a solimp whose dmin of $value is above its dmax of $used, so its"
            " contacts get softer with depth",
        ),
        geoms,
        dmin,
        dmax,
        partial(in_order, scene),
    )


def timeconst(scene: Scene) -> Iterator[Hits]:
    """Yield timeconsts that the engine clamps because the step is too long for them."""
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
    wording = Finding(
        "timeconst",
        "",
        "timeconst",
        0.0,
        f"$shape has a timeconst of $value against $against, but MuJoCo uses $used,"
        f" because a timeconst cannot be shorter than {least}",
        unit="s",
    )
    # A timeconst that equals the default was probably not chosen.
    below &= authored != DEFAULT_SOLREF[0]

    def advise(pair: int) -> Remedy:
        effect = "only states the value that MuJoCo uses"
        return longer_solref(scene, pair, limit[pair], effect)

    # Timeconsts are often written as short as possible on purpose.
    is_far = limit >= FAR * authored * (1.0 - SAME)
    for severity, rows in (("warning", below & is_far), ("note", below & ~is_far)):
        graded = replace(wording, severity=severity)
        yield _pair_hits(scene, graded, rows, authored, limit, advise)


def too_stiff(scene: Scene) -> Iterator[Hits]:
    """Yield solrefs that are too stiff for the time step and that refsafe permits."""
    contacts = scene.contacts
    step = scene.option.timestep_s
    first, second = contacts.solref.T
    # A contact accelerates by dmax · b and dmax² · k.
    gain = -second * step - 0.5 * first * step**2
    is_unclamped = (first <= 0.0) & (second <= 0.0)
    if not scene.option.refsafe:
        is_short = (first > 0.0) & (second > 0.0)
        own = 2.0 * step / first + 0.5 * (step / (first * second)) ** 2
        is_unclamped = is_unclamped | is_short
        gain = np.where(is_short, own, gain)
    # The integrator discrete is stable with any of them, as both terms are implicit.
    stiff = is_unclamped & (gain >= STIFF) & (not scene.option.discrete)
    why = "does not clamp it" if scene.option.refsafe else "is off"
    wording = Finding(
        "stiff",
        "",
        "solref",
        0.0,
        "$shape is too stiff against $against for the time step: contacts throw bodies"
        f" off because b·h + k·h²/2 of their solref is above {STIFF}, and refsafe {why}",
        severity="error",
    )

    def softer(pair: int) -> Remedy:
        effect = "is the stiffest solref that the time step permits"
        if first[pair] > 0.0:
            return longer_solref(scene, pair, 2.0 * step, effect)
        damping = clamped(contacts.solimp[pair, 1]) / step

        def weaker(solref: Sequence[float]) -> str | None:
            # The engine uses the minimum of the two solrefs, so it never uses a
            # timeconst.
            if solref[0] > 0.0 or solref[1] > 0.0:
                return None
            stiffness = min(-solref[0], 0.25 * damping**2)
            return f"{-stiffness:.4g} {-min(-solref[1], damping):.4g}"

        return [(of_contact(scene, pair, weaker), effect)]

    yield _pair_hits(
        scene, wording, stiff, np.where(first > 0.0, first, second), np.nan, softer
    )


def one_sided(scene: Scene) -> Iterator[Hits]:
    """Yield stiff geoms that only touch soft ones."""
    contacts = scene.contacts
    authored = scene.model.geom_solref[:, 0]
    # Direct solrefs are not mixed: the engine uses the element-wise minimum.
    mixed = (contacts.named < 0) & (contacts.solref > 0.0).all(axis=1)
    ranked = contacts.geoms[contacts.outranked]
    # Where a geom touches an equally stiff one, it is as stiff as written.
    stiffest = -_largest(scene, mixed, -contacts.solref[:, 0])
    # The parameters of a geom with a priority are meant to decide.
    stiffest[ranked] = 0.0
    is_stiff = (
        (authored > 0.0) & (authored * FAR <= DEFAULT_SOLREF[0]) & np.isfinite(stiffest)
    )
    softer = stiffest > np.maximum(2.0 * authored, 4.0 * scene.option.timestep_s)
    hit = is_stiff & softer
    wording = Finding(
        "one-sided",
        "",
        "solref",
        0.0,
        "$shape has a stiff solref of $value, but its contacts use at least $used,"
        " because MuJoCo averages it with the softer solref of the other geom",
        unit="s",
    )
    ranking = "makes contacts use its solref, solimp, friction and condim"
    stiff = [(of_higher_priority(scene, np.flatnonzero(hit)), ranking)]
    yield Hits(wording, hit, authored, stiffest, lambda _: stiff)


def friction(scene: Scene) -> Iterator[Hits]:
    """Yield geoms with a low friction that every contact ignores."""
    contacts = scene.contacts
    authored = scene.model.geom_friction[:, 0]
    plain = (contacts.named < 0) & (contacts.condim > 1)
    least = -_largest(scene, plain, -contacts.friction[:, 0])

    def advise(geom: int) -> Remedy:
        effect = "makes contacts use its friction, solref, solimp and condim"
        return [(of_geom(scene, geom, rank(scene)), effect)]

    # The compiled model does not distinguish a default from the same number in the
    # file.
    yield Hits(
        Finding(
            "friction",
            "",
            "friction",
            0.0,
            "$shape has a friction of $value, but its contacts use at least $used,"
            " because MuJoCo takes the larger friction of the two geoms unless one of"
            " them has a higher priority",
        ),
        (authored * FAR <= least) & np.isfinite(least) & (authored != 1.0),
        authored,
        least,
        advise,
    )


def rank(scene: Scene) -> dict[str, str]:
    """Return the attribute of a priority above all priorities of the scene."""
    return {"priority": str(scene.model.geom_priority.max(initial=0) + 1)}


def of_higher_priority(scene: Scene, geoms: np.ndarray) -> Changes:
    """Return changes that make the solrefs of geoms count alone."""
    option = scene.option
    least = 2.0 * option.timestep_s if option.refsafe else 0.0
    changes: Changes = ()
    for geom in geoms.tolist():
        authored, ratio = scene.model.geom_solref[geom].tolist()
        attributes = rank(scene)
        # Otherwise the next run would report the clamped timeconst.
        if authored < least:
            attributes["solref"] = f"{least:g} {ratio:g}"
        changes += of_geom(scene, geom, attributes)
    return distinct(changes)


def longer_solref(scene: Scene, pair: int, timeconst_s: float, effect: str) -> Remedy:
    """Return changes that lengthen shorter timeconsts to a given one."""

    def longer(solref: Sequence[float]) -> str | None:
        is_short = 0.0 < solref[0] < timeconst_s
        return f"{timeconst_s:.6g} {solref[1]:g}" if is_short else None

    return [(of_contact(scene, pair, longer), effect)]


def in_order(scene: Scene, geom: int) -> Remedy:
    """Return changes that raise dmax to dmin, so that contacts become stiffer."""
    dmin, dmax, *shape = scene.model.geom_solimp[geom].tolist()
    high = min(max(dmin, dmax), 1.0)
    entries = " ".join(f"{entry:g}" for entry in (min(dmin, 1.0), high, *shape))
    effect = "makes contacts stiffer with depth"
    return [(of_geom(scene, geom, {"solimp": entries}), effect)]


def _largest(scene: Scene, pairs: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the largest value of each geom among some pairs; -inf without a pair."""
    largest = np.full(scene.model.ngeom, -np.inf)
    for geoms in (scene.contacts.first, scene.contacts.second):
        np.maximum.at(largest, geoms[pairs], values[pairs])
    return largest


def _pair_hits(
    scene: Scene,
    wording: Finding,
    pairs: np.ndarray,
    authored: np.ndarray,
    used: np.ndarray | float,
    advise: Advise,
) -> Hits:
    """Return hits of some pairs, with the stiffer geom first."""
    contacts = scene.contacts
    timeconst = scene.model.geom_solref[:, 0]
    swap = (
        timeconst[contacts.second] < timeconst[contacts.first]
    ) & ~contacts.outranked
    shape = np.where(swap, contacts.second, contacts.first)

    return Hits(
        wording,
        pairs,
        value=authored,
        used=used,
        shape=shape,
        partner=np.where(swap, contacts.first, contacts.second),
        advise=advise,
    )
