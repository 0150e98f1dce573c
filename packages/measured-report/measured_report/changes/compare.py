"""Comparison of two editions: what can't be trusted, which claims flipped, and which values moved beyond the noise."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from measured_report.changes.flips import Flip, backed, cells, flips_between
from measured_report.changes.moves import Move, cells_between
from measured_report.files.config import config
from measured_report.pages.editions import Edition
from measured_report.records.columns import UNBELIEVED, column_of
from measured_report.values.scatter import discoveries


@dataclass(frozen=True)
class Fault:
    """Give a reason not to trust results."""

    release: str
    section: str
    kind: str
    """``damaged``, ``missing``, ``not shown``, ``broken`` or ``cannot tell``."""
    reason: str
    claim: str = ""
    """The claim that can't be told for it."""

    @property
    def text(self) -> str:
        place = f"{self.section}.{self.claim}".rstrip(".")
        return f"{self.kind}: {config().package} {self.release}, {place}: {self.reason}"


@dataclass(frozen=True)
class Comparison:
    """Hold all differences between two editions."""

    releases: tuple[str, str]
    faults: list[Fault]
    flips: list[Flip]
    cells: list[Move]
    """Values that compare, moved or not."""
    notes: list[str]
    """Said of what could not be compared, and why."""

    @cached_property
    def moves(self) -> list[Move]:
        """Return the cells that moved beyond the noise."""
        return [cell for cell in self.cells if cell.is_real]

    @cached_property
    def settings(self) -> list[Move]:
        """Return defaults and options that are not the same."""
        return [move for move in self.moves if move.is_setting]

    @cached_property
    def alarms(self) -> list[Move]:
        """Return settings and named numbers that moved by more than their threshold."""
        return [move for move in self.moves if move.exceeds_threshold]

    @property
    def missing(self) -> list[str]:
        """Name the numbers with a threshold that are not in both: they can raise no alarm."""
        there = {cell.name for cell in self.cells}
        return [name for name in config().changes.thresholds if name not in there]

    @property
    def is_alarm(self) -> bool:
        """Tell whether somebody has to look at it."""
        return bool(self.faults or self.flips or self.alarms)


def compare(before: Edition, after: Edition) -> Comparison:
    """Compare the results of two editions."""
    sides = before.chapters, after.chapters
    found = [cell for name in sides[0] if name in sides[1] for cell in cells_between(sides[0][name], sides[1][name])]
    limit = discoveries([cell.chance for cell in found if cell.chance is not None])
    found = [replace(cell, limit=limit) if cell.chance is not None and cell.is_real else cell for cell in found]
    return Comparison(
        releases=(before.project.release, after.project.release),
        faults=list(dict.fromkeys([*_faults_between(before, after), *faults_of(before), *faults_of(after)])),
        flips=backed(flips_between(*sides), found),
        cells=found,
        notes=[*_uncompared(before, after)],
    )


def _uncompared(before: Edition, after: Edition) -> Iterator[str]:
    """Name the sections that one edition lacks, and those whose costs are of other machines."""
    for side, other in ((before, after), (after, before)):
        for state in side.left_out:
            if state.kind == "missing" and state.section in other.chapters:
                yield f"{state.section}: {config().package} {side.project.release} has no results of it"
    apart: dict[str, list[str]] = {}
    for section in (name for name in before.chapters if name in after.chapters):
        records = [side.chapters[section].results.record for side in (before, after)]
        has_costs = any("cost" in column_of(name).kinds for name in records[0].units)
        if has_costs and len({record.machine_for_speed for record in records}) > 1:
            apart.setdefault(" and on ".join(record.machine_in_full for record in records), []).append(section)
    for machines, names in apart.items():
        yield f"speed and cost in {', '.join(names)}: measured on {machines}"


def faults_of(edition: Edition) -> list[Fault]:
    """Return what an edition's own results say against it: records that are damaged, gone or can't be shown, and claims
    that can't be told because a run broke down."""
    release, manifest, sections = edition.project.release, edition.project.manifest, edition.chapters
    found = []
    for state in edition.left_out:
        if state.kind != "missing":
            kind = "damaged" if state.kind == "damaged" else "not shown"
            found.append(Fault(release, state.section, kind, state.words))
        elif manifest and state.section in manifest.sections:
            found.append(Fault(release, state.section, "missing", "it was measured, and its results are gone"))
    for name, chapter in sections.items():
        for claim in chapter.section.claims:
            if claim.outcome.name == "unknown" and not claim.outcome.is_inconclusive:
                lost = (row for _, row, column in cells(claim.outcome.reads, sections) if row.get(column) is None)
                broken = next(filter(None, map(_breakdown, lost)), "")
                found += [Fault(release, name, "cannot tell", broken, claim.name)] if broken else []
    return found


def _faults_between(before: Edition, after: Edition) -> Iterator[Fault]:
    """Yield what speaks against one of two editions only because the other is sound there: sections that are gone, and
    the first run that breaks down in a section that has none such in the other.

    Where runs break down in both, as where a section looks for the edge at which they do, its claims decide.
    """
    for state in () if after.project.manifest else after.left_out:  # one that has it says itself what it misses
        if state.kind == "missing" and state.section in before.chapters:
            reason = f"no results, which {config().package} {before.project.release} has"
            yield Fault(after.project.release, state.section, "missing", reason)
    for section in (name for name in before.chapters if name in after.chapters):
        records = [side.chapters[section].results.record for side in (before, after)]
        broken = [list(filter(None, map(_breakdown, record.rows))) for record in records]
        for edition, reasons in zip((before, after), broken, strict=True):
            if reasons and not all(broken):
                others = f", and {len(reasons) - 1} more" if reasons[1:] else ""
                yield Fault(edition.project.release, section, "broken", reasons[0] + others)


def _breakdown(row: Mapping[str, Any]) -> str:
    """Say which run it is and why it can't be trusted; empty where nothing is against it."""
    unbelieved = (cell for cell in row.values() if isinstance(cell, str) and cell.startswith(UNBELIEVED))
    reason = row.get("failure") or next(unbelieved, "")
    return reason and f"{row['case']}: {reason}"
