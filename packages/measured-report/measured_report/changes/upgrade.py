"""Upgrade: what a few sections say of a new edition, in a dozen lines: what changed, largest first, and what to do."""

import shlex
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from measured_report.changes.compare import Comparison
from measured_report.changes.faults import Fault
from measured_report.changes.largest import few, largest, power, settings_text
from measured_report.changes.query import Query
from measured_report.editions.project import Project
from measured_report.files.config import config
from measured_report.measuring.measure import seconds_known
from measured_report.pages.editions import Edition
from measured_report.parts.claim import HOLDS
from measured_report.records.identity import sections as all_sections
from measured_report.records.provenance import package_changes
from measured_report.records.record import Record


def seconds_expected(project: Project, device: str, sections: Sequence[str]) -> float:
    """Return how long the sections may take [s], by what they took before."""
    rules = config().changes
    guess = rules.deciding_seconds.get(project.profile, 0.0) * len(sections) / max(1, len(deciding(project)))
    return seconds_known(project, device, sections) or guess


def deciding(project: Project) -> Sequence[str]:
    """Name the sections that tell most of an edition: those that report.toml names, or else all."""
    return config().changes.deciding or all_sections(project.root)


def base_of(project: Project) -> str | None:
    """Return what an edition is held against: the same release as it came out, or else the newest one before it.

    It has the deciding sections, in this profile or in full runs.
    """
    sides = [side.of(name) for side in (project, replace(project, profile="full")) for name in side.releases]
    plain = [side for side in sides if side.release == side.named.version and not _lacking(side)]
    found = {side.release: side.named.order for side in plain if side.release != project.release}
    if project.named.version in found:
        return project.named.version
    return max((name for name in found if found[name] < project.named.order), key=found.__getitem__, default=None)


def _lacking(project: Project) -> list[str]:
    return [section for section in deciding(project) if not project.record_path(section).exists()]


def unmeasured(project: Project) -> list[Fault]:
    """Return a fault for each deciding section that should have been measured and is not there."""
    return [Fault(project.release, section, "missing", "it could not be measured") for section in _lacking(project)]


def verdict(found: Comparison, before: Edition, after: Edition) -> list[str]:
    """Return at most a dozen lines, worst first."""
    a, b = found.releases
    lines = [f"{config().edition_name} {b} against {a}{_other_packages(before, after)}: {_measured(after)}"]
    if found.faults:
        lines.append(f"can't be trusted: {few([fault.text for fault in found.faults])}")
    flips = [f"{flip.claim} {flip.outcomes}" for flip in found.flips]
    cause = Query(config().changes.cause, is_claim=True).claim(after.chapters)
    why = cause.text if cause and cause.outcome == HOLDS else "the sections that were measured do not say"
    asks_why = flips or any(not move.is_setting for move in found.alarms)
    return [
        *lines,
        f"settings: {settings_text(found.settings)}",
        f"flipped: {few(flips) if flips else 'no claim'}",
        *([group.text for group in largest(found)] or ["moved: nothing beyond the noise"]),
        f"would have shown: {power(found)}",
        *([f"why: {why}"] if asks_why else []),
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
    names = deciding(edition.project)
    return [chapter.results.record for name, chapter in edition.chapters.items() if name in names]


def _measured(edition: Edition) -> str:
    records = _deciding(edition)
    if not records:
        return "nothing of it could be measured"
    machines = sorted({record.machine_text for record in records})
    seconds = sum(record.measured["seconds"] for record in records)
    profile = "" if edition.project.profile == "full" else f", {edition.project.profile}"
    return f"{', '.join(record.section for record in records)} on {' and '.join(machines)}, {seconds:.0f} s{profile}"


def _advice(found: Comparison, before: Edition, after: Edition) -> str:
    if found.faults:
        return "look at what can't be trusted first; nothing else can be said"
    profile = "" if after.project.profile == "full" else f" PROFILE={after.project.profile}"
    lists = f"make diff A={before.project.release} B={after.project.release} VALUES=all{profile} lists it"
    told = [move.name for move in found.alarms if not move.is_gone]  # between a number and none there is no middle
    if found.flips or told:
        asked = f"CLAIM={found.flips[0].claim}" if found.flips else f"VALUE={told[0]}"
        query = Query(asked.partition("=")[2])
        device = after.chapters[query.section].results.record.machine["device"]
        minutes = max(1, round(seconds_expected(after.project, device, [query.section]) / 60))
        ends = " ".join(map(shlex.quote, _bisect_ends(before.project, after.project)))
        return f"make bisect {asked} {ends} finds which change did it, in about {minutes} min a step; {lists}"
    if any(not move.is_inconclusive for move in found.moves):
        return f"see whether what moved was meant to: {lists}"
    return "nothing; make report measures the rest"


def _bisect_ends(before: Project, after: Project) -> tuple[str, str]:
    """Name both editions to bisect: those of a repository as its commits, with the tag of the release that is older."""
    source, asked = after.named.source, after.asked
    folder = asked.rpartition("@")[0] or asked
    if source.startswith("g") and Path(folder).is_dir() and not before.named.source:
        return f"A={folder}@v{before.named.version}", f"B={folder}@{source[1:8]}"
    return f"A={before.asked}", f"B={asked}"
