"""The command line that make calls; ``make help`` says what there is."""

import argparse
import os
import subprocess
import sys
from functools import partial
from typing import Any

from report import ReportError, UsageError
from report.records.environment import python_of, refuse_bad_release
from report.records.identity import sections
from report.records.measure import NO_CUDA, measure, measuring_device
from report.records.project import PROFILES, Project, own_release
from report.records.status import expected_packages, states_of, status_matrix, status_table


def main() -> int:
    try:
        arguments = _parse_arguments()
        own = own_release()
        project = Project(arguments.newton or own, arguments.profile, own_release=own)
        result = arguments.run(project, arguments)
        sys.stdout.flush()
        return result
    except BrokenPipeError:  # whoever reads the output, as head, has enough of it
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except KeyboardInterrupt:
        print("stopped; what was measured before is kept", file=sys.stderr)
        return 130
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
        if state.kind == "damaged":
            print(f"damaged record: {'; '.join(state.notes)}", file=sys.stderr)
    stale = [state.section for state in states if state.kind != "fresh"]
    failed = False
    if stale and device:
        try:
            measure(project, stale, device)
        except UsageError:
            raise
        except ReportError as error:
            print(error, file=sys.stderr)
            failed = True
    if _build(project, arguments.address) and not device:
        print(f"{NO_CUDA}, in up to hours")
    return int(failed)


def rerun(project: Project, arguments: argparse.Namespace) -> int:
    """Measure one section, fresh or not, and build the site."""
    device = measuring_device(arguments.device, project.profile)
    if not device:
        raise UsageError(NO_CUDA)
    measure(project, [arguments.section], device)
    _build(project, arguments.address)
    return 0


def page(project: Project, arguments: argparse.Namespace) -> int:
    """Build the site from what is measured, and measure nothing."""
    _refuse_unmeasured(project)
    _build(project, arguments.address)
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
    from report.editions import editions_of
    from report.page import Templates

    _refuse_unmeasured(project)
    for chapter in editions_of(project, Templates(project.templates))[project.release].chapters.values():
        for claim in chapter.section.claims:
            said = f" ({claim.outcome.said})" if claim.outcome.name == "fails" else ""
            print(f"{claim.outcome.name:8} {chapter.name}.{claim.name}: {claim.text}{said}")
    return 0


def diff(project: Project, arguments: argparse.Namespace) -> int:
    """Print what differs between two releases; 1 when a claim flipped."""
    from report.compare import compare
    from report.editions import derive_edition
    from report.page import Templates

    sides = [project.of(arguments.a), project.of(arguments.b)]
    for side in sides:
        _refuse_unmeasured(side)
    templates = Templates(project.templates)
    comparison = compare((arguments.a, arguments.b), *(derive_edition(side, templates).chapters for side in sides))
    print(comparison.text)
    return 1 if comparison.flips else 0


def publish(project: Project, arguments: argparse.Namespace) -> int:
    """Put a checked copy of the site at the target."""
    from report.publish import publish as publish_site

    print(f"published at {publish_site(project.site, arguments.target)}")
    return 0


def test(project: Project, arguments: argparse.Namespace) -> int:
    """Run the tests with one release."""
    python = python_of(project.release, expected_packages(project), project.root)
    return subprocess.run([python, "-m", "pytest"], cwd=project.root, check=False).returncode


def _build(project: Project, address: str) -> bool:
    """Build the site, and say what it lacks; whether it lacks anything."""
    from report.site import build

    edition = build(project, address)
    stale = [name for name, chapter in edition.chapters.items() if chapter.state.notes]
    for state in edition.left_out:
        print(f"{state.section} is left out ({state.kind}): {project.rerun(state.section)} measures it")
    for name in stale:
        print(f"{name} is stale: {project.rerun(name)} renews it")
    print(f"built {project.site / 'index.html'}")
    return bool(edition.left_out or stale)


def _refuse_unmeasured(project: Project) -> None:
    """Where nothing is to be measured, a release that has no results is taken for a mistake; the own one is not."""
    if not project.is_own and not any(state.kind != "missing" for state in states_of(project)):
        there = ", ".join(release for release in project.releases if release != project.release) or "none"
        measuring = f"make report NEWTON={project.release} DEVICE=cpu measures it here"
        raise UsageError(f"NEWTON={project.release} has no results (there are: {there}); {measuring}")


def _section(name: str) -> str:
    if name not in sections():
        fault = f"SECTION={name} is no section" if name else "SECTION is missing"
        raise UsageError(f"{fault}; use one of: {', '.join(sections())}")
    return name


def _release(option: str, release: str) -> str:
    refuse_bad_release(option, release)
    return release


def _profile(name: str) -> str:
    if name not in PROFILES:
        raise UsageError(f"PROFILE={name} is no profile; use one of: {', '.join(PROFILES)}")
    return name


def _address(address: str) -> str:
    if address and not address.startswith(("https://", "http://")):
        raise UsageError(f"ADDRESS={address} is no address of a site; use one as https://example.org/shake/")
    return f"{address.rstrip('/')}/" if address else ""


# An option's type checks its default as well, so one that must be given has a default that is refused.
OPTIONS: dict[str, dict[str, Any]] = {
    "section": {"type": _section, "default": "", "help": "section to measure"},
    "newton": {"type": partial(_release, "NEWTON"), "help": "Newton release, where it is not the project's own"},
    "a": {"type": partial(_release, "A"), "default": "", "help": "Newton release to compare from"},
    "b": {"type": partial(_release, "B"), "default": "", "help": "Newton release to compare with it"},
    "device": {"help": "cuda or cpu, to measure there on purpose"},
    "profile": {"type": _profile, "default": "full", "help": "quick: small grids and short runs, kept apart"},
    "address": {"type": _address, "default": "", "help": "where the site will lie, as https://example.org/shake/"},
    "target": {"default": "", "help": "where to publish, as dir:PATH"},
}
COMMANDS = {
    report: ("newton", "device", "profile", "address"),
    page: ("newton", "profile", "address"),
    rerun: ("section", "newton", "device", "profile", "address"),
    status: ("newton", "profile"),
    check: ("newton", "profile"),
    diff: ("a", "b", "profile"),
    publish: ("target",),
    test: ("newton",),
}
"""What there is to run, and the options that each has."""


class _Parser(argparse.ArgumentParser):
    """One that says in one line what it can't read."""

    def error(self, message: str):
        raise UsageError(f"{message}; see {self.prog} --help")


def _parse_arguments() -> argparse.Namespace:
    parser = _Parser(prog="build.py", description=__doc__)
    parser.set_defaults(newton=None, profile="full")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for run, options in COMMANDS.items():
        command = commands.add_parser(run.__name__, help=run.__doc__, description=run.__doc__)
        command.set_defaults(run=run)
        for option in options:
            command.add_argument(f"--{option}", **OPTIONS[option])
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
