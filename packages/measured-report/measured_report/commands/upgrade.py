"""Measure the deciding sections of a release, in minutes, and say what changed."""

import argparse
import os
import sys
from dataclasses import replace
from functools import partial

from measured_report.changes.alarm import upgrade_text
from measured_report.changes.compare import Fault, compare
from measured_report.changes.upgrade import base_of, deciding, lacking, verdict
from measured_report.commands.options import refuse_itself, shared
from measured_report.commands.page import build_site
from measured_report.commands.report import measure_what_can
from measured_report.editions.project import Project
from measured_report.editions.release import Release, release_of
from measured_report.editions.status import states_of
from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.measuring.machine import NO_CUDA, machine_name, measuring_device
from measured_report.measuring.measure import kept_by
from measured_report.pages.editions import editions_of
from measured_report.pages.prose import Templates

OPTIONS = {
    "since": {
        "type": partial(release_of, option="SINCE"),
        "help": "edition to compare with; else the same unpinned, or the one before",
    },
    **shared("edition", "device", "profile", "format"),
}


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Measure the few sections that decide, say what changed, largest first, and build the site; 1 for an alarm."""
    device = measuring_device(arguments.device, project.profile)
    base = arguments.since or release_of(base_of(project) or project.own_release)
    refuse_itself(str(base), project.release)
    answer = sys.stdout if arguments.format == "text" else _apart()
    # What may not install goes first: a base would be measured for nothing.
    after = _with_deciding(project, arguments.release, device, renews=True)
    before = _with_deciding(project, base, device, renews=False)
    names = [before.release, after.release]
    editions = editions_of(project, Templates(project.templates), among=names)
    compared = [editions[name] for name in names]
    found = compare(*compared)
    absent = [Fault(after.release, section, "missing", "it could not be measured") for section in lacking(after)]
    found = replace(found, faults=[*absent, *found.faults])
    print(upgrade_text(found, verdict(found, *compared), arguments.format), file=answer, flush=True)
    if arguments.format == "text":  # the front page stays that of the project's own edition
        build_site(project.of(project.own_release or project.release))
    return int(found.is_alarm)


def _apart():
    """Return where the answer for a program goes; all else that is printed from now on, by others too, is no part."""
    sys.stdout.flush()
    answer = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    return answer


def _with_deciding(project: Project, release: Release, device: str | None, *, renews: bool) -> Project:
    """Measure the deciding sections of a release that are missing or, if ``renews``, stale; return its report."""
    side = project.of(str(release))
    absent = lacking(side)
    stale = {state.section for state in states_of(side) if state.kind != "fresh"} if device and renews else ()
    if not (names := [section for section in deciding(side) if section in stale or section in absent]):
        return side
    if not device:
        raise UsageError(f"{NO_CUDA}, and with PROFILE=quick in minutes")
    print(f"{config().package} {side.release}: measuring {', '.join(names)}", flush=True)
    return measure_what_can(kept_by(side, machine_name(device), names), release, names, device)[0]
