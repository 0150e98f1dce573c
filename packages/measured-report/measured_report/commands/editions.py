"""Commands about editions: measured after an upgrade, searched for a change, told over time, removed."""

import argparse
import os
import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, redirect_stdout
from dataclasses import replace
from typing import TYPE_CHECKING

from measured_report import ReportError, UsageError
from measured_report.commands.building import build_site
from measured_report.commands.options import refuse_lacking_ends
from measured_report.editions.devices import NO_CUDA, machine_name, measuring_device
from measured_report.editions.environment import environment_of
from measured_report.editions.project import PROFILES, Project
from measured_report.editions.stack import Stack, stack_of
from measured_report.editions.status import states_of
from measured_report.files.files import locked
from measured_report.files.suggestion import suggestion
from measured_report.measuring.measure import kept_by, measure
from measured_report.records.identity import sections

if TYPE_CHECKING:
    from measured_report.changes.question import Question
    from measured_report.deriving.chapters import Releases

EXAMPLES = {True: "CLAIM=reproduction.slips", False: "VALUE=reproduction.as-shipped.slip_mm"}
"""By whether a claim is asked for."""
STDOUT, STDERR = 1, 2
"""As programs that are started from here know them."""


def upgrade(project: Project, arguments: argparse.Namespace) -> int:
    """Measure the few sections that decide, say in five lines what changed, and build the site; 1 for an alarm."""
    from measured_report.changes.alarm import upgrade_said
    from measured_report.changes.compare import compare
    from measured_report.changes.upgrade import base_of, unmeasured, verdict
    from measured_report.deriving.editions import editions_of
    from measured_report.pages.page import Templates

    device = measuring_device(arguments.device, project.profile)
    base = arguments.since or stack_of(base_of(project) or project.own_release)
    with nullcontext() if arguments.format == "text" else aside():
        sides = [_decided(project, stack, device, anew=stack is not base) for stack in (base, arguments.stack)]
    names = [side.release for side in sides]
    editions = editions_of(project, Templates(project.templates), among=names)
    found = compare(*(editions[name] for name in names))
    found = replace(found, faults=[*unmeasured(sides[1]), *found.faults])
    print(upgrade_said(found, verdict(found, *(editions[name] for name in names)), arguments.format))
    if arguments.format == "text":
        build_site(sides[1], "")
    return int(found.is_alarm)


def _decided(project: Project, stack: Stack, device: str | None, *, anew: bool) -> Project:
    """The report of a stack with what decides, measured where it is not there, or, ``anew``, not fresh."""
    from measured_report.changes.upgrade import DECIDING, seconds_expected

    side = project.of(str(stack.label))
    lacking = [section for section in DECIDING if not side.record_path(section).exists()]
    if device and anew:  # of what it is held against, what is there will do
        stale = [state.section for state in states_of(side) if state.kind != "fresh"]
        lacking = [section for section in DECIDING if section in stale]
    if lacking and not device:
        quick = replace(project, profile="quick")
        full, short = (seconds_expected(each, "cpu", DECIDING) / 60 for each in (project, quick))
        raise UsageError(f"{NO_CUDA}, in about {full:.0f} min, and with PROFILE=quick in about {short:.0f}")
    if lacking:
        minutes = seconds_expected(side, device, lacking) / 60
        print(f"newton {side.release}: measuring {', '.join(lacking)}, about {max(minutes, 1):.0f} min", flush=True)
        side = kept_by(side, machine_name(device), lacking)
        try:
            measure(side, stack, lacking, device)
        except UsageError:
            raise
        except ReportError as error:  # what could be measured may say enough
            print(error, file=sys.stderr)
    return side


@contextmanager
def aside() -> Iterator[None]:
    """Within it, what is printed, by other programs as well, goes where errors go: the answer is for a program."""
    sys.stdout.flush()
    kept = os.dup(STDOUT)
    os.dup2(STDERR, STDOUT)
    try:
        with redirect_stdout(sys.stderr):
            yield
    finally:
        os.dup2(kept, STDOUT)
        os.close(kept)


def bisect(project: Project, arguments: argparse.Namespace) -> int:
    """Find the first release or commit between A and B that a claim or a value changes in, and which package did it."""
    from measured_report.changes.bisect import Alike, Bisection, bisect_commits, bisect_releases, common_repository
    from measured_report.pages.page import Templates

    refuse_lacking_ends(arguments, "make bisect CLAIM=reproduction.slips A=1.4.0 B=1.8.0")
    device = measuring_device(arguments.device, "quick")
    question, templates = _question(arguments), Templates(project.templates)
    search = Bisection(replace(project, profile="quick"), question, device, templates)
    try:
        search.ends(arguments.a, arguments.b)
    except Alike as error:
        print(f"{error} in a quick run; it takes full ones", flush=True)
        search = replace(search, project=project)
    repository = common_repository(arguments.a, arguments.b)
    if not repository:
        print(bisect_releases(search, arguments.a, arguments.b))
        return 0
    ends = search.ends(arguments.a, arguments.b)
    clone = project.root / ".venv-bisect"
    judging = [sys.executable, str(project.root / "build.py"), "judge", "--newton", str(clone), "--device", device]
    judging += ["--profile", search.project.profile, f"--{'claim' if question.is_claim else 'value'}", question.text]
    judging += [f"--first={ends[0]}", f"--last={ends[1]}"]  # apart, a negative number looks like an option
    print(bisect_commits(*repository, judging, clone))
    return 0


def judge(project: Project, arguments: argparse.Namespace) -> int:
    """Say for git bisect, by the exit status, whether Newton is as the first end is or as the last."""
    from measured_report.changes.bisect import AS_FIRST, AS_LAST, CANNOT_TELL, Bisection
    from measured_report.pages.page import Templates

    question = _question(arguments)
    answer = Bisection(project, question, arguments.device, Templates(project.templates)).answer(arguments.stack)
    ends = (arguments.first, arguments.last) if question.is_claim else (float(arguments.first), float(arguments.last))
    if answer is None:
        return CANNOT_TELL
    return AS_FIRST if question.is_as(answer, *ends) else AS_LAST


def newest(project: Project, arguments: argparse.Namespace) -> int:
    """Print, for a workflow, what the index has of Newton, or else of one other package, newer than all here."""
    from measured_report.editions.label import read_label
    from measured_report.editions.stack import releases_of
    from measured_report.editions.status import records_of

    known = [each for profile in PROFILES for each in _editions(replace(project, profile=profile))]
    latest = [read_label(release) for release in releases_of("newton")[-1:]]
    if not latest:
        raise ReportError("the index says of no release of newton; this takes the network")
    if all(label.order > each.label.order for label in latest for each in known):
        print(f"newton={latest[0]}\nwith=")
        return 0
    newton = max((each.label for each in known), key=lambda label: label.order).version
    for package in ("warp-lang", "mujoco-warp"):
        used = {record.identity.packages[package] for each in known for record in records_of(each)}
        for version in releases_of(package)[-1:]:
            if version not in used:
                print(f"newton={newton}\nwith={package}=={version}")
                return 0
    return 0


def history(project: Project, arguments: argparse.Namespace) -> int:
    """Print a value or a claim over all editions; without one, the numbers that say most and the claims that flip."""
    from measured_report.changes.history import flip_history, history
    from measured_report.deriving.editions import editions_of
    from measured_report.pages.page import Templates

    editions = editions_of(project, Templates(project.templates))
    releases = {release: edition.uncompared for release, edition in editions.items()}
    if arguments.claim or arguments.value:
        question = _asked(arguments)
        _refuse_unknown(question, releases, project.release)
        print(history(releases, question))
        return 0
    from measured_report.changes.question import Question
    from report.sections.upgrade.tables import HEADLINES

    told = [history(releases, Question(headline.place, is_claim=False)) for headline in HEADLINES]
    print("\n\n".join([*told, flip_history(releases, project.release)]))
    return 0


def retire(project: Project, arguments: argparse.Namespace) -> int:
    """Remove results, environment and page of an edition."""
    if project.is_own:
        raise UsageError(f"newton {project.release} is the project's own and stays; NEWTON=1.5.0 names another")
    quick = replace(project, profile="quick")
    folders = [project.results, quick.results, environment_of(arguments.stack, project.root)]
    there = [folder for folder in folders if folder.is_dir()]
    if not there:
        raise UsageError(f"NEWTON={arguments.stack.asked} has neither results nor an environment")
    for folder in there:
        with locked(folder.parent):
            shutil.rmtree(folder)
        print(f"removed {folder.relative_to(project.root)}/")
    return int(build_site(project.of(project.own_release), arguments.address)[0])


def _question(arguments: argparse.Namespace) -> "Question":
    """What is asked, of a section that there is: whether that has it is known once it is measured."""
    question = _asked(arguments)
    if question.section not in sections() or question.section == question.text:
        hint = suggestion(question.section, sections())
        raise UsageError(f"{_given(question)} is in no section{hint}; {EXAMPLES[question.is_claim]} is")
    return question


def _asked(arguments: argparse.Namespace) -> "Question":
    from measured_report.changes.question import Question

    if bool(arguments.claim) == bool(arguments.value):
        raise UsageError(f"one of {EXAMPLES[True]} and {EXAMPLES[False]} is needed")
    return Question(arguments.claim or arguments.value, bool(arguments.claim))


def _refuse_unknown(question: "Question", releases: "Releases", shown: str) -> None:
    """What no edition knows is taken for a mistake; names like it are those of the edition ``shown``."""
    known = (question.answer(each) is not None or question.text in question.names(each) for each in releases.values())
    if not any(known):
        hint = suggestion(question.text, question.names(releases[shown]))
        raise UsageError(f"no edition has {_given(question)}{hint}; {EXAMPLES[question.is_claim]} is one")


def _given(question: "Question") -> str:
    return f"{'CLAIM' if question.is_claim else 'VALUE'}={question.text}"


def _editions(project: Project) -> list[Project]:
    return [project.of(release) for release in project.releases]
