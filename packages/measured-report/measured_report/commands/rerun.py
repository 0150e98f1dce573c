"""Measure one section, fresh or not, and build site/."""

import argparse

from measured_report.commands.options import shared
from measured_report.commands.page import build_site
from measured_report.commands.report import device_of
from measured_report.editions.devices import NO_CUDA, needs_gpu
from measured_report.editions.project import Project
from measured_report.files.errors import UsageError
from measured_report.files.root import ROOT
from measured_report.files.suggestion import suggestion
from measured_report.measuring.measure import measure
from measured_report.records.identity import sections

OPTIONS = {
    "section": {"default": "", "help": "section to measure"},
    **shared("edition", "device", "cluster", "profile", "address"),
}


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Measure the section and build the site."""
    section = arguments.section
    refuse_unknown(section)
    device = device_of(project, arguments) if needs_gpu(section, project.root) else "cpu"
    if not device:
        raise UsageError(NO_CUDA)
    project = measure(project, arguments.release, [section], device, arguments.cluster)
    return int(build_site(project, arguments.address)[0])


def refuse_unknown(name: str) -> None:
    """Refuse what is no section."""
    if name not in sections():
        fault = f"SECTION={name} is no section" if name else "SECTION is missing"
        if name.isidentifier() and (ROOT / "experiments" / f"{name}.py").is_file():
            fault += f": there is no report/sections/{name}.py"
        else:
            fault += suggestion(name, sections())
        raise UsageError(f"{fault}; use one of: {', '.join(sections())}")
