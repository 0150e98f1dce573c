"""Predicted creep of all pairs of a scene: their contacts' parameters put into the law."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import mujoco
import numpy as np

from newton_lint.findings import groups_of, row_numbers
from newton_lint.law import STEP_SHARE, Contact, M, Option, clamped, response_of
from newton_lint.scene import Scene


@dataclass(frozen=True)
class Load:
    """A load that a grasp is asked to bear."""

    acceleration_m_s2: float = 0.0
    """Along the contact, and left out by its rows."""
    load_n: float = 0.0


@dataclass(frozen=True)
class Prediction:
    """The creep of pairs whose contacts are alike."""

    pairs: tuple[tuple[str, str], ...]
    timeconst_s: float
    """Of the friction rows, as the engine takes it."""
    dmax: float
    response_s: float
    """1/b."""
    acceleration_response_s: float
    """Slide for each m/s² that the rows leave out: 1/b, and what the integrator's step adds or takes."""
    load_deep_mm_s: float
    """Slide under the load of a contact as deep as solimp's width and of one that hardly touches, the less first."""
    load_shallow_mm_s: float
    acceleration_mm_s: float
    is_free: bool = False


def predictions(scene: Scene, load: Load) -> list[Prediction]:
    """Return predictions of pairs with friction and damping, alike together, free bodies first."""
    contacts = scene.contacts
    rows = np.flatnonzero(contacts.condim > 1)
    loose = scene.free[scene.model.geom_bodyid]
    names = scene.names
    creeps = []
    for members in groups_of(row_numbers(_kinds(scene)[rows])):
        pairs = rows[members]
        geoms = zip(
            contacts.first[pairs].tolist(), contacts.second[pairs].tolist(), strict=True
        )
        between = tuple((names[geom1], names[geom2]) for geom1, geom2 in geoms)
        pair = int(pairs[0])
        is_free = bool(loose[contacts.first[pair]] or loose[contacts.second[pair]])
        if prediction := predicted(
            contacts.contact(pair), scene.option, load, between, is_free
        ):
            if (
                named := contacts.named[pair]
            ) >= 0:  # mj_makeImpedance: R μ² is the same along both tangents
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
    columns = np.concatenate(
        (model.geom_solref.T, model.geom_solimp.T, model.geom_friction.T)
    )
    single = (
        model.geom_condim,
        model.geom_priority,
        model.geom_solmix,
        scene.free[model.geom_bodyid],
    )
    kind = row_numbers(*columns, *single, model.body_invweight0[model.geom_bodyid, 0])
    kind1 = kind[contacts.first]
    kind2 = kind[contacts.second]
    unordered = np.minimum(kind1, kind2) * model.ngeom + np.maximum(kind1, kind2)
    return np.where(
        contacts.named < 0, unordered, -1 - contacts.named
    )  # each <pair> has parameters of its own


def predicted(
    contact: Contact,
    option: Option,
    load: Load,
    pairs: Sequence[tuple[str, str]],
    is_free: bool = False,
) -> Prediction | None:
    """Return the creep of one contact; None where nothing damps it."""
    dmax = clamped(contact.solimp[1])
    deep = response_of(contact, option)
    shallow = response_of(contact, option, clamped(contact.solimp[0]))
    if (
        not 0.0 <= deep.acceleration_s < math.inf
    ):  # undamped, or too stiff for the step, which throws it off
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
