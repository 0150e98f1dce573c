"""Define the devices and the simulator of a report that measures on the CPU.

``report.toml`` can name two modules that define the same names. The module
``accelerator`` defines the names up to ``driver``, which are used before a measurement.
The module ``host`` defines the others.
"""

from collections.abc import Mapping
from typing import NamedTuple

from measured_report.files.errors import ReportError
from measured_report.measuring.measurement import Conditions as Conditions

KIND = ""  # name of the accelerator in DEVICE=
NOUN = ""  # name of the accelerator in sentences
NONE: Mapping[str, str] = {}  # environment that hides all accelerators from a process
ALONE: Mapping[str, str] = {}
"""Environment of a process that measures times.

It turns off the settings with which processes share an accelerator.
"""


class Accelerator(NamedTuple):
    name: str
    memory_mib: int
    settings: Mapping[str, str]  # environment of a process that uses only this one


def accelerators() -> list[Accelerator]:
    """Return the accelerators that this process may use."""
    return []


def share_count(shared: Accelerator, count: int = 1) -> int:
    """Return the number of processes that share one of ``count`` accelerators."""
    return 1


def driver() -> str | None:
    """Return the version of the driver, as records write it."""
    return None


def card(kind: str) -> tuple[str | None, str | None]:
    """Return the name and uuid of the accelerator to measure on, or None for a CPU."""
    if kind != "cpu":
        raise ReportError(
            f"DEVICE={kind} cannot be used, because this report measures on the "
            "CPU: use DEVICE=cpu"
        )
    return None, None


def prepare(kind: str) -> None:
    """Prepare a kind of device for all sections, for example by compiling kernels."""


def be_quiet() -> None:
    """Print only errors from now on; this is called before a section is imported."""


def explained(error: Exception) -> str:
    """Return a line that explains an error of the simulator, or an empty string."""
    return ""
