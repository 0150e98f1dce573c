"""What the simulator has to do with the machine that it measures on; see ``measured_report.measuring.host``."""

from importlib.metadata import version

import warp as wp
from tqdm import tqdm

from experiments.simulation.measurement import Conditions
from measured_report.files.errors import ReportError
from measured_report.measuring.batch import NOT_COMPILED
from measured_report.measuring.machine import NO_CUDA
from measured_report.records.provenance import package_versions

__all__ = ["Conditions", "be_quiet", "explained", "gpu", "prepare"]


def warp_device(kind: str | None) -> wp.Device:
    """Return the Warp device to measure on; ReportError when it is not there.

    Args:
        kind: ``cuda``, ``cpu``, or None for CUDA where there is one.
    """
    be_quiet()
    wp.init()
    if kind is None:
        kind = "cuda" if wp.is_cuda_available() else "cpu"
    if kind == "cuda" and not wp.is_cuda_available():
        raise ReportError(f"DEVICE=cuda: {NO_CUDA}")
    return wp.get_device("cuda:0" if kind == "cuda" else "cpu")


def gpu(kind: str) -> tuple[str | None, str | None]:
    """Return name and uuid of the GPU to measure on; see ``warp_device``."""
    found = warp_device(kind)
    return (found.name, found.uuid) if found.is_cuda else (None, None)


def prepare(kind: str) -> None:
    """Compile what the sections need; ReportError where this release can't run the scene."""
    from experiments.simulation import kernels  # which brings much that only this needs

    tqdm.write("Kernels that this machine has not compiled yet come first, for a minute or so.")
    found = warp_device(kind)
    if reason := kernels.compile_first(found):
        newton, oldest = package_versions()["newton"], ".".join(map(str, kernels.OLDEST))
        raise ReportError(f"newton {newton} cannot run the scene: {reason}; {oldest} is the oldest that can")


def be_quiet() -> None:
    """Let Warp say errors only, and leave out gradients, a third of compiling; before it meets a kernel."""
    if hasattr(wp, "LOG_ERROR"):  # Warp of old releases has none, and they are told what else they lack
        wp.config.log_level = wp.LOG_ERROR
    wp.config.enable_backward = False


def explained(error: Exception) -> str:
    """Return what an error of Warp means, in a line; it has printed what the compiler says."""
    said = " ".join(str(error).split())
    found = NOT_COMPILED.search(said)
    return f"its kernels can't be compiled by Warp {version('warp-lang')} ({said:.200})" if found else ""
