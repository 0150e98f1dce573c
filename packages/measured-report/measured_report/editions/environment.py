"""Create the environments of editions with uv.

The project's own edition uses the project's environment. Every other edition has a
separate environment.
"""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import date, timedelta
from importlib.util import find_spec
from pathlib import Path

from measured_report.editions.release import Release, release_date
from measured_report.files.atomic import locked, write_file
from measured_report.files.config import Config, read_toml
from measured_report.files.config import report as current
from measured_report.files.errors import ReportError, UsageError
from measured_report.records.identity import MISSING, package_versions

MEASURING = ("measured_report", "msgspec", "packaging", "tqdm", "tomli")
"""Packages that the generator imports while measuring, including itself."""
VERSION = re.compile(r"[0-9]+(\.[0-9]+)*[a-z0-9.]*(\+[a-z0-9.]+)?")
NAME = re.compile(r"[^A-Za-z0-9-].*")
# This variable of uv overrides the date of the release.
FILTER = "UV_EXCLUDE_NEWER"
READY = ".ready"  # a file in a complete environment with the digest of its requirements


def add_group(name: str, root: Path, python: Path = Path(sys.executable)) -> None:
    """Install a dependency group of pyproject.toml into the project's environments.

    Do nothing if the Python belongs to another environment.
    """
    if python.parents[2] != root:
        return
    if python.parents[1].name != ".venv":
        group = f"{root / 'pyproject.toml'}:{name}"
        _run(["pip", "install", "--python", str(python), "--group", group], name)
        return
    with locked(root):
        # --inexact keeps packages that other groups need.
        options = ["--frozen", "--inexact", "--group", name]
        _run(["sync", *options, "--project", str(root)], name)


def python_of(release: Release, packages: Mapping[str, str], root: Path) -> Path:
    """Return a Python that has a release and the ``packages`` it was measured with.

    The environment is created if it does not exist.
    """
    settings = release.settings
    package = settings.edition
    if release.is_installed_with(package_versions(settings)):
        return Path(sys.executable)
    if not release.requirement:
        example = f"git+https://HOST/{package}.git@COMMIT"
        raise UsageError(
            f"{settings.option}={release} does not include the address of its code: "
            f"use {example}"
        )
    label = replace(release, machine="")
    folder = root / f".venv-{settings.edition_folder(str(label))}"
    pins = [f"{name}=={version}" for name, version in release.pins]
    # A package that pyproject.toml lists later is added. Versions that the records name
    # do not count, because they are those that the environment already has.
    declared = [
        *_other_requirements(root, settings.packages, settings),
        *pins,
        release.requirement,
    ]
    if not _is_ready(folder, declared):
        # The release itself is added below, because it may be a commit.
        versions = {**packages, package: MISSING, **dict(release.pins)}
        installs = requirements(root, versions, settings)
        name = f"{settings.option}={release.spec}"
        options = _date_options(release, name, installs)
        arguments = [*options, *installs, release.requirement]
        _make(folder, name, arguments, declared, pins)
    _link_generator(folder)
    return folder / "bin" / "python"


def _link_generator(folder: Path) -> None:
    """Link the packages that measuring imports from the generator into an environment.

    The environment itself contains only the measured packages.
    """
    lent = folder / "lent"
    lent.mkdir(exist_ok=True)
    for name in MEASURING:
        if spec := find_spec(name):
            link = lent / name
            source = Path(str(spec.origin)).parent
            if not link.exists() or link.resolve() != source.resolve():
                link.unlink(missing_ok=True)
                link.symlink_to(source)
    for packages in folder.glob("lib/python*/site-packages"):
        path = packages / "measured-report.pth"
        # Write it only if it differs, because another process may be reading it.
        if not path.exists() or path.read_text(encoding="utf-8") != f"{lent}\n":
            write_file(path, f"{lent}\n")


def python_with(name: str, requirements: Sequence[str]) -> Path:
    """Return the Python of ``.venv-<name>`` with exactly these requirements.

    The environment is created if it does not exist.
    """
    folder = current().root / f".venv-{name}"
    _make(folder, name, requirements, requirements)
    return folder / "bin" / "python"


def requirements(
    root: Path, packages: Mapping[str, str], settings: Config
) -> list[str]:
    """Return the project's requirements, with these versions of packages.

    Packages with the version ``missing`` get no version.
    """
    pinned = {}
    for name, version in packages.items():
        is_version = version == MISSING or VERSION.fullmatch(version)
        if name not in settings.packages or not is_version:
            raise ReportError(
                f"{name} {version!r:.60} cannot be installed: use a package of "
                "report.toml with a plain version such as 1.2.3"
            )
        if version != MISSING:
            pinned[name] = f"{settings.requirement_of(name)}=={version}"
    return [
        *_other_requirements(root, [*pinned, settings.edition], settings),
        *pinned.values(),
    ]


def _other_requirements(
    root: Path, packages: Sequence[str], settings: Config
) -> list[str]:
    """Return the project's requirements, except those of ``packages`` and their groups."""
    replaced = {*packages}.union(*settings.changes.package_groups)
    project = read_toml(root / "pyproject.toml").get("project", {})
    dependencies = project.get("dependencies", ())
    return [line for line in dependencies if NAME.sub("", line) not in replaced]


def _date_options(release: Release, name: str, installs: Sequence[str]) -> list[str]:
    """Return uv's options for the newest packages on the release date.

    They do not apply to requirements with a version.
    """
    day = release_date(release)
    if os.environ.get(FILTER) or not day:
        return []
    print(
        f"{name} was released on {day}, so packages of that day are installed; "
        f"{FILTER}={date.today()} allows later ones"
    )
    # uv would take a date as one of the local time zone, and include that day.
    next_day = date.fromisoformat(day) + timedelta(days=1)
    options = ["--exclude-newer", f"{next_day}T00:00:00Z"]
    for requirement in installs:
        package, has_version, _ = requirement.partition("==")
        if has_version:
            options += ["--exclude-newer-package", f"{package}=2100-01-01"]
    return options


def _is_ready(folder: Path, declared: Sequence[str]) -> bool:
    """Return whether an environment is complete and was made for these requirements."""
    ready = folder / READY
    return ready.is_file() and ready.read_text(encoding="utf-8") == "\n".join(declared)


def _make(
    folder: Path,
    name: str,
    arguments: Sequence[str],
    declared: Sequence[str],
    pins: Sequence[str] = (),
) -> None:
    """Create an environment, unless one exists that is ready for ``declared``.

    The versions in ``pins`` replace those that other packages require.
    """
    overrides = folder / "overrides.txt"
    install = ["pip", "install", "--python", f"{folder}/bin/python"]
    with locked(folder.parent):
        if _is_ready(folder, declared):
            return
        try:
            # The folder is cleared, because a killed process may have left a part of an
            # environment.
            _run(["venv", "--clear", "--python", sys.executable, str(folder)], name)
            write_file(overrides, "\n".join(pins))
            _run([*install, "--overrides", str(overrides), *arguments], name)
            write_file(folder / READY, "\n".join(declared))
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            raise


def _run(arguments: Sequence[str], name: str) -> None:
    """Run uv, which may take minutes; raise UsageError with the cause if it fails."""
    # The Makefile installs uv into .venv.tools on hosts without it.
    folders = [Path(sys.executable).parent, current().root / ".venv.tools" / "bin"]
    path = os.pathsep.join([os.environ.get("PATH", ""), *map(str, folders)])
    uv = shutil.which("uv", path=path)
    if not uv:
        raise UsageError(
            f"{name} cannot be installed, because uv is missing: see "
            "https://docs.astral.sh/uv"
        )
    if sys.stdout.isatty():
        print(f"{name}: uv {' '.join(arguments[:2])} …", flush=True)
    process = subprocess.run(
        [uv, *arguments], stdout=-1, stderr=-2, text=True, errors="replace", check=False
    )
    if process.returncode:
        lines = [line.strip(" ×╰─▶\t") for line in process.stdout.splitlines()]
        lines = [*filter(None, lines)] or ["uv gave no reason"]
        _, because, cause = " ".join(lines).partition("Because ")
        raise UsageError(f"{name} cannot be installed: {because + cause or lines[-1]}")
