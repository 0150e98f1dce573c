"""Measure sections and keep their records: ``python -m measured_report.measuring.run SECTION [SECTION …]``."""

import signal

# Records are put in place whole, so that there is nothing to tidy up after Ctrl-C.
signal.signal(signal.SIGINT, signal.SIG_DFL)

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
from measured_report.measuring.machine import (
    machine,
    measuring_device,
    needs_device,
    read_device,
)
from measured_report.measuring.measure import UNFIT
from measured_report.measuring.pool import environments, gather, host_pools
from measured_report.measuring.section import Loop, Section, section_of
from measured_report.records.code import Code
from measured_report.records.identity import package_versions, sections
from measured_report.records.record import basis_of


def main() -> int:
    tqdm.monitor_interval = 0  # no process may be forked beside a thread
    parser = argparse.ArgumentParser(prog="python -m measured_report.measuring.run")
    parser.add_argument("section", nargs="+")
    parser.add_argument("--device", default="")
    parser.add_argument("--profile", choices=("full", "quick"), default="full")
    parser.add_argument("--edition", help="label of the results")
    parser.add_argument("--aside", default="", help="folder below results/")
    parser.add_argument("--cluster", help="address of a Dask scheduler")
    arguments = parser.parse_args()
    report = current()
    status = UNFIT
    try:
        release = edition_of(arguments.edition, report)
        own = own_release(report=report)
        project = Project(release, arguments.profile, report.root, own, arguments.aside)
        asked = arguments.device or measuring_device(None, "quick") or "cpu"
        requested = sections_asked(project, arguments.section, asked)
        with pools(report, arguments.cluster, requested) as (shared, exclusive):
            status = 1
            return int(Loop(requested, shared, exclusive).run())
    except ReportError as error:
        print(error, file=sys.stderr)
        return status


def sections_asked(
    project: Project, names: Sequence[str], device: str
) -> Sequence[Section]:
    """Return the sections of these names; raise ReportError if they cannot be measured here."""
    code = Code(project.root)
    for name in names:
        if not name.isidentifier() or not code.module(f"experiments.{name}"):
            raise ReportError(
                f"SECTION={name} is no section; use one of: {', '.join(sections())}"
            )
    # Batches of the processor alone begin first: they are few and long.
    ordered = sorted(names, key=lambda name: needs_device(name, project))
    # Before anything of the report is imported, such as the modules of devices.
    bases = [
        basis_of(name, project.record_path(name), project.profile, project.root)
        for name in ordered
    ]
    device = read_device(device)
    gc.disable()  # looking for garbage takes half the time of loading a simulator
    project.report.host.be_quiet()
    found = [
        section_of(project, basis, section_module(basis.section), device)
        for basis in bases
    ]
    gc.freeze()
    gc.enable()
    return found


@contextmanager
def pools(
    report: Report, cluster: str | None, requested: Sequence[Section]
) -> Iterator[Any]:
    """Open the pools that measure: of this host, or of a cluster's workers."""
    devices = sorted({section.device for section in requested})
    if cluster:
        from measured_report.measuring.cluster import cluster_pools, connected

        with connected(cluster) as client:
            yield cluster_pools(client, devices[-1])
        return
    alone = {}
    shared = environments(devices[-1], requested[0].project.profile, report)
    if devices[-1] == "cpu":
        machine("cpu")  # once for all forks, which inherit it
    else:
        alone = {**shared[0], **report.accelerator.ALONE}
    with host_pools(shared, alone) as opened:
        prepare = report.host.prepare
        try:
            gather([opened[0].submit(prepare, each) for each in devices], "kernels")
        except BrokenProcessPool:
            raise ReportError(KILLED) from None
        yield opened


def section_module(section: str) -> ModuleType:
    """Import the module that measures a section; raise ReportError if it cannot be imported."""
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
    """Return the label of what is installed here; raise ReportError if another one was asked for."""
    settings = (report or current()).settings
    installed = package_versions(settings)
    asked = requested or installed[settings.edition]
    label = read_label(asked, settings)
    if label is None or not label.is_installed_with(installed):
        have = ", ".join(f"{name} {version}" for name, version in installed.items())
        raise ReportError(
            f"{settings.option}={asked} is not what is installed here ({have})"
        )
    return str(label)


if __name__ == "__main__":
    sys.exit(main())
