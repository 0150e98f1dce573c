"""Measure sections and keep their records: ``python -m measured_report.measuring.run SECTION [SECTION …]``."""

import signal

signal.signal(signal.SIGINT, signal.SIG_DFL)  # while this is being imported there is nothing to say about a Ctrl-C

import argparse
import gc
import importlib
import importlib.util
import io
import json
import os
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from types import ModuleType

from tqdm import tqdm

from measured_report.editions.devices import is_about
from measured_report.editions.project import Project, own_release
from measured_report.editions.release import read_label
from measured_report.files.config import config
from measured_report.files.errors import ReportError
from measured_report.measuring.cluster_address import read_cluster
from measured_report.measuring.executors import Executor, LocalExecutor
from measured_report.measuring.host import host
from measured_report.measuring.machine import machine
from measured_report.measuring.pool import processes
from measured_report.measuring.scheduler import Scheduler
from measured_report.measuring.section_run import SectionRun, section_run
from measured_report.records.code import unchanged_files
from measured_report.records.identity import identity_of, sections
from measured_report.records.provenance import EDITED, package_versions

FAILED, UNFIT, STOPPED = 1, 2, 130
"""Exit status where measuring failed, could not begin, and was stopped."""


def main() -> int:
    signal.signal(signal.SIGINT, signal.default_int_handler)  # which whoever started this may have ignored
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # the output may know ASCII alone
    arguments, status = parse_arguments(), UNFIT
    try:
        with begun(arguments) as (runs, executor):
            if arguments.only_prepare:
                return 0
            status, scheduler = FAILED, Scheduler(runs, executor)
            with progress(scheduler.status):
                return FAILED if scheduler.run() else 0
    except ReportError as error:
        print(error, file=sys.stderr)
        return status
    except KeyboardInterrupt:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        print("stopped; what is finished is kept", file=sys.stderr, flush=True)
        return STOPPED


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m measured_report.measuring.run", description=__doc__.split(":")[0])
    parser.add_argument("section", nargs="+", metavar="SECTION", help=", ".join(sections()))
    parser.add_argument("--device", choices=("cuda", "cpu"), help="default: cuda where there is one")
    parser.add_argument("--profile", choices=("full", "quick"), default="full")
    parser.add_argument("--seconds", default="{}", metavar="JSON", help="how long each took before, by section")
    parser.add_argument("--edition", metavar="LABEL", help="what the results are kept as; default: what is installed")
    parser.add_argument("--only-prepare", action="store_true", help="try whether it can be measured, and compile")
    parser.add_argument("--aside", metavar="FOLDER", default="", help="where below results/ they are kept apart")
    parser.add_argument("--processes", type=int, default=1, help="batches at once, on a CPU, but for those about time")
    parser.add_argument("--cluster", metavar="CLUSTER", help="who measures: local, local:2, ssh:FILE, tcp://HOST:PORT")
    parser.add_argument("--processor", metavar="NAME", help="the only GPU that the cluster may measure on")
    return parser.parse_args()


def section_runs(arguments: argparse.Namespace) -> Sequence[SectionRun]:
    """The runs of the sections that were asked for; ReportError where they can't be measured here."""
    label = edition_of(arguments.edition)
    project = Project(label, arguments.profile, own_release=own_release(), aside=arguments.aside)
    if others := [name for name in arguments.section if not is_about(name, package_versions())]:
        raise ReportError(f"{', '.join(others)}: what NEEDS names there is not what is installed here")
    gc.disable()  # looking for garbage takes half the time of loading a simulator, and a second or two at the end
    if not arguments.cluster:
        arguments.device = host().device(arguments.device).kind
    modules, known = {name: section_module(name) for name in arguments.section}, json.loads(arguments.seconds)
    gc.freeze()
    gc.enable()
    return [section_run(project, section, module, arguments.device, known) for section, module in modules.items()]


@contextmanager
def begun(arguments: argparse.Namespace) -> Iterator[tuple[Sequence[SectionRun], Executor]]:
    """The runs, and the executor that was asked for: this process, forks of it, or a cluster's workers."""
    if arguments.cluster:
        from measured_report.measuring.cluster import cluster_executor

        with unchanged_files():
            identities = {section: identity_of(section, arguments.profile) for section in arguments.section}
        cluster, arguments.device = read_cluster(arguments.cluster), arguments.device or "cuda"
        with cluster_executor(cluster, arguments.device, arguments.processor, identities) as executor:
            runs = section_runs(arguments)  # loads the simulator, as the workers do meanwhile
            executor.gather()
            yield runs, executor
        return
    runs = section_runs(arguments)
    for device in sorted({run.device for run in runs}):
        host().prepare(device)
    count, here = arguments.processes, machine(arguments.device)
    with nullcontext() if count == 1 else processes(count, "fork") as pool:
        yield runs, LocalExecutor(here, pool, count)


@contextmanager
def progress(status: Callable[[], str]) -> Iterator[None]:
    """Show on a terminal, within it, what ``status`` says, each second; a log has a line for each section."""
    done = threading.Event()
    with tqdm(bar_format="{elapsed}  {desc}", leave=False, disable=not sys.stderr.isatty()) as bar:

        def tick() -> None:
            while not done.wait(1.0):
                bar.set_description_str(status())

        threading.Thread(target=tick, daemon=True).start()
        try:
            yield
        finally:
            done.set()


def section_module(section: str) -> ModuleType:
    """The module that measures a section; ReportError when there is none."""
    if section.isidentifier() and importlib.util.find_spec(f"experiments.{section}"):
        module = importlib.import_module(f"experiments.{section}")
        if hasattr(module, "measure"):
            return module
    raise ReportError(f"SECTION={section} is no section; use one of: {', '.join(sections())}")


def edition_of(asked: str | None) -> str:
    """The label that results of what is installed here are kept under; ReportError when another one was asked for."""
    installed, package = package_versions(), config().package
    version, edits, _ = installed[package].partition(f"{EDITED}.")
    version += EDITED if edits else ""
    label = read_label(asked or version)
    if label is None or not label.is_installed_with({**installed, package: version}):
        have = ", ".join(f"{name} {found}" for name, found in installed.items())
        raise ReportError(f"{config().option}={asked or version} is not what is installed here ({have})")
    return str(label)


if __name__ == "__main__":
    status = main()
    if status == STOPPED:
        os._exit(status)  # Python takes a second or three to take the simulator apart, for which nobody waits
    sys.exit(status)
