"""Faults: why the results of an edition can't be trusted; whoever waits for an alarm hears of them before all else."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from measured_report.changes.costs import cells
from measured_report.claims.claim import Claim
from measured_report.deriving.chapters import Chapter
from measured_report.deriving.editions import Edition
from measured_report.files.config import config
from measured_report.records.columns import REASON, UNBELIEVED


@dataclass(frozen=True)
class Fault:
    """One thing that can't be trusted."""

    release: str
    section: str
    kind: str
    """``damaged``, ``missing``, ``not shown``, ``broken`` or ``cannot tell``."""
    reason: str
    claim: str = ""
    """The claim that can't be told for it."""

    @property
    def text(self) -> str:
        name = f"{self.section}.{self.claim}" if self.claim else self.section
        return f"{self.kind}: {config().package} {self.release}, {name}: {self.reason}"


def faults_of(edition: Edition) -> list[Fault]:
    """Return what an edition's own results say against it: records that are damaged, gone or can't be shown, and claims
    that can't be told because a run broke down."""
    release = edition.project.release
    found = [
        Fault(release, state.section, "damaged" if state.kind == "damaged" else "not shown", state.words)
        for state in edition.left_out
        if state.kind != "missing"
    ]
    for state in edition.left_out:
        if state.kind == "missing" and state.section in (noted_sections(edition) or ()):
            found.append(Fault(release, state.section, "missing", "it was measured, and its results are gone"))
    for chapter in edition.chapters.values():
        for claim in chapter.section.claims:
            if reason := _breakdown_behind(claim, edition):
                found.append(Fault(release, chapter.name, "cannot tell", reason, claim.name))
    return found


def faults_between(before: Edition, after: Edition) -> list[Fault]:
    """Return what speaks against one of two editions only because the other is sound there: sections that are gone, and
    runs that break down in a section that has none such in the other."""
    found = []
    for state in after.left_out:
        if state.kind == "missing" and state.section in before.chapters and noted_sections(after) is None:
            reason = f"no results, which {config().package} {before.project.release} has"
            found.append(Fault(after.project.release, state.section, "missing", reason))
    for section in before.chapters:
        if section in after.chapters:
            found += _broken(before, after, section)
    return found


def noted_sections(edition: Edition) -> Sequence[str] | None:
    """Return the sections that an edition notes as measured; None where it notes nothing, so that none is missed."""
    manifest = edition.project.manifest
    return manifest.sections if manifest else None


def _broken(before: Edition, after: Edition, section: str) -> Iterator[Fault]:
    """Yield the first broken run of a section in which the other edition has none.

    Where runs break down in both, as where a section looks for the edge at which they do, its claims decide.
    """
    sides = [(side, list(_broken_rows(side.chapters[section]))) for side in (before, after)]
    if sum(bool(rows) for _, rows in sides) == 1:
        for side, rows in sides:
            for row in rows[:1]:
                others = f", and {len(rows) - 1} more" if len(rows) > 1 else ""
                yield Fault(side.project.release, section, "broken", f"{row['case']}: {_breakdown(row)}{others}")


def _broken_rows(chapter: Chapter) -> Iterable[Mapping[str, Any]]:
    return (row for row in chapter.results.record.rows if _breakdown(row))


def _breakdown(row: Mapping[str, Any], column: str = "") -> str:
    """Say why a run, or a number of it, can't be trusted; empty where nothing is against it."""
    reasons = [row.get(name) for name in row if name == column + REASON or (not column and name.endswith(REASON))]
    unbelieved = [reason for reason in reasons if str(reason).startswith(UNBELIEVED)]
    return row.get("failure") or next(iter(unbelieved), "")


def _breakdown_behind(claim: Claim, edition: Edition) -> str:
    """Name the broken run for which a claim can't be told; empty where there is none."""
    if claim.outcome.name != "unknown" or claim.outcome.is_near:
        return ""
    found = (
        f"{row['case']}: {reason}"
        for _, row, column in cells(claim.outcome.reads, edition.chapters)
        if row.get(column) is None and (reason := _breakdown(row, column))
    )
    return next(found, "")
