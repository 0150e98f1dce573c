"""Commands about editions: measured after an upgrade, searched for a change, told over time, removed."""

import argparse
import math
import os
import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, redirect_stdout
from dataclasses import replace
from pathlib import Path

from measured_report.changes.alarm import upgrade_text
from measured_report.changes.bisect import (
    ASIDE,
    CLONE,
    Alike,
    Bisection,
    bisect_commits,
    bisect_releases,
    commit_count,
    common_repository,
    said,
)
from measured_report.changes.compare import compare
from measured_report.changes.history import flip_history
from measured_report.changes.history import history as history_of
from measured_report.changes.query import Query
from measured_report.changes.upgrade import base_of, deciding, seconds_expected, unmeasured, verdict
from measured_report.commands.building import build_site
from measured_report.commands.options import refuse_lacking_ends
from measured_report.deriving.editions import editions_of
from measured_report.editions.devices import NO_CUDA, machine_name, measuring_device
from measured_report.editions.environment import environment_of
from measured_report.editions.label import read_label
from measured_report.editions.project import PROFILES, Project
from measured_report.editions.stack import Stack, releases_between, releases_of, stack_of
from measured_report.editions.status import records_of, states_of
from measured_report.files.atomic import locked
from measured_report.files.config import config
from measured_report.files.errors import ReportError, UsageError
from measured_report.files.suggestion import suggestion
from measured_report.measuring.measure import kept_by, measure, prepare
from measured_report.pages.prose import Templates
from measured_report.records.identity import sections

STDOUT, STDERR = 1, 2  # as programs that are started from here know them


def upgrade(project: Project, arguments: argparse.Namespace) -> int:
    """Measure the few sections that decide, say what changed, largest first, and build the site; 1 for an alarm."""
    device = measuring_device(arguments.device, project.profile)
    base = arguments.since or stack_of(base_of(project) or project.own_release)
    with nullcontext() if arguments.format == "text" else printing_to_stderr():
        stacks = base, arguments.stack
        lacking = [_lacking(project.of(str(stack.label)), device, renews=stack is not base) for stack in stacks]
        if device and all(lacking):
            prepare(project, arguments.stack, lacking[1], device)  # before a base is measured for nothing
        sides = [_with_deciding(project, stack, device, renews=stack is not base) for stack in stacks]
    names = [side.release for side in sides]
    editions = editions_of(project, Templates(project.templates), among=names)
    compared = [editions[name] for name in names]
    found = compare(*compared)
    found = replace(found, faults=[*unmeasured(sides[1]), *found.faults])
    print(upgrade_text(found, verdict(found, *compared), arguments.format))
    if arguments.format == "text":
        build_site(sides[1], "")
    return int(found.is_alarm)


def _with_deciding(project: Project, stack: Stack, device: str | None, *, renews: bool) -> Project:
    """Measure the deciding sections of a stack that are missing or, if ``renews``, stale; return its report."""
    side = project.of(str(stack.label))
    lacking = _lacking(side, device, renews=renews)
    if lacking and not device:
        quick = replace(project, profile="quick")
        full, short = (seconds_expected(each, "cpu", deciding(each)) / 60 for each in (project, quick))
        raise UsageError(f"{NO_CUDA}, in about {full:.0f} min, and with PROFILE=quick in about {short:.0f}")
    if lacking:
        minutes = max(seconds_expected(side, device, lacking) / 60, 1)
        what = f"{config().package} {side.release}: measuring {', '.join(lacking)}"
        print(f"{what}, about {minutes:.0f} min", flush=True)
        side = kept_by(side, machine_name(device), lacking)
        try:
            measure(side, stack, lacking, device)
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


def bisect(project: Project, arguments: argparse.Namespace) -> int:
    """Find the first release or commit between A and B that a claim or a value changes in, and which package did it."""
    refuse_lacking_ends(arguments, f"make bisect CLAIM={config().changes.example_claim} A=1.4.0 B=1.8.0")
    device = measuring_device(arguments.device, "quick")
    query, templates = _query(arguments, is_of_section=True), Templates(project.templates)
    search = Bisection(replace(project, profile="quick"), query, device, templates)
    repository = common_repository(arguments.a, arguments.b)
    count = commit_count(*repository) if repository else len(releases_between(arguments.a.label, arguments.b.label)) + 1
    print(_cost(search, count), flush=True)
    try:
        search.ends(arguments.a, arguments.b)
    except Alike as error:
        search = replace(search, project=project)
        told = f"{error} in a quick run; it takes full ones: {_cost(search, count)}"
        if device == "cpu" and not arguments.yes:
            raise UsageError(f"{told}; YES=1 begins") from None
        print(told, flush=True)
    ends = search.ends(arguments.a, arguments.b)
    if repository:
        clone = project.root / CLONE

        def is_first() -> bool | None:
            stack_of.cache_clear()  # there is another commit in the clone now
            return search.is_first(ends, stack_of(str(clone)))

        found = bisect_commits(*repository, clone, is_first)
    else:
        found = bisect_releases(search, arguments.a, arguments.b)
    print(f"{found}\n{query.text}: {said(ends[0])} → {said(ends[1])}")
    after = search.side(arguments.b)
    build_site(after, "")
    return 0


def _cost(search: Bisection, count: int) -> str:
    """Say how many steps a search among so many editions takes, and how long they may."""
    steps = 2 + math.ceil(math.log2(max(1, count)))
    minutes = seconds_expected(search.project, search.device, [search.query.section]) / 60
    kind = f"{search.project.profile} run of {search.query.section}"
    return f"about {steps} steps, each a {kind} of {max(1, round(minutes))} min where it was not measured before"


def newest(project: Project, arguments: argparse.Namespace) -> int:
    """Print, for a workflow, the newest release in the index, or else of one other package, if newer than all here."""
    package = config().package
    sides = (replace(project, profile=profile) for profile in PROFILES)
    known = [side.of(release) for side in sides for release in side.releases]
    newest_known = max((each.label for each in known), key=lambda label: label.order)
    releases = releases_of(package)
    if not releases:
        raise ReportError(f"the index says of no release of {package}; this takes the network")
    latest = read_label(releases[-1])
    if latest.order > newest_known.order:
        print(f"{package}={latest}\nwith=")
        return 0
    for other, *_ in config().changes.together:
        used = {record.identity.packages[other] for each in known for record in records_of(each)}
        for newer in releases_of(other)[-1:]:
            if newer not in used:
                print(f"{package}={newest_known.version}\nwith={other}=={newer}")
                return 0
    return 0


def history(project: Project, arguments: argparse.Namespace) -> int:
    """Print a value or a claim over all editions; without one, the numbers that say most and the claims that flip."""
    editions = editions_of(project, Templates(project.templates))
    releases = {release: edition.chapters for release, edition in editions.items()}
    if not (arguments.claim or arguments.value):
        told = [history_of(releases, Query(value)) for value in config().changes.headlines.values()]
        print("\n\n".join([*told, flip_history(releases, project.release)]))
        return 0
    query = _query(arguments)
    if not any(query.answer(each) is not None or query.text in query.names(each) for each in releases.values()):
        hint = suggestion(query.text, query.names(releases[project.release]))
        raise UsageError(f"no edition has {query.given}{hint}; {query.example} is one")
    print(history_of(releases, query))
    return 0


def retire(project: Project, arguments: argparse.Namespace) -> int:
    """Remove all that an edition left, or, where none is named, that searches left; with LIST=1 say how much it is."""
    root, package = project.root, config().package
    if arguments.list:
        sizes = {folder: _bytes_in(folder) for folder in [*_folders(root), *_left_by_searches(project)]}
        for folder, size in sizes.items():
            print(f"{size / 1e6:9.1f} MB  {folder.relative_to(root)}/")
        print(f"{sum(sizes.values()) / 1e6:9.1f} MB  in all")
        return 0
    if project.is_own:
        gone = _left_by_searches(project)
    else:
        sides = [replace(project, profile=profile, aside=aside) for aside in ("", ASIDE) for profile in PROFILES]
        gone = [*(side.results for side in sides), environment_of(arguments.stack, root)]
    gone = [folder for folder in gone if folder.is_dir()]
    if not gone and project.is_own:
        other = f"{config().option}=1.5.0 names another"
        raise UsageError(
            f"no search left anything; {package} {project.release} is the project's own and stays; {other}"
        )
    if not gone:
        raise UsageError(f"{config().option}={arguments.stack.asked} has neither results nor an environment")
    for folder in gone:
        with locked(folder.parent):
            shutil.rmtree(folder)
        print(f"removed {folder.relative_to(root)}/")
    return int(build_site(project.of(project.own_release or project.release), arguments.address)[0])


def _folders(root: Path) -> list[Path]:
    """The folders of editions: their environments and results."""
    name = config().edition_folder("*")
    return sorted([*root.glob(f".venv-{name}"), *root.glob(f"results/{name}"), *root.glob(f"results/quick/{name}")])


def _left_by_searches(project: Project) -> list[Path]:
    """What bisect made: its records, its clone, environments of what has no records of its own, and empty folders."""
    root, folders = project.root, _folders(project.root)
    kept = {f".venv-{folder.name}" for folder in folders if any(folder.glob("*.json"))}
    clones = config().edition_folder(CLONE)
    lone = [
        folder
        for folder in folders
        if (folder.parent == root and folder.name not in kept and _is_of_search(folder.name, clones))
        or not any(folder.iterdir())
    ]
    return [folder for folder in (root / "results" / ASIDE, root / CLONE) if folder.is_dir()] + lone


def _is_of_search(name: str, clones: str) -> bool:
    """Whether an environment of that name is of a release, or of the clone; that of somebody's checkout is not."""
    place = name.removeprefix(".venv-")
    return place.startswith(clones) or read_label(config().edition_in(place)) is not None


def _bytes_in(folder: Path) -> int:
    return sum(path.lstat().st_size for path in folder.rglob("*"))


def _query(arguments: argparse.Namespace, *, is_of_section: bool = False) -> Query:
    """Return what CLAIM or VALUE asks, if ``is_of_section`` of one that there is: what that has is not known yet."""
    if bool(arguments.claim) == bool(arguments.value):
        examples = " and ".join(Query("", is_claim).example for is_claim in (True, False))
        raise UsageError(f"one of {examples} is needed")
    query = Query(arguments.claim or arguments.value, bool(arguments.claim))
    if is_of_section and (query.section not in sections() or query.section == query.text):
        hint = suggestion(query.section, sections())
        raise UsageError(f"{query.given} is in no section{hint}; {query.example} is")
    return query
