"""Reading what is to be linted: a file, or a function that returns a model."""

import contextlib
import importlib
import importlib.util
import logging
import sys
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

import mujoco
import newton
from newton.solvers import SolverMuJoCo

MJCF = ".xml"
READERS = {MJCF: "add_mjcf", ".urdf": "add_urdf", **dict.fromkeys((".usd", ".usda", ".usdc", ".usdz"), "add_usd")}
"""The builder's method for a file, by its ending."""
TIMESTEP_S = 0.002
"""The solver's time step where nothing says another, as MuJoCo has it."""
NO_TRIMESH = "it has meshes, which take two more packages: pip install trimesh scipy"


@dataclass(frozen=True)
class Target:
    """What is linted."""

    model: newton.Model
    timestep_s: float = TIMESTEP_S
    """As the scene says."""


class TargetError(Exception):
    """A target that cannot be linted, said in one line."""


def read_target(target: str) -> Target:
    """The model at a target; what is printed meanwhile goes to the standard error.

    Raises:
        TargetError: There is no such file, module or function, or it gives no model.
    """
    path = Path(target)
    logging.getLogger("trimesh").setLevel(logging.ERROR)  # it reads meshes without scipy, and warns with a traceback
    with contextlib.redirect_stdout(sys.stderr):
        if path.suffix.lower() in READERS:
            return _read_file(path)
        if ":" in target:
            return Target(_model_from(target))
    raise TargetError(f"{target}: is none of FILE.xml, FILE.urdf, FILE.usd, FILE.py:function and module:function")


def _read_file(path: Path) -> Target:
    if not path.is_file():
        raise TargetError(f"{path}: there is no such file")
    timestep_s = _compiled(path).opt.timestep if path.suffix.lower() == MJCF else TIMESTEP_S
    return Target(_model_in(path), timestep_s)


def _compiled(path: Path) -> mujoco.MjModel:
    """MJCF as MuJoCo compiles it, which refuses what Newton's importer passes over, such as a misspelt attribute.

    Without sensors and textures, which decide nothing about contacts, and may be amiss in a file that Newton reads: its
    own nv_humanoid.xml has a sensor of a site that is not there.
    """
    try:
        spec = mujoco.MjSpec.from_file(str(path))
        for material in spec.materials:
            material.textures = [""] * len(material.textures)
        for unread in (*spec.sensors, *spec.textures):
            spec.delete(unread)
        return spec.compile()
    except Exception as error:
        raise TargetError(f"{path}: MuJoCo refuses it: {_line(error)}") from error


def _model_in(path: Path) -> newton.Model:
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    try:
        getattr(builder, READERS[path.suffix.lower()])(str(path))
        return builder.finalize(device="cpu")
    except Exception as error:  # whatever the importers meet in a file that is none of theirs
        raise TargetError(f"{path}: cannot be read: {_said(error)}") from error


def _model_from(target: str) -> newton.Model:
    name, _, function = target.rpartition(":")
    sys.path.insert(0, str(Path(name).parent if name.endswith(".py") else Path.cwd()))
    try:
        found = getattr(_imported(name), function)()
    except Exception as error:  # the code is the user's
        raise TargetError(f"{target}: gives no model: {_said(error)}") from error
    finally:
        sys.path.pop(0)
    if not isinstance(found, newton.Model):
        raise TargetError(f"{target}: returns a {type(found).__name__}, not a finalized newton.Model")
    return found


def _imported(name: str) -> ModuleType:
    """A module by its name, or by its file."""
    if not name.endswith(".py"):
        return importlib.import_module(name)
    spec = importlib.util.spec_from_file_location(f"linted_{Path(name).stem}", name)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # as dataclasses ask for
    spec.loader.exec_module(module)
    return module


def _said(error: Exception) -> str:
    if isinstance(error, ModuleNotFoundError) and error.name == "trimesh":
        return NO_TRIMESH
    return f"{type(error).__name__}: {_line(error)}"


def _line(error: Exception) -> str:
    return " ".join(str(error).split())[:300]
