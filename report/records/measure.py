"""Measuring, which another process does: nothing here knows the simulator."""

import json
import os
import subprocess
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from report import ReportError
from report.records.environment import python_of
from report.records.files import refuse_unwritable
from report.records.processes import end_with
from report.records.project import Project
from report.records.status import expected_packages


def measure(project: Project, sections: list[str], device: str) -> None:
    """Measure the sections in one process, which loads the simulator's kernels once; ReportError if any failed."""
    refuse_unwritable(project.results)
    _run(project, "experiments.run", *sections, "--device", device, "--profile", project.profile)


def measure_headline(project: Project, device: str) -> Mapping[str, Any]:
    """Measure the headline and keep nothing of it; what ``experiments.headline`` writes: machine, rows and seconds."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / "headline.json"
        _run(project, "experiments.headline", "--device", device, "--json", str(path))
        return json.loads(path.read_text(encoding="utf-8"))


def _run(project: Project, module: str, *options: str) -> None:
    """Run a module of the experiments; ReportError when it fails.

    A release that is not installed here is measured by the Python of its own environment.
    """
    python = python_of(project.release, expected_packages(project), project.root)
    # It ends with this process: nobody would know of it otherwise.
    beginning = partial(end_with, os.getpid())
    command = [str(python), "-m", module, *options]
    status = subprocess.run(command, cwd=project.root, check=False, preexec_fn=beginning).returncode
    if status:
        raise ReportError(f"measuring ended with exit status {status}; what was there is kept")
