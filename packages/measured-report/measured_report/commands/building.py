"""Commands that make something: measured sections, the site, its tests, and what serves or publishes it."""

import argparse
import pkgutil
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import replace
from functools import partial

from measured_report.commands.programs import add_tests_cluster, programs
from measured_report.editions.devices import NO_CUDA, has_cuda, measuring_device, needs_gpu
from measured_report.editions.environment import python_of
from measured_report.editions.project import Project
from measured_report.editions.stack import Stack
from measured_report.editions.status import State, expected_packages, states_of, status_matrix, status_table
from measured_report.files.config import config
from measured_report.files.errors import ReportError, UsageError
from measured_report.measuring.measure import machines_besides, measure
from measured_report.records.identity import sections


def report(project: Project, arguments: argparse.Namespace) -> int:
    """Measure what is not fresh, where that may be done unasked, and build the site."""
    device = _measuring_device(project, arguments)
    if not device:
        refuse_unmeasured(project, arguments.stack)
    stale = [state.section for state in states_of(project) if state.kind != "fresh"]
    failed = False
    if stale and device:
        try:
            project = measure(project, arguments.stack, stale, device, arguments.cluster)
        except UsageError:
            raise
        except ReportError as error:
            print(error, file=sys.stderr)
            failed = True
    damaged, lacking = build_site(project, arguments.address)
    if lacking and not device:
        print(f"{NO_CUDA}, in up to hours")
    return int(failed or damaged)


def rerun(project: Project, arguments: argparse.Namespace) -> int:
    """Measure one section, fresh or not, and build the site."""
    section = arguments.section
    device = _measuring_device(project, arguments) if needs_gpu(section, project.root) else "cpu"
    if not device:
        raise UsageError(NO_CUDA)
    project = measure(project, arguments.stack, [section], device, arguments.cluster)
    return int(build_site(project, arguments.address)[0])


def _measuring_device(project: Project, arguments: argparse.Namespace) -> str | None:
    """The device to measure on; hosts elsewhere have GPUs, unless a CPU is asked for."""
    if arguments.cluster and not arguments.cluster.is_here:
        return arguments.device or "cuda"
    return measuring_device(arguments.device, project.profile)


def page(project: Project, arguments: argparse.Namespace) -> int:
    """Build the site from what is measured, and measure nothing."""
    refuse_unmeasured(project, arguments.stack)
    return int(build_site(project, arguments.address)[0])


def status(project: Project, arguments: argparse.Namespace) -> int:
    """Print which sections of which releases are fresh, and what changed for those that are not."""
    refuse_unmeasured(project, arguments.stack)
    print(status_matrix(project))
    print(f"\n{config().package} {project.release}")
    made = [pkgutil.resolve_name(each.state)(project) for each in programs(project.root).values() if each.state]
    print(status_table([*states_of(project), *made], project.profile))
    return 0


def test(project: Project, arguments: argparse.Namespace) -> int:
    """Run the tests with one release."""
    python = python_of(arguments.stack, expected_packages(project), project.root)
    add_tests_cluster(python, project)
    command = [str(python), "-m", "pytest", *(["-m", "words and not slow"] if arguments.fast else [])]
    return subprocess.run(command, cwd=project.root, check=False).returncode


def publish(project: Project, arguments: argparse.Namespace) -> int:
    """Put a checked copy of the site at the target."""
    from measured_report.site.publish import publish as publish_site

    print(f"published at {publish_site(project.site, arguments.target)}")
    return 0


def serve(project: Project, arguments: argparse.Namespace) -> int:
    """Serve the site until Ctrl-C, and build it again whenever something changes."""
    from measured_report.site.serving import Server

    refuse_unmeasured(project, arguments.stack)
    server = Server(project.site, arguments.port)
    print(f"serving {project.site} at http://127.0.0.1:{arguments.port}", flush=True)
    options = [f"--{config().package}", arguments.stack.asked, "--profile", project.profile]
    command = [sys.executable, "build.py", "page", *options]  # apart, since what changes may be the program
    server.follow(project.inputs, partial(subprocess.run, command, cwd=project.root, check=False))
    return 0


def build_site(project: Project, address: str) -> tuple[bool, bool]:
    """Build the site, and say what it lacks; whether a record is damaged, and whether any is to be renewed."""
    from measured_report.site.build import build

    releases = build(project, address)
    built = releases[project.release]
    missing = [state.section for state in built.left_out if state.kind == "missing"]
    others = [state.section for state in built.left_out if state.kind != "missing"]
    measurable = sections(project.root)
    lacking = [name for name in (*missing, *others, *built.stale) if name in measurable]
    for words, names in (("not measured", missing), ("stale", built.stale)):
        if names:
            print(f"{words}: {', '.join(names)}")
    if lacking:
        print(_hint(project, lacking[0]))
    print(f"built {project.site / 'index.html'}")
    return say_damage(state for release in releases.values() for state in release.left_out), bool(lacking)


def _hint(project: Project, section: str) -> str:
    """Which command measures a section for this report; a CPU's results never stand with those of a GPU."""
    if has_cuda():
        return f"{project.rerun(section)} measures one of them"
    if not needs_gpu(section, project.root) or not any(machines_besides(project, "cpu")):
        return f"{project.rerun(section, 'cpu')} measures one of them"
    own = f"; with DEVICE=cpu it becomes an edition of its own, {replace(project.label, machine='cpu')}"
    return f"{project.rerun(section)} measures one of them on a GPU{'' if project.label.machine else own}"


def say_damage(states: Iterable[State]) -> bool:
    """Name each record that can't be trusted; whether there is one."""
    damaged = [state for state in states if state.kind == "damaged"]
    for state in damaged:
        print(f"damaged: {state.words}", file=sys.stderr)
    return bool(damaged)


def refuse_unmeasured(project: Project, stack: Stack) -> None:
    """Where nothing is to be measured, an edition that has no results is taken for a mistake; the own one is not."""
    if not project.is_own and not any(state.kind != "missing" for state in states_of(project)):
        there = ", ".join(release for release in project.releases if release != project.release) or "none"
        asked = f"{config().option}={stack.asked}"
        raise UsageError(f"{asked} has no results (there are: {there}); make upgrade {asked} measures what decides")
