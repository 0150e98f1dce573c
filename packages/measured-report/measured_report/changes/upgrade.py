"""Upgrade: what a few sections say of a new edition, in a dozen lines: what changed, largest first, and what to do."""

import shlex
from collections.abc import Sequence
from dataclasses import replace

from measured_report.changes.alarm import largest, power, settings_text
from measured_report.changes.compare import Comparison
from measured_report.changes.moves import few
from measured_report.changes.query import Query
from measured_report.editions.project import Project
from measured_report.files.config import config
from measured_report.pages.editions import Edition
from measured_report.parts.claim import HOLDS
from measured_report.records.identity import sections as all_sections
from measured_report.records.provenance import package_changes


def deciding(project: Project) -> Sequence[str]:
    """Name the sections that tell most of an edition: those that report.toml names, or else all."""
    return config().changes.deciding or all_sections(project.root)


def base_of(project: Project) -> str | None:
    """Return what an edition is held against: the same release as it came out, or else the newest one before it.

    It has the deciding sections, in this profile or in full runs.
    """
    sides = [side.of(name) for side in (project, replace(project, profile="full")) for name in side.releases]
    plain = [side for side in sides if side.release == side.named.version != project.release and not lacking(side)]
    before = [side for side in plain if side.named.order <= project.named.order]
    return max(before, key=lambda side: side.named.order).release if before else None


def lacking(project: Project) -> list[str]:
    """Name the deciding sections that an edition has no record of."""
    return [section for section in deciding(project) if not project.record_path(section).exists()]


def verdict(found: Comparison, before: Edition, after: Edition) -> list[str]:
    """Return at most a dozen lines, worst first."""
    a, b = found.releases
    names = deciding(after.project)
    old, new = (
        [chapter.results.record for name, chapter in edition.chapters.items() if name in names]
        for edition in (before, after)
    )
    changed = package_changes(old[0].identity.packages, new[0].identity.packages) if old and new else []
    others = ", ".join(change for change in changed if not change.startswith(f"{config().package} "))
    machines = " and ".join(sorted({record.machine_text for record in new}))
    measured = f"{', '.join(record.section for record in new) or 'nothing'} on {machines or 'no machine'}"
    measured += "" if after.project.profile == "full" else f", {after.project.profile}"
    flips = [f"{flip.claim} {flip.outcomes}" for flip in found.flips]
    cause = Query(config().changes.cause, is_claim=True).claim(after.chapters)
    why = cause.text if cause and cause.outcome == HOLDS else "the sections that were measured do not say"
    asks_why = flips or any(not move.is_setting for move in found.alarms)
    return [
        f"{config().edition_name} {b} against {a}{f' ({others})' if others else ''}: {measured}",
        *([f"can't be trusted: {few([fault.text for fault in found.faults])}"] if found.faults else []),
        f"settings: {settings_text(found.settings)}",
        f"flipped: {few(flips) if flips else 'no claim'}",
        *(largest(found) or ["moved: nothing beyond the noise"]),
        f"would have shown: {power(found)}",
        *([f"why: {why}"] if asks_why else []),
        f"what to do: {_advice(found, before.project, after.project)}",
    ]


def _advice(found: Comparison, before: Project, after: Project) -> str:
    if found.faults:
        return "look at what can't be trusted first; nothing else can be said"
    profile = "" if after.profile == "full" else f" PROFILE={after.profile}"
    lists = f"make diff A={before.release} B={after.release} VALUES=all{profile} lists it"
    told = [f"VALUE={move.name}" for move in found.alarms if not move.is_gone]  # else there is no middle
    if asked := [*(f"CLAIM={flip.claim}" for flip in found.flips), *told]:
        ends = " ".join(shlex.quote(f"{name}={side.asked}") for name, side in (("A", before), ("B", after)))
        return f"make bisect {asked[0]} {ends} finds which change did it; {lists}"
    if any(not move.is_inconclusive for move in found.moves):
        return f"see whether what moved was meant to: {lists}"
    return "nothing; make report measures the rest"
