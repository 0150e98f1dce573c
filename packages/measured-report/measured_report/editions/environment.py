"""Environments: one of its own for each edition but the project's, which leaves the lock alone. uv makes them."""

import hashlib
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

MEASURING = (
    "measured_report",
    "msgspec",
    "packaging",
    "tqdm",
    "tomli",
)  # what it imports, the generator included
VERSION = re.compile(r"[0-9]+(\.[0-9]+)*[a-z0-9.]*(\+[a-z0-9.]+)?")
NAME = re.compile(r"[^A-Za-z0-9-].*")
FILTER = "UV_EXCLUDE_NEWER"  # uv's variable for another day than the one on which a release came out
READY = ".ready"  # in an environment that is whole: the digest of what it was made from


def add_group(
    name: str, root: Path, python: Path = Path(sys.executable), kind: str = "group"
) -> None:
    """Install a group, or an ``extra`` that there is, of pyproject.toml; a Python not of the project is left alone."""
    file = root / "pyproject.toml"
    extra = (
        read_toml(file)["project"].get("optional-dependencies", {}).get(name, ())
        if kind == "extra"
        else ()
    )
    if python.parents[2] != root or (kind == "extra" and not extra):
        return
    if python.parents[1].name == ".venv":
        with locked(root):
            _run(
                [
                    "sync",
                    "--frozen",
                    "--inexact",
                    f"--{kind}",
                    name,
                    "--project",
                    str(root),
                ],
                name,
            )
    else:
        _run(
            [
                "pip",
                "install",
                "--python",
                str(python),
                *(extra or ["--group", f"{file}:{name}"]),
            ],
            name,
        )


def python_of(release: Release, packages: Mapping[str, str], root: Path) -> Path:
    """Return the Python that has a release, and the ``packages`` that it was measured with; it is made if need be."""
    settings = release.settings
    package, option = settings.edition, settings.option
    if release.is_installed_with(package_versions(settings)):
        return Path(sys.executable)
    if not release.requirement:
        example = f"a path or git+https://HOST/{package}.git@COMMIT"
        raise UsageError(
            f"{option}={release} does not say where its code is; {example} does"
        )
    folder = environment_of(release, root)
    if release.checkout or not (folder / READY).exists():
        versions = {
            name: version for name, version in packages.items() if name != package
        }
        installs = requirements(
            root, {package: MISSING, **versions, **dict(release.pins)}, settings
        )
        edits = (
            (release.checkout / "pyproject.toml").read_text(encoding="utf-8")
            if release.checkout
            else ""
        )
        pins = [f"{name}=={version}" for name, version in release.pins]
        _make(
            folder,
            f"{option}={release.asked}",
            _asked_for(release, installs),
            pins,
            edits,
        )
    _lend(folder)
    return folder / "bin" / "python"


def _lend(folder: Path) -> None:
    """Let an environment, which has only what is measured, import what measuring takes of the generator's own."""
    lent = folder / "lent"
    lent.mkdir(exist_ok=True)
    for name in MEASURING:
        if spec := find_spec(name):
            link, source = lent / name, Path(str(spec.origin)).parent
            if not link.exists() or link.resolve() != source.resolve():
                link.unlink(missing_ok=True)
                link.symlink_to(source)
    for packages in folder.glob("lib/python*/site-packages"):
        path, text = packages / "measured-report.pth", f"{lent}\n"
        if (
            not path.exists() or path.read_text(encoding="utf-8") != text
        ):  # another process may just begin to read it
            write_file(path, text)


def python_with(name: str, requirements: Sequence[str]) -> Path:
    """Return the Python of ``.venv-<name>``, which has these requirements alone; it is made when it is not there."""
    folder = current().root / f".venv-{name}"
    _make(folder, name, requirements)
    return folder / "bin" / "python"


def environment_of(release: Release, root: Path) -> Path:
    """Name the folder of a release's environment; that of a checkout serves all that is edited in it."""
    name = str(replace(release, machine=""))
    if release.checkout:
        pins = "".join(f"+{pin}" for pin in name.split("+")[2:])
        name = f"{release.checkout.name}-{hashlib.sha256(str(release.checkout).encode()).hexdigest()[:7]}{pins}"
    return root / f".venv-{release.settings.edition_folder(name)}"


def requirements(
    root: Path, packages: Mapping[str, str], settings: Config
) -> list[str]:
    """Read the project's requirements with these versions in the place of its own, ``missing`` ones as they come."""
    for name, version in packages.items():
        if name not in settings.packages or (
            not VERSION.fullmatch(version) and version != MISSING
        ):
            raise ReportError(
                f"{name} {version!r:.60} is no package of this report with a plain version"
            )
    dependencies = (
        read_toml(root / "pyproject.toml").get("project", {}).get("dependencies", ())
    )
    pinned = {name: version for name, version in packages.items() if version != MISSING}
    replaced = {*pinned, settings.edition}.union(*settings.changes.package_groups)
    remaining = [
        requirement
        for requirement in dependencies
        if NAME.sub("", requirement) not in replaced
    ]
    return remaining + [
        f"{settings.requirement_of(name)}=={version}"
        for name, version in pinned.items()
    ]


def _asked_for(release: Release, installs: Sequence[str]) -> list[str]:
    """Write what ``uv pip install`` is told: packages that nobody named are those of the day on which it came out."""
    options = []
    named = [
        requirement.partition("==")[0]
        for requirement in installs
        if "==" in requirement
    ]
    if not os.environ.get(FILTER) and (day := release_date(release)):
        asked = f"{release.settings.option}={release.asked}"
        print(
            f"{asked} came out on {day}; its packages are of that day, and {FILTER}={date.today()} takes later ones"
        )
        options += [
            "--exclude-newer",
            (date.fromisoformat(day) + timedelta(days=1)).isoformat(),
        ]
        options += [
            argument
            for name in named
            for argument in ("--exclude-newer-package", f"{name}=2100-01-01")
        ]
    extras = release.settings.requirement.removeprefix(release.settings.edition)
    target = (
        ["--editable", f"{release.checkout}{extras}"]
        if release.checkout
        else [release.requirement]
    )
    return [*options, *installs, *target]


def _make(
    folder: Path,
    name: str,
    arguments: Sequence[str],
    pins: Sequence[str] = (),
    edits: str = "",
) -> None:
    """Make an environment of what is asked for, unless it is there; ``pins`` count whatever other packages ask for."""
    digest, ready = (
        hashlib.sha256("\n".join([edits, *arguments, *pins]).encode()).hexdigest(),
        folder / READY,
    )
    install, overrides = (
        ["pip", "install", "--python", f"{folder}/bin/python"],
        folder / "overrides.txt",
    )
    with locked(folder.parent):
        if ready.is_file() and ready.read_text(encoding="utf-8") == digest:
            return
        try:
            _run(["venv", "--clear", "--python", sys.executable, str(folder)], name)
            write_file(overrides, "\n".join(pins))
            _run([*install, "--overrides", str(overrides), *arguments], name)
            write_file(ready, digest)
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            raise


def _run(arguments: Sequence[str], name: str) -> None:
    """Run uv, which may take a while; UsageError, one line, with the cause where it fails."""
    tools = (
        current().root / ".venv.tools" / "bin"
    )  # where the Makefile has put it, on a host that has none
    if not (
        uv := shutil.which("uv")
        or shutil.which("uv", path=f"{Path(sys.executable).parent}{os.pathsep}{tools}")
    ):
        raise UsageError(
            f"{name} cannot be installed: uv is not there; https://docs.astral.sh/uv says how to get it"
        )
    if sys.stdout.isatty():  # a log has the one line that says why it failed
        print(f"{name}: uv {' '.join(arguments[:2])} …", flush=True)
    process = subprocess.run(
        [uv, *arguments], stdout=-1, stderr=-2, text=True, errors="replace", check=False
    )
    if process.returncode:
        lines = [
            *filter(
                None, (line.strip(" ×╰─▶\t") for line in process.stdout.splitlines())
            )
        ]
        cause = (
            "".join(" ".join(lines).partition("Because ")[1:])
            or "".join(lines[-1:])
            or "no reason was given"
        )
        raise UsageError(f"{name} cannot be installed: {cause}")
