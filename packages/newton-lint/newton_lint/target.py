"""Reading what is to be linted: a file, or a function that returns a model of MuJoCo's or Newton's."""

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
"""One of them is in a file that a folder is searched for; ``<mujocoinclude>`` is no root."""
INCLUDE = re.compile(rb"""<include\s[^>]*file\s*=\s*["']([^"']+)""")
NEWTONS = "newton_lint.newton_models.report"
NEEDS_NEWTON = "takes Newton and what it reads meshes and USD with: pip install 'newton-lint[newton]'"


@dataclass(frozen=True)
class Target:
    """What is linted."""

    name: str
    model: MjModel | None
    """None of a Newton model."""
    newton_model: Any = None
    """A finalized ``newton.Model``, where the target is one or is read by Newton."""
    path: Path | None = None
    """The file of MJCF or URDF."""
    data: MjData | None = None
    """A state that a function returns beside its model."""
    texts: Mapping[Path, bytes] = field(default_factory=dict)
    """What files are taken to hold in place of what they do, where a change is tried."""


class TargetError(Exception):
    """A target that cannot be linted, said in one line."""


def targets_of(names: Sequence[str], exclude: Sequence[str] = ()) -> Iterator[str]:
    """Yield the targets, folders replaced by the scenes in them that are not hidden; TargetError where one has none."""
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
            raise TargetError(f"{name}: has no scene")
        # MJCF that others include has <mujoco> as its root too, and is read with them.
        pieces = {piece for path in scenes for piece in _included(path)}
        yield from (str(path) for path in scenes if path.resolve() not in pieces)


def _is_scene(path: Path) -> bool:
    is_readable = path.suffix.lower() in MUJOCOS and os.access(
        path, os.R_OK
    )  # or it is said when it is read
    return not is_readable or bool(ROOTS.search(path.read_bytes()))


def _included(path: Path) -> Iterator[Path]:
    """Yield the files that a scene includes, which may be no scenes of their own."""
    with contextlib.suppress(OSError):
        for match in INCLUDE.finditer(path.read_bytes()):
            yield (path.parent / match[1].decode(errors="replace")).resolve()


def read_target(target: str) -> Target:
    """Return the model at a target, or raise TargetError; what is printed meanwhile goes to the standard error."""
    path = Path(target)
    with contextlib.redirect_stdout(sys.stderr):
        if path.suffix.lower() in ENDINGS:
            return _read_file(target, path)
        if ":" in target:
            return _of(target, _returned(target))
    raise TargetError(
        f"{target}: is none of FILE.xml, FILE.urdf, FILE.usd, FILE.py:function and module:function"
    )


def _read_file(target: str, path: Path) -> Target:
    if not path.is_file() or not os.access(path, os.R_OK):
        raise TargetError(
            f"{path}: {'cannot be read' if path.exists() else 'there is no such file'}"
        )
    if path.suffix.lower() in USD:
        return Target(target, None, newtons(target, NEWTONS, "imported", path))
    try:
        return Target(target, compiled(path), path=path)
    except (
        ValueError,
        TypeError,
        mujoco.FatalError,
    ) as error:  # a TypeError of a name that is no text
        raise TargetError(f"{path}: MuJoCo refuses it: {_line(error)}") from error


def tried(target: Target, texts: Mapping[Path, bytes]) -> Target:
    """Return a target as it would be if files held other texts; a ValueError where MuJoCo refuses it."""
    assert target.path is not None  # only what a file describes is changed
    return replace(target, model=compiled(target.path, texts), texts=texts)


def compiled(path: Path, texts: Mapping[Path, bytes] | None = None) -> MjModel:
    """Compile a file, or texts in place of what files hold; a ValueError where MuJoCo refuses it."""
    try:
        return MjModel.from_xml_path(
            str(path), {str(file): text for file, text in (texts or {}).items()}
        )
    except ValueError:
        if texts:
            raise
        # Sensors and textures decide nothing, and a scene is often copied without its pictures.
        with contextlib.suppress(Exception):  # before MuJoCo 3.3.4 MjSpec has no delete
            return _without_pictures(mujoco.MjSpec.from_file(str(path)))
        raise


def _without_pictures(spec: Any) -> MjModel:
    for material in spec.materials:
        material.textures = [""] * len(
            material.textures
        )  # or spec.compile asks for what is deleted
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
    except (Exception, SystemExit) as error:  # the code is the user's
        raise TargetError(
            f"{target}: gives no model: {type(error).__name__}: {_line(error)}"
        ) from error
    finally:
        sys.path.pop(0)


def _of(target: str, scene: Any) -> Target:
    """Return a target of what a function returns: a model, an MjSpec, or a model with its data, or what has them."""
    data = None
    if isinstance(scene, tuple) and len(scene) == 2:
        scene, data = scene
    elif hasattr(scene, "model") and hasattr(scene, "data"):
        scene, data = scene.model, scene.data
    if hasattr(scene, "compile") and hasattr(scene, "worldbody"):
        try:
            scene = scene.compile()
        except ValueError as error:
            raise TargetError(f"{target}: MuJoCo refuses it: {_line(error)}") from error
    if isinstance(scene, MjModel):
        return Target(target, scene, data=data if isinstance(data, MjData) else None)
    if "newton" in sys.modules and newtons(target, NEWTONS, "is_model", scene):
        return Target(target, None, scene)
    raise TargetError(
        f"{target}: returns a {type(scene).__name__}, and no model of MuJoCo's or Newton's"
    )


def newtons(target: str, module: str, function: str, *arguments: Any) -> Any:
    """Ask the part for Newton's models, which takes seconds to import; TargetError where Newton is missing or fails."""
    try:
        return attrgetter(function)(importlib.import_module(module))(*arguments)
    except ImportError as error:
        raise TargetError(f"{target}: {NEEDS_NEWTON} ({_line(error)})") from error
    except (
        Exception
    ) as error:  # whatever the importers meet in a file that is none of theirs
        raise TargetError(
            f"{target}: cannot be read: {type(error).__name__}: {_line(error)}"
        ) from error


def _line(error: BaseException) -> str:
    return " ".join(str(error).split())[:300]
