"""Comparison of editions: claims that flip, results that cannot be trusted, and values that moved."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import groupby
from typing import Any

from markupsafe import Markup

from measured_report.changes.moves import Move, cost_terms, moves_between
from measured_report.files.columns import implausible_cells
from measured_report.files.config import Config, Page, Report
from measured_report.files.groups import grouped
from measured_report.findings.chapters import Chapter, Chapters, Releases
from measured_report.findings.editions import Edition
from measured_report.parts.claim import Claim
from measured_report.parts.macros import macros
from measured_report.records.record import Record
from measured_report.values.quantities import Pointer


@dataclass(frozen=True)
class Flip:
    """Holds a claim that editions answer differently."""

    section: str
    name: str
    label: str
    page: Page
    answers: Sequence[tuple[Sequence[str], Claim]]
    """Oldest first: neighbours that agree, and the claim as one of them has it."""

    @property
    def claim(self) -> str:
        """Return the name that CLAIM= takes."""
        return f"{self.section}.{self.name}"

    @property
    def ends(self) -> tuple[Claim, Claim]:
        """Return the claim as the oldest and as the newest edition have it."""
        return self.answers[0][1], self.answers[-1][1]

    @property
    def outcomes(self) -> str:
        return " → ".join(claim.outcome.answer for claim in self.ends)

    @property
    def is_decided(self) -> bool:
        """Return whether one edition upholds it and another does not."""
        return len({claim.outcome.name for _, claim in self.answers} - {"unknown"}) > 1


def flips(releases: Releases, page_release: str) -> Iterator[Flip]:
    """Yield the claims that editions answer differently; the words are those of the
    page's own edition, or else of the newest."""
    sections = set().union(*releases.values())
    claims: dict[tuple[str, str], dict[str, Claim]] = {}
    for release, chapters in releases.items():
        is_whole = len(chapters) == len(sections)
        for section, chapter in chapters.items():
            for claim in chapter.section.claims:
                outcome = claim.outcome
                # Without a section that it reads a claim cannot tell, which is no answer.
                if outcome.name != "unknown" or outcome.is_inconclusive or is_whole:
                    claims.setdefault((section, claim.name), {})[release] = claim
    for (section, name), answers in claims.items():
        if len({claim.outcome.name for claim in answers.values()}) < 2:
            continue
        terms = {
            release: _terms_of(section, claim, releases[release])
            for release, claim in answers.items()
        }
        page_terms = terms.get(page_release, next(iter(terms.values())))
        outcomes = {
            release: claim.outcome.name
            for release, claim in answers.items()
            if terms[release] == page_terms
        }
        groups = [list(group) for _, group in groupby(outcomes, outcomes.__getitem__)]
        if len(groups) > 1:
            worded = [
                page_release if page_release in each else each[-1] for each in groups
            ]
            answered = list(zip(groups, map(answers.__getitem__, worded), strict=True))
            chapter = releases[next(iter(answers))][section]
            yield Flip(section, name, chapter.results.label, chapter.page, answered)


def _terms_of(
    section: str, claim: Claim, chapters: Chapters
) -> frozenset[tuple[Any, ...]]:
    """Return what editions must share for their answers to a claim to be compared: the
    machine, for a claim on costs or on the noise."""
    results = chapters[section].results
    columns = results.columns
    if section == columns.settings.noise_section:
        return frozenset({(results.record.processor,)})
    read = cells(claim.outcome.reads, chapters)
    costs = [(record, row) for record, row, name in read if columns[name].is_cost]
    return frozenset(cost_terms(record, row, columns) for record, row in costs)


def cells(
    pointers: Collection[str], chapters: Chapters
) -> list[tuple[Record, Mapping[str, Any], str]]:
    """Return record, row and column of each pointer to a cell of these chapters."""
    records = {each.results.source: each.results.record for each in chapters.values()}
    return [
        (records[pointer.file], records[pointer.file].rows[cell[0]], cell[1])
        for pointer in map(Pointer, sorted(pointers))
        if pointer.file in records and (cell := pointer.cell)
    ]


def flips_between(before: Chapters, after: Chapters) -> list[Flip]:
    """Return the claims that one of two editions upholds and the other does not, or, if
    both have the same sections, cannot tell."""
    is_whole = set(before) == set(after)
    return [
        flip
        for flip in flips({"before": before, "after": after}, "after")
        if not any(claim.outcome.is_inconclusive for _, claim in flip.answers)
        if flip.is_decided or is_whole
    ]


def backed(flips: Sequence[Flip], compared: Sequence[Move], noise: str) -> list[Flip]:
    """Return the flips of claims that read a cell that moved, of another section than
    that on ``noise``; others may flip back when they are measured again."""
    of_rows = grouped((row.source, move) for move in compared for row in move.rows)
    backed_flips = []
    for flip in flips:
        is_untold = False
        read = set()
        for _, claim in flip.answers:
            pointers = list(map(Pointer, claim.outcome.reads))
            read |= {each for each in pointers if each.cell and noise not in each.file}
            has_traces = any(
                each.is_trace for each in pointers
            )  # which records may lack
            is_untold |= has_traces and claim.outcome.name == "unknown"
        moved = (_has_moved(pointer, of_rows) for pointer in read)
        if not is_untold and (not read or any(moved)):
            backed_flips.append(flip)
    return backed_flips


def _has_moved(pointer: Pointer, of_rows: Mapping[str, Sequence[Move]]) -> bool:
    """Return whether a cell moved, or its row is lost in one edition; a row that nothing
    compares counts as moved."""
    row, _, name = pointer.text.rpartition("/")
    moved = [move for move in of_rows.get(row, ()) if move.is_real]
    names = [name if move.chance is None else move.column.name for move in moved]
    return row not in of_rows or name in names


@dataclass(frozen=True)
class FlipList:
    """Lists flips of some releases by section, as others than the page's own word them."""

    seen: Sequence[str]
    shown: str
    sections: Collection[str]
    flips: Sequence[Flip] = ()
    settings: Config = field(default_factory=Config)

    def of(self, releases: Releases) -> "FlipList":
        """Return the same with the flips, whose words are not kept between builds."""
        seen = {release: releases[release] for release in self.seen}
        decided = [flip for flip in flips(seen, self.shown) if flip.is_decided]
        chapters = next(iter(releases[self.shown].values()))
        return replace(self, flips=decided, settings=chapters.results.columns.settings)

    def __html__(self) -> Markup:
        names = self.settings.short_name
        return macros().turns(self.flips, self.shown, self.sections, names)


@dataclass(frozen=True)
class Fault:
    """Gives a reason not to trust results."""

    release: str
    section: str
    kind: str  # `damaged`, `missing`, `not shown`, `broken` or `cannot tell`
    reason: str
    claim: str = ""

    def text(self, settings: Config) -> str:
        subject = f"{self.section}.{self.claim}".rstrip(".")
        return (
            f"{self.kind}: {settings.edition} {self.release}, {subject}: {self.reason}"
        )


@dataclass(frozen=True)
class Comparison:
    """Holds all differences between two editions."""

    releases: tuple[str, str]
    faults: list[Fault]
    flips: list[Flip]
    cells: list[Move]
    notes: list[str]
    report: Report

    @cached_property
    def moves(self) -> list[Move]:
        """Return the cells that changed, beyond the noise of so many."""
        return [cell for cell in self.cells if cell.is_real]

    @cached_property
    def number_count(self) -> int:
        return sum(cell.chance is not None for cell in self.cells)

    @property
    def settings(self) -> list[Move]:
        """Return defaults and options that are not the same."""
        return [move for move in self.moves if move.is_setting]

    @cached_property
    def alarms(self) -> list[Move]:
        """Return settings and named numbers that moved by more than their threshold."""
        return [move for move in self.moves if move.exceeds_threshold]

    @property
    def missing(self) -> list[str]:
        """Return the numbers with a threshold that are not in both editions."""
        names = {cell.name for cell in self.cells}
        return [
            name
            for name in self.report.settings.changes.thresholds
            if name not in names
        ]

    @property
    def is_alarm(self) -> bool:
        """Return whether somebody has to look at it."""
        return bool(self.faults or self.flips or self.alarms)


def compare(
    before: Edition, after: Edition, timed: Sequence[Edition] = ()
) -> Comparison:
    """Compare the results of two editions; sections that were ``timed`` in turn, in both
    of these editions, by their times there."""
    sides = before.chapters, after.chapters
    pairs = dict(common_chapters(*sides))
    if timed:
        pairs |= common_chapters(*(edition.chapters for edition in timed))
    compared = [cell for pair in pairs.values() for cell in moves_between(*pair)]
    faults = [*_faults_between(before, after), *faults_of(before), *faults_of(after)]
    noise = f"/{after.project.report.settings.noise_section}.json"
    return Comparison(
        releases=(before.project.release, after.project.release),
        faults=list(dict.fromkeys(faults)),
        flips=backed(flips_between(*sides), compared, noise),
        cells=compared,
        notes=[*_uncompared(before, after)],
        report=after.project.report,
    )


def common_chapters(
    before: Chapters, after: Chapters
) -> dict[str, tuple[Chapter, Chapter]]:
    """Return the chapters of the sections that both editions have."""
    return {name: (before[name], after[name]) for name in before if name in after}


def _uncompared(before: Edition, after: Edition) -> Iterator[str]:
    edition = after.project.report.settings.edition
    for side, opposite in ((before, after), (after, before)):
        for state in side.left_out:
            if state.kind == "missing" and state.section in opposite.chapters:
                release = side.project.release
                yield f"{state.section}: {edition} {release} has no results of it"
    sections_by_machines: dict[str, list[str]] = {}
    for section, pair in common_chapters(before.chapters, after.chapters).items():
        records = [chapter.results.record for chapter in pair]
        columns = pair[0].results.columns
        has_costs = any(columns[name].is_cost for name in records[0].units)
        if has_costs and records[0].machine_for_speed != records[1].machine_for_speed:
            machines = " and on ".join(record.machine_in_full for record in records)
            sections_by_machines.setdefault(machines, []).append(section)
    for machines, names in sections_by_machines.items():
        yield f"speed and cost in {', '.join(names)}: measured on {machines}"


def faults_of(edition: Edition) -> list[Fault]:
    """Return what an edition's own results say against it: records that fail, and claims
    that cannot tell because a run broke down."""
    release = edition.project.release
    manifest = edition.project.manifest
    faults = []
    for state in edition.left_out:
        if state.kind != "missing":
            kind = "damaged" if state.kind == "damaged" else "not shown"
            faults.append(Fault(release, state.section, kind, state.words))
        elif manifest and state.section in manifest.sections:
            reason = "it was measured, and its results are gone"
            faults.append(Fault(release, state.section, "missing", reason))
    for name, chapter in edition.chapters.items():
        for claim in chapter.section.claims:
            if claim.outcome.name == "unknown" and not claim.outcome.is_inconclusive:
                read = cells(claim.outcome.reads, edition.chapters)
                lost = [row for _, row, column in read if row.get(column) is None]
                for reason in list(filter(None, map(_breakdown, lost)))[:1]:
                    faults.append(
                        Fault(release, name, "cannot tell", reason, claim.name)
                    )
    return faults


def _faults_between(before: Edition, after: Edition) -> Iterator[Fault]:
    """Yield what speaks against one of two editions because the other is sound; if both
    are broken, their claims decide."""
    for state in after.left_out:
        # An edition with a manifest says itself what it misses.
        is_missing = state.kind == "missing" and not after.project.manifest
        if is_missing and state.section in before.chapters:
            package = after.project.report.settings.edition
            reason = f"no results, which {package} {before.project.release} has"
            yield Fault(after.project.release, state.section, "missing", reason)
    for section, pair in common_chapters(before.chapters, after.chapters).items():
        records = [chapter.results.record for chapter in pair]
        cases = [{row["case"] for row in record.rows} for record in records]
        common = set.intersection(*cases)
        broken = [
            [
                reason
                for row in record.rows
                if row["case"] in common
                if (reason := _breakdown(row))
            ]
            for record in records
        ]
        for edition, reasons in zip((before, after), broken, strict=True):
            if reasons and not all(broken):
                more = f", and {len(reasons) - 1} more" if reasons[1:] else ""
                release = edition.project.release
                yield Fault(release, section, "broken", reasons[0] + more)


def _breakdown(row: Mapping[str, Any]) -> str:
    """Return which run it is and why it cannot be trusted; empty if nothing says so."""
    reason = row.get("failure") or next(iter(implausible_cells(row).values()), "")
    return reason and f"{row['case']}: {reason}"
