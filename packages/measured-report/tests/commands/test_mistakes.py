"""Test mistakes in a new report: each of them is reported in one line with its place
and a remedy, or has no effect.
"""

import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from measured_report.commands.new import new
from measured_report.files.root import ROOT

X = "experiments/pendulum.py"
RECORD = "results/quick/numpy-@/pendulum.json"
Changes = dict[str, Callable[[str], str]]
ALL_AT_ONCE: Changes = {
    X: lambda text: text.replace("= max(map(abs, changes))", '= float("nan")'),
    RECORD: lambda _: "{",
}
"""A number that is not one, and a damaged record that is measured again."""
MISTAKES: list[tuple[Changes, list[str]]] = [
    (
        ALL_AT_ONCE,
        [
            "pendulum: 10 rows in",
            "cannot raise an alarm: euler: the measurement gave nan",
            "built",
        ],
    ),
    (
        {X: lambda text: text.replace("    seconds =", "    1 / 0\n    seconds =", 1)},
        [r"experiments/pendulum\.py:\d+: ZeroDivisionError", "built"],
    ),
    (
        {"report.toml": lambda text: text.replace('edition = "numpy"', "")},
        ['add edition = "NAME"'],
    ),
]


def report(folder: Path) -> str:
    settings = {**os.environ, "PYTHONPATH": str(ROOT / "packages" / "measured-report")}
    command = [sys.executable, "build.py", "report", "--profile", "quick"]
    done = subprocess.run(
        command, cwd=folder, env=settings, stdout=-1, stderr=-2, text=True, check=False
    )
    return done.stdout


@pytest.mark.slow
@pytest.mark.parametrize(("changes", "lines"), MISTAKES)
def test_a_mistake_is_one_line(tmp_path, changes, lines):
    """Test mistakes in a report whose files have the line breaks of Windows."""
    new(folder := tmp_path / "a folder" / "mine")
    for name, change in changes.items():
        path = folder / name.replace("@", np.__version__)
        path.parent.mkdir(parents=True, exist_ok=True)
        before = path.read_text() if path.exists() else ""
        path.write_text(change(before))
        assert path.read_text() != before
    for path in folder.rglob("*"):
        if path.suffix in (".py", ".toml", ".j2", ".cff"):
            text = path.read_text().replace("numpy==2.4.6", f"numpy=={np.__version__}")
            path.write_text(text, newline="\r\n")
    found = report(folder)
    assert "Traceback" not in found, found
    for line in lines:
        assert re.search(line, found), found
