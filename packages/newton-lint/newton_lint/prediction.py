"""Predicted creep of all pairs of a model: its contacts' parameters put into ``creep.predicted_creep``."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import newton
import numpy as np

from newton_lint.compat import make_solver
from newton_lint.creep import Creep, clamped, predicted_creep
from newton_lint.findings import named
from newton_lint.rules import Engine, Scene, kf_unread, read


@dataclass(frozen=True)
class Load:
    """What a grasp is asked to bear."""

    acceleration_m_s2: float = 0.0
    """Along the contact, and left out by its rows."""
    load_n: float = 0.0
    """Tangential force on each contact point."""


@dataclass(frozen=True)
class Prediction:
    """The creep of pairs whose contacts are alike."""

    pairs: tuple[tuple[str, str], ...]
    timeconst_s: float
    """Of the friction rows, as the engine takes it."""
    dmax: float
    """As the engine takes it."""
    deep: Creep
    """Of contacts as deep as solimp's width, or deeper."""
    shallow: Creep
    """Of contacts that hardly touch, which yield most."""


def predictions(model: newton.Model, engine: Engine, load: Load) -> list[Prediction]:
    """Of all pairs that have friction, those alike together, in the order of the model.

    Left out are pairs whose solref depends on the bodies' masses, as that of shapes in force space, and those without
    damping, which nothing brakes.
    """
    if not model.shape_count:
        return []
    scene = read(model, engine)
    contacts, has_kf = scene.contacts, not kf_unread(scene.engine)
    weight = np.zeros(len(contacts.first))
    if load.load_n or has_kf:
        shapes = inverse_weights(model)[scene.shapes.body]
        weight = shapes[contacts.first] + shapes[contacts.second]
    solref = _friction_solref(scene, weight) if has_kf else contacts.solref
    told = np.column_stack([solref, contacts.solimp[:, :2], contacts.mu, weight])
    held = np.flatnonzero(scene.has_friction & (solref[:, 1] != 0.0) & np.isfinite(told).all(axis=1))
    if not len(held):
        return []
    _, first, which = np.unique(told[held], axis=0, return_index=True, return_inverse=True)
    names = scene.shapes.names()
    found = []
    for index in np.argsort(first).tolist():
        pairs = held[which.reshape(-1) == index]
        found.append(_prediction(scene.engine, load, told[pairs[0]].tolist(), list(_named(scene, pairs, names))))
    return found


def inverse_weights(model: newton.Model) -> np.ndarray:
    """Translational body_invweight0 of each body [1/kg], and a last one of the world, as the engine compiles them."""
    solver = make_solver(model, use_mujoco_cpu=True)
    weights = np.zeros(model.body_count + 1)
    of_newton = solver.mjc_body_to_newton.numpy()[0]
    weights[of_newton] = solver.mj_model.body_invweight0[: len(of_newton), 0]
    weights[-1] = 0.0
    return weights


def _friction_solref(scene: Scene, weight: np.ndarray) -> np.ndarray:
    """Of friction rows that kf gives a timeconst of their own; see ``compat.KF_RELEASE``."""
    dmax = scene.contacts.solimp[:, 1]
    with np.errstate(divide="ignore", invalid="ignore"):
        own = 2.0 / (scene.kf * weight * ((1.0 - dmax) / scene.engine.impratio + dmax))
    has_own = (scene.kf > 0.0) & np.isfinite(own)
    return np.where(has_own[:, None], np.stack([own, np.ones(len(own))], axis=1), scene.contacts.solref)


def _prediction(engine: Engine, load: Load, told: Sequence[float], pairs: Sequence[tuple[str, str]]) -> Prediction:
    *solref, dmin, dmax, mu, weight = told
    dmin, dmax = clamped(dmin), clamped(dmax)
    step = engine.substep_dt if engine.refsafe else 0.0
    deep, shallow = (
        predicted_creep(
            solref,
            dmax,
            timestep_s=step,
            acceleration_m_s2=load.acceleration_m_s2,
            load_n=load.load_n,
            inverse_mass_1_kg=weight,
            impedance=impedance,
            impratio=engine.impratio,
            cone=engine.cone,
            mu=mu,
        )
        for impedance in (dmax, dmin)
    )
    return Prediction(tuple(pairs), 2.0 * deep.response_s / dmax, dmax, deep, shallow)


def _named(scene: Scene, pairs: np.ndarray, names: Sequence[str]) -> Iterator[tuple[str, str]]:
    for pair in pairs.tolist():
        yield names[scene.contacts.first[pair]], names[scene.contacts.second[pair]]


def said(prediction: Prediction, load: Load) -> str:
    """A prediction as one line of text."""
    count = len(prediction.pairs)
    place = f"{named(one for one, _ in prediction.pairs)} on {named(other for _, other in prediction.pairs)}"
    deep, shallow = prediction.deep, prediction.shallow
    parts = [
        f"timeconst {prediction.timeconst_s:.3g} s",
        f"{1e3 * deep.response_s:.3g} mm/s for each m/s² that its rows leave out",
    ]
    if load.acceleration_m_s2:
        parts.append(f"{deep.acceleration_mm_s:.3g} mm/s at {load.acceleration_m_s2:g} m/s²")
    if load.load_n:
        parts.append(f"{deep.load_mm_s:.3g} to {shallow.load_mm_s:.3g} mm/s under {load.load_n:g} N on a contact point")
    return f"{place}{f' ({count} pairs)' if count > 1 else ''}: {'; '.join(parts)}"
