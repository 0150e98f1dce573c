"""Upgrade: what a few sections say of a new Newton, in five lines: what flipped, what moved, why, and what to do."""

import shlex
from collections.abc import Sequence
from dataclasses import replace

from measured_report.changes.compare import Comparison, Move
from measured_report.changes.faults import Fault
from measured_report.changes.releases import Headline, cell
from measured_report.claims.claims import HOLDS
from measured_report.deriving.editions import Edition
from measured_report.editions.project import Project
from measured_report.files.config import config
from measured_report.measuring.measure import seconds_known
from measured_report.records.provenance import package_changes
from measured_report.records.record import Record

DECIDING = ("noise", "reproduction", "upgrade", "contact_source")
"""Sections that tell most in least time, the longest first: where several are measured at once that ends soonest."""
CPU_SECONDS = {"full": 770, "quick": 100}
"""What they take on two cores of a CPU, where no record says."""
SLIP = Headline("slip as shipped", "reproduction", "as-shipped", "slip_mm", "mm")
CAUSE = ("upgrade", "cause")
"""The claim that says why, where it holds."""
NAMED = 4
"""Claims that are named in the verdict."""


def seconds_expected(project: Project, device: str, sections: Sequence[str]) -> float:
    """How long the sections may take [s], by what they took before."""
    return seconds_known(project, device, sections) or CPU_SECONDS[project.profile] * len(sections) / len(DECIDING)


def base_of(project: Project) -> str | None:
    """The edition before this one that has what decides, in this profile or in full runs; None where there is none."""
    found = {
        release
        for side in (project, replace(project, profile="full"))
        for release in side.releases
        if side.of(release).order < project.order and _has_deciding(side.of(release))
    }
    return max(found, key=lambda release: project.of(release).order, default=None)


def _has_deciding(project: Project) -> bool:
    return all(project.record_path(section).exists() for section in DECIDING)


def unmeasured(project: Project) -> list[Fault]:
    """The sections that should have been measured, and are not there."""
    lacking = [section for section in DECIDING if not project.record_path(section).exists()]
    return [Fault(project.release, section, "missing", "it could not be measured") for section in lacking]


def verdict(found: Comparison, before: Edition, after: Edition) -> list[str]:
    """The lines, worst first."""
    a, b = found.releases
    lines = [f"Newton {b} against {a}{_other_packages(before, after)}: {_measured(after)}"]
    if found.faults:
        lines.append(f"can't be trusted: {_few([fault.text for fault in found.faults])}")
    flips = [
        f"{flip.section}.{flip.before.name} {flip.before.outcome.said} → {flip.after.outcome.said}"
        for flip in found.flips
    ]
    lines.append(f"flipped: {_few(flips) if flips else 'no claim'}")
    lines.append(f"moved: {_moved(found.moves, before, after)}")
    lines.append(f"why: {_why(after) if flips else 'nothing to explain'}")
    lines.append(f"what to do: {_advice(found, before, after)}")
    return lines


def _other_packages(before: Edition, after: Edition) -> str:
    """What else is of another version than it was, which may be what moved a number."""
    sides = _deciding(before), _deciding(after)
    if not all(sides):
        return ""
    old, new = (records[0].identity.packages for records in sides)
    changed = package_changes(old, new, config().packages[1:])
    return f" ({', '.join(changed)})" if changed else ""


def _deciding(edition: Edition) -> list[Record]:
    return [chapter.results.record for name, chapter in edition.chapters.items() if name in DECIDING]


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
    chapters = {"a": before.chapters, "b": after.chapters}
    slips = [cell(chapters, side, SLIP) for side in chapters]
    worse = sum(move.verdict == "worse" and not move.is_near for move in moves)
    better = sum(move.verdict == "better" and not move.is_near for move in moves)
    return f"{SLIP.label} {slips[0]} → {slips[1]}; {len(moves)} values beyond the noise, {better} better, {worse} worse"


def _why(after: Edition) -> str:
    section, name = CAUSE
    claims = after.chapters[section].section.claims if section in after.chapters else ()
    told = [claim for claim in claims if claim.name == name and claim.outcome == HOLDS]
    return told[0].text if told else "the sections that were measured do not say"


def _advice(found: Comparison, before: Edition, after: Edition) -> str:
    a, b = before.project.asked, after.project.asked
    if found.faults:
        return "look at what can't be trusted first; nothing else can be said"
    if found.flips:
        flip = found.flips[0]
        claim, ends = f"{flip.section}.{flip.before.name}", f"{shlex.quote(f'A={a}')} {shlex.quote(f'B={b}')}"
        return f"make bisect CLAIM={claim} {ends} finds which change did it"
    if any(not move.is_near for move in found.moves):
        profile = "" if after.project.profile == "full" else f" PROFILE={after.project.profile}"
        ends = f"A={before.project.release} B={after.project.release}"
        return f"see whether what moved was meant to: make diff {ends} VALUES=all{profile} lists it"
    return "nothing; make report measures the rest"
