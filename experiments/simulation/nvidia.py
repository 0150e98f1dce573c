"""Implement NVIDIA's GPUs as accelerators; see ``measured_report.measuring.host``."""

import os
from pathlib import Path

from measured_report.measuring.host import Accelerator
from measured_report.measuring.machine import said

KIND, NOUN = "cuda", "GPU"
VISIBLE = "CUDA_VISIBLE_DEVICES"
NONE = {VISIBLE: ""}  # a process that has initialized CUDA must not be forked
MPS, MPS_FOLDER = "CUDA_MPS_PIPE_DIRECTORY", "/tmp/nvidia-mps"
"""Variable with the folder of NVIDIA's MPS, and its default.

MPS is the daemon through which processes share a GPU.
"""
ALONE = {MPS: "/nonexistent"}
# Numbers of processes that share a GPU. Without MPS only one of them runs at a time.
SHARE_COUNT, MPS_SHARE_COUNT = (
    4,
    16,
)
SHARE_MIB = 2048  # memory of the GPU that each process needs


def accelerators() -> list[Accelerator]:
    """Return the GPUs that this process may use."""
    listing = said(
        "nvidia-smi",
        "--query-gpu=index,uuid,memory.total,name",
        "--format=csv,noheader,nounits",
    )
    gpus = [
        line.split(", ", 3) for line in listing.splitlines() if line.count(", ") > 2
    ]
    if (allowed := os.environ.get(VISIBLE)) is not None:
        names = {name.strip() for name in allowed.split(",")}
        gpus = [gpu for gpu in gpus if names & {*gpu[:2]}]
    # GPUs that share memory with the CPU may not report its size.
    return [
        Accelerator(name, int(size) if size.isdecimal() else 0, {VISIBLE: uuid})
        for _, uuid, size, name in gpus
    ]


def share_count(shared: Accelerator, count: int = 1) -> int:
    has_daemon = (Path(os.environ.get(MPS, MPS_FOLDER)) / "control").exists()
    most = min(
        MPS_SHARE_COUNT if has_daemon else SHARE_COUNT, (os.cpu_count() or 1) // count
    )
    return max(1, min(most, shared.memory_mib // SHARE_MIB))


def driver() -> str | None:
    return (
        said("nvidia-smi", "--query-gpu=driver_version", "--format=csv,noheader").split(
            "\n"
        )[0]
        or None
    )
