"""The rules: what a scene says and ``SolverMuJoCo`` does not do. A function each, over arrays of shapes and pairs."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import newton
import numpy as np

from newton_lint.findings import Buffer, Finding
from newton_lint.grouping import Hits, hits
from newton_lint.grouping import findings_of as told
from newton_lint.newton_models.compat import kf_is_read
from newton_lint.newton_models.contacts import (
    CONDIM,
    CONES,
    CONVERTED,
    DEFAULT_SOLREF,
    RAW,
    SOLIMP,
    Contacts,
    Shapes,
    contacts_of,
    same,
)

LARGE_RATIO = 4.0
"""A buffer that holds more than this many times the measured peak is called too large."""
FAR = 4.0
"""A damping ratio that is more than this many times another one is far from it."""
TORSIONAL_CONDIM, ROLLING_CONDIM = 4, 6
"""Least condim with which a contact resists to spinning, and to rolling."""
NOT_READ = "is not read by SolverMuJoCo"
OVERRULED = "never reaches the solver: the other shape has the higher priority"


@dataclass(frozen=True)
class Engine:
    """What the solver is given that is not in the model."""

    substep_dt: float
    """Time step of the solver [s]."""
    refsafe: bool = True
    """Whether it keeps a contact's timeconst at 2 time steps or more, as it does by default."""
    contacts: str = "mujoco"
    """Whose contacts it solves: ``mujoco``, its own, or ``newton``, which read kf and no pair that MJCF names."""
    cone: str | None = None
    """``elliptic`` or ``pyramidal``; None: as the model says."""
    impratio: float | None = None
    """None: as the model says."""


@dataclass(frozen=True)
class Scene:
    """What the rules read."""

    shapes: Shapes
    contacts: Contacts
    engine: Engine

    @cached_property
    def settled(self) -> tuple[np.ndarray, np.ndarray]:
        """Return which shapes' parameters count in which pair: both unless one outranks the other."""
        contacts, priority = self.contacts, self.shapes.priority
        plain = ~contacts.explicit
        level = plain & (priority[contacts.first] == priority[contacts.second])
        shapes = np.concatenate([contacts.first[plain], contacts.second[level]])
        return shapes, np.concatenate([np.flatnonzero(plain), np.flatnonzero(level)])

    @cached_property
    def kf(self) -> np.ndarray:
        """Return of each pair."""
        contacts, kf = self.contacts, self.shapes.kf
        return contacts.mix * kf[contacts.first] + (1.0 - contacts.mix) * kf[contacts.second]

    @cached_property
    def has_friction(self) -> np.ndarray:
        """Tell whether a pair has friction rows: none with a condim of 1, or a kf of 0 that is read."""
        rows = self.contacts.condim > 1
        return rows if kf_unread(self.engine) else rows & (self.kf != 0.0)


def lint(model: newton.Model, engine: Engine, buffers: Sequence[Buffer] = ()) -> list[Finding]:
    """Return everything in a finalized model that ``SolverMuJoCo`` will not use as it was authored.

    Args:
        model: Any finalized model, with or without the solver's custom attributes, or without shapes.
        engine: What the solver is given besides.
        buffers: Buffers with what a run was measured to need of them.
    """
    missized = [finding for buffer in buffers for finding in _missized(buffer)]
    return (findings_of(read(model, engine)) if model.shape_count else []) + missized


def findings_of(scene: Scene) -> list[Finding]:
    """Return what the rules say of a scene that has shapes."""
    names = scene.shapes.names()
    rules = (priority, default_gap, timeconst, ke_without_kd, dampratio, friction_gain, unused)
    return [finding for rule in rules for found in rule(scene) for finding in told(found, names)]


def read(model: newton.Model, engine: Engine) -> Scene:
    """Return what the rules read of a model that has shapes."""
    shapes = Shapes(model)
    told = {
        "cone": engine.cone or CONES[int(shapes.option("cone", 0))],
        "impratio": shapes.option("impratio", 1.0) if engine.impratio is None else engine.impratio,
    }
    return Scene(shapes, contacts_of(shapes, named=engine.contacts == "mujoco"), replace(engine, **told))


def priority(scene: Scene) -> Iterator[Hits]:
    """Yield authored parameters of the shape of lower priority: of such a pair only the other's values are used."""
    shapes, contacts = scene.shapes, scene.contacts
    there = ~contacts.explicit & (shapes.priority[contacts.first] > shapes.priority[contacts.second])
    winner, loser = contacts.first[there], contacts.second[there]
    config = newton.ModelBuilder.ShapeConfig()
    parameters = {
        "ke": (shapes.ke, config.ke),
        "kd": (shapes.kd, config.kd),
        **({"kf": (shapes.kf, config.kf)} if kf_is_read() else {}),
        "mu": (shapes.mu, config.mu),
        "mu_torsional": (shapes.mu_torsional, config.mu_torsional),
        "mu_rolling": (shapes.mu_rolling, config.mu_rolling),
        "condim": (shapes.condim, CONDIM),
        **{f"solimp[{index}]": (shapes.solimp[:, index], default) for index, default in enumerate(SOLIMP)},
    }
    raw = (shapes.mode[winner] == RAW) | (shapes.mode[loser] == RAW)
    for name, (values, default) in parameters.items():
        lost = ~same(values[loser], default) & ~same(values[loser], values[winner])
        if name in ("ke", "kd"):
            lost &= ~raw  # they are not what the solver reads of a shape with a solref of its own
        yield hits(
            *("priority", name, loser[lost], winner[lost], values[loser[lost]], values[winner[lost]], OVERRULED),
            severity="note",
        )
    for index, default in enumerate(DEFAULT_SOLREF):
        # Compared with the pair's: of solrefs below 0 MuJoCo Warp takes the smaller, whatever their priority.
        values, used = shapes.solref[loser, index], contacts.solref[there, index]
        lost = raw & ~same(values, default) & ~same(values, used)
        yield hits(
            *("priority", f"solref[{index}]", loser[lost], winner[lost], values[lost], used[lost], OVERRULED),
            severity="note",
        )


def default_gap(scene: Scene) -> Iterator[Hits]:
    """Yield shapes left at the builder's gap although some that they can touch were not. Gaps of a pair add."""
    shapes, contacts = scene.shapes, scene.contacts
    default = newton.ModelBuilder().rigid_gap
    plain = ~contacts.explicit
    authored = np.where(same(shapes.gap, default), -np.inf, shapes.gap)
    largest = np.full(len(shapes.gap), -np.inf)
    for one, other in ((contacts.first, contacts.second), (contacts.second, contacts.first)):
        np.maximum.at(largest, one[plain], authored[other[plain]])
    left = np.flatnonzero(same(shapes.gap, default) & (largest > -np.inf))
    message = "is the builder's default although its neighbours' gaps were set; gaps of a pair add"
    yield hits("default-gap", "gap", left, None, shapes.gap[left], shapes.gap[left] + largest[left], message, "m")


def timeconst(scene: Scene) -> Iterator[Hits]:
    """Yield a timeconst below two substeps, which the engine does not take."""
    if not scene.engine.refsafe:
        return
    contacts, limit = scene.contacts, 2.0 * scene.engine.substep_dt
    with np.errstate(invalid="ignore"):
        below = (contacts.timeconst > 0.0) & (contacts.timeconst < limit) & ~same(contacts.timeconst, limit)
    found = contacts.timeconst[below]
    message = "is below two substeps, which the engine clamps it to"
    yield hits("timeconst", "timeconst", contacts.first[below], contacts.second[below], found, limit, message, unit="s")


def ke_without_kd(scene: Scene) -> Iterator[Hits]:
    """Yield ke or kd of which the other is 0: neither is read, and the contact has the default's solref."""
    shapes = scene.shapes
    counts, _ = scene.settled
    shape = _each(counts)
    shape = shape[shapes.mode[shape] == CONVERTED]
    timeconst_s, ratio = DEFAULT_SOLREF
    defaults = {"ke": 1.0 / (timeconst_s * ratio) ** 2, "kd": 2.0 / timeconst_s}
    for name, other in (("ke", "kd"), ("kd", "ke")):
        values = getattr(shapes, name)
        alone = shape[(values[shape] > 0.0) & (getattr(shapes, other)[shape] <= 0.0)]
        message = f"is not read: {other} is 0, so that solref is ({timeconst_s:g}, {ratio:g}) whatever {name} is"
        yield hits("ke-without-kd", name, alone, None, values[alone], defaults[name], message)


def dampratio(scene: Scene) -> Iterator[Hits]:
    """Yield a contact that rings, or that yields as the square of its damping ratio."""
    contacts = scene.contacts
    ratio, timeconst_s = contacts.dampratio, contacts.timeconst
    with np.errstate(invalid="ignore"):
        far = np.flatnonzero((ratio > FAR) | (ratio < 1.0 / FAR))

    def say(index: int) -> str:
        pair = far[index]
        own = f"its timeconst is {timeconst_s[pair]:.3g} s" if timeconst_s[pair] > 0.0 else "as its solref says"
        if ratio[pair] < 1.0:
            return f"is far below 1, so that the contact rings; {own}"
        return f"is far above 1, and the contact yields by its square; {own}"

    yield hits("dampratio", "dampratio", contacts.first[far], contacts.second[far], ratio[far], 1.0, say)


def friction_gain(scene: Scene) -> Iterator[Hits]:
    """Yield authored kf that is not read, takes the friction away, or asks for a timeconst below two substeps.

    Clamped is said of pairs of which both bodies move freely or not at all: another one's weight is not in the model.
    """
    shapes, contacts = scene.shapes, scene.contacts
    authored = ~same(shapes.kf, newton.ModelBuilder.ShapeConfig().kf)
    shape, pair = scene.settled
    engine = scene.engine
    if reason := kf_unread(engine):
        unread = _each(shape[authored[shape]])
        yield hits("kf", "kf", unread, None, shapes.kf[unread], np.nan, f"{NOT_READ} {reason}")
        return
    first, second, kf = contacts.first, contacts.second, scene.kf
    lost = np.flatnonzero((contacts.condim > 1) & (contacts.mu > 0.0) & ~scene.has_friction)
    message = "is not read: kf is 0, which takes the friction away"
    yield hits("kf", "mu", first[lost], second[lost], contacts.mu[lost], np.nan, message)
    inverse = shapes.inverse_mass()
    dmax = contacts.solimp[:, 1]
    weight = (inverse[first] + inverse[second]) * ((1.0 - dmax) / engine.impratio + dmax)
    with np.errstate(divide="ignore", invalid="ignore"):
        most = 1.0 / (engine.substep_dt * weight)
        clamped = engine.refsafe & ~contacts.explicit & (kf > most) & ~same(kf, most)
    own = np.zeros(len(kf), dtype=bool)
    own[pair[authored[shape]]] = True
    hit = np.flatnonzero(clamped & own)
    message = "asks for a friction timeconst below two substeps, which the engine clamps it to"
    yield hits("kf", "kf", first[hit], second[hit], kf[hit], most[hit], message)


def kf_unread(engine: Engine) -> str:
    """Say why kf is not read; empty where it is."""
    if not kf_is_read():
        return "of this release"
    if engine.contacts != "newton":
        return "in contacts of MuJoCo"
    return "" if engine.cone == "elliptic" else "with a pyramidal cone"


def unused(scene: Scene) -> Iterator[Hits]:
    """Yield what no contact of a shape reads: restitution, and friction of a kind for which its condim has no rows."""
    shapes, contacts = scene.shapes, scene.contacts
    config = newton.ModelBuilder.ShapeConfig()
    shape, pair = scene.settled
    condim = np.zeros(len(shapes.body), dtype=int)
    np.maximum.at(condim, shape, contacts.condim[pair].astype(int))
    bounces = _each(shape[shapes.restitution[shape] != 0.0])
    yield hits("unused", "restitution", bounces, None, shapes.restitution[bounces], np.nan, NOT_READ, severity="note")
    for name, least in (("mu_torsional", TORSIONAL_CONDIM), ("mu_rolling", ROLLING_CONDIM)):
        values = getattr(shapes, name)
        authored = np.flatnonzero((condim > 0) & (condim < least) & ~same(values, getattr(config, name)))
        message = f"has no rows in its contacts: their condim is below {least}"
        yield hits("unused", name, authored, None, values[authored], np.nan, message, severity="note")


def _each(shapes: np.ndarray) -> np.ndarray:
    return np.flatnonzero(np.bincount(shapes))


def _missized(buffer: Buffer) -> Iterator[Finding]:
    message = None
    if buffer.capacity < buffer.peak:
        message = "is smaller than the measured peak: what does not fit is lost"
    elif buffer.capacity > LARGE_RATIO * max(buffer.peak, 1):
        message = "is much larger than the measured peak: every world pays for it"
    if message:
        yield Finding("buffer", "", (), buffer.name, buffer.capacity, buffer.peak, "count", message)
