"""Measuring, which another process does: nothing here knows the simulator."""

import shutil
import subprocess

from report import ReportError, UsageError
from report.records.environment import python_of
from report.records.project import Project
from report.records.status import expected_packages

DEVICES = ("cuda", "cpu")
NO_CUDA = "this machine has no CUDA device; DEVICE=cpu measures on its CPU"


def has_cuda() -> bool:
    """Whether this machine has an NVIDIA GPU that works."""
    if not shutil.which("nvidia-smi"):
        return False
    listing = subprocess.run(["nvidia-smi", "-L"], capture_output=True, text=True, check=False)
    return listing.returncode == 0 and "GPU" in listing.stdout


def measuring_device(asked: str | None, profile: str) -> str | None:
    """The device to measure on; None when measuring here has to be asked for.

    A CPU never takes the place of a GPU unasked: full measurements would take hours on it.
    """
    if asked not in (None, *DEVICES):
        raise UsageError(f"DEVICE={asked} is no device; use one of: {', '.join(DEVICES)}")
    if asked == "cpu":
        return asked
    if has_cuda():
        return "cuda"
    if asked:
        raise UsageError(f"DEVICE=cuda: {NO_CUDA}")
    return "cpu" if profile == "quick" else None


def measure(project: Project, sections: list[str], device: str) -> None:
    """Measure the sections in one process, which loads the simulator's kernels once; ReportError if any failed.

    A release that is not installed here is measured by the Python of its own environment.
    """
    python = python_of(project.release, expected_packages(project), project.root)
    options = ["--device", device, "--profile", project.profile]
    command = [str(python), "-m", "experiments.run", *sections, *options]
    status = subprocess.run(command, cwd=project.root, check=False).returncode
    if status:
        raise ReportError(f"measuring ended with exit status {status}; what was there is kept")
