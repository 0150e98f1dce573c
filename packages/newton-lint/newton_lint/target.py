"""Reading what is to be linted: a file, or a function that returns a model of MuJoCo's or Newton's."""

import contextlib
import importlib
import importlib.util
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import mujoco

MUJOCOS = (".xml", ".urdf", ".mjb")
USD = (".usd", ".usda", ".usdc", ".usdz")
ENDINGS = (*MUJOCOS, *USD)
ROOTS = (b"<mujoco", b"<robot")
"""One of them is in a file that a folder is searched for."""
READER = "newton_lint.newton_models.reader"
NEEDS_NEWTON = "takes Newton, which does not come with the lint: pip install 'newton-lint[newton]'"


@dataclass(frozen=True)
class Target:
    """What is linted."""

    name: str
    model: mujoco.MjModel | None
    """None of a Newton model."""
    newton_model: Any = None
    """A finalized ``newton.Model``, where the target is one or is read by Newton."""
    path: Path | None = None
    """The file of MJCF or URDF."""
    data: mujoco.MjData | None = None
    """A state that a function returns beside its model."""


class TargetError(Exception):
    """A target that cannot be linted, said in one line."""


def found_in(names: list[str]) -> Iterator[str]:
    """Yield the targets, with folders replaced by the scenes within them.

    Raises:
        TargetError: A folder has none.
    """
    for name in names:
        if not Path(name).is_dir():
            yield name
            continue
        files = [path for path in sorted(Path(name).rglob("*")) if path.suffix.lower() in ENDINGS and _is_scene(path)]
        if not files:
            raise TargetError(f"{name}: has no scene")
        yield from map(str, files)


def _is_scene(path: Path) -> bool:
    return path.suffix.lower() not in (".xml", ".urdf") or any(root in path.read_bytes() for root in ROOTS)


def read_target(target: str) -> Target:
    """Return the model at a target; what is printed meanwhile goes to the standard error.

    Raises:
        TargetError: There is no such file, module or function, or it gives no model.
    """
    path = Path(target)
    with contextlib.redirect_stdout(sys.stderr):
        if path.suffix.lower() in ENDINGS:
            return _read_file(target, path)
        if ":" in target:
            return _of(target, _returned(target))
    raise TargetError(f"{target}: is none of FILE.xml, FILE.urdf, FILE.usd, FILE.py:function and module:function")


def _read_file(target: str, path: Path) -> Target:
    if not path.is_file():
        raise TargetError(f"{path}: there is no such file")
    if path.suffix.lower() in USD:
        return Target(target, None, newtons(target, READER, "imported", path))
    try:
        return Target(target, compiled(path), path=path)
    except (ValueError, mujoco.FatalError) as error:
        raise TargetError(f"{path}: MuJoCo refuses it: {_line(error)}") from error


def compiled(path: Path) -> mujoco.MjModel:
    """Compile a file; without sensors and textures, which decide nothing, where those are what is amiss.

    Raises:
        ValueError: MuJoCo refuses it.
    """
    try:
        binary = path.suffix.lower() == ".mjb"
        return (mujoco.MjModel.from_binary_path if binary else mujoco.MjModel.from_xml_path)(str(path))
    except ValueError:
        with contextlib.suppress(Exception):  # of old releases MjSpec has no such function, or cannot delete
            return _without_pictures(mujoco.MjSpec.from_file(str(path)))
        raise


def _without_pictures(spec: Any) -> mujoco.MjModel:
    for material in spec.materials:
        material.textures = [""] * len(material.textures)
    for unread in (*spec.sensors, *spec.textures):
        spec.delete(unread)
    return spec.compile()


def _returned(target: str) -> Any:
    name, _, function = target.rpartition(":")
    sys.path.insert(0, str(Path(name).parent if name.endswith(".py") else Path.cwd()))
    try:
        return getattr(_imported(name), function)()
    except Exception as error:  # the code is the user's
        raise TargetError(f"{target}: gives no model: {type(error).__name__}: {_line(error)}") from error
    finally:
        sys.path.pop(0)


def _of(target: str, found: Any) -> Target:
    """Return a target of what a function returns: a model, an MjSpec, or a model with its data, or what has them."""
    data = None
    if isinstance(found, tuple) and len(found) == 2:
        found, data = found
    elif hasattr(found, "model") and hasattr(found, "data"):
        found, data = found.model, found.data
    if hasattr(found, "compile") and hasattr(found, "worldbody"):
        try:
            found = found.compile()
        except ValueError as error:
            raise TargetError(f"{target}: MuJoCo refuses it: {_line(error)}") from error
    if isinstance(found, mujoco.MjModel):
        return Target(target, found, data=data if isinstance(data, mujoco.MjData) else None)
    if "newton" in sys.modules and newtons(target, READER, "is_model", found):
        return Target(target, None, found)
    raise TargetError(f"{target}: returns a {type(found).__name__}, and no model of MuJoCo's or Newton's")


def newtons(target: str, module: str, function: str, *given: Any) -> Any:
    """Ask the part for Newton's models, which takes seconds to import, and so is imported where it is needed.

    Raises:
        TargetError: Newton is not installed, or fails.
    """
    try:
        part = importlib.import_module(module)
    except ImportError as error:
        raise TargetError(f"{target}: {NEEDS_NEWTON} ({_line(error)})") from error
    try:
        return getattr(part, function)(*given)
    except Exception as error:  # whatever the importers meet in a file that is none of theirs
        raise TargetError(f"{target}: cannot be read: {type(error).__name__}: {_line(error)}") from error


def _imported(name: str) -> ModuleType:
    if not name.endswith(".py"):
        return importlib.import_module(name)
    spec = importlib.util.spec_from_file_location(f"linted_{Path(name).stem}", name)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # as dataclasses ask for
    spec.loader.exec_module(module)
    return module


def _line(error: BaseException) -> str:
    return " ".join(str(error).split())[:300]
