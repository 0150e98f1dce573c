"""Measure sections and keep their records: ``python -m measured_report.measuring.run SECTION [SECTION …]``."""

import signal

signal.signal(
    signal.SIGINT, signal.SIG_DFL
)  # records are put in place whole: there is nothing to tidy up

import argparse
import gc
import importlib
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

from tqdm import tqdm

from measured_report.editions.project import Project, own_release
from measured_report.editions.release import read_label
from measured_report.files.atomic import short_path
from measured_report.files.config import Report
from measured_report.files.config import report as current
from measured_report.files.errors import ReportError, bug_of
from measured_report.files.processes import KILLED
from measured_report.measuring.accelerator import read_device
from measured_report.measuring.machine import machine, measuring_device, needs_device
from measured_report.measuring.measure import UNFIT, batches_at_once
from measured_report.measuring.pool import gather, host_pools
from measured_report.measuring.section import Loop, Section, section_of
from measured_report.records.code import Code
from measured_report.records.identity import package_versions, sections
from measured_report.records.record import basis_of


def main() -> int:
    tqdm.monitor_interval = (
        0  # a thread of its own, which no process may be forked beside
    )
    parser = argparse.ArgumentParser(
        prog="python -m measured_report.measuring.run",
        description=__doc__.split(":")[0],
    )
    parser.add_argument(
        "section", nargs="+", metavar="SECTION", help=", ".join(sections())
    )
    parser.add_argument("--device", default="", help="kind of device to measure on")
    parser.add_argument("--profile", choices=("full", "quick"), default="full")
    parser.add_argument(
        "--edition",
        metavar="LABEL",
        help="what the results are kept as; default: what is installed",
    )
    parser.add_argument(
        "--aside",
        metavar="FOLDER",
        default="",
        help="where below results/ they are kept apart",
    )
    parser.add_argument(
        "--cluster",
        metavar="CLUSTER",
        help="who measures: local, tcp://HOST:PORT or tls://HOST:PORT",
    )
    parser.add_argument(
        "--processor",
        metavar="NAME",
        help="the only accelerator that the cluster may measure on",
    )
    arguments, status = parser.parse_args(), UNFIT
    try:
        requested = sections_asked(arguments)
        with pools(arguments, requested) as (shared, exclusive):
            status = 1
            return int(Loop(requested, shared, exclusive).run())
    except ReportError as error:
        print(error, file=sys.stderr)
        return status


def sections_asked(arguments: argparse.Namespace) -> Sequence[Section]:
    """Return the sections that were asked for; ReportError where they can't be measured here."""
    report = current()
    label = edition_of(arguments.edition, report)
    project = Project(
        label,
        arguments.profile,
        report.root,
        own_release(report=report),
        arguments.aside,
    )
    # What the accelerator waits for least begins first: batches of the processor alone are few and long.
    code = Code(project.root)
    for name in arguments.section:
        if not name.isidentifier() or not code.module(f"experiments.{name}"):
            raise ReportError(
                f"SECTION={name} is no section; use one of: {', '.join(sections())}"
            )
    names = sorted(arguments.section, key=lambda name: needs_device(name, project))
    # Before anything of the report is imported, such as the modules of devices.
    bases = [
        basis_of(name, project.record_path(name), project.profile, project.root)
        for name in names
    ]
    arguments.device = read_device(
        arguments.device or measuring_device(None, "quick", report) or "cpu", report
    )
    gc.disable()  # looking for garbage takes half the time of loading a simulator
    report.host.be_quiet()
    found = [
        section_of(project, basis, section_module(basis.section), arguments.device)
        for basis in bases
    ]
    gc.freeze()
    gc.enable()
    return found


@contextmanager
def pools(
    arguments: argparse.Namespace, requested: Sequence[Section]
) -> Iterator[tuple[Any, Any]]:
    """Open the pools that measure: of this host, or of a cluster's workers."""
    report = requested[0].project.report
    count = batches_at_once(requested[0].project, arguments.device)
    if arguments.cluster:
        try:
            from measured_report.measuring.cluster import cluster_pools
        except ImportError as error:
            raise ReportError(
                f"CLUSTER takes {error.name}, which {sys.executable} lacks; install it there"
            ) from None
        with cluster_pools(
            arguments.cluster, arguments.device, arguments.processor, report, count
        ) as opened:
            yield opened
        return
    if arguments.device == "cpu":
        machine(
            "cpu", report
        )  # once for all forks, which inherit what has no accelerator
    with host_pools(count, report.accelerator.ALONE) as (shared, exclusive):
        try:
            devices = sorted({section.device for section in requested})
            gather(
                [shared.submit(report.host.prepare, device) for device in devices],
                "kernels",
            )
        except BrokenProcessPool:
            raise ReportError(KILLED) from None
        yield shared, exclusive


def section_module(section: str) -> ModuleType:
    """Import the module that measures a section; ReportError when it cannot be imported."""
    try:
        module = importlib.import_module(f"experiments.{section}")
    except (Exception, SystemExit) as error:
        raise ReportError(bug_of(error)) from error
    if hasattr(module, "measure"):
        return module
    raise ReportError(
        f"{short_path(Path(str(module.__file__)))} has no function measure(conditions)"
    )


def edition_of(requested: str | None, report: Report | None = None) -> str:
    """Return the label of what is installed here; ReportError when another one was asked for."""
    settings = (report or current()).settings
    installed = package_versions(settings)
    asked = requested or installed[settings.edition]
    label = read_label(asked, settings)
    if label is None or not label.is_installed_with(installed):
        have = ", ".join(f"{name} {release}" for name, release in installed.items())
        raise ReportError(
            f"{settings.option}={asked} is not what is installed here ({have})"
        )
    return str(label)


if __name__ == "__main__":
    sys.exit(main())
