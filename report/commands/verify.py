"""Measure the headline again here, and compare it with the tracked one; keep nothing."""

import argparse

from measured_report.commands.options import refuse_unmeasured, shared
from measured_report.editions.project import Project
from measured_report.findings.editions import derive_edition
from measured_report.measuring.accelerator import accelerator
from measured_report.measuring.machine import measuring_device
from measured_report.measuring.measure import measure_headline
from report.verify import PROGRAM, verify

OPTIONS = shared("edition", "device")


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Print both and whether they agree within the noise; 1 when they differ."""
    refuse_unmeasured(project, arguments.release.asked)
    device = measuring_device(arguments.device or ("cuda" if accelerator().accelerators() else "cpu"), project.profile)
    text, agrees = verify(derive_edition(project), measure_headline(project, arguments.release, device, PROGRAM))
    print(text)
    return int(not agrees)
