"""Environments: another Newton release gets one of its own, and the project's lock is not touched."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NoReturn

from report import ROOT, ReportError, UsageError
from report.identity import installed_release

RELEASE = re.compile(r"[0-9]+(\.[0-9]+)+")
OVERRIDES = "newton[sim]=={}\nwarp-lang\nmujoco-warp\nmujoco\n"
"""What takes the place of the project's own pins; newton then says which of the others it takes."""


def enter(release: str, arguments: list[str], root: Path = ROOT) -> None:
    """Return if this is the environment of ``release``, else run ``build.py`` there in place of this."""
    if not RELEASE.fullmatch(release):
        raise UsageError(f"NEWTON={release} is no release number; NEWTON=1.8.0 is one")
    if release != _release_here():
        _run_there(_set_up(release, root), arguments, root)


def _release_here() -> str | None:
    try:
        return installed_release()
    except ReportError:
        return None


def _set_up(release: str, root: Path) -> Path:
    """The Python of the release's environment, which is made when it is not there."""
    folder = root / f".venv-newton-{release}"
    python, ready = folder / "bin" / "python", folder / ".ready"
    if ready.exists():
        return python
    uv = shutil.which("uv") or shutil.which("uv", path=str(root / ".venv" / "bin"))
    if not uv:
        raise UsageError(f"NEWTON={release} needs uv to make its environment, and uv is not there")
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as overrides:
        overrides.write(OVERRIDES.format(release))
        overrides.flush()
        install = [uv, "pip", "install", "--python", python, "--overrides", overrides.name]
        install += ["--requirements", root / "pyproject.toml", "--group", f"{root / 'pyproject.toml'}:dev"]
        for command in ([uv, "venv", "--allow-existing", "--python", sys.executable, folder], install):
            _run(command, release, folder)
    ready.touch()
    return python


def _run(command: list[str | Path], release: str, folder: Path) -> None:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        shutil.rmtree(folder, ignore_errors=True)
        lines = [line.strip(" ×╰─▶\t") for line in done.stderr.splitlines() if line.strip()]
        raise UsageError(f"NEWTON={release} cannot be installed: {lines[-1] if lines else 'uv gave no reason'}")


def _run_there(python: Path, arguments: list[str], root: Path) -> NoReturn:
    sys.stdout.flush()
    os.execv(python, [str(python), str(root / "build.py"), *arguments])
