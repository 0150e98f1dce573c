"""Environments: another Newton release is measured in one of its own, and the project's lock is not touched."""

import re
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

from report import ROOT, UsageError
from report.records.identity import MISSING, package_versions

RELEASE = re.compile(r"[0-9]+(\.[0-9]+)+")
REQUIREMENT = re.compile(r'^ {4}"([^"]+)",$', re.MULTILINE)
NAME = re.compile(r"[A-Za-z0-9-]+")
PROGRESS = re.compile(r"Resolved|Downloading|Building|Prepared|Installed")
"""How the lines of uv begin that say how far it is; they come only once it knows that the release can be installed."""


def refuse_bad_release(name: str, release: str) -> None:
    """UsageError when what was given as ``name`` can't be a Newton release."""
    if not RELEASE.fullmatch(release):
        raise UsageError(f"{name}={release} is no release number; {name}=1.8.0 is one")


def python_of(release: str, packages: Mapping[str, str], root: Path = ROOT) -> Path:
    """The Python that has a Newton release; its environment is made when it is not there.

    Args:
        release: Newton release.
        packages: Version by package that its earlier measurements were made with, to be installed again; a package
            that is ``missing`` there gets the version that the release asks for.
    """
    if package_versions()["newton"] == release:
        return Path(sys.executable)
    folder = root / f".venv-newton-{release}"
    python, ready = folder / "bin" / "python", folder / ".ready"
    if not ready.exists():
        _set_up(folder, release, packages, root)
        ready.touch()
    return python


def _set_up(folder: Path, release: str, packages: Mapping[str, str], root: Path) -> None:
    uv = shutil.which("uv") or shutil.which("uv", path=str(root / ".venv" / "bin"))
    if not uv:
        raise UsageError(f"NEWTON={release} needs uv to make its environment, and uv is not there")
    project = root / "pyproject.toml"
    python = str(folder / "bin" / "python")
    install = [uv, "pip", "install", "--python", python, "--group", f"{project}:dev"]
    install += requirements(project.read_text(encoding="utf-8"), {**packages, "newton": release})
    for command in ([uv, "venv", "--allow-existing", "--python", sys.executable, str(folder)], install):
        _run(command, release, folder)


def requirements(project: str, packages: Mapping[str, str]) -> list[str]:
    """The project's requirements with these versions of the simulator's packages in the place of its own.

    Args:
        project: Text of pyproject.toml, in which each requirement is a line of its own.
        packages: Version by package; one that is ``missing`` is left to the others, which know which one they take.
    """
    named = {"newton": "newton[sim]"}
    own = [line for line in REQUIREMENT.findall(project) if NAME.match(line)[0] not in packages]
    return own + [f"{named.get(name, name)}=={version}" for name, version in packages.items() if version != MISSING]


def _run(command: list[str], release: str, folder: Path) -> None:
    """Run uv, which takes a while, and pass on what it says of its progress."""
    with subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True) as uv:
        lines = []
        for line in uv.stderr:
            lines.append(line.strip(" ×╰─▶\t\n"))
            if PROGRESS.match(line):
                print(f"{folder.name}: {line.strip()}", flush=True)
    if uv.returncode:
        shutil.rmtree(folder, ignore_errors=True)
        said = [line for line in lines if line]
        raise UsageError(f"NEWTON={release} cannot be installed: {said[-1] if said else 'uv gave no reason'}")
