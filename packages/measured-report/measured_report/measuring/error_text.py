"""Texts of errors: why measuring failed, in a line."""

import re

from measured_report.files.errors import ReportError
from measured_report.measuring.host import host

OUT_OF_MEMORY = re.compile("out of memory|failed to allocate|cannot allocate|bad_alloc", re.IGNORECASE)
DEVICE_LOST = re.compile(
    "cuda error|cudaerror|device-side|driver|unspecified launch failure|graph capture", re.IGNORECASE
)
NOT_COMPILED = re.compile("kernel build failed|nvrtc", re.IGNORECASE)


def reason_of(error: Exception) -> str:
    """Say why measuring failed, in one line, with what to do."""
    said = " ".join(str(error).split())
    if is_out_of_memory(error):
        return f"the memory is too small ({said:.200}); free some of it, or PROFILE=quick measures small grids"
    if DEVICE_LOST.search(said):
        return f"the device does not answer ({said:.200}); nvidia-smi says whether it is there"
    if explained := host().explained(error):
        return explained
    if isinstance(error, OSError):
        said = error.strerror or said  # one that was raised with words alone has no other reason
        said = f"{error.filename}: {said}" if error.filename else said
    return said or type(error).__name__


def is_out_of_memory(error: Exception) -> bool:
    return isinstance(error, MemoryError) or bool(OUT_OF_MEMORY.search(str(error)))


def is_expected(error: Exception) -> bool:
    """Tell whether its reason says all there is; an error of the code itself has its trace as well."""
    known = OUT_OF_MEMORY.search(str(error)) or DEVICE_LOST.search(str(error)) or host().explained(error)
    return isinstance(error, ReportError | OSError | MemoryError) or bool(known)
