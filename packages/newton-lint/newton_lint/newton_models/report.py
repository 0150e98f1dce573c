"""Newton's models: read from files that only Newton reads, or returned by a function, and what is said of them."""

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
"""The builder's method for a file, by its ending; of any other USD's."""
TIMESTEP_S = 0.002
"""The time step of a model without shapes, as MuJoCo has it."""


wp.config.log_level = wp.LOG_WARNING
logging.getLogger("trimesh").setLevel(
    logging.ERROR
)  # it reads meshes without scipy, and warns with a traceback
with muted_standard_error():
    wp.init()


def is_model(scene: Any) -> bool:
    return isinstance(scene, newton.Model)


def imported(path: Path) -> newton.Model:
    """Return a file as Newton's importer reads it, with the attributes of ``SolverMuJoCo``."""
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    getattr(builder, READERS.get(path.suffix.lower(), "add_usd"))(str(path))
    return builder.finalize(
        device="cpu"
    )  # its arrays are only read, and a GPU may be missing or busy


def report_of(target: Target, request: Request) -> Report:
    """Lint a finalized ``newton.Model``, with ``--engine newton`` by Newton's contacts."""
    model = target.newton_model
    scene = Shapes.of(model, request.engine) if model.shape_count else None
    has_own = (
        scene
        and not kf_unread(scene)
        and (scene.of_geoms("shape_material_kf") > 0.0).any()
    )
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
        creep=predictions(scene, request.load)
        if scene and not has_own
        else [],  # kf gives friction its own timeconst
        newton=newton.__version__,
    )
