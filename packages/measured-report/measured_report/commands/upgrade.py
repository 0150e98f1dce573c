"""Measure the deciding sections of a release, in minutes, and say what changed."""

import argparse
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, redirect_stdout
from dataclasses import replace
from functools import partial

from measured_report.changes.alarm import upgrade_text
from measured_report.changes.compare import compare
from measured_report.changes.upgrade import base_of, deciding, seconds_expected, unmeasured, verdict
from measured_report.commands.options import shared
from measured_report.commands.page import build_site
from measured_report.editions.devices import NO_CUDA, machine_name, measuring_device
from measured_report.editions.project import Project
from measured_report.editions.release import Release, release_of
from measured_report.editions.status import states_of
from measured_report.files.config import config
from measured_report.files.errors import ReportError, UsageError
from measured_report.measuring.measure import kept_by, measure, prepare
from measured_report.pages.editions import editions_of
from measured_report.pages.prose import Templates

STDOUT, STDERR = 1, 2  # as programs that are started from here know them

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
    with nullcontext() if arguments.format == "text" else printing_to_stderr():
        asked = base, arguments.release
        lacking = [_lacking(project.of(str(release)), device, renews=release is not base) for release in asked]
        if device and all(lacking):
            prepare(project, arguments.release, lacking[1], device)  # before a base is measured for nothing
        sides = [_with_deciding(project, release, device, renews=release is not base) for release in asked]
    names = [side.release for side in sides]
    editions = editions_of(project, Templates(project.templates), among=names)
    compared = [editions[name] for name in names]
    found = compare(*compared)
    found = replace(found, faults=[*unmeasured(sides[1]), *found.faults])
    print(upgrade_text(found, verdict(found, *compared), arguments.format))
    if arguments.format == "text":
        build_site(sides[1])
    return int(found.is_alarm)


def _with_deciding(project: Project, release: Release, device: str | None, *, renews: bool) -> Project:
    """Measure the deciding sections of a release that are missing or, if ``renews``, stale; return its report."""
    side = project.of(str(release))
    lacking = _lacking(side, device, renews=renews)
    if not lacking:
        return side
    if not device:
        quick = replace(project, profile="quick")
        full, short = (seconds_expected(each, "cpu", deciding(each)) / 60 for each in (project, quick))
        raise UsageError(f"{NO_CUDA}, in about {full:.0f} min, and with PROFILE=quick in about {short:.0f}")
    minutes = max(seconds_expected(side, device, lacking) / 60, 1)
    what = f"{config().package} {side.release}: measuring {', '.join(lacking)}"
    print(f"{what}, about {minutes:.0f} min", flush=True)
    side = kept_by(side, machine_name(device), lacking)
    try:
        measure(side, release, lacking, device)
    except UsageError:
        raise
    except ReportError as error:  # what could be measured may say enough
        print(error, file=sys.stderr)
    return side


def _lacking(side: Project, device: str | None, *, renews: bool) -> list[str]:
    """Name the deciding sections that an edition lacks or, if ``renews`` and there is a device, has stale."""
    unfit = {state.section for state in states_of(side) if state.kind != "fresh"} if device and renews else ()
    return [section for section in deciding(side) if section in unfit or not side.record_path(section).exists()]


@contextmanager
def printing_to_stderr() -> Iterator[None]:
    """Send what is printed within it, by other programs as well, where errors go: the answer is for a program."""
    sys.stdout.flush()
    kept = os.dup(STDOUT)
    os.dup2(STDERR, STDOUT)
    try:
        with redirect_stdout(sys.stderr):
            yield
    finally:
        os.dup2(kept, STDOUT)
        os.close(kept)
