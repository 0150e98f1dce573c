"""Measure the deciding sections of a release, and print the changes."""

import os
import shlex
import sys
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from operator import attrgetter
from typing import TextIO

from measured_report.changes.alarm import (
    Say,
    blind_sections,
    largest,
    sensitivity_text,
    settings_text,
    summary,
    upgrade_text,
)
from measured_report.changes.compare import (
    Comparison,
    Fault,
    common_chapters,
    compare,
)
from measured_report.changes.moves import few, moves_between
from measured_report.changes.query import Query
from measured_report.commands.options import Arguments, refuse_itself, shared
from measured_report.editions.project import Project
from measured_report.editions.release import Release, release_of
from measured_report.editions.status import Kind, records_of, states_of
from measured_report.files.atomic import write_file
from measured_report.files.errors import UsageError
from measured_report.findings.editions import Edition, derive_edition, editions_of
from measured_report.measuring.machine import lacks, measuring_device
from measured_report.measuring.measure import measure_available
from measured_report.pages.wording import sentences_of
from measured_report.parts.claim import HOLDS
from measured_report.records.identity import package_changes, sections
from measured_report.records.replicas import FOLDER, archive_of
from measured_report.values.evidence import is_absolute

TIMED = "timed"  # the folder below `results` for timings of two editions in turn
MOST_PASSES = 6
"""Chosen: a pass takes minutes, and six are enough unless times differ by more than half of
their threshold from one pass to the next."""
SINCE = {
    "type": partial(release_of, option="SINCE"),
    "help": "edition to compare with (default: the previous release)",
}
OPTIONS = {"since": SINCE, **shared("edition", "device", "profile", "format")}


def run(project: Project, arguments: Arguments) -> int:
    """Measure the deciding sections, print the changes, and return 1 for an alarm.

    The largest changes are printed first.
    """
    report = project.report
    device = measuring_device(arguments.device, project.profile)
    measurable = sections(project.root)
    names = report.settings.changes.upgrade_sections or measurable
    own = project.own_release or project.release
    base = arguments.since or release_of(base_of(project, names) or own)
    refuse_itself(project, str(base), project.release)
    output = sys.stdout if arguments.format == "text" else _output_file()
    # The newer edition is measured first: if it cannot be installed, there is no need to
    # measure its base.
    releases = [arguments.release, base]
    sides = [project.of(str(release)) for release in releases]
    unmeasured = []
    for side in sides:
        # The missing sections of both editions are measured. For the newer edition,
        # sections whose code has changed are measured too.
        kinds = {Kind.MISSING}
        if device and side.release == project.release:
            kinds |= {Kind.STALE, Kind.DAMAGED}
        states = {state.section for state in states_of(side) if state.kind in kinds}
        to_measure = [name for name in names if name in states]
        unmeasured.append(to_measure)
        if to_measure and not device:
            raise UsageError(f"{lacks()} (this takes minutes with PROFILE=quick)")
        if to_measure:
            label = f"{report.settings.edition} {side.release}"
            print(f"{label}: sections to measure: {', '.join(to_measure)}", flush=True)
    for index, to_measure in enumerate(unmeasured):
        if to_measure and device:
            label = f"{report.settings.edition} {releases[index]}"
            print(f"{label}: measuring {', '.join(to_measure)}", flush=True)
            sides[index], _ = measure_available(
                sides[index], releases[index], to_measure, device
            )
    after, before = sides
    editions = editions_of(project, among=[before.release, after.release])
    old, new = editions.values()
    timed = []
    if device:
        timed = timed_in_turn([before, after], releases[::-1], measurable, device)
    comparison = compare(old, new, timed)
    missing = [
        Fault(after.release, name, "missing", "it could not be measured")
        for name in lacking(after, names)
    ]
    comparison = replace(comparison, faults=[*missing, *comparison.faults])
    say = sentences_of(project)
    lines = verdict(comparison, say, before=old, after=new, names=names)
    text = upgrade_text(comparison, lines, arguments.format, say)
    print(text, file=output, flush=True)
    return int(comparison.is_alarm)


def _output_file() -> TextIO:
    """Return a file that writes to standard output, for text that a program reads.

    All other output of this process and its children then goes to standard error.
    """
    sys.stdout.flush()
    output = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    return output


def timed_in_turn(
    sides: Sequence[Project],
    releases: Sequence[Release],
    measurable: Sequence[str],
    device: str,
) -> list[Edition]:
    """Time two editions in turn on this machine, and return them.

    Both editions are then timed at the same speed and load of the machine. They are
    timed at least twice. More passes follow, at most ``MOST_PASSES``, until a change as
    large as its threshold would be detected in each number with a threshold. Return an
    empty list if there is no timed section, or if a timing fails.
    """
    report = sides[0].report
    timed_sections = {
        name.partition(".")[0]: None
        for name in report.settings.changes.thresholds
        if is_absolute(report.columns[name.rpartition(".")[2]])
    }
    names = [name for name in timed_sections if name in measurable]
    timed = in_turn(sides)
    editions: list[Edition] = []
    for number in range(1, MOST_PASSES + 1) if names else ():
        for index, release in enumerate(releases):
            if number == 1:
                _remove_passes(timed[index])
            else:
                _keep_pass(timed[index], names, number - 1)
            print(
                f"{report.settings.edition} {release}: timing {', '.join(names)} in "
                f"turn, pass {number}",
                flush=True,
            )
            timed[index], is_done = measure_available(
                timed[index], release, names, device
            )
            if not is_done:
                return []
        # A single pass does not show how the times scatter.
        if number > 1:
            editions = list(map(derive_edition, timed))
            if not hidden_times(*editions):
                break
    return editions


def in_turn(sides: Sequence[Project]) -> list[Project]:
    """Return the projects with the timings of two editions in turn."""
    pair = "-".join(sorted(side.results.name for side in sides))
    return [replace(side, aside=f"{TIMED}/{pair}") for side in sides]


def _remove_passes(project: Project) -> None:
    """Remove the passes of an earlier upgrade, which may have run on another machine."""
    for path in (project.results / FOLDER).glob("pass-*.tgz"):
        path.unlink()


def _keep_pass(project: Project, names: Sequence[str], number: int) -> None:
    """Store the records of a pass as a replica, before they are measured again."""
    records = [record for record in records_of(project) if record.section in names]
    write_file(project.results / FOLDER / f"pass-{number}.tgz", archive_of(records))


def hidden_times(before: Edition, after: Edition) -> list[str]:
    """Return the times whose noise may hide a change above their threshold."""
    pairs = common_chapters(before.chapters, after.chapters).values()
    moves = [move for pair in pairs for move in moves_between(*pair)]
    return [
        move.name
        for move in moves
        if move.is_named and is_absolute(move.column)
        if move.noise and move.noise > move.threshold * abs(move.before)
    ]


def base_of(project: Project, names: Sequence[str]) -> str | None:
    """Return the published release of this version, or else the release before it.

    Only editions that have records of all these sections are considered.
    """
    profiles = project, replace(project, profile="full")
    sides = [side.of(release) for side in profiles for release in side.releases]
    candidates = [
        side
        for side in sides
        if side.release == side.named.version != project.release
        and side.named.order <= project.named.order
        and not lacking(side, names)
    ]
    if not candidates:
        return None
    return max(candidates, key=attrgetter("named.order")).release


def lacking(project: Project, names: Sequence[str]) -> list[str]:
    """Return the sections without a record in an edition."""
    return [name for name in names if not project.record_path(name).exists()]


def verdict(
    comparison: Comparison,
    say: Say,
    before: Edition,
    after: Edition,
    names: Sequence[str],
) -> list[str]:
    """Return the summary of an upgrade in at most a dozen lines.

    ``names`` are the sections that were measured for it.
    """
    settings = comparison.report.settings
    a, b = comparison.releases
    old, new = (
        [
            chapter.results.record
            for name, chapter in side.chapters.items()
            if name in names
        ]
        for side in (before, after)
    )
    other_packages = []
    for record in (*old[:1], *new[:1]):
        versions = record.identity.packages.items()
        other_packages.append(
            {name: version for name, version in versions if name != settings.edition}
        )
    packages = ", ".join(package_changes(*other_packages)) if old and new else ""
    packages = packages and f" ({packages})"
    machines = " and ".join(sorted({record.machine_text for record in new}))
    measured_names = ", ".join(record.section for record in new) or "nothing"
    measured = f"{measured_names} on {machines or 'no machine'}"
    measured += "" if after.project.profile == "full" else f", {after.project.profile}"
    flips = [f"{flip.claim} {flip.outcomes}" for flip in comparison.flips]
    faults = few([fault.text(settings) for fault in comparison.faults])
    return [
        f"{settings.edition_name} {b} against {a}{packages}: {summary(comparison)}",
        f"measured: {measured}",
        *([f"faults: {faults}"] if faults else []),
        f"settings: {settings_text(comparison.settings)}",
        f"flipped: {few(flips) if flips else 'no claim'}",
        *(largest(comparison) or ["changed: nothing"]),
        f"changes that would have been detected: {sensitivity_text(comparison)}",
        *_cause_lines(comparison, say, after),
        f"what to do: {_advice(comparison, before.project, after.project)}",
    ]


def _cause_lines(comparison: Comparison, say: Say, after: Edition) -> list[str]:
    """Return a line about the cause if a claim flipped or a number raised an alarm."""
    if not comparison.flips and all(move.is_setting for move in comparison.alarms):
        return []
    query = Query(comparison.report.settings.changes.explanation, is_claim=True)
    cause = query.claim(after.chapters)
    if cause and cause.outcome == HOLDS:
        return [f"why: {say(query.section, cause)}"]
    settings = [
        f"{move.name} {move.ends}"
        for move in comparison.moves
        if move.is_setting or "computed" in move.column.kinds
    ]
    if settings:
        return [f"why: settings changed: {few(settings)}"]
    return ["why: the measured sections do not show the cause"]


def _advice(comparison: Comparison, before: Project, after: Project) -> str:
    settings = comparison.report.settings
    if comparison.faults:
        return "fix the faults first, because nothing else can be concluded"
    profile = "" if after.profile == "full" else f" PROFILE={after.profile}"
    ends = f"A={before.release} B={after.release}"
    lists = f"make diff {ends} FORMAT=json{profile} lists every change"
    # A number that no longer exists cannot be followed between the editions.
    values = [f"VALUE={move.name}" for move in comparison.alarms if not move.is_gone]
    if queries := [*(f"CLAIM={flip.claim}" for flip in comparison.flips), *values]:
        specs = shlex.join([f"A={before.spec}", f"B={after.spec}"])
        return (
            f"make bisect {queries[0]} {specs} finds the change that caused it; {lists}"
        )
    if comparison.moves:
        return f"check whether the changes were intended: {lists}"
    if blind := blind_sections(comparison):
        return (
            f"measure again, because a change could be hidden in {few(blind)}: "
            f"make replicate {settings.option}={after.release}"
        )
    is_part = settings.changes.upgrade_sections
    return "nothing; make report measures the other sections" if is_part else "nothing"
