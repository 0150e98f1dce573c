"""Reads a target: a file, or a function that returns a MuJoCo or Newton model."""

import contextlib
import importlib
import os
import re
import runpy
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fnmatch import fnmatch
from operator import attrgetter
from pathlib import Path
from typing import Any

import mujoco
from mujoco import MjData, MjModel

MUJOCOS = (".xml", ".urdf")
USD = (".usd", ".usda", ".usdc", ".usdz")
ENDINGS = (*MUJOCOS, *USD)
ROOTS = re.compile(rb"<(mujoco|robot)[\s>/]")
"""Matches the root of a scene, which ``<mujocoinclude>`` is not."""
INCLUDE = re.compile(rb"""<include\s[^>]*file\s*=\s*["']([^"']+)""")
NEWTONS = "newton_lint.newton_models.report"


@dataclass(frozen=True)
class Target:
    """A scene to lint."""

    name: str
    model: MjModel | None
    """The MuJoCo model; None for a Newton model."""
    newton_model: Any = None
    """A finalized ``newton.Model``, if Newton reads the target."""
    path: Path | None = None
    """The MJCF or URDF file."""
    data: MjData | None = None
    """The state that a function returns together with its model."""
    texts: Mapping[Path, bytes] = field(default_factory=dict)
    """Contents that replace those of files while a change is tried."""


class TargetError(Exception):
    """A target cannot be linted. The message is one line."""


def targets_of(names: Sequence[str], exclude: Sequence[str] = ()) -> Iterator[str]:
    """Yield the targets, with each folder replaced by the scenes in it.

    Raises:
        TargetError: A folder has no scene.
    """
    for name in names:
        if not Path(name).is_dir() or Path(name).suffix.lower() in ENDINGS:
            yield name
            continue
        paths = (
            path
            for path in sorted(Path(name).rglob("*"))
            if "/." not in f"/{path.relative_to(name).as_posix()}"
        )
        files = [
            path for path in paths if path.suffix.lower() in ENDINGS and path.is_file()
        ]
        excluded = {
            path
            for path in files
            for glob in exclude
            if fnmatch(str(path), glob) or path.match(glob)
        }
        scenes = [path for path in files if path not in excluded and _is_scene(path)]
        if not scenes:
            raise TargetError(f"{name}: this folder has no scene")
        # Included MJCF has <mujoco> as its root too, but it is read with its scene.
        pieces = {piece for path in scenes for piece in _included(path)}
        yield from (str(path) for path in scenes if path.resolve() not in pieces)


def _is_scene(path: Path) -> bool:
    # A file that cannot be read raises an error later.
    is_readable = path.suffix.lower() in MUJOCOS and os.access(path, os.R_OK)
    return not is_readable or bool(ROOTS.search(path.read_bytes()))


def _included(path: Path) -> Iterator[Path]:
    """Yield the files that a scene includes."""
    with contextlib.suppress(OSError):
        for match in INCLUDE.finditer(path.read_bytes()):
            yield (path.parent / match[1].decode(errors="replace")).resolve()


def read_target(target: str) -> Target:
    """Return the scene at a target.

    Output that is printed meanwhile goes to standard error.

    Raises:
        TargetError: There is no scene at the target.
    """
    path = Path(target)
    with contextlib.redirect_stdout(sys.stderr):
        if path.suffix.lower() in ENDINGS:
            return _read_file(target, path)
        if ":" in target:
            return target_of(_returned(target), target)
    raise TargetError(
        f"{target}: expected FILE.xml, FILE.urdf, FILE.usd, FILE.py:function or"
        " module:function"
    )


def _read_file(target: str, path: Path) -> Target:
    if not path.is_file() or not os.access(path, os.R_OK):
        raise TargetError(
            f"{path}: the file"
            f" {'cannot be read' if path.exists() else 'does not exist'}"
        )
    if path.suffix.lower() in USD:
        return Target(target, None, newtons(target, NEWTONS, "imported", path))
    try:
        return Target(target, compiled(path), path=path)
    # MuJoCo raises a TypeError for a path that is not text.
    except (ValueError, TypeError, mujoco.FatalError) as error:
        raise TargetError(f"{path}: MuJoCo refuses it: {_line(error)}") from error


def tried(target: Target, texts: Mapping[Path, bytes]) -> Target:
    """Return a target with other file contents; ValueError if MuJoCo refuses them."""
    assert target.path is not None  # Only scenes that come from a file are changed.
    return replace(target, model=compiled(target.path, texts), texts=texts)


def compiled(path: Path, texts: Mapping[Path, bytes] | None = None) -> MjModel:
    """Compile a file, with other contents if given.

    Raises:
        ValueError: MuJoCo refuses the file.
    """
    try:
        return MjModel.from_xml_path(
            str(path), {str(file): text for file, text in (texts or {}).items()}
        )
    except ValueError:
        if texts:
            raise
        # Sensors and textures affect no rule, and scenes often lack their textures.
        with contextlib.suppress(
            Exception
        ):  # MjSpec has no delete before MuJoCo 3.3.4.
            return _without_pictures(mujoco.MjSpec.from_file(str(path)))
        raise


def _without_pictures(spec: Any) -> MjModel:
    for material in spec.materials:
        # Otherwise spec.compile would look for the deleted textures.
        material.textures = [""] * len(material.textures)
    for unread in (*spec.sensors, *spec.textures):
        spec.delete(unread)
    return spec.compile()


def _returned(target: str) -> Any:
    name, _, function = target.rpartition(":")
    sys.path.insert(0, str(Path(name).parent if name.endswith(".py") else Path.cwd()))
    try:
        names = (
            runpy.run_path(name)
            if name.endswith(".py")
            else vars(importlib.import_module(name))
        )
        return names[function]()
    except (Exception, SystemExit) as error:  # This is the user's code.
        raise TargetError(
            f"{target}: the function failed with {type(error).__name__}: {_line(error)}"
        ) from error
    finally:
        sys.path.pop(0)


def target_of(scene: Any, target: str = "scene") -> Target:
    """Return the target for an object, such as the return value of a function.

    It may be a model, an MjSpec, a ``newton.ModelBuilder``, a tuple of a model and its
    data, an object that has both, or the path of a file.
    """
    if isinstance(scene, str | Path):
        return read_target(str(scene))
    data = None
    if isinstance(scene, tuple) and len(scene) == 2:
        scene, data = scene
    elif hasattr(scene, "model") and hasattr(scene, "data"):
        data = scene.data
        scene = scene.model
    if hasattr(scene, "compile") and hasattr(scene, "worldbody"):
        try:
            scene = scene.compile()
        except ValueError as error:
            raise TargetError(f"{target}: MuJoCo refuses it: {_line(error)}") from error
    if isinstance(scene, MjModel):
        return Target(target, scene, data=data if isinstance(data, MjData) else None)
    if "newton" in sys.modules and (
        model := newtons(target, NEWTONS, "finalized", scene)
    ):
        return Target(target, None, model)
    raise TargetError(
        f"{target}: expected a MuJoCo or Newton model, got a {type(scene).__name__}"
    )


def newtons(target: str, module: str, function: str, *arguments: Any) -> Any:
    """Call a function of the modules for Newton, which take seconds to import.

    Raises:
        TargetError: Newton is missing or cannot read the target.
    """
    try:
        return attrgetter(function)(importlib.import_module(module))(*arguments)
    except ImportError as error:
        raise TargetError(
            f"{target}: this needs Newton and its importers:"
            f" pip install 'newton-lint[newton]' ({_line(error)})"
        ) from error
    except Exception as error:  # The importers raise errors of any kind.
        raise TargetError(
            f"{target}: cannot be read: {type(error).__name__}: {_line(error)}"
        ) from error


def _line(error: BaseException) -> str:
    return " ".join(str(error).split())[:300]
