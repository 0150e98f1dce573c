"""Newton's models: read from files that only Newton reads, or returned by a function."""

import logging
from pathlib import Path
from typing import Any

import newton
import warp as wp
from newton.solvers import SolverMuJoCo

from newton_lint.warp_engine import muted_standard_error

READERS = {".xml": "add_mjcf", ".urdf": "add_urdf"}
"""The builder's method for a file, by its ending; of any other USD's."""


wp.config.log_level = wp.LOG_WARNING
logging.getLogger("trimesh").setLevel(logging.ERROR)  # it reads meshes without scipy, and warns with a traceback
with muted_standard_error():
    wp.init()


def is_model(scene: Any) -> bool:
    return isinstance(scene, newton.Model)


def imported(path: Path) -> newton.Model:
    """Return a file as Newton's importer reads it, with the attributes of ``SolverMuJoCo``."""
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    getattr(builder, READERS.get(path.suffix.lower(), "add_usd"))(str(path))
    return builder.finalize(device="cpu")  # its arrays are only read, and a GPU may be missing or busy
