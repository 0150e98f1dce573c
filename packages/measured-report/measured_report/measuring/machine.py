"""Machines that measure: which devices there are, and the machine and the commit, as records and labels say them."""

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
from measured_report.measuring.accelerator import lacks
from measured_report.records.code import Code
from measured_report.records.record import Record

KIND = (
    "device",
    "gpu",
    "driver",
    "cpu",
    "cores",
)  # what of a machine is the same for all batches of a section


@cache
def machine(kind: str, report: Report | None = None) -> dict[str, str | None]:
    """Return the machine that measures; host and card tell of two records whether they ran side by side."""
    report = report or current()
    card, uuid = report.host.card(kind)
    driver = None if kind == "cpu" else report.accelerator.driver()
    system = f"{platform.system()} {platform.machine()}"
    devices = {
        "device": kind,
        "gpu": card,
        "driver": driver,
        "cpu": cpu_name(),
        "cores": str(os.cpu_count()),
    }
    return {
        **devices,
        "python": platform.python_version(),
        "host": None if uuid else host_digest(report.settings.edition),
        "gpu_uuid": uuid,
        "system": system,
    }


def host_digest(edition: str) -> str | None:
    """Return a digest of a number drawn by chance when this host was set up, or begun; a name would be guessed."""
    for path in map(Path, ("/etc/machine-id", "/proc/sys/kernel/random/boot_id")):
        if os.access(path, os.R_OK) and (
            number := path.read_text(encoding="utf-8").strip()
        ):
            return hashlib.sha256(f"{edition} {number}".encode()).hexdigest()[:12]
    return None


def cpu_name() -> str:
    path = Path("/proc/cpuinfo")
    named = re.search(
        r"^model name\s*:(.*)",
        path.read_text(encoding="utf-8") if path.exists() else "",
        re.MULTILINE,
    )
    return named[1].strip() if named else platform.processor() or platform.machine()


def commit(root: Path | None = None) -> str | None:
    """Return the commit that is checked out, marked where the tree differs; of a copy the environment's GIT_COMMIT."""
    if name := os.environ.get("GIT_COMMIT"):
        return name
    root = root or current().root
    name = git(root, "describe", "--always", "--abbrev=12", "--exclude=*", "--dirty")
    untracked = git(
        root, "ls-files", "--others", "--exclude-standard", "experiments", "assets"
    )
    return (
        f"{name.removesuffix('-dirty')}-dirty" if name and untracked else name or None
    )


def said(*command: str) -> str:
    """Return what a command prints; nothing when it fails or is not there."""
    try:
        return subprocess.run(
            command, cwd=current().root, capture_output=True, text=True, check=False
        ).stdout.strip()
    except OSError:
        return ""


def needs_device(section: str, project: Project) -> bool:
    """Tell whether numbers depend on the device: a section with ``NEEDS_GPU = False`` stands with any."""
    code = Code(project.root)
    file = (
        code.module(f"experiments.{section}")
        or f"{project.root}/experiments/{section}.py"
    )
    return bool(code.source(file).top.get("NEEDS_GPU", project.settings.needs_device))


def measuring_device(
    device: str | None, profile: str, report: Report | None = None
) -> str | None:
    """Choose the device to measure on; None where it has to be asked for: full measurements take hours on a CPU."""
    report = report or current()
    if device == "cpu" or not (device or report.settings.needs_device):
        return "cpu"
    if report.accelerator.accelerators():
        return str(report.accelerator.KIND)
    if device:
        raise UsageError(f"DEVICE={device}: {lacks(report)}")
    return "cpu" if profile == "quick" else None


def machine_name(device: str, report: Report | None = None) -> str:
    """Name this machine for a label when it measures on ``device``: by its accelerator, or ``cpu``."""
    if device == "cpu":
        return device
    return slug(
        next(
            (card.name for card in (report or current()).accelerator.accelerators()), ""
        )
    )


def machine_of(record: Record) -> str:
    return "cpu" if record.machine.get("device") == "cpu" else slug(record.processor)


def slug(name: str) -> str:
    return re.sub("[^a-z0-9]+", "-", name.lower()).strip("-")
