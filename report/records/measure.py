"""Measuring, which another process does: nothing here knows the simulator."""

import os
import subprocess
from functools import partial

from report import ReportError
from report.records.environment import python_of
from report.records.files import refuse_unwritable
from report.records.processes import end_with
from report.records.project import Project
from report.records.status import expected_packages


def measure(project: Project, sections: list[str], device: str) -> None:
    """Measure the sections in one process, which loads the simulator's kernels once; ReportError if any failed.

    A release that is not installed here is measured by the Python of its own environment.
    """
    refuse_unwritable(project.results)
    python = python_of(project.release, expected_packages(project), project.root)
    options = ["--device", device, "--profile", project.profile]
    command = [str(python), "-m", "experiments.run", *sections, *options]
    # It ends with this process: nobody would know of it otherwise.
    beginning = partial(end_with, os.getpid())
    status = subprocess.run(command, cwd=project.root, check=False, preexec_fn=beginning).returncode
    if status:
        raise ReportError(f"measuring ended with exit status {status}; what was there is kept")
