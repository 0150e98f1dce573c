"""Accelerators: what a report that measures on the CPU has none of; ``report.toml`` names a module with these names."""

from collections.abc import Mapping
from types import ModuleType
from typing import NamedTuple

from measured_report.files.config import Report
from measured_report.files.config import report as current
from measured_report.files.errors import UsageError

KIND, NOUN = "", ""  # what DEVICE calls one beside `cpu`, and people do
NONE: Mapping[str, str] = {}  # environment of a process that may use none
ALONE: Mapping[
    str, str
] = {}  # environment of a process that measures times, past what lets others share one


class Accelerator(NamedTuple):
    name: str
    memory_mib: int
    settings: Mapping[str, str]  # environment of a process that may use this one alone


def accelerators() -> list[Accelerator]:
    """List those that this process may use."""
    return []


def share_count(shared: Accelerator, count: int = 1) -> int:
    """Return how many processes share one where there are ``count``."""
    return 1


def driver() -> str | None:
    """Name the driver, as records do."""
    return None


def accelerator() -> ModuleType:
    return current().accelerator


def kinds(report: Report | None = None) -> list[str]:
    """List the kinds of devices that may be asked for."""
    return [*filter(None, [(report or current()).accelerator.KIND]), "cpu"]


def read_device(kind: str, report: Report | None = None) -> str:
    """Return a kind of device; UsageError if there is none of that name."""
    if kind not in kinds(report):
        raise UsageError(
            f"DEVICE={kind:.80} is no device; use one of: {', '.join(kinds(report))}"
        )
    return kind


def lacks(report: Report | None = None) -> str:
    """Say that this machine has none."""
    kind = (report or current()).accelerator.KIND.upper() or "other"
    return f"this machine has no {kind} device; DEVICE=cpu measures on its CPU"
