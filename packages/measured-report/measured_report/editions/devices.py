"""Devices: where it may be measured, and with which packages."""

import re
import subprocess
from contextlib import suppress
from pathlib import Path

from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.files.root import ROOT
from measured_report.records.code import files, roots_of
from measured_report.records.record import Record

DEVICES = ("cuda", "cpu")
NO_CUDA = "this machine has no CUDA device; DEVICE=cpu measures on its CPU"


def has_cuda() -> bool:
    return bool(_gpus())


def _gpus() -> list[str]:
    """Name this machine's NVIDIA GPUs; none where the driver does not answer."""
    query = ["nvidia-smi", "--query-gpu=name", "--format=csv,noheader"]
    with suppress(OSError, subprocess.CalledProcessError):
        return subprocess.check_output(query, stderr=subprocess.DEVNULL, text=True).splitlines()
    return []


def needs_gpu(section: str, root: Path = ROOT) -> bool:
    """Tell whether numbers depend on the device: a section with ``NEEDS_GPU = False`` stands with those of a GPU."""
    graph = files().graph(roots_of(root))
    file = graph.module(["experiments", section]) or f"{root}/experiments/{section}.py"
    return bool(graph.source(file).top.get("NEEDS_GPU", config().needs_gpu))


def measuring_device(asked: str | None, profile: str) -> str | None:
    """Choose the device to measure on; None where it has to be asked for: full measurements take hours on a CPU."""
    if asked == "cpu" or not (asked or config().needs_gpu):
        return "cpu"
    if has_cuda():
        return "cuda"
    if asked:
        raise UsageError(f"DEVICE=cuda: {NO_CUDA}")
    return "cpu" if profile == "quick" else None


def machine_name(device: str) -> str:
    """Name this machine for a label when it measures on ``device``: by its GPU, or ``cpu``."""
    return device if device == "cpu" else slug("".join(_gpus()[:1]))


def machine_of(record: Record) -> str:
    """Name the machine that measured a record for a label."""
    return "cpu" if record.machine.get("device") == "cpu" else slug(record.processor)


def slug(name: str) -> str:
    return re.sub("[^a-z0-9]+", "-", name.lower()).strip("-")
