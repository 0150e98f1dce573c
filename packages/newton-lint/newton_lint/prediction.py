"""Predicts the creep of all pairs of a scene by applying the law to their contacts."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import mujoco
import numpy as np

from newton_lint.findings import groups_of
from newton_lint.law import STEP_SHARE, Contact, M, Option, clamped, response_of
from newton_lint.pairs import kinds_of, numbered
from newton_lint.scene import Scene


@dataclass(frozen=True)
class Load:
    """A load on each contact, for which creep is predicted."""

    acceleration_m_s2: float = 0.0
    """Acceleration along the contact that its rows leave out."""
    load_n: float = 0.0


@dataclass(frozen=True)
class Prediction:
    """The creep of pairs whose contacts have equal parameters."""

    pairs: tuple[tuple[str, str], ...]
    timeconst_s: float
    """Timeconst of the friction rows, as the engine uses it."""
    dmax: float
    response_s: float
    """The inverse of b."""
    acceleration_response_s: float
    """Creep per m/s² that the rows leave out: 1/b and a share of the time step."""
    load_deep_mm_s: float
    """Lower bound of the creep under the load, between a deep and a shallow contact.

    A deep contact is pressed in by the width of solimp; a shallow one barely touches.
    """
    load_shallow_mm_s: float
    acceleration_mm_s: float
    is_free: bool = False


def predictions(scene: Scene, load: Load) -> list[Prediction]:
    """Return a prediction for each group of equal contacts, free bodies first."""
    contacts = scene.contacts
    rows = np.flatnonzero(contacts.condim > 1)
    loose = scene.free[scene.model.geom_bodyid]
    names = np.array(scene.names, dtype=object)
    creeps = []
    for members in groups_of(numbered(_kinds(scene)[rows])):
        pairs = rows[members]
        between = tuple(map(tuple, names[contacts.geoms[pairs]].tolist()))
        pair = pairs[0]
        is_free = bool(loose[contacts.first[pair]] or loose[contacts.second[pair]])
        if prediction := predicted(
            contacts.contact(pair), scene.option, load, between, is_free
        ):
            # mj_makeImpedance: R μ² is the same along both tangents.
            if (named := contacts.named[pair]) >= 0:
                mu1, mu2 = scene.model.pair_friction[named, :2]
                least, most = sorted((1.0, float(mu1 / max(mu2, mujoco.mjMINMU)) ** 2))
                prediction = replace(
                    prediction,
                    load_deep_mm_s=least * prediction.load_deep_mm_s,
                    load_shallow_mm_s=most * prediction.load_shallow_mm_s,
                )
            creeps.append(prediction)
    return sorted(creeps, key=_order)


def _kinds(scene: Scene) -> np.ndarray:
    contacts = scene.contacts
    model = scene.model
    kind = kinds_of(model, model.body_invweight0[:, 0], scene.free)
    kind1 = kind[contacts.first]
    kind2 = kind[contacts.second]
    unordered = np.minimum(kind1, kind2) * model.ngeom + np.maximum(kind1, kind2)
    # Each <pair> has parameters of its own.
    return np.where(contacts.named < 0, unordered, -1 - contacts.named)


def predicted(
    contact: Contact,
    option: Option,
    load: Load,
    pairs: Sequence[tuple[str, str]],
    is_free: bool = False,
) -> Prediction | None:
    """Return the creep of one contact, or None if it has no damping."""
    dmax = clamped(contact.solimp[1])
    deep = response_of(contact, option)
    shallow = response_of(contact, option, clamped(contact.solimp[0]))
    # The contact is undamped, or it is so stiff that the time step throws bodies off.
    if not 0.0 <= deep.acceleration_s < math.inf:
        return None
    inverse_b = (
        deep.acceleration_s - STEP_SHARE.get(option.integrator, 0.0) * option.timestep_s
    )
    least, most = sorted(
        M * (response.load_m_s_n * load.load_n) for response in (deep, shallow)
    )
    return Prediction(
        pairs=tuple(pairs),
        timeconst_s=2.0 * inverse_b / dmax,
        dmax=dmax,
        response_s=inverse_b,
        acceleration_response_s=deep.acceleration_s,
        load_deep_mm_s=least,
        load_shallow_mm_s=most,
        acceleration_mm_s=M * deep.acceleration_s * load.acceleration_m_s2,
        is_free=is_free,
    )


def _order(prediction: Prediction) -> tuple[bool, float, float]:
    total = prediction.load_shallow_mm_s + prediction.acceleration_mm_s
    return not prediction.is_free, -total, -prediction.acceleration_response_s
