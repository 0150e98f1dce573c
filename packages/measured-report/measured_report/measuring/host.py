"""A host: what a report that measures on the CPU does with it; ``report.toml`` names a module with these names.

It may have ``note_work(note)`` too, after which ``note`` is called with each piece of work that a device is given, in
words: what is timed is the same where these are, which ``make carry`` asks.
"""

from types import ModuleType

from measured_report.files.config import report as current
from measured_report.files.errors import ReportError
from measured_report.measuring.measurement import Conditions

__all__ = ["Conditions", "be_quiet", "card", "explained", "host", "prepare"]


def card(kind: str) -> tuple[str | None, str | None]:
    """Return name and uuid of the accelerator to measure on, nothing of a CPU; ReportError where there is none."""
    if kind != "cpu":
        raise ReportError(
            f"DEVICE={kind}: this report measures on the CPU; DEVICE=cpu does"
        )
    return None, None


def prepare(kind: str) -> None:
    """Make ready what all sections need on a kind of device; ReportError when it can't be."""


def be_quiet() -> None:
    """Say nothing in a process beside others, which have said it; called before a section is imported."""


def explained(error: Exception) -> str:
    """Say what an error of the simulator means, in a line; empty where its own text has to do."""
    return ""


def host() -> ModuleType:
    return current().host
