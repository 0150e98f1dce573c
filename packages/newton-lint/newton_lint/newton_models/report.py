"""What is said of a Newton model: findings, and the predicted creep of all its pairs."""

import newton
import numpy as np

from newton_lint.newton_models.compat import make_solver
from newton_lint.newton_models.rules import Engine, Scene, findings_of, kf_unread, read
from newton_lint.prediction import Prediction, predictions
from newton_lint.report import Asked, Report
from newton_lint.scene import Scene as Compiled
from newton_lint.source import Source
from newton_lint.target import Target

TIMESTEP_S = 0.002
"""The solver's time step where nothing says another, as MuJoCo has it."""
COLLIDES = int(newton.ShapeFlags.COLLIDE_SHAPES)


def report_of(target: Target, asked: Asked) -> Report:
    """Lint a finalized ``newton.Model``, with ``--engine newton`` by Newton's contacts."""
    model, given = target.newton_model, asked.engine
    contacts = "newton" if given.name == "newton" else "mujoco"
    engine = Engine(given.timestep_s or TIMESTEP_S, contacts=contacts, cone=given.cone, impratio=given.impratio)
    scene = read(model, engine) if model.shape_count else None
    return Report(
        target=target.name,
        dt_s=engine.substep_dt,
        shape_count=int(np.count_nonzero(model.shape_flags.numpy() & COLLIDES)) if scene else 0,
        pair_count=len(scene.contacts.first) if scene else 0,
        load=asked.load,
        findings=[finding for finding in findings_of(scene) if finding.rule not in asked.ignore] if scene else [],
        creep=_creep(scene, asked) if scene else [],
        newton=newton.__version__,
    )


def _creep(scene: Scene, asked: Asked) -> list[Prediction]:
    """Return creep by the model that the solver compiles; none where kf gives friction a timeconst of its own."""
    if not kf_unread(scene.engine) and (scene.kf > 0.0).any():
        return []
    model = make_solver(scene.shapes.model, use_mujoco_cpu=True).mj_model
    model.opt.timestep = scene.engine.substep_dt
    return predictions(Compiled(asked.engine.asked(model), Source(None, model)), asked.load)
