"""Reading what is to be linted: a file, or a function that returns a model."""

import contextlib
import importlib
import sys
from pathlib import Path

import newton
from newton.solvers import SolverMuJoCo

READERS = {
    ".xml": "add_mjcf",
    ".urdf": "add_urdf",
    **dict.fromkeys((".usd", ".usda", ".usdc", ".usdz"), "add_usd"),
}
"""The builder's method for a file, by its ending."""


class TargetError(Exception):
    """A target that cannot be linted, said in one line."""


def model_of(target: str) -> newton.Model:
    """The model at a target; what is printed meanwhile goes to the standard error.

    Raises:
        TargetError: There is no such file, module or function, or it gives no model.
    """
    path = Path(target)
    with contextlib.redirect_stdout(sys.stderr):
        if path.suffix.lower() in READERS:
            return _model_in(path)
        if ":" in target:
            return _model_from(target)
    raise TargetError(f"{target}: is none of FILE.xml, FILE.urdf, FILE.usd and module:function")


def _model_in(path: Path) -> newton.Model:
    if not path.is_file():
        raise TargetError(f"{path}: there is no such file")
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    try:
        getattr(builder, READERS[path.suffix.lower()])(str(path))
        return builder.finalize(device="cpu")
    except Exception as error:  # whatever the importers meet in a file that is none of theirs
        raise TargetError(f"{path}: cannot be read: {_said(error)}") from error


def _model_from(target: str) -> newton.Model:
    name, _, function = target.rpartition(":")
    sys.path.insert(0, str(Path.cwd()))
    try:
        found = getattr(importlib.import_module(name), function)()
    except Exception as error:  # the code is the user's
        raise TargetError(f"{target}: gives no model: {_said(error)}") from error
    finally:
        sys.path.pop(0)
    if not isinstance(found, newton.Model):
        raise TargetError(f"{target}: returns a {type(found).__name__}, not a finalized newton.Model")
    return found


def _said(error: Exception) -> str:
    return f"{type(error).__name__}: {' '.join(str(error).split())}"[:300]
