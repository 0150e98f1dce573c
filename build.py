"""The command line that make calls; ``make help`` says what there is."""

import argparse
import os
import subprocess
import sys

from report import ReportError, UsageError
from report.environment import python_of, refuse_bad_release
from report.identity import installed_release, sections
from report.measure import measure, measuring_device
from report.project import PROFILES, Project
from report.status import expected_packages, states_of, status_matrix, status_table


def main() -> int:
    arguments = _parse_arguments()
    try:
        _refuse_bad_input(arguments)
        own = installed_release()
        project = Project(arguments.newton or own, arguments.profile, own_release=own)
        result = COMMANDS[arguments.command](project, arguments)
        sys.stdout.flush()
        return result
    except BrokenPipeError:  # whoever reads the output, as head, has enough of it
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except ReportError as error:
        print(error, file=sys.stderr)
        return 2 if isinstance(error, UsageError) else 1


def report(project: Project, arguments: argparse.Namespace) -> int:
    """Measure what is not fresh, where that may be done unasked, and build the site."""
    device = measuring_device(arguments.device, project.profile)
    if not device:
        _refuse_unmeasured(project)
    states = states_of(project)
    for state in states:
        if state.name == "damaged":
            print(f"damaged record: {'; '.join(state.notes)}", file=sys.stderr)
    stale = [state.section for state in states if state.name != "fresh"]
    status = 0
    if stale and device:
        try:
            measure(project, stale, device)
        except UsageError:
            raise
        except ReportError as error:
            print(error, file=sys.stderr)
            status = 1
    _build(project)
    return status


def rerun(project: Project, arguments: argparse.Namespace) -> int:
    """Measure one section, fresh or not, and build the site."""
    device = measuring_device(arguments.device, project.profile)
    if not device:
        raise UsageError("this machine has no CUDA device; DEVICE=cpu measures on its CPU")
    measure(project, [arguments.section], device)
    _build(project)
    return 0


def status(project: Project, arguments: argparse.Namespace) -> int:
    """Print which sections of which releases are fresh, and what changed for those that are not."""
    _refuse_unmeasured(project)
    print(status_matrix(project))
    print(f"\nnewton {project.release}")
    print(status_table(states_of(project), project.profile))
    return 0


def check(project: Project, arguments: argparse.Namespace) -> int:
    """Print every claim of the report with its outcome."""
    from report.assemble import assemble

    _refuse_unmeasured(project)
    for chapter in assemble(project).chapters:
        for claim in chapter.section.claims:
            print(f"{claim.outcome.name:8} {chapter.name}.{claim.name}: {claim.text}")
    return 0


def diff(project: Project, arguments: argparse.Namespace) -> int:
    """Print what differs between two releases; 1 when a claim flipped."""
    from report.compare import compare_projects

    releases = [project.of(arguments.a), project.of(arguments.b)]
    for release in releases:
        _refuse_unmeasured(release)
    comparison = compare_projects(*releases)
    print(comparison.text)
    return 1 if comparison.flips else 0


def publish(project: Project, arguments: argparse.Namespace) -> int:
    """Put a checked copy of the site at the target."""
    from report import publish

    print(f"published at {publish.publish(project.site, arguments.target or '')}")
    return 0


def test(project: Project, arguments: argparse.Namespace) -> int:
    """Run the tests with one release."""
    python = python_of(project.release, expected_packages(project), project.root)
    return subprocess.run([python, "-m", "pytest"], cwd=project.root, check=False).returncode


COMMANDS = {
    "report": report,
    "rerun": rerun,
    "status": status,
    "check": check,
    "diff": diff,
    "publish": publish,
    "test": test,
}


def _build(project: Project) -> None:
    from report.site import build

    report = build(project)
    for state in report.left_out:
        print(f"{state.section} is left out ({state.name}): {project.rerun(state.section)} measures it")
    for chapter in report.chapters:
        if chapter.state.notes:
            print(f"{chapter.name} is stale: {project.rerun(chapter.name)} renews it")
    unmeasured = report.left_out or any(chapter.state.notes for chapter in report.chapters)
    if unmeasured and not measuring_device(None, project.profile):
        print("this machine has no CUDA device: with DEVICE=cpu these commands measure here, in up to hours")
    print(f"built {project.site / 'index.html'}")


def _parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="build.py", description=__doc__)
    parser.add_argument("command", choices=COMMANDS)
    parser.add_argument("--section", help="section to measure")
    parser.add_argument("--newton", help="Newton release, where it is not the project's own")
    parser.add_argument("--a", help="Newton release to compare from")
    parser.add_argument("--b", help="Newton release to compare with it")
    parser.add_argument("--device", help="cuda or cpu, to measure there on purpose")
    parser.add_argument("--profile", default="full", help="quick: small grids and short runs, kept apart")
    parser.add_argument("--target", help="where to publish, as dir:PATH")
    return parser.parse_args()


def _refuse_bad_input(arguments: argparse.Namespace) -> None:
    if arguments.profile not in PROFILES:
        raise UsageError(f"PROFILE={arguments.profile} is no profile; use one of: {', '.join(PROFILES)}")
    if arguments.command == "rerun" and arguments.section not in sections():
        raise UsageError(f"SECTION={arguments.section or ''} is no section; use one of: {', '.join(sections())}")
    if arguments.newton:
        refuse_bad_release("NEWTON", arguments.newton)
    if arguments.command == "diff":
        for name in ("a", "b"):
            refuse_bad_release(name.upper(), getattr(arguments, name) or "")
    if arguments.device:
        measuring_device(arguments.device, arguments.profile)


def _refuse_unmeasured(project: Project) -> None:
    """Where nothing is to be measured, a release that has no results is taken for a mistake; the own one is not."""
    if not project.is_own and not any(state.name != "missing" for state in states_of(project)):
        there = [release for release in project.releases if release != project.release]
        raise UsageError(f"NEWTON={project.release} has no results; there are: {', '.join(there) or 'none'}")


if __name__ == "__main__":
    sys.exit(main())
