"""Upgrade: what a few sections say of a new edition, in five lines: what flipped, what moved, why, and what to do."""

import shlex
from collections.abc import Sequence
from dataclasses import replace

from measured_report.changes.compare import Comparison
from measured_report.changes.faults import Fault
from measured_report.changes.moves import Move
from measured_report.changes.query import Query
from measured_report.claims.claim import HOLDS
from measured_report.deriving.editions import Edition
from measured_report.editions.project import Project
from measured_report.files.config import config
from measured_report.measuring.measure import seconds_known
from measured_report.records.provenance import package_changes
from measured_report.records.record import Record

NAMED = 4
"""Claims that are named in a line."""


def seconds_expected(project: Project, device: str, sections: Sequence[str]) -> float:
    """Return how long the sections may take [s], by what they took before."""
    rules = config().changes
    guess = rules.deciding_seconds.get(project.profile, 0.0) * len(sections) / max(1, len(rules.deciding))
    return seconds_known(project, device, sections) or guess


def base_of(project: Project) -> str | None:
    """Return the edition before this one that has the deciding sections, in this profile or in full runs."""
    found = {
        release
        for side in (project, replace(project, profile="full"))
        for release in side.releases
        if side.of(release).order < project.order and not _lacking(side.of(release))
    }
    return max(found, key=lambda release: project.of(release).order, default=None)


def _lacking(project: Project) -> list[str]:
    return [section for section in config().changes.deciding if not project.record_path(section).exists()]


def unmeasured(project: Project) -> list[Fault]:
    """Return a fault for each deciding section that should have been measured and is not there."""
    return [Fault(project.release, section, "missing", "it could not be measured") for section in _lacking(project)]


def verdict(found: Comparison, before: Edition, after: Edition) -> list[str]:
    """Return the lines, worst first."""
    a, b = found.releases
    lines = [f"{config().edition_name} {b} against {a}{_other_packages(before, after)}: {_measured(after)}"]
    if found.faults:
        lines.append(f"can't be trusted: {_few([fault.text for fault in found.faults])}")
    flips = [f"{flip.claim} {flip.outcomes}" for flip in found.flips]
    cause = Query(config().changes.cause, is_claim=True).claim(after.chapters)
    why = cause.text if cause and cause.outcome == HOLDS else "the sections that were measured do not say"
    return [
        *lines,
        f"flipped: {_few(flips) if flips else 'no claim'}",
        f"moved: {_moved(found.moves, before, after)}",
        f"why: {why if flips else 'nothing to explain'}",
        f"what to do: {_advice(found, before, after)}",
    ]


def _other_packages(before: Edition, after: Edition) -> str:
    """Name the other packages whose versions differ, which may be what moved a number."""
    sides = _deciding(before), _deciding(after)
    if not all(sides):
        return ""
    old, new = (records[0].identity.packages for records in sides)
    changed = package_changes(old, new, config().packages[1:])
    return f" ({', '.join(changed)})" if changed else ""


def _deciding(edition: Edition) -> list[Record]:
    names = config().changes.deciding
    return [chapter.results.record for name, chapter in edition.chapters.items() if name in names]


def _measured(edition: Edition) -> str:
    records = _deciding(edition)
    if not records:
        return "nothing of it could be measured"
    machines = sorted({record.machine_text for record in records})
    seconds = sum(record.measured["seconds"] for record in records)
    profile = "" if edition.project.profile == "full" else f", {edition.project.profile}"
    return f"{', '.join(record.section for record in records)} on {' and '.join(machines)}, {seconds:.0f} s{profile}"


def _few(names: Sequence[str]) -> str:
    more = f"; and {len(names) - NAMED} more" if len(names) > NAMED else ""
    return "; ".join(names[:NAMED]) + more


def _moved(moves: Sequence[Move], before: Edition, after: Edition) -> str:
    rules = config().changes
    old, new = (Query(rules.headline).quantity(edition.chapters) for edition in (before, after))
    better, worse = (sum(move.mark == mark for move in moves) for mark in ("better", "worse"))
    headline = f"{rules.headline_label} {old} → {new}; " if rules.headline else ""
    return f"{headline}{len(moves)} values beyond the noise, {better} better, {worse} worse"


def _advice(found: Comparison, before: Edition, after: Edition) -> str:
    a, b = before.project.asked, after.project.asked
    if found.faults:
        return "look at what can't be trusted first; nothing else can be said"
    if found.flips:
        ends = f"{shlex.quote(f'A={a}')} {shlex.quote(f'B={b}')}"
        return f"make bisect CLAIM={found.flips[0].claim} {ends} finds which change did it"
    if any(not move.is_near for move in found.moves):
        profile = "" if after.project.profile == "full" else f" PROFILE={after.project.profile}"
        ends = f"A={before.project.release} B={after.project.release}"
        return f"see whether what moved was meant to: make diff {ends} VALUES=all{profile} lists it"
    return "nothing; make report measures the rest"
