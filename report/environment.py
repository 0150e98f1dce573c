"""Environments: another Newton release is measured in one of its own, and the project's lock is not touched."""

import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

from report import ROOT, UsageError
from report.identity import MISSING, package_versions

RELEASE = re.compile(r"[0-9]+(\.[0-9]+)+")
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
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as overrides:
        overrides.write("\n".join(_overrides(packages | {"newton": release})))
        overrides.flush()
        python = folder / "bin" / "python"
        install = [uv, "pip", "install", "--python", python, "--overrides", overrides.name]
        install += ["--requirements", root / "pyproject.toml", "--group", f"{root / 'pyproject.toml'}:dev"]
        for command in ([uv, "venv", "--allow-existing", "--python", sys.executable, folder], install):
            _run(command, release, folder)


def _overrides(packages: Mapping[str, str]) -> list[str]:
    """What takes the place of the project's own pins."""
    names = {"newton": "newton[sim]"}
    versions = {name: "" if version == MISSING else f"=={version}" for name, version in packages.items()}
    return [names.get(name, name) + version for name, version in versions.items()]


def _run(command: list[str | Path], release: str, folder: Path) -> None:
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
