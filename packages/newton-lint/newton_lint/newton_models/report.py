"""What is said of a Newton model: findings, and the predicted creep of all its pairs."""

import newton
import numpy as np

from newton_lint.law import Contact, Option
from newton_lint.newton_models.compat import make_solver
from newton_lint.newton_models.rules import Engine, Scene, findings_of, kf_unread, read
from newton_lint.prediction import Load, Prediction, predicted
from newton_lint.report import Asked, Report
from newton_lint.target import Target

TIMESTEP_S = 0.002
"""The solver's time step where nothing says another, as MuJoCo has it."""
COLLIDES = int(newton.ShapeFlags.COLLIDE_SHAPES)


def report_of(target: Target, asked: Asked) -> Report:
    """Lint a finalized ``newton.Model``, with ``--engine newton`` by Newton's contacts."""
    model, given = target.newton_model, asked.engine
    engine = Engine(
        given.timestep_s or TIMESTEP_S,
        contacts="newton" if given.name == "newton" else "mujoco",
        cone=given.cone,
        impratio=given.impratio,
    )
    scene = read(model, engine) if model.shape_count else None
    return Report(
        target=target.name,
        dt_s=engine.substep_dt,
        shape_count=int(np.count_nonzero(model.shape_flags.numpy() & COLLIDES)) if scene else 0,
        pair_count=len(scene.contacts.first) if scene else 0,
        load=asked.load,
        findings=[finding for finding in findings_of(scene) if finding.rule not in asked.ignore] if scene else [],
        creep=predictions(scene, asked.load) if scene else [],
        newton=newton.__version__,
    )


def predictions(scene: Scene, load: Load) -> list[Prediction]:
    """Return of all pairs that have friction, those alike together, in the order of the model.

    Left out are pairs whose solref depends on the bodies' masses, as that of shapes in force space, and those without
    damping, which nothing brakes.
    """
    contacts, has_kf = scene.contacts, not kf_unread(scene.engine)
    weight = np.zeros(len(contacts.first))
    if load.load_n or has_kf:
        shapes = inverse_weights(scene.shapes.model)[scene.shapes.body]
        weight = shapes[contacts.first] + shapes[contacts.second]
    solref = _friction_solref(scene, weight) if has_kf else contacts.solref
    told = np.column_stack([solref, contacts.solimp, contacts.mu, contacts.condim, weight])
    held = np.flatnonzero(scene.has_friction & (solref[:, 1] != 0.0) & np.isfinite(told).all(axis=1))
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
    """Return translational body_invweight0 of each body [1/kg], as the engine compiles it; the world's is the last."""
    weights = np.zeros(model.body_count + 1)
    solver = make_solver(model, use_mujoco_cpu=True)
    of_newton = solver.mjc_body_to_newton.numpy()[0]
    weights[of_newton] = solver.mj_model.body_invweight0[: len(of_newton), 0]
    weights[-1] = 0.0
    return weights


def _friction_solref(scene: Scene, weight: np.ndarray) -> np.ndarray:
    """Return of friction rows that kf gives a timeconst of their own; see ``compat.KF_RELEASE``."""
    dmax = scene.contacts.solimp[:, 1]
    with np.errstate(divide="ignore", invalid="ignore"):
        own = 2.0 / (scene.kf * weight * ((1.0 - dmax) / scene.engine.impratio + dmax))
    has_own = (scene.kf > 0.0) & np.isfinite(own)
    return np.where(has_own[:, None], np.stack([own, np.ones(len(own))], axis=1), scene.contacts.solref)
