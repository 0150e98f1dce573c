"""Measure one section, even if its record is fresh, and build site/."""

from measured_report.commands.options import Arguments, read_section, shared
from measured_report.commands.page import build_site
from measured_report.editions.project import Project
from measured_report.files.errors import UsageError
from measured_report.measuring.machine import lacks, measuring_device, needs_device
from measured_report.measuring.measure import measure

SECTION = {"default": "", "help": "section to measure"}
OPTIONS = {
    "section": SECTION,
    **shared("edition", "device", "cluster", "profile", "address"),
}


def run(project: Project, arguments: Arguments) -> int:
    section = read_section(arguments.section)
    cluster = arguments.cluster
    device: str | None = "cpu"
    if needs_device(section, project):
        device = measuring_device(arguments.device, project.profile, cluster)
    if not device:
        raise UsageError(lacks())
    project = measure(project, arguments.release, [section], device, cluster=cluster)
    return int(build_site(project, arguments.address)[0])
