"""Newton's models: read from files that only Newton reads, or returned by a function."""

import contextlib
import logging
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import newton
import warp as wp
from newton.solvers import SolverMuJoCo

READERS = {".xml": "add_mjcf", ".urdf": "add_urdf"}
"""The builder's method for a file, by its ending; of any other USD's."""


@contextlib.contextmanager
def _muted_standard_error() -> Iterator[None]:
    """Return what Warp's library writes goes nowhere: of a machine without a GPU it warns, and the lint takes none."""
    kept, nowhere = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nowhere)


wp.config.log_level = wp.LOG_WARNING
logging.getLogger("trimesh").setLevel(logging.ERROR)  # it reads meshes without scipy, and warns with a traceback
with _muted_standard_error():
    wp.init()


def is_model(found: Any) -> bool:
    return isinstance(found, newton.Model)


def imported(path: Path) -> newton.Model:
    """Return a file as Newton's importer reads it, with the attributes of ``SolverMuJoCo``."""
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    getattr(builder, READERS.get(path.suffix.lower(), "add_usd"))(str(path))
    return builder.finalize(device="cpu")
