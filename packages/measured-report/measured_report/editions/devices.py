"""Devices: where it may be measured."""

import re
import subprocess
from pathlib import Path

from measured_report import ROOT, UsageError
from measured_report.records.identity import module_of, source_at
from measured_report.records.record import Record

DEVICES = ("cuda", "cpu")
NO_CUDA = "this machine has no CUDA device; DEVICE=cpu measures on its CPU"


def has_cuda() -> bool:
    """Whether this machine has an NVIDIA GPU that works."""
    return bool(_gpus())


def _gpus() -> list[str]:
    """The names of this machine's GPUs; none where the driver does not answer."""
    query = ["nvidia-smi", "--query-gpu=name", "--format=csv,noheader"]
    try:
        done = subprocess.run(query, capture_output=True, text=True, check=False)
    except OSError:
        return []
    return done.stdout.splitlines() if done.returncode == 0 else []


def needs_gpu(section: str, root: Path = ROOT) -> bool:
    """Whether a section's numbers depend on the device: those of one with ``NEEDS_GPU = False`` are the same on any.

    It is measured on the CPU wherever that is asked for, and its record stands with those of a GPU.
    """
    file = Path(module_of(section, root))
    return bool(source_at(file, file.relative_to(root).as_posix()).top.get("NEEDS_GPU", True))


def measuring_device(asked: str | None, profile: str) -> str | None:
    """The device to measure on; None when measuring here has to be asked for.

    A CPU never takes the place of a GPU unasked: full measurements would take hours on it.
    """
    if asked == "cpu":
        return asked
    if has_cuda():
        return "cuda"
    if asked:
        raise UsageError(f"DEVICE=cuda: {NO_CUDA}")
    return "cpu" if profile == "quick" else None


def machine_name(device: str) -> str:
    """What this machine is called in a label when it measures on ``device``: by its GPU, or ``cpu``."""
    return device if device == "cpu" else slug("".join(_gpus()[:1]))


def machine_of(record: Record) -> str:
    """What the machine that measured a record is called in a label."""
    return "cpu" if record.machine.get("device") == "cpu" else slug(record.processor)


def slug(name: str) -> str:
    return re.sub("[^a-z0-9]+", "-", name.lower()).strip("-")
