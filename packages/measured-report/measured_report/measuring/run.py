"""Measure sections and keep their records: ``python -m measured_report.measuring.run SECTION [SECTION …]``."""

import signal

signal.signal(signal.SIGINT, signal.SIG_DFL)  # while this is being imported there is nothing to say about a Ctrl-C

import argparse
import importlib
import importlib.util
import io
import json
import os
import sys
from collections.abc import Sequence
from types import ModuleType

from measured_report import ReportError
from measured_report.editions.label import read_label
from measured_report.editions.project import Project, own_release
from measured_report.files.config import config
from measured_report.files.files import refuse_unwritable
from measured_report.files.processes import workers
from measured_report.measuring.course import Course, course_of
from measured_report.measuring.forks import Forks
from measured_report.measuring.host import host
from measured_report.measuring.machine import machine
from measured_report.measuring.progress import progress
from measured_report.measuring.scheduler import Crew, Here, Study
from measured_report.measuring.where import read_cluster
from measured_report.records.identity import sections
from measured_report.records.provenance import EDITED, package_versions

STOPPED = 130


def main() -> int:
    signal.signal(signal.SIGINT, signal.default_int_handler)  # which whoever started this may have ignored
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # the output may know ASCII alone
    arguments = parse_arguments()
    try:
        project = Project(edition_of(arguments.edition), arguments.profile, own_release=own_release())
        kind = (arguments.device or "cuda") if arguments.cluster else host().device(arguments.device).kind
        modules = {section: section_module(section) for section in arguments.section}
        refuse_unwritable(project.results)
        known = json.loads(arguments.seconds)
        courses = [course_of(project, section, module, kind, known) for section, module in modules.items()]
        if arguments.cluster:
            from measured_report.measuring.cluster import crew_of

            asked = {course.section: course.identity for course in courses}
            with crew_of(read_cluster(arguments.cluster), kind, arguments.processor, asked, project.profile) as crew:
                return measure_all(courses, crew)
        for each in sorted({course.device for course in courses}):
            host().prepare(each)
    except ReportError as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return stopped()
    try:
        if arguments.processes == 1:
            return measure_all(courses, Here(machine(kind)))
        with workers(arguments.processes, "fork") as pool:
            return measure_all(courses, Forks(pool, arguments.processes, machine(kind)))
    except ReportError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return stopped()


def stopped() -> int:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    print("stopped; what is finished is kept", file=sys.stderr, flush=True)
    return STOPPED


def measure_all(courses: Sequence[Course], crew: Crew) -> int:
    """Measure the sections, and return the exit status."""
    study = Study(courses, crew)
    with progress(study.status):
        return int(study.run())


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m measured_report.measuring.run", description=__doc__.split(":")[0])
    parser.add_argument("section", nargs="+", metavar="SECTION", help=", ".join(sections()))
    parser.add_argument("--device", choices=("cuda", "cpu"), help="default: cuda where there is one")
    parser.add_argument("--profile", choices=("full", "quick"), default="full")
    parser.add_argument("--seconds", default="{}", metavar="JSON", help="how long each took before, by section")
    parser.add_argument("--edition", metavar="LABEL", help="what the results are kept as; default: what is installed")
    parser.add_argument("--processes", type=int, default=1, help="batches at once, on a CPU, but for those about time")
    parser.add_argument("--cluster", metavar="CLUSTER", help="who measures: local, local:2, ssh:FILE, tcp://HOST:PORT")
    parser.add_argument("--processor", metavar="NAME", help="the only GPU that the cluster may measure on")
    return parser.parse_args()


def section_module(section: str) -> ModuleType:
    """The module that measures a section; ReportError when there is none."""
    if section.isidentifier() and importlib.util.find_spec(f"experiments.{section}"):
        module = importlib.import_module(f"experiments.{section}")
        if hasattr(module, "measure"):
            return module
    raise ReportError(f"SECTION={section} is no section; use one of: {', '.join(sections())}")


def edition_of(asked: str | None) -> str:
    """The label that results of what is installed here are kept under; ReportError when another one was asked for."""
    installed = package_versions()
    version, edits, _ = installed[config().package].partition(f"{EDITED}.")
    version += EDITED if edits else ""
    label = read_label(asked or version)
    if label is None or not label.is_installed_with({**installed, config().package: version}):
        have = ", ".join(f"{package} {version}" for package, version in installed.items())
        raise ReportError(f"{config().option}={asked or version} is not what is installed here ({have})")
    return str(label)


if __name__ == "__main__":
    status = main()
    if status == STOPPED:
        os._exit(status)  # Python takes a second or three to take the simulator apart, for which nobody waits
    sys.exit(status)
