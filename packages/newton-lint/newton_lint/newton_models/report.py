"""Reads and lints the models of Newton."""

import logging
from pathlib import Path
from typing import Any

import newton
import warp as wp
from newton.solvers import SolverMuJoCo

from newton_lint.newton_models.rules import Shapes, findings_in, kf_unread
from newton_lint.prediction import predictions
from newton_lint.report import Report, Request
from newton_lint.target import Target
from newton_lint.warp_engine import muted_standard_error

READERS = {".xml": "add_mjcf", ".urdf": "add_urdf"}
"""Maps the ending of a file to the builder's method; ``add_usd`` reads all others."""
TIMESTEP_S = 0.002
"""MuJoCo's default, which is used for a model without shapes."""


wp.config.log_level = wp.LOG_WARNING
# trimesh reads meshes without scipy, but logs a traceback about it.
logging.getLogger("trimesh").setLevel(logging.ERROR)
with muted_standard_error():
    wp.init()


def is_model(scene: Any) -> bool:
    return isinstance(scene, newton.Model)


def imported(path: Path) -> newton.Model:
    """Return a file as Newton imports it, with the attributes of ``SolverMuJoCo``."""
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    getattr(builder, READERS.get(path.suffix.lower(), "add_usd"))(str(path))
    # The arrays are only read, and a GPU may be missing or busy.
    return builder.finalize(device="cpu")


def report_of(target: Target, request: Request) -> Report:
    """Lint a finalized ``newton.Model``."""
    model = target.newton_model
    scene = Shapes.of(model, request.engine) if model.shape_count else None
    has_own = (
        scene
        and not kf_unread(scene)
        and (scene.of_geoms("shape_material_kf") > 0.0).any()
    )
    # Friction has a timeconst of its own if kf is read, so the law does not apply.
    return Report(
        target=target.name,
        dt_s=scene.option.timestep_s
        if scene
        else request.engine.timestep_s or TIMESTEP_S,
        shape_count=scene.colliding if scene else 0,
        pair_count=len(scene.contacts) if scene else 0,
        load=request.load,
        findings=[
            finding
            for finding in findings_in(scene)
            if finding.rule not in request.ignore
        ]
        if scene
        else [],
        creep=predictions(scene, request.load) if scene and not has_own else [],
        newton=newton.__version__,
    )
