"""Test mistakes in a new report: each of them is reported in one line with its place
and a remedy, or has no effect.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from measured_report.commands.new import new
from measured_report.files.root import ROOT

X = "experiments/pendulum.py"
MISTAKES = [
    (
        X,
        '"case": case,',
        '"cas": case,',
        "measure returns no rows or a row without a case",
    ),
    (
        X,
        "    seconds =",
        "    1 / 0\n    seconds =",
        r"experiments/pendulum\.py:\d+: ZeroDivisionError",
    ),
    (
        X,
        "= max(map(abs, changes))",
        '= float("nan")',
        "cannot raise an alarm: euler: the measurement gave nan",
    ),
    ("report.toml", 'edition = "numpy"', "", 'add edition = "NAME"'),
    ("results/quick/*/pendulum.json", '"rows"', '"row"', "pendulum: 10 rows in"),
    ("*", "\n", "\r\n", "built"),
]


def report(folder: Path) -> str:
    settings = {**os.environ, "PYTHONPATH": str(ROOT / "packages" / "measured-report")}
    command = [sys.executable, "build.py", "report", "--profile", "quick"]
    done = subprocess.run(
        command, cwd=folder, env=settings, stdout=-1, stderr=-2, text=True, check=False
    )
    return done.stdout


@pytest.fixture(scope="module")
def measured(tmp_path_factory) -> Path:
    new(folder := tmp_path_factory.mktemp("a folder") / "mine")
    text = (folder / "pyproject.toml").read_text()
    (folder / "pyproject.toml").write_text(
        text.replace("numpy==2.4.6", f"numpy=={np.__version__}")
    )
    assert "built" in report(folder)
    return folder


@pytest.mark.slow
@pytest.mark.parametrize(("names", "old", "put", "said"), MISTAKES)
def test_a_mistake_is_one_line(measured, names, old, put, said):
    folder = shutil.copytree(
        measured, measured.with_name("planted"), dirs_exist_ok=True
    )
    for path in [
        each
        for each in folder.rglob(names)
        if each.suffix in (".py", ".toml", ".j2", ".json", ".cff")
    ]:
        path.write_bytes(
            (text := path.read_bytes()).replace(
                old.encode(), put.encode(), 1 if put.strip() else -1
            )
        )
        assert path.read_bytes() != text or names == "*"
    found = report(folder)
    assert "Traceback" not in found and [
        line for line in found.splitlines() if re.search(said, line)
    ], found
