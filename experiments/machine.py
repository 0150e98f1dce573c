"""The machine that measures, and the commit that it measures with, as records keep them."""

import hashlib
import os
import platform
import subprocess
from pathlib import Path

import warp as wp

from report import ROOT


def device_kind(device: wp.Device) -> str:
    return "cuda" if device.is_cuda else "cpu"


def machine(device: wp.Device) -> dict[str, str | None]:
    """The machine that measures, as far as a reader needs it to judge a number.

    With the host's digest, the GPU's UUID and the times of two records anyone can tell whether they ran side by side.
    """
    gpu = driver = None
    if device.is_cuda:
        gpu = device.name
        driver = _said("nvidia-smi", "--query-gpu=driver_version", "--format=csv,noheader").split("\n")[0] or None
    return {
        "device": device_kind(device),
        "gpu": gpu,
        "driver": driver,
        "cpu": cpu_name(),
        "cores": str(os.cpu_count()),
        "python": platform.python_version(),
        "host": hashlib.sha256(platform.node().encode()).hexdigest()[:12],
        "gpu_uuid": device.uuid if device.is_cuda else None,
        "system": f"{platform.system()} {platform.machine()}",
    }


def cpu_name() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def commit() -> str | None:
    """The commit that is checked out, with a mark when the working tree differs from it.

    Where only a copy of the tree is, as on a GPU host, the environment's GIT_COMMIT says it; None when nothing does.
    """
    if told := os.environ.get("GIT_COMMIT"):
        return told
    found = _said("git", "describe", "--always", "--abbrev=12", "--exclude=*", "--dirty")
    untracked = _said("git", "ls-files", "--others", "--exclude-standard", "experiments", "assets")
    return f"{found.removesuffix('-dirty')}-dirty" if found and untracked else found or None


def _said(*command: str) -> str:
    """What a command prints; nothing when it fails or is not there."""
    try:
        return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False).stdout.strip()
    except OSError:
        return ""
