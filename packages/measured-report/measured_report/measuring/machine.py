"""Machines that measure: which devices there are, and the machine and the commit, as records and labels say them."""

import hashlib
import os
import platform
import re
import subprocess
from pathlib import Path
from typing import NamedTuple

from measured_report.files.config import cached_in_report, config, report
from measured_report.files.errors import UsageError
from measured_report.measuring.host import host
from measured_report.records.code import files, roots_of
from measured_report.records.record import Record

DEVICES = ("cuda", "cpu")
NO_CUDA = "this machine has no CUDA device; DEVICE=cpu measures on its CPU"
KIND = ("device", "gpu", "driver", "cpu", "cores")  # what of a machine is the same for all batches of a section
MPS, MPS_FOLDER = "CUDA_MPS_PIPE_DIRECTORY", "/tmp/nvidia-mps"
"""Variable that says where NVIDIA's MPS is, the daemon through which processes share a GPU, and its default."""
SHARE_COUNT, MPS_SHARE_COUNT = 4, 16  # processes that share a GPU: without that daemon they take turns on it
SHARE_MIB = 2048  # memory of a GPU that there has to be for each of them


class Gpu(NamedTuple):
    uuid: str
    memory_mib: int
    name: str


@cached_in_report
def machine(kind: str) -> dict[str, str | None]:
    """Return the machine that measures; host and GPU tell of two records whether they ran side by side."""
    (gpu, uuid), driver = host().gpu(kind), None
    if kind == "cuda":
        driver = said("nvidia-smi", "--query-gpu=driver_version", "--format=csv,noheader").split("\n")[0] or None
    node, system = hashlib.sha256(platform.node().encode()).hexdigest(), f"{platform.system()} {platform.machine()}"
    devices = {"device": kind, "gpu": gpu, "driver": driver, "cpu": cpu_name(), "cores": str(os.cpu_count())}
    return {**devices, "python": platform.python_version(), "host": node[:12], "gpu_uuid": uuid, "system": system}


def cpu_name() -> str:
    path = Path("/proc/cpuinfo")
    named = re.search(r"^model name\s*:(.*)", path.read_text(encoding="utf-8") if path.exists() else "", re.MULTILINE)
    return named[1].strip() if named else platform.processor() or platform.machine()


def commit() -> str | None:
    """Return the commit that is checked out, marked where the tree differs; of a copy the environment's GIT_COMMIT."""
    if told := os.environ.get("GIT_COMMIT"):
        return told
    found = said("git", "describe", "--always", "--abbrev=12", "--exclude=*", "--dirty")
    untracked = said("git", "ls-files", "--others", "--exclude-standard", "experiments", "assets")
    return f"{found.removesuffix('-dirty')}-dirty" if found and untracked else found or None


def said(*command: str) -> str:
    """Return what a command prints; nothing when it fails or is not there."""
    try:
        return subprocess.run(command, cwd=report().root, capture_output=True, text=True, check=False).stdout.strip()
    except OSError:
        return ""


def gpus() -> list[Gpu]:
    """List the GPUs that this process may use."""
    listing = said("nvidia-smi", "--query-gpu=index,uuid,memory.total,name", "--format=csv,noheader,nounits")
    there = [line.split(", ", 3) for line in listing.splitlines() if line.count(", ") > 2]
    if (allowed := os.environ.get("CUDA_VISIBLE_DEVICES")) is not None:
        names = {name.strip() for name in allowed.split(",")}
        there = [each for each in there if names & {*each[:2]}]
    # What shares memory with the processor may not say how much it has.
    return [Gpu(uuid, int(size) if size.isdecimal() else 0, name) for _, uuid, size, name in there]


def share_count(gpu: Gpu, gpu_count: int = 1) -> int:
    has_daemon = (Path(os.environ.get(MPS, MPS_FOLDER)) / "control").exists()
    most = min(MPS_SHARE_COUNT if has_daemon else SHARE_COUNT, (os.cpu_count() or 1) // gpu_count)
    return max(1, min(most, gpu.memory_mib // SHARE_MIB))


def needs_gpu(section: str, root: Path) -> bool:
    """Tell whether numbers depend on the device: a section with ``NEEDS_GPU = False`` stands with those of a GPU."""
    graph = files().graph(roots_of(root))
    file = graph.module(f"experiments.{section}") or f"{root}/experiments/{section}.py"
    return bool(graph.source(file).top.get("NEEDS_GPU", config().needs_gpu))


def measuring_device(asked: str | None, profile: str) -> str | None:
    """Choose the device to measure on; None where it has to be asked for: full measurements take hours on a CPU."""
    if asked == "cpu" or not (asked or config().needs_gpu):
        return "cpu"
    if gpus():
        return "cuda"
    if asked:
        raise UsageError(f"DEVICE=cuda: {NO_CUDA}")
    return "cpu" if profile == "quick" else None


def machine_name(device: str) -> str:
    """Name this machine for a label when it measures on ``device``: by its GPU, or ``cpu``."""
    return device if device == "cpu" else slug(gpus()[0].name if gpus() else "")


def machine_of(record: Record) -> str:
    return "cpu" if record.machine.get("device") == "cpu" else slug(record.processor)


def slug(name: str) -> str:
    return re.sub("[^a-z0-9]+", "-", name.lower()).strip("-")
