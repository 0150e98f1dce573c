"""What is said of a Newton model: findings, and the predicted creep of all its pairs."""

import newton

from newton_lint.newton_models.rules import Shapes, findings_in, kf_unread
from newton_lint.prediction import predictions
from newton_lint.report import Report, Request
from newton_lint.target import Target

TIMESTEP_S = 0.002
"""The time step of a model without shapes, as MuJoCo has it."""


def report_of(target: Target, request: Request) -> Report:
    """Lint a finalized ``newton.Model``, with ``--engine newton`` by Newton's contacts."""
    model = target.newton_model
    scene = Shapes.of(model, request.engine) if model.shape_count else None
    has_own = scene and not kf_unread(scene) and (scene.of_geoms("shape_material_kf") > 0.0).any()
    return Report(
        target=target.name,
        dt_s=scene.option.timestep_s if scene else request.engine.timestep_s or TIMESTEP_S,
        shape_count=scene.colliding if scene else 0,
        pair_count=len(scene.contacts) if scene else 0,
        load=request.load,
        findings=[finding for finding in findings_in(scene) if finding.rule not in request.ignore] if scene else [],
        creep=predictions(scene, request.load) if scene and not has_own else [],  # kf gives friction its own timeconst
        newton=newton.__version__,
    )
