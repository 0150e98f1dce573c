"""A change that is planted in the simulator is named first and ends with status 1; a harmless one with 0 and no move.

Each is a wheel, made of the package that is installed, and goes the way of any upgrade, in quick runs on the CPU.
"""

import importlib.metadata
import json
import os
import re
import shutil
import site
import subprocess
import sys
import venv
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest
from conftest import SOURCES, link, made_once, program

from measured_report.editions.environment import READY, environment_of
from measured_report.editions.project import own_release
from measured_report.editions.release import release_of
from measured_report.files.root import ROOT

pytestmark = pytest.mark.slow
BUILDER, KERNELS, SOLVER = "sim/builder.py", "solvers/mujoco/kernels.py", "solvers/mujoco/solver_mujoco.py"
DECIDING_SECTIONS = ["upgrade", "defaults"]
DECIDING = re.compile(r"^deciding = .*$", re.MULTILINE)
TIMECONST = "timeconst = 2.0 / (kd * d_width)"
FRICTION = '"""The coefficient of friction."""'
LESS = (
    ("upgrade.py", "[*RUNS, *(KF_RUNS if compat.kf_is_read() else ())]", "[AS_SHIPPED, STIFF_PADS]"),
    ("simulation/measurement.py", "QUICK_FRAME_COUNT = 420", "QUICK_FRAME_COUNT = 300"),
)
"""What the copy measures less of: two runs, and 1.5 s of the shake."""
INTEGRATOR = "integrator = mujoco.mjtIntegrator.mjINT_"


@dataclass(frozen=True)
class Plant:
    """A change of the package's code, and what the verdict has to say first, and its status."""

    edits: Sequence[tuple[str, str, str]]
    """Each a file, a text in it, and what takes its place."""
    leads: Sequence[str]
    names: Sequence[str]
    """What later lines name."""
    status: int = 1


PLANTS = {
    "many": Plant(
        [
            (BUILDER, "kf: float = 1000.0", "kf: float = 850.0"),
            (BUILDER, "mu: float = 1.0\n", "mu: float = 0.8\n"),
            (SOLVER, f"{INTEGRATOR}IMPLICITFAST", f"{INTEGRATOR}EULER"),
            (KERNELS, TIMECONST, f"{TIMECONST} * 1.15"),
        ],
        ["geom_solref", "default-kf 1000 → 850", "default-mu 1 → 0.8", "solver-integrator 3 → 0"],
        ["alarm: penetration", "make bisect CLAIM=defaults.as_the_scene"],
    ),
    "timeconst-3": Plant(
        [(KERNELS, TIMECONST, f"{TIMECONST} * 1.03")], ["geom_solref"], ["timeconst 0.002 s → 0.00206 s, +3 %"], 0
    ),
    "harmless": Plant([(BUILDER, FRICTION, f"{FRICTION}  # and no more")], ["all as they were"], ["moved: nothing"], 0),
}


@pytest.fixture(scope="module")
def project(tmp_path_factory) -> Path:
    """A copy of the report that upgrades by two runs and the defaults, with what the installed release gives."""

    def make(root: Path) -> None:
        link(root, "CITATION.cff", "LICENSE", *(name for name in SOURCES if name not in ("report.toml", "experiments")))
        shutil.copytree(ROOT / "experiments", root / "experiments", ignore=shutil.ignore_patterns("__pycache__"))
        for file, old, new in LESS:
            text = (root / "experiments" / file).read_text()
            assert text.count(old) == 1
            (root / "experiments" / file).write_text(text.replace(old, new))
        (root / "build.py").write_text((ROOT / "build.py").read_text())
        (root / "report.toml").write_text(
            DECIDING.sub(f"deciding = {json.dumps(DECIDING_SECTIONS)}", (ROOT / "report.toml").read_text())
        )
        paths = os.pathsep.join(map(str, [root, *(root / "packages").iterdir()]))
        options = [*DECIDING_SECTIONS, "--profile", "quick", "--device", "cpu"]
        done = program("-m", "measured_report.measuring.run", *options, cwd=root, PYTHONPATH=paths)
        assert done.returncode == 0, done.stderr

    return made_once(tmp_path_factory, "planted", make)


def build(root: Path, *options: str) -> subprocess.CompletedProcess:
    command = [sys.executable, "build.py", *options, "--profile", "quick", "--device", "cpu"]
    return subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)


def wheel_with(edits: Sequence[tuple[str, str, str]], folder: Path) -> Path:
    """Make a wheel of the installed package with other texts in its files."""
    wheel = folder / f"newton-{own_release()}-py3-none-any.whl"
    with zipfile.ZipFile(wheel, "w") as archive:
        for file in importlib.metadata.files("newton"):
            content = file.locate().read_bytes()
            for old, new in [texts for name, *texts in edits if str(file) == f"newton/_src/{name}"]:
                assert content.count(old.encode()) == 1, file
                content = content.replace(old.encode(), new.encode())
            archive.writestr(str(file), content)
    return wheel


def install(wheel: Path, root: Path) -> None:
    """Make its environment of the one that runs the tests, with the wheel's package in the place of its own."""
    folder = environment_of(release_of(str(wheel)), root)
    venv.create(folder, symlinks=True)
    packages = next(folder.glob("lib/python*/site-packages"))
    zipfile.ZipFile(wheel).extractall(packages)
    [about] = packages.glob("newton-*.dist-info")
    (about / "direct_url.json").write_text(f'{{"url": "{wheel.as_uri()}", "archive_info": {{}}}}')
    (packages / "tests.pth").write_text("\n".join(site.getsitepackages()))
    (folder / READY).touch()


@pytest.mark.parametrize("name", PLANTS)
def test_a_planted_change_is_named_first_and_a_harmless_one_is_none(name, project, tmp_path):
    plant = PLANTS[name]
    wheel = wheel_with(plant.edits, tmp_path)
    install(wheel, project)
    done = build(project, "upgrade", f"--newton={wheel}")
    lines = [line for line in done.stdout.splitlines() if re.match("Newton .* against", line)]
    verdict = done.stdout.partition(lines[0])[2].splitlines()
    assert all(lead in verdict[1] for lead in plant.leads), done.stdout
    assert all(name in "\n".join(verdict[2:]) for name in plant.names), done.stdout
    assert done.returncode == plant.status
