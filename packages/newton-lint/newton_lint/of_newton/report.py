"""What is said of a Newton model."""

import newton
import numpy as np

from newton_lint.of_newton.prediction import predictions
from newton_lint.of_newton.rules import Engine, findings_of, read
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
    found = findings_of(scene) if scene else []
    return Report(
        target=target.name,
        dt_s=engine.substep_dt,
        shape_count=int(np.count_nonzero(model.shape_flags.numpy() & COLLIDES)) if scene else 0,
        pair_count=len(scene.contacts.first) if scene else 0,
        load=asked.load,
        findings=[finding for finding in found if finding.rule not in asked.ignore],
        creep=predictions(model, engine, asked.load),
        newton=newton.__version__,
    )
