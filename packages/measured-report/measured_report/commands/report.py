"""Measure missing and stale sections, and build site/."""

from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.commands.page import build_site
from measured_report.editions.project import Project
from measured_report.editions.status import Kind, states_of
from measured_report.measuring.machine import lacks, measuring_device
from measured_report.measuring.measure import measure_available

OPTIONS = shared("edition", "device", "cluster", "profile", "address")


def run(project: Project, arguments: Arguments) -> int:
    cluster = arguments.cluster
    device = measuring_device(arguments.device, project.profile, cluster)
    if not device:
        refuse_unmeasured(project, arguments.release.spec)
    states = states_of(project) if device else []
    names = [state.section for state in states if state.kind != Kind.FRESH]
    is_done = True
    if names and device:
        project, is_done = measure_available(
            project, arguments.release, names, device, cluster
        )
    is_damaged, is_incomplete = build_site(project, arguments.address)
    if is_incomplete and not device:
        print(f"{lacks()} (this may take hours)")
    return int(is_damaged or not is_done)
