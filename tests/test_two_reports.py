"""Test that one process builds several reports with equal package names as separate
processes do.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import experiments
import report.sections
from measured_report.commands.new import new
from measured_report.editions.project import Project, own_release
from measured_report.files.atomic import digests_below
from measured_report.files.config import report_in
from measured_report.files.root import ROOT
from measured_report.site.build import build


def pendulum(folder: Path) -> None:
    new(folder)
    text = (folder / "pyproject.toml").read_text()
    (folder / "pyproject.toml").write_text(
        text.replace("numpy==2.4.6", f"numpy=={np.__version__}")
    )


def built(folder: Path) -> dict[str, str]:
    """Return the site that a separate process builds."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "packages/measured-report")}
    subprocess.run(
        [sys.executable, "build.py", "report"],
        cwd=folder,
        env=environment,
        capture_output=True,
        check=True,
    )
    return digests_below(folder / "site")


def built_here(project: Project, monkeypatch) -> dict[str, str]:
    """Return the site that this process builds without a cache."""
    shutil.rmtree(project.site, ignore_errors=True)
    monkeypatch.setenv(
        "XDG_CACHE_HOME", str(project.root / f"cache-{len([*project.root.iterdir()])}")
    )
    build(project)
    return digests_below(project.site)


def project_in(folder: Path) -> Project:
    with report_in(folder):
        return Project(own_release(), own_release=own_release())


@pytest.mark.slow
def test_one_process_builds_two_reports_as_a_process_each_does(
    toy, tmp_path, monkeypatch
):
    """Test builds in turn.

    This process also has the modules and settings of this repository's report, to which
    the toy belongs.
    """
    pendulum(second := tmp_path / "second")
    apart, own = built(second), built_here(toy.project, monkeypatch)
    assert built_here(project_in(second), monkeypatch) == apart
    assert min(len(own), len(apart)) > 10
    assert built_here(toy.project, monkeypatch) == own
    assert (sys.modules["experiments"], sys.modules["report.sections"]) == (
        experiments,
        report.sections,
    )
