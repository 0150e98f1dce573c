"""Predicted creep of all pairs of a Newton model."""

import newton
import numpy as np

from newton_lint.law import Contact, Option
from newton_lint.of_newton.compat import make_solver
from newton_lint.of_newton.rules import Engine, Scene, kf_unread, read
from newton_lint.prediction import Load, Prediction, predicted


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
    told = np.column_stack([solref, contacts.solimp, contacts.mu, contacts.condim, weight])
    held = np.flatnonzero(scene.has_friction & (solref[:, 1] != 0.0) & np.isfinite(told).all(axis=1))
    if not len(held):
        return []
    _, first, which = np.unique(told[held], axis=0, return_index=True, return_inverse=True)
    names = scene.shapes.names()
    option = Option(
        scene.engine.substep_dt, cone=scene.engine.cone, impratio=scene.engine.impratio, refsafe=scene.engine.refsafe
    )
    found = []
    for index in np.argsort(first).tolist():
        pairs = held[which.reshape(-1) == index]
        timeconst, dampratio, *solimp, mu, condim, weight_1_kg = told[pairs[0]].tolist()
        contact = Contact((timeconst, dampratio), tuple(solimp), mu, weight_1_kg, condim=int(condim))
        between = ((names[contacts.first[pair]], names[contacts.second[pair]]) for pair in pairs.tolist())
        found.append(predicted(contact, option, load, tuple(between)))
    return [prediction for prediction in found if prediction]


def inverse_weights(model: newton.Model) -> np.ndarray:
    """Translational body_invweight0 of each body [1/kg], and a last one of the world, as the engine compiles them."""
    weights = np.zeros(model.body_count + 1)
    solver = make_solver(model, use_mujoco_cpu=True)
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
