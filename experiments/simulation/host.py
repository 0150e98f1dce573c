"""Implement the host of the simulator; see ``measured_report.measuring.host``."""

import os
import re
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from importlib.metadata import version

import warp as wp
from packaging.version import Version
from tqdm import tqdm

from experiments.facts.case import AS_SHIPPED
from experiments.simulation import forward_only, paired_timing  # noqa: F401
from experiments.simulation.kernels import Launch, has_begun, is_bare, scene_kernels
from experiments.simulation.measurement import Conditions
from experiments.simulation.simulation import Simulation
from measured_report.files.errors import ReportError
from measured_report.files.processes import workers
from measured_report.measuring.machine import lacks
from measured_report.measuring.pool import gather, start
from measured_report.records.identity import package_versions

# a chosen value: with more processes, all wait for the largest module
PROCESS_COUNT = 16
# There are more shares than modules of a frame, so that a process that has finished one
# takes the next.
SHARE_COUNT = 64
DEVICE_LOST = re.compile(
    "(?i)cuda error|cudaerror|device-side|driver|unspecified launch failure|graph capture"
)
NOT_COMPILED = re.compile("kernel build failed|nvrtc", re.IGNORECASE)
OLDEST = "1.4.0"  # the oldest release that can run the scene
__all__ = ["Conditions", "be_quiet", "card", "explained", "note_work", "prepare"]


def warp_device(kind: str | None) -> wp.Device:
    """Return the Warp device to measure on; raise ReportError if it does not exist.

    Args:
        kind: ``cuda``, ``cpu``, or None for CUDA if it is available.
    """
    be_quiet()
    wp.init()
    if kind is None:
        kind = "cuda" if wp.is_cuda_available() else "cpu"
    if kind == "cuda" and not wp.is_cuda_available():
        raise ReportError(f"DEVICE=cuda: {lacks()}")
    return wp.get_device("cuda:0" if kind == "cuda" else "cpu")


def card(kind: str) -> tuple[str | None, str | None]:
    """Return the name and the UUID of the GPU to measure on; see ``warp_device``."""
    device = warp_device(kind)
    return (device.name, device.uuid) if device.is_cuda else (None, None)


def prepare(kind: str) -> None:
    """Compile the kernels of the sections.

    Raise ReportError if this release cannot run the scene.
    """
    tqdm.write(
        "Kernels that this machine has not compiled yet come first, for a minute or three."
    )
    if reason := compile_first(kind):
        packages = package_versions()
        names = ", ".join(f"{name} {version}" for name, version in packages.items())
        is_old = Version(packages["newton"]) < Version(OLDEST)
        hint = f"; {OLDEST} is the oldest that can" if is_old else ""
        raise ReportError(f"{names} cannot run the scene: {reason}{hint}")


def compile_first(kind: str) -> str:
    """Compile the kernels of all sections by running a frame of the scene.

    Return the reason if the scene cannot run at all. Other errors are left to the
    measurement.
    """
    began = time.perf_counter()
    try:
        if is_bare():
            _compile_beside(kind)
        device = warp_device(kind)
        Simulation([replace(AS_SHIPPED, frame_count=1)], device).step()
        wp.synchronize_device(device)
    except ReportError:
        raise
    except (AttributeError, ImportError, TypeError) as missing:
        return " ".join(str(missing).split())[:200]
    except Exception as error:
        tqdm.write(
            f"kernels are compiled as they are met: {' '.join(str(error).split())[:200]}"
        )
    else:
        tqdm.write(f"kernels are ready after {time.perf_counter() - began:.0f} s")
    return ""


def _compile_beside(kind: str) -> None:
    """Compile the kernels of a simulation and its frame in parallel processes.

    A fork has imported all modules, but it cannot use a device that this process has
    started to use. It also cannot use locks that another thread may hold, such as a
    worker of a cluster.
    """
    method = "spawn" if has_begun() or threading.active_count() > 1 else "fork"
    with workers(min(PROCESS_COUNT, os.cpu_count() or 1), method, be_quiet) as pool:
        gather(
            start(pool, _compile, [(kind, index) for index in range(SHARE_COUNT)]),
            "kernels",
        )


def _compile(kind: str, index: int) -> None:
    """Compile a share of the kernels.

    Most of the time is spent in Python, which generates the code, so shares need
    processes.
    """
    device = warp_device(kind)
    for module, block_dim in list(scene_kernels(device.alias))[index::SHARE_COUNT]:
        module.load(device, block_dim=block_dim)


def be_quiet() -> None:
    """Let Warp print only errors."""
    # Old releases of Warp do not have this setting. ``compile_first`` reports the
    # features that they lack.
    if hasattr(
        wp,
        "LOG_ERROR",
    ):
        wp.config.log_level = wp.LOG_ERROR


def note_work(note: Callable[[str], None]) -> None:
    """Note the name and the size of every kernel that is launched or captured from now
    on. Timed functions then run for only one look, so that the noted work does not
    depend on speed.
    """
    paired_timing.LOOK_COUNT = 1
    for name in ("launch", "launch_tiled"):
        setattr(wp, name, partial(_noted, note, getattr(wp, name)))


def _noted(
    note: Callable[[str], None], launch: Launch, kernel: wp.Kernel, *args, **options
) -> object:
    note(f"{kernel.key} {options['dim'] if 'dim' in options else args[0]}")
    return launch(kernel, *args, **options)


def explained(error: Exception) -> str:
    """Return a line that explains an error of Warp.

    Warp has already printed the messages of the compiler.
    """
    message = " ".join(str(error).split())
    if DEVICE_LOST.search(message):
        return f"the device does not answer ({message:.200}); nvidia-smi says whether it is there"
    match = NOT_COMPILED.search(message)
    return (
        f"its kernels can't be compiled by Warp {version('warp-lang')} ({message:.200})"
        if match
        else ""
    )
