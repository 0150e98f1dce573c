"""Faults: why the results of an edition can't be trusted; whoever waits for an alarm hears of them before all else."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from measured_report.changes.costs import cells
from measured_report.files.config import config
from measured_report.pages.editions import Edition
from measured_report.parts.claim import Claim
from measured_report.records.columns import REASON, UNBELIEVED


@dataclass(frozen=True)
class Fault:
    """A reason not to trust results."""

    release: str
    section: str
    kind: str
    """``damaged``, ``missing``, ``not shown``, ``broken`` or ``cannot tell``."""
    reason: str
    claim: str = ""
    """The claim that can't be told for it."""

    @property
    def place(self) -> str:
        return f"{self.section}.{self.claim}".rstrip(".")

    @property
    def text(self) -> str:
        return f"{self.kind}: {config().package} {self.release}, {self.place}: {self.reason}"


def faults_of(edition: Edition) -> list[Fault]:
    """Return what an edition's own results say against it: records that are damaged, gone or can't be shown, and claims
    that can't be told because a run broke down."""
    release = edition.project.release
    manifest, found = edition.project.manifest, []
    for state in edition.left_out:
        if state.kind != "missing":
            kind = "damaged" if state.kind == "damaged" else "not shown"
            found.append(Fault(release, state.section, kind, state.words))
        elif manifest and state.section in manifest.sections:
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
    for state in () if after.project.manifest else after.left_out:  # one that has it says itself what it misses
        if state.kind == "missing" and state.section in before.chapters:
            reason = f"no results, which {config().package} {before.project.release} has"
            found.append(Fault(after.project.release, state.section, "missing", reason))
    for section in before.chapters:
        if section in after.chapters:
            found += _broken(before, after, section)
    return found


def _broken(before: Edition, after: Edition, section: str) -> Iterator[Fault]:
    """Yield the first broken run of a section in which the other edition has none.

    Where runs break down in both, as where a section looks for the edge at which they do, its claims decide.
    """
    records = [(side.project.release, side.chapters[section].results.record) for side in (before, after)]
    sides = {release: [row for row in record.rows if _breakdown(row)] for release, record in records}
    if not all(sides.values()):
        for release, rows in sides.items():
            for row in rows[:1]:
                others = f", and {len(rows) - 1} more" if len(rows) > 1 else ""
                yield Fault(release, section, "broken", f"{row['case']}: {_breakdown(row)}{others}")


def _breakdown(row: Mapping[str, Any], column: str = "") -> str:
    """Say why a run, or a number of it, can't be trusted; empty where nothing is against it."""
    reasons = [str(row[name]) for name in row if name.endswith(REASON) and column in ("", name.removesuffix(REASON))]
    return row.get("failure") or next((reason for reason in reasons if reason.startswith(UNBELIEVED)), "")


def _breakdown_behind(claim: Claim, edition: Edition) -> str:
    """Name the broken run for which a claim can't be told; empty where there is none."""
    if claim.outcome.name != "unknown" or claim.outcome.is_inconclusive:
        return ""
    found = (
        f"{row['case']}: {reason}"
        for _, row, column in cells(claim.outcome.reads, edition.chapters)
        if row.get(column) is None and (reason := _breakdown(row, column))
    )
    return next(found, "")
