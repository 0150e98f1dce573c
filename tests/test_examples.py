"""Test that each example can be built from its tracked records."""

import os
import shutil
import subprocess
import sys

import pytest

from measured_report.files.root import ROOT

EXAMPLES = {
    # The default edition, one with all sections, and the newest one. Building all
    # twelve takes four times as long.
    "benchmark-upgrade": ("mujoco-3.3.0", "mujoco-3.7.0", "mujoco-4.0.0"),
    "ode-solvers": ("scipy-1.17.1",),
    "package-benchmark": ("idna-3.13.0", "idna-3.14.0"),
}
LINE_LIMIT = 120


def tracked(name: str) -> list[str]:
    """Return the tracked files of an example."""
    command = ["git", "ls-files", "-z", "."]
    folder = ROOT / "examples" / name
    listed = subprocess.check_output(command, cwd=folder, text=True)
    return list(filter(None, listed.split("\0")))


@pytest.mark.parametrize("example", ["ode-solvers", "package-benchmark"])
def test_a_small_example_stays_small(example):
    folders = ("experiments", "report", "templates")
    names = [name for name in tracked(example) if name.startswith(folders)]
    texts = [(ROOT / "examples" / example / name).read_text() for name in names]
    assert len("".join(texts).splitlines()) < LINE_LIMIT


@pytest.mark.slow
@pytest.mark.parametrize("example", EXAMPLES)
def test_it_passes_its_own_tests_from_its_tracked_records(tmp_path, example):
    there = tmp_path / "examples" / example
    for name in tracked(example):
        if name.startswith("results/") and name.split("/")[1] not in EXAMPLES[example]:
            continue
        (there / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / "examples" / example / name, there / name)
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
