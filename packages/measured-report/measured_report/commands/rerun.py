"""Measure one section, fresh or not, and build site/."""

from measured_report.commands.options import Arguments, shared
from measured_report.commands.page import build_site
from measured_report.commands.report import device_of
from measured_report.editions.project import Project
from measured_report.files.errors import UsageError, suggestion
from measured_report.measuring.accelerator import lacks
from measured_report.measuring.machine import needs_device
from measured_report.measuring.measure import measure
from measured_report.records.identity import sections

SECTION = {"default": "", "help": "section to measure"}
OPTIONS = {
    "section": SECTION,
    **shared("edition", "device", "cluster", "profile", "address"),
}


def run(project: Project, arguments: Arguments) -> int:
    section, names = arguments.section, sections(project.root)
    if section not in names:
        raise UsageError(
            f"SECTION={section} is no section{suggestion(section, names)}; use one of: {', '.join(names)}"
        )
    if not (
        device := device_of(project, arguments)
        if needs_device(section, project)
        else "cpu"
    ):
        raise UsageError(lacks(project.report))
    project = measure(project, arguments.release, [section], device, arguments.cluster)
    return int(build_site(project, arguments.address)[0])
