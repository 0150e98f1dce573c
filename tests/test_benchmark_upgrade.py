"""Test that the second report is built from its tracked records by the public interface
only.
"""

import os
import shutil
import subprocess
import sys

import pytest

from measured_report.files.root import ROOT

EXAMPLE = ROOT / "examples" / "benchmark-upgrade"
EDITIONS = ("mujoco-3.3.0", "mujoco-3.7.0", "mujoco-4.0.0")
"""Releases to build: the report's own, one with all sections, and the newest.

Building all twelve takes four times as long.
"""
TRACKED = subprocess.run(
    ["git", "ls-files", "-z", "."],
    cwd=EXAMPLE,
    capture_output=True,
    text=True,
    check=True,
).stdout


@pytest.mark.slow
def test_it_passes_its_own_tests_from_its_tracked_records(tmp_path):
    there = tmp_path / "examples" / "benchmark-upgrade"
    names = filter(None, TRACKED.split("\0"))
    for name in (
        name
        for name in names
        if not name.startswith("results/") or name.split("/")[1] in EDITIONS
    ):
        (there / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(EXAMPLE / name, there / name)
    (tmp_path / "packages").symlink_to(ROOT / "packages")
    packages = os.pathsep.join(map(str, (ROOT / "packages").glob("*")))
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-p",
        "no:cacheprovider",
        "-p",
        "no:xdist",
    ]
    done = subprocess.run(
        command,
        cwd=there,
        env={**os.environ, "PYTHONPATH": packages},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-1000:]
