"""The host: devices and a simulator, as a report that measures on the CPU has them.

``report.toml`` names modules with the same names: as ``accelerator`` one with those up to ``driver``, which is asked
before anything is measured, and as ``host`` one with the others.
"""

from collections.abc import Mapping
from typing import NamedTuple

from measured_report.files.errors import ReportError
from measured_report.measuring.measurement import Conditions as Conditions

KIND = ""  # how DEVICE= calls an accelerator
NOUN = ""  # how people call it
NONE: Mapping[str, str] = {}  # environment of a process that may use none
ALONE: Mapping[str, str] = {}
"""Environment of a process that measures times, past what lets others share an accelerator."""


class Accelerator(NamedTuple):
    name: str
    memory_mib: int
    settings: Mapping[str, str]  # environment of a process that may use this one alone


def accelerators() -> list[Accelerator]:
    """Return the accelerators that this process may use."""
    return []


def share_count(shared: Accelerator, count: int = 1) -> int:
    """Return how many processes share one of ``count`` accelerators."""
    return 1


def driver() -> str | None:
    """Return the driver, as records name it."""
    return None


def card(kind: str) -> tuple[str | None, str | None]:
    """Return name and uuid of the accelerator to measure on, both None for a CPU."""
    if kind != "cpu":
        raise ReportError(
            f"DEVICE={kind}: this report measures on the CPU; DEVICE=cpu does"
        )
    return None, None


def prepare(kind: str) -> None:
    """Prepare what all sections need on a kind of device."""


def be_quiet() -> None:
    """Print nothing but errors from now on; called before a section is imported."""


def explained(error: Exception) -> str:
    """Return what an error of the simulator means, in one line; empty if its own text says it."""
    return ""
