"""The command line that make calls; ``make help`` says what there is."""

import argparse
import sys

from report import ReportError, UsageError
from report.environment import enter
from report.identity import installed_release, sections
from report.measure import measure, measuring_device
from report.project import PROFILES, Project
from report.status import State, state_of, status_table


def main() -> int:
    arguments = _parse_arguments()
    try:
        _refuse_bad_input(arguments)
        if arguments.newton:
            enter(arguments.newton, sys.argv[1:])
        return COMMANDS[arguments.command](Project(installed_release(), arguments.profile), arguments)
    except ReportError as error:
        print(error, file=sys.stderr)
        return 2 if isinstance(error, UsageError) else 1


def report(project: Project, arguments: argparse.Namespace) -> int:
    """Measure what is not fresh, where that may be done unasked, and build the site."""
    device = measuring_device(arguments.device, project.profile)
    states = _states(project)
    for state in states:
        if state.name == "damaged":
            print(f"damaged record: {'; '.join(state.notes)}", file=sys.stderr)
    stale = [state.section for state in states if state.name != "fresh"]
    status = 0
    if stale and device:
        try:
            measure(project, stale, device)
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
    """Print which sections are fresh, and what changed for those that are not."""
    print(f"newton {project.release}")
    print(status_table(_states(project), project.profile))
    return 0


def check(project: Project, arguments: argparse.Namespace) -> int:
    """Print every claim of the report with its outcome."""
    from report.site import assemble

    for chapter in assemble(project, _states(project)).chapters:
        for claim in chapter.section.claims:
            print(f"{claim.outcome.name:8} {chapter.name}.{claim.name}: {claim.text}")
    return 0


def publish(project: Project, arguments: argparse.Namespace) -> int:
    """Put a checked copy of the site at the target."""
    from report import publish

    print(f"published at {publish.publish(project.site, arguments.target or '')}")
    return 0


COMMANDS = {"report": report, "rerun": rerun, "status": status, "check": check, "publish": publish}


def _build(project: Project) -> None:
    from report.site import assemble, build

    report = assemble(project, _states(project))
    build(report)
    for state in report.left_out:
        print(f"{state.section} is left out ({state.name}): {state.rerun(project.profile)} measures it")
    for chapter in report.chapters:
        if chapter.state.notes:
            print(f"{chapter.name} is stale: {chapter.state.rerun(project.profile)} renews it")
    print(f"built {project.site / 'index.html'}")


def _states(project: Project) -> list[State]:
    return [state_of(project, section) for section in sections()]


def _parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="build.py", description=__doc__)
    parser.add_argument("command", choices=COMMANDS)
    parser.add_argument("--section", help="section to measure")
    parser.add_argument("--newton", help="Newton release, where it is not the project's own")
    parser.add_argument("--device", help="cuda or cpu, to measure there on purpose")
    parser.add_argument("--profile", default="full", help="quick: small grids and short runs, kept apart")
    parser.add_argument("--target", help="where to publish, as dir:PATH")
    return parser.parse_args()


def _refuse_bad_input(arguments: argparse.Namespace) -> None:
    if arguments.profile not in PROFILES:
        raise UsageError(f"PROFILE={arguments.profile} is no profile; use one of: {', '.join(PROFILES)}")
    if arguments.command == "rerun" and arguments.section not in sections():
        raise UsageError(f"SECTION={arguments.section or ''} is no section; use one of: {', '.join(sections())}")
    if arguments.device:
        measuring_device(arguments.device, arguments.profile)


if __name__ == "__main__":
    sys.exit(main())
