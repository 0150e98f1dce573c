"""Apply the patches here to the released packages, run tests before and after, and write ``checked.json``.

python -m assets.upstream.check
"""

import hashlib
import json
import math
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from experiments.cure.turntable import MJCF, RADIUS_M, TURN_RAD_S
from measured_report.editions.environment import python_with

HERE = Path(__file__).parent
CHECKED = HERE / "checked.json"
PACKAGES = ("mujoco-warp==4.0.0", "mujoco==4.0.0", "newton==1.8.0", "warp-lang==1.19.0", "numpy==2.4.6")
PATCHES = {"mujoco_warp": HERE / "mujoco_warp-4.0.0.patch", "newton": HERE / "newton-1.8.0.patch"}
OWN = ("mujoco_warp/_src/constraint_test.py", "mujoco_warp/_src/forward_test.py")
"""MuJoCo Warp's tests of constraints and of forward dynamics."""
NEW = ("mujoco_warp/_src/contact_jdotv_test.py", "newton/tests/test_mujoco_contact_jdotv.py")
TURNTABLE = """
import json, sys
import mujoco, mujoco_warp as mjw
mjcf, qvel, step_count = json.loads(sys.argv[1])
model = mujoco.MjModel.from_xml_string(mjcf)
data = mujoco.MjData(model)
data.qvel[:] = qvel
mujoco.mj_forward(model, data)
m, places = mjw.put_model(model), {}
for option in (False, True) if hasattr(m.opt, "contact_jdotv") else (False,):
    m.opt.contact_jdotv = option
    d = mjw.put_data(model, data)
    for _ in range(step_count):
        mjw.step(m, d)
    places[option] = d.qpos.numpy()[0].tolist()
print(json.dumps(places))
"""
"""A program that says where the box on the turning table ends, without the term and, where there is one, with it."""
STEP_COUNT = 500


def digests() -> dict[str, str]:
    return {patch.name: hashlib.sha256(patch.read_bytes()).hexdigest() for patch in PATCHES.values()}


def environment() -> Path:
    """Return the Python that has the released packages; UsageError where they can't be had."""
    return python_with("upstream", (*PACKAGES, "pytest==9.2.0", "absl-py==2.5.1"))


def copied(python: Path, folder: Path) -> Path:
    """Copy the released packages into a folder."""
    command = [python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
    site = Path(subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip())
    for package in PATCHES:
        shutil.copytree(site / package, folder / package, ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def patched(folder: Path) -> Path:
    """Apply the patches to the packages in a folder."""
    for patch in PATCHES.values():
        command = ["patch", "-p1", "--silent", "--forward", "--fuzz=0", f"--input={patch}"]
        subprocess.run(command, cwd=folder, check=True)
    return folder


def counts(python: Path, folder: Path, *tests: str) -> dict[str, int]:
    """Count the tests that passed, failed and were skipped, of the packages in a folder."""
    command = [python, "-m", "pytest", "-q", "-p", "no:cacheprovider", *tests]
    last = run(command, folder).strip().splitlines()[-1].partition(" in ")[0]
    return {outcome: int(count) for count, outcome in re.findall(r"(\d+) (?!warning)([a-z]+)", last)}


def turntable(python: Path, folder: Path) -> dict[str, list[float]]:
    """Return the last state of the box on the turning table, by whether its contacts have the term."""
    asked = json.dumps([MJCF, [TURN_RAD_S, 0.0, TURN_RAD_S * RADIUS_M, 0.0, 0.0, 0.0, TURN_RAD_S], STEP_COUNT])
    return json.loads(run([python, "-c", TURNTABLE, asked], folder).splitlines()[-1])


def run(command: Sequence[str | Path], folder: Path) -> str:
    """Return what a command prints that finds the packages in a folder."""
    settings = {**os.environ, "PYTHONPATH": str(folder)}
    return subprocess.run(command, cwd=folder, env=settings, capture_output=True, text=True, check=False).stdout


def walk_mm(place: Sequence[float]) -> float:
    return 1e3 * (math.hypot(place[1], place[2]) - RADIUS_M)


def main() -> None:
    python = environment()
    with tempfile.TemporaryDirectory() as first, tempfile.TemporaryDirectory() as second:
        released, changed = copied(python, Path(first)), patched(copied(python, Path(second)))
        before, after = turntable(python, released), turntable(python, changed)
        checked = {
            "packages": PACKAGES,
            "patches": digests(),
            "own_before": counts(python, released, *OWN),
            "own_after": counts(python, changed, *OWN),
            "new": {Path(test).stem: counts(python, changed, test) for test in NEW},
            "same_when_off": before["false"] == after["false"],
            "walk_mm": {option: round(walk_mm(place), 4) for option, place in after.items()},
        }
    CHECKED.write_text(json.dumps(checked, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
