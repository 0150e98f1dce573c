"""Comparison of editions: which claims flip, what can't be trusted, and which values moved beyond the noise."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import groupby
from typing import Any

from markupsafe import Markup

from measured_report.changes.moves import Move, cells_between, cost_terms
from measured_report.files.config import Page, config
from measured_report.files.groups import grouped
from measured_report.findings.chapters import Chapters, Releases
from measured_report.findings.editions import Edition
from measured_report.parts.claim import Claim
from measured_report.parts.macros import macros
from measured_report.records.columns import UNBELIEVED, is_cost
from measured_report.records.record import Record
from measured_report.values.noise import FALSE_SHARE, discoveries
from measured_report.values.quantities import Pointer


@dataclass(frozen=True)
class Flip:
    """Hold a claim that editions answer differently."""

    section: str
    name: str
    label: str
    page: Page
    answers: Sequence[tuple[Sequence[str], Claim]]  # neighbours that agree, and the claim as one words it; oldest first

    @property
    def claim(self) -> str:
        """Name it as CLAIM= does."""
        return f"{self.section}.{self.name}"

    @property
    def ends(self) -> tuple[Claim, Claim]:
        """Return the claim as the oldest and as the newest of them have it."""
        return self.answers[0][1], self.answers[-1][1]

    @property
    def outcomes(self) -> str:
        return " → ".join(claim.outcome.answer for claim in self.ends)

    @property
    def is_decided(self) -> bool:
        """Tell whether one edition upholds it and another doesn't; or else one of them can't tell."""
        return len({claim.outcome.name for _, claim in self.answers} - {"unknown"}) > 1


def flips(releases: Releases, page_release: str) -> Iterator[Flip]:
    """Yield the claims that editions answer differently, as the page's own says it, ``shown``, or else the newest."""
    sections = set().union(*releases.values())
    claims: dict[tuple[str, str], dict[str, Claim]] = {}
    for release, chapters in releases.items():
        for section, chapter in chapters.items():
            for claim in chapter.section.claims:
                # That one can't tell says nothing where it lacks a section, unless it is for being near the noise.
                if claim.outcome.name != "unknown" or claim.outcome.is_inconclusive or len(chapters) == len(sections):
                    claims.setdefault((section, claim.name), {})[release] = claim
    for (section, name), answers in claims.items():
        terms = {release: _terms_of(section, claim, releases[release]) for release, claim in answers.items()}
        page_terms = terms.get(page_release, next(iter(terms.values())))
        outcomes = {release: claim.outcome.name for release, claim in answers.items() if terms[release] == page_terms}
        if len(groups := [list(group) for _, group in groupby(outcomes, outcomes.__getitem__)]) > 1:
            answered = [(group, answers[page_release if page_release in group else group[-1]]) for group in groups]
            chapter = releases[next(iter(answers))][section]
            yield Flip(section, name, chapter.results.label, chapter.page, answered)


def _terms_of(section: str, claim: Claim, chapters: Chapters) -> frozenset[tuple[Any, ...]]:
    """Return what a claim on costs, or on the noise, turns on that is of the machine and not of the edition."""
    if section == config().noise_section:
        return frozenset({(chapters[section].results.record.processor,)})
    costs = [pointer for pointer in claim.outcome.reads if is_cost(pointer.rpartition("/")[2])]
    return frozenset(cost_terms(record, row) for record, row, _ in cells(costs, chapters))


def cells(pointers: Collection[str], chapters: Chapters) -> list[tuple[Record, Mapping[str, Any], str]]:
    """Return record, row and column of each pointer to a cell of the edition's own records."""
    records = {chapter.results.source: chapter.results.record for chapter in chapters.values()}
    places = ((pointer.file, pointer.cell) for pointer in map(Pointer, sorted(pointers)) if pointer.file in records)
    return [(record := records[file], record.rows[cell[0]], cell[1]) for file, cell in places if cell]


def flips_between(before: Chapters, after: Chapters) -> list[Flip]:
    """Return the claims that one of two editions upholds and the other doesn't, or, if both are whole, can't tell."""
    is_whole = set(before) == set(after)
    all_flips = flips({"before": before, "after": after}, "after")
    near = (flip for flip in all_flips if not any(claim.outcome.is_inconclusive for _, claim in flip.answers))
    return [flip for flip in near if flip.is_decided or is_whole]


def backed(flips: Sequence[Flip], compared: Sequence[Move]) -> list[Flip]:
    """Return the flips of which something moved that their tests read: others may flip when measured again."""
    of_rows = grouped((row.source, move) for move in compared for row in move.rows)
    backed_flips = []
    for flip in flips:
        read = {pointer for _, claim in flip.answers for pointer in claim.outcome.reads if Pointer(pointer).cell}
        read = {pointer for pointer in read if f"/{config().noise_section}.json#" not in pointer}
        moved = (_moved(of_rows.get(row), column) for row, _, column in (pointer.rpartition("/") for pointer in read))
        is_untold = any(".csv.gz" in claim.outcome.reason for _, claim in flip.answers)
        backed_flips += [flip] if not is_untold and (not read or any(moved)) else []
    return backed_flips


def _moved(row: Sequence[Move] | None, column: str) -> bool:
    """Tell whether a number of a row did, or the row is lost in one of both; one that nothing compares has."""
    return row is None or any(move.is_real for move in row if move.column == column or move.chance is None)


@dataclass(frozen=True)
class FlipList:
    """List flips of some releases by section; printed, each has what others say than the page's own."""

    seen: Sequence[str]
    shown: str
    sections: Collection[str]
    flips: Sequence[Flip] = ()

    def of(self, releases: Releases) -> "FlipList":
        """Return the same with the flips, whose words are of each time and are not kept."""
        all_flips = flips({release: releases[release] for release in self.seen}, self.shown)
        return replace(self, flips=[flip for flip in all_flips if flip.is_decided])

    def __html__(self) -> Markup:
        return macros().turns(self.flips, self.shown, self.sections, config().short_name)


@dataclass(frozen=True)
class Fault:
    """Give a reason not to trust results."""

    release: str
    section: str
    kind: str  # `damaged`, `missing`, `not shown`, `broken` or `cannot tell`
    reason: str
    claim: str = ""

    @property
    def text(self) -> str:
        subject = f"{self.section}.{self.claim}".rstrip(".")
        return f"{self.kind}: {config().edition} {self.release}, {subject}: {self.reason}"


@dataclass(frozen=True)
class Comparison:
    """Hold all differences between two editions."""

    releases: tuple[str, str]
    faults: list[Fault]
    flips: list[Flip]
    cells: list[Move]
    notes: list[str]

    @cached_property
    def moves(self) -> list[Move]:
        """Return the cells that changed, beyond the noise of so many."""
        return [cell for cell in self.cells if cell.is_real]

    def alone(self, cell: Move) -> float:
        """Return the least difference of a cell that would count if no other changed."""
        count = sum(move.chance is not None for move in self.cells)
        return replace(cell, limit=FALSE_SHARE / max(1, count)).noise or 0.0

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
        names = {cell.name for cell in self.cells}
        return [name for name in config().changes.thresholds if name not in names]

    @property
    def is_alarm(self) -> bool:
        """Tell whether somebody has to look at it."""
        return bool(self.faults or self.flips or self.alarms)


def compare(before: Edition, after: Edition, timed: Sequence[Edition] = ()) -> Comparison:
    """Compare the results of two editions; sections that were ``timed`` in turn, in both, by their times there."""
    sides = before.chapters, after.chapters
    pairs = {name: (sides[0][name], sides[1][name]) for name in sides[0] if name in sides[1]}
    for name in set.intersection(*(set(edition.chapters) for edition in timed)) if timed else ():
        pairs[name] = timed[0].chapters[name], timed[1].chapters[name]
    compared = [cell for pair in pairs.values() for cell in cells_between(*pair)]
    chances = [cell.chance for cell in compared if cell.chance is not None]
    limit = max(discoveries(chances), FALSE_SHARE / max(1, len(chances)))
    compared = [replace(cell, limit=limit) if (cell.chance or 0.0) <= FALSE_SHARE else cell for cell in compared]
    releases = before.project.release, after.project.release
    faults = list(dict.fromkeys([*_faults_between(before, after), *faults_of(before), *faults_of(after)]))
    flips = backed(flips_between(*sides), compared)
    return Comparison(releases, faults, flips, compared, [*_uncompared(before, after)])


def _uncompared(before: Edition, after: Edition) -> Iterator[str]:
    for side, opposite in ((before, after), (after, before)):
        for state in side.left_out:
            if state.kind == "missing" and state.section in opposite.chapters:
                yield f"{state.section}: {config().edition} {side.project.release} has no results of it"
    sections_by_machines: dict[str, list[str]] = {}
    for section in (name for name in before.chapters if name in after.chapters):
        records = [side.chapters[section].results.record for side in (before, after)]
        if any(map(is_cost, records[0].units)) and len({record.machine_for_speed for record in records}) > 1:
            machines = " and on ".join(record.machine_in_full for record in records)
            sections_by_machines.setdefault(machines, []).append(section)
    for machines, names in sections_by_machines.items():
        yield f"speed and cost in {', '.join(names)}: measured on {machines}"


def faults_of(edition: Edition) -> list[Fault]:
    """Return what an edition's own results say against it: records that fail, claims that a broken run leaves open."""
    release, manifest, sections = edition.project.release, edition.project.manifest, edition.chapters
    faults = []
    for state in edition.left_out:
        if state.kind != "missing":
            kind = "damaged" if state.kind == "damaged" else "not shown"
            faults.append(Fault(release, state.section, kind, state.words))
        elif manifest and state.section in manifest.sections:
            faults.append(Fault(release, state.section, "missing", "it was measured, and its results are gone"))
    for name, chapter in sections.items():
        for claim in chapter.section.claims:
            if claim.outcome.name == "unknown" and not claim.outcome.is_inconclusive:
                lost = (row for _, row, column in cells(claim.outcome.reads, sections) if row.get(column) is None)
                broken = next(filter(None, map(_breakdown, lost)), "")
                faults += [Fault(release, name, "cannot tell", broken, claim.name)] if broken else []
    return faults


def _faults_between(before: Edition, after: Edition) -> Iterator[Fault]:
    """Yield what speaks against one of two editions because the other is sound; where neither is its claims decide."""
    for state in () if after.project.manifest else after.left_out:  # one that has it says itself what it misses
        if state.kind == "missing" and state.section in before.chapters:
            reason = f"no results, which {config().edition} {before.project.release} has"
            yield Fault(after.project.release, state.section, "missing", reason)
    for section in (name for name in before.chapters if name in after.chapters):
        records = [side.chapters[section].results.record for side in (before, after)]
        common = set.intersection(*({row["case"] for row in record.rows} for record in records))
        rows = [[row for row in record.rows if row["case"] in common] for record in records]
        broken = [list(filter(None, map(_breakdown, side))) for side in rows]
        for edition, reasons in zip((before, after), broken, strict=True):
            if reasons and not all(broken):
                more = f", and {len(reasons) - 1} more" if reasons[1:] else ""
                yield Fault(edition.project.release, section, "broken", reasons[0] + more)


def _breakdown(row: Mapping[str, Any]) -> str:
    """Say which run it is and why it can't be trusted; empty where nothing is against it."""
    unbelieved = (cell for cell in row.values() if isinstance(cell, str) and cell.startswith(UNBELIEVED))
    reason = row.get("failure") or next(unbelieved, "")
    return reason and f"{row['case']}: {reason}"
