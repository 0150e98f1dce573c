"""Describe the machine that measures, its devices and the commit, as records do."""

import hashlib
import os
import platform
import re
import subprocess
from functools import cache
from pathlib import Path

from measured_report.editions.project import Project
from measured_report.files.config import Report
from measured_report.files.config import report as current
from measured_report.files.errors import UsageError
from measured_report.files.git import git
from measured_report.records.code import Code
from measured_report.records.record import Record

KIND = ("device", "gpu", "driver", "cpu", "cores")
"""Properties of a machine that must be the same for all batches of a section."""


@cache
def machine(kind: str) -> dict[str, str | None]:
    """Return a description of the machine that measures.

    Two records with the same host or card were measured on the same machine.
    """
    report = current()
    card, uuid = report.host.card(kind)
    return {
        "device": kind,
        "gpu": card,
        "driver": None if kind == "cpu" else report.accelerator.driver(),
        "cpu": cpu_name(),
        "cores": str(os.cpu_count()),
        "python": platform.python_version(),
        "host": None if uuid else host_digest(report.settings.edition),
        "gpu_uuid": uuid,
        "system": f"{platform.system()} {platform.machine()}",
    }


def host_digest(edition: str) -> str | None:
    """Return a digest of the host's random number.

    A digest of the host's name would not hide it, because names can be guessed.
    """
    for name in ("/etc/machine-id", "/proc/sys/kernel/random/boot_id"):
        if os.access(name, os.R_OK):
            number = Path(name).read_text(encoding="utf-8").strip()
            return hashlib.sha256(f"{edition} {number}".encode()).hexdigest()[:12]
    return None


def cpu_name() -> str:
    path = Path("/proc/cpuinfo")
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    name = re.search(r"^model name\s*:(.*)", text, re.MULTILINE)
    return name[1].strip() if name else platform.processor() or platform.machine()


def commit() -> str | None:
    """Return the commit that is checked out, marked as dirty if files differ from it.

    New results do not count, because measuring writes them. A copy without a repository
    takes the commit from the environment variable GIT_COMMIT.
    """
    if name := os.environ.get("GIT_COMMIT"):
        return name
    root = current().root
    name = git(root, "describe", "--always", "--abbrev=12", "--exclude=*")
    folders = ("experiments", "assets")
    changes = git(root, "diff", "--name-only", "HEAD", "--", ":/", ":!results")
    changes += git(root, "ls-files", "--others", "--exclude-standard", *folders)
    return f"{name}-dirty" if name and changes else name or None


def said(*command: str) -> str:
    """Return the output of a command, or an empty string if it cannot be run."""
    try:
        process = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError:
        return ""
    return process.stdout.strip()


def needs_device(section: str, project: Project) -> bool:
    """Return whether the numbers of a section depend on the device.

    They do not if the section sets ``NEEDS_GPU = False``.
    """
    code = Code(project.root)
    module = code.module(f"experiments.{section}")
    top = code.source(module).top if module else {}
    return bool(top.get("NEEDS_GPU", project.settings.needs_device))


def read_device(kind: str) -> str:
    """Return a valid kind of device; raise UsageError for any other name."""
    kinds = [*filter(None, [current().accelerator.KIND]), "cpu"]
    if kind not in kinds:
        raise UsageError(
            f"DEVICE={kind:.80} is not a device: use one of {', '.join(kinds)}"
        )
    return kind


def lacks() -> str:
    """Return a message that this machine has no accelerator."""
    kind = current().accelerator.KIND.upper() or "other"
    return f"this machine has no {kind} device: use DEVICE=cpu to measure on its CPU"


def measuring_device(
    device: str | None, profile: str, cluster: str | None = None
) -> str | None:
    """Return the device to measure on, or None if the user must choose one.

    Full measurements take hours on a CPU, so the CPU is used only on request.
    """
    report = current()
    kind = str(report.accelerator.KIND)
    if device == "cpu" or not (device or report.settings.needs_device):
        return "cpu"
    if cluster or report.accelerator.accelerators():
        return kind
    if device:
        raise UsageError(f"DEVICE={device}: {lacks()}")
    return "cpu" if profile == "quick" else None


def machine_name(device: str, report: Report) -> str:
    """Return the name of this machine in labels: its accelerator or ``cpu``."""
    if device == "cpu":
        return device
    cards = report.accelerator.accelerators()
    return slug(cards[0].name) if cards else ""


def machine_of(record: Record) -> str:
    return "cpu" if record.machine.get("device") == "cpu" else slug(record.processor)


def slug(name: str) -> str:
    return re.sub("[^a-z0-9]+", "-", name.lower()).strip("-")
