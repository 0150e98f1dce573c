"""Reads and lints the models of Newton."""

import logging
from dataclasses import replace
from pathlib import Path
from typing import Any

import newton
import warp as wp
from newton.solvers import SolverMuJoCo

from newton_lint.newton_models.rules import Shapes, findings_in, kf_unread
from newton_lint.report import Report, Request, report_on
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


def finalized(scene: Any) -> newton.Model | None:
    """Return the model of a builder or a model itself, or None for other objects."""
    if isinstance(scene, newton.ModelBuilder):
        return scene.finalize(device="cpu")
    return scene if isinstance(scene, newton.Model) else None


def imported(path: Path) -> newton.Model:
    """Return a file as Newton imports it, with the attributes of ``SolverMuJoCo``."""
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    getattr(builder, READERS.get(path.suffix.lower(), "add_usd"))(str(path))
    # The arrays are only read, and a GPU may be missing or busy.
    return builder.finalize(device="cpu")


def report_of(target: Target, request: Request) -> Report:
    """Lint a finalized ``newton.Model``, as ``SolverMuJoCo`` compiles it."""
    model = target.newton_model
    if not model.shape_count:
        step = request.engine.timestep_s or TIMESTEP_S
        return Report(target.name, step, 0, 0, request.load, [], [], newton.__version__)
    scene = Shapes.of(model, request.engine)
    report = report_on(
        scene, replace(target, data=scene.start), request, findings_in(scene)
    )
    # Friction has a timeconst of its own if kf is read, so the law does not apply.
    has_own = not kf_unread(scene) and (scene.of_geoms("shape_material_kf") > 0.0).any()
    creep = [] if has_own else report.creep
    return replace(report, creep=creep, newton=newton.__version__, source=None)
