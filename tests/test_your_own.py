"""Test docs/your-own.md line by line with the generator's wheel only: a page, a claim,
a release, an alarm.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from measured_report.files.root import ROOT

DOCUMENT = (ROOT / "docs" / "your-own.md").read_text(encoding="utf-8")
FILE = re.compile(
    r"`([\w/.]+)` (?:measures|derives|contains)[^`]*?.*?\n\n```\w+\n(.*?)```", re.DOTALL
)
SCRIPT = re.compile(r"values are better:\n\n```python\n(.*?)```", re.DOTALL)
LINES = re.compile(r"^ {4}(make .*)$", re.MULTILINE)
UV = Path(sys.executable).with_name("uv")
MOST_BYTES = 320 << 20  # SciPy is a third of the installation


def files() -> dict[str, str]:
    return dict(FILE.findall(DOCUMENT))


def run(*command: str | Path, cwd: Path) -> str:
    settings = {
        name: value
        for name, value in os.environ.items()
        if name not in ("PYTHONPATH", "MAKEFLAGS")
    }
    settings["PATH"] = f"{UV.parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        command, cwd=cwd, env=settings, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


@pytest.mark.slow
@pytest.mark.skipif(
    not UV.exists(), reason="there is no uv to install a new report with"
)
def test_the_document_works_line_by_line(tmp_path):
    run(
        UV,
        "build",
        "--wheel",
        "--quiet",
        ROOT / "packages/measured-report",
        "-o",
        tmp_path,
        cwd=tmp_path,
    )
    [wheel] = tmp_path.glob("*.whl")
    command = ["uvx", "--isolated", "--from", str(wheel), "measured-report"]
    try:
        run(*command, "new", "my-report", cwd=tmp_path)
        report = tmp_path / "my-report"
        first, second, *others = LINES.findall(DOCUMENT)
        run(*first.split(), cwd=report)
    except AssertionError as error:
        if re.search(r"(?i)dns|network|connect|failed to fetch|timed out", str(error)):
            pytest.skip("there is no index to install a new report from")
        raise
    run(*second.split(), cwd=report)
    assert (
        sum(path.lstat().st_size for path in (report / ".venv").rglob("*")) < MOST_BYTES
    )
    for name, text in files().items():
        (report / name).write_text(text, encoding="utf-8")
    run(sys.executable, "-c", SCRIPT.search(DOCUMENT)[1], cwd=report)
    said = {line: run(*line.split(), cwd=report) for line in others}
    assert "holds        ball.euler_rises_more" in said["make check"]
    assert "flipped: no claim" in said["make upgrade NUMPY=2.2.6"]
    assert (tmp_path / "published" / "index.html").is_file()


def test_the_tests_of_the_skeleton_are_not_collected_with_those_of_the_packages():
    """Test that these tests are not collected here, because they need the modules of a
    new report.
    """
    options = ["-c", "pyproject.toml", "--collect-only", "-n", "0"]
    folder = "packages/measured-report/measured_report"
    command = [sys.executable, "-m", "pytest", *options, folder]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, check=False)
    assert done.returncode == pytest.ExitCode.NO_TESTS_COLLECTED, done.stdout
