"""Measure the sections of a release, in minutes, and say what changed."""

import os
import shlex
import sys
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TextIO

from measured_report.changes.alarm import (
    Say,
    largest,
    power,
    settings_text,
    summary,
    upgrade_text,
)
from measured_report.changes.compare import Comparison, Fault, compare
from measured_report.changes.moves import few
from measured_report.changes.query import Query
from measured_report.commands.options import Arguments, refuse_itself, shared
from measured_report.commands.report import measure_what_can
from measured_report.editions.project import Project
from measured_report.editions.release import Release, release_of
from measured_report.editions.status import records_of, states_of
from measured_report.files.atomic import atomic_file
from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.findings.editions import Edition, derive_edition, editions_of
from measured_report.measuring.accelerator import lacks
from measured_report.measuring.machine import machine_name, measuring_device
from measured_report.measuring.measure import kept_by
from measured_report.pages.editions import sentences_of
from measured_report.parts.claim import HOLDS
from measured_report.records.columns import column_of
from measured_report.records.identity import package_changes, sections
from measured_report.records.replicas import FOLDER, archive_of
from measured_report.site.build import build
from measured_report.values.evidence import is_absolute

TIMED = "timed"  # the folder below `results` of what two editions were timed for, each time anew
SINCE = {"type": partial(release_of, option="SINCE"), "help": "edition to compare with, in place of the one before"}
OPTIONS = {"since": SINCE, **shared("edition", "device", "profile", "format")}


def run(project: Project, arguments: Arguments) -> int:
    """Measure the few sections that decide, say what changed, largest first, and build the site; 1 for an alarm."""
    device = measuring_device(arguments.device, project.profile)
    base = arguments.since or release_of(base_of(project) or project.own_release)
    refuse_itself(str(base), project.release)
    answer = sys.stdout if arguments.format == "text" else _answer_file()
    # What may not install goes first: a base would be measured for nothing.
    sides = {arguments.release: True, base: False}
    unmeasured = {release: _unmeasured(project.of(str(release)), device, renews) for release, renews in sides.items()}
    for release, names in unmeasured.items():
        if names:
            took = sum(record.measured["seconds"] for record in records_of(project) if record.section in names)
            time = f", about {took:.0f} s of a processor as last time" if took else ""
            print(f"{config().edition} {release}: to be measured are {', '.join(names)}{time}", flush=True)
    after, before = (_measured(project, release, device, names) for release, names in unmeasured.items())
    compared = [*editions_of(project, among=[before.release, after.release]).values()]
    comparison = compare(compared[0], compared[1], timed_in_turn([before, after], [base, arguments.release], device))
    absent = [Fault(after.release, section, "missing", "it could not be measured") for section in lacking(after)]
    comparison = replace(comparison, faults=[*absent, *comparison.faults])
    say = sentences_of(project)
    print(upgrade_text(comparison, verdict(comparison, say, *compared), arguments.format, say), file=answer, flush=True)
    if arguments.format == "text":  # the front page stays that of the project's own edition
        project = project.of(project.own_release or project.release)
        build(project)
        print(f"built {project.site.name}/index.html")
    return int(comparison.is_alarm)


def _answer_file() -> TextIO:
    """Return where the answer for a program goes; all else that is printed from now on, by others too, is no part."""
    sys.stdout.flush()
    answer = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    return answer


def _unmeasured(edition: Project, device: str | None, renews: bool) -> list[str]:
    """Name the sections that are to be measured, those that are stale too where it ``renews`` them."""
    stale = {state.section for state in states_of(edition) if state.kind != "fresh"} if device and renews else ()
    names = [section for section in upgrade_sections(edition) if section in {*stale, *lacking(edition)}]
    if names and not device:
        raise UsageError(f"{lacks()}, and with PROFILE=quick in minutes")
    return names


def _measured(project: Project, release: Release, device: str | None, names: Sequence[str]) -> Project:
    edition = project.of(str(release))
    if not names or not device:
        return edition
    print(f"{config().edition} {edition.release}: measuring {', '.join(names)}", flush=True)
    return measure_what_can(kept_by(edition, machine_name(device), names), release, names, device)[0]


def timed_in_turn(sides: Sequence[Project], releases: Sequence[Release], device: str | None) -> list[Edition]:
    """Time two editions twice, one after the other, on this machine; nothing where none is timed, or one can't be.

    How fast a machine is, what else it does and which card it has is then the same for both.
    """
    rules, measurable = config().changes, sections(sides[0].root)
    named = dict.fromkeys(name.partition(".")[0] for name in rules.thresholds if is_absolute(name.rpartition(".")[2]))
    if not device or not (names := [name for name in named if name in measurable]):
        return []
    timed = [replace(side, aside=TIMED) for side in sides]
    for again in (False, True):
        for index, release in enumerate(releases):
            print(f"{config().edition} {release}: timing {', '.join(names)}, in turn", flush=True)
            timed[index], is_done = measure_what_can(timed[index], release, names, device)
            if not is_done:
                return []
            if not again:
                records = [record for record in records_of(timed[index]) if record.section in names]
                with atomic_file(timed[index].results / FOLDER / "first.tgz") as temporary:
                    temporary.write_bytes(archive_of(records))
    return list(map(derive_edition, timed))


def upgrade_sections(project: Project) -> Sequence[str]:
    """Name the sections that tell most of an edition: those that report.toml names, or else all."""
    return config().changes.upgrade_sections or sections(project.root)


def base_of(project: Project) -> str | None:
    """Return the same release as it came out, or else the newest before it, that has the sections."""
    sides = [side.of(name) for side in (project, replace(project, profile="full")) for name in side.releases]
    plain = [side for side in sides if side.release == side.named.version != project.release and not lacking(side)]
    before = [side for side in plain if side.named.order <= project.named.order]
    return max(before, key=lambda side: side.named.order).release if before else None


def lacking(project: Project) -> list[str]:
    """Name the sections that an edition has no record of."""
    return [section for section in upgrade_sections(project) if not project.record_path(section).exists()]


def verdict(comparison: Comparison, say: Say, before: Edition, after: Edition) -> list[str]:
    """Return at most a dozen lines, worst first."""
    a, b = comparison.releases
    names = upgrade_sections(after.project)
    pair = [[chapter for name, chapter in side.chapters.items() if name in names] for side in (before, after)]
    old, new = ([chapter.results.record for chapter in chapters] for chapters in pair)
    changed = package_changes(old[0].identity.packages, new[0].identity.packages) if old and new else []
    packages = ", ".join(change for change in changed if not change.startswith(f"{config().edition} "))
    machines = " and ".join(sorted({record.machine_text for record in new}))
    measured = f"{', '.join(record.section for record in new) or 'nothing'} on {machines or 'no machine'}"
    measured += "" if after.project.profile == "full" else f", {after.project.profile}"
    flips = [f"{flip.claim} {flip.outcomes}" for flip in comparison.flips]
    query, why = Query(config().changes.explanation, is_claim=True), "the sections that were measured do not say"
    if given := [move for move in comparison.moves if move.is_setting or "computed" in column_of(move.column).kinds]:
        why = f"what it is set to changed: {few([f'{move.name} {move.ends}' for move in given])}"
    if (cause := query.claim(after.chapters)) and cause.outcome == HOLDS:
        why = say(query.section, cause)
    asks_why = flips or any(not move.is_setting for move in comparison.alarms)
    return [
        f"{config().edition_name} {b} against {a}{f' ({packages})' if packages else ''}: {summary(comparison)}",
        f"measured: {measured}",
        *([f"can't be trusted: {few([fault.text for fault in comparison.faults])}"] if comparison.faults else []),
        f"settings: {settings_text(comparison.settings)}",
        f"flipped: {few(flips) if flips else 'no claim'}",
        *(largest(comparison) or ["changed: nothing"]),
        f"smallest change that would have been seen: {power(comparison)}",
        *([f"why: {why}"] if asks_why else []),
        f"what to do: {_advice(comparison, before.project, after.project)}",
    ]


def _advice(comparison: Comparison, before: Project, after: Project) -> str:
    if comparison.faults:
        return "look at what can't be trusted first; nothing else can be said"
    profile = "" if after.profile == "full" else f" PROFILE={after.profile}"
    lists = f"make diff A={before.release} B={after.release} FORMAT=json{profile} lists it"
    values = [f"VALUE={move.name}" for move in comparison.alarms if not move.is_gone]  # else there is no middle
    if queries := [*(f"CLAIM={flip.claim}" for flip in comparison.flips), *values]:
        ends = shlex.join([f"A={before.asked}", f"B={after.asked}"])
        return f"make bisect {queries[0]} {ends} finds which change did it; {lists}"
    if comparison.moves:
        return f"see whether what changed was meant to: {lists}"
    return "nothing; make report measures the rest" if config().changes.upgrade_sections else "nothing"
