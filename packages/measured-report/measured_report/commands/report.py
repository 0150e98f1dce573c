"""Measure what is missing or stale, and build site/."""

import sys
from collections.abc import Sequence

from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.commands.page import build_site
from measured_report.editions.project import Project
from measured_report.editions.release import Release
from measured_report.editions.status import states_of
from measured_report.files.errors import ReportError, UsageError
from measured_report.measuring.accelerator import kinds, lacks
from measured_report.measuring.machine import measuring_device
from measured_report.measuring.measure import measure

OPTIONS = shared("edition", "device", "cluster", "profile", "address")


def run(project: Project, arguments: Arguments) -> int:
    if not (device := device_of(project, arguments)):
        refuse_unmeasured(project, arguments.release.asked)
    stale_sections = [
        state.section for state in states_of(project) if state.kind != "fresh"
    ]
    is_done = True
    if stale_sections and device:
        project, is_done = measure_what_can(
            project, arguments.release, stale_sections, device, arguments.cluster
        )
    damaged, lacking = build_site(project, arguments.address)
    if lacking and not device:
        print(f"{lacks(project.report)}, in up to hours")
    return int(damaged or not is_done)


def measure_what_can(
    project: Project,
    release: Release,
    sections: Sequence[str],
    device: str,
    cluster: str | None = None,
) -> tuple[Project, bool]:
    """Measure sections and say what can't be; return the report that has them, and whether all could."""
    try:
        return measure(project, release, sections, device, cluster), True
    except UsageError:
        raise
    except ReportError as error:
        if str(error):  # what measured may have said it
            print(error, file=sys.stderr)
        return project, False


def device_of(project: Project, arguments: Arguments) -> str | None:
    """Return the device to measure on; hosts elsewhere have accelerators, unless a CPU is asked for."""
    if arguments.cluster not in (None, "local"):
        return arguments.device or kinds(project.report)[0]
    return measuring_device(arguments.device, project.profile, project.report)
