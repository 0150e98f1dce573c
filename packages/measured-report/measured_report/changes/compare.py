"""Compare editions: claims that flipped, numbers that moved, and faults of the results."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import groupby
from operator import attrgetter
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
    """A claim whose outcome differs between editions."""

    section: str
    name: str
    label: str
    page: Page
    answers: Sequence[tuple[Sequence[str], Claim]]
    """Neighbouring editions that agree, oldest first, with the claim of one of them."""

    @property
    def claim(self) -> str:
        """Return the name of the claim, as the option CLAIM= takes it."""
        return f"{self.section}.{self.name}"

    @property
    def ends(self) -> tuple[Claim, Claim]:
        """Return the claim of the oldest and of the newest edition."""
        return self.answers[0][1], self.answers[-1][1]

    @property
    def outcomes(self) -> str:
        return " → ".join(claim.outcome.answer for claim in self.ends)

    @property
    def is_decided(self) -> bool:
        """Return whether the claim holds in one edition and fails in another."""
        return len({claim.outcome.name for _, claim in self.answers} - {"unknown"}) > 1


def flips(releases: Releases, page_release: str) -> Iterator[Flip]:
    """Yield the claims whose outcome differs between editions.

    One claim represents each group of neighbouring editions that agree. It belongs to
    the page's own edition if this is in the group, and otherwise to the newest edition
    of the group.
    """
    sections = set().union(*releases.values())
    claims: dict[tuple[str, str], dict[str, Claim]] = {}
    for release, chapters in releases.items():
        is_whole = len(chapters) == len(sections)
        for section, chapter in chapters.items():
            for claim in chapter.section.claims:
                outcome = claim.outcome
                # A claim also cannot tell if a section that it reads is missing. This
                # does not count as an answer.
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
            representatives = [
                page_release if page_release in group else group[-1] for group in groups
            ]
            claims_of_groups = map(answers.__getitem__, representatives)
            group_answers = list(zip(groups, claims_of_groups, strict=True))
            chapter = releases[next(iter(answers))][section]
            label = chapter.results.label
            yield Flip(section, name, label, chapter.page, group_answers)


def _terms_of(
    section: str, claim: Claim, chapters: Chapters
) -> frozenset[tuple[Any, ...]]:
    """Return the conditions under which two answers to a claim can be compared.

    For a claim on costs these are the machine and the amount of work, and for a claim
    on the noise the processor. For other claims there are no conditions.
    """
    results = chapters[section].results
    columns = results.columns
    if section == columns.settings.noise_section:
        return frozenset({(results.record.processor,)})
    costs = [
        (record, row)
        for record, row, name in cells(claim.outcome.reads, chapters)
        if columns[name].is_cost
    ]
    return frozenset(cost_terms(record, row, columns) for record, row in costs)


def cells(
    pointers: Collection[str], chapters: Chapters
) -> list[tuple[Record, Mapping[str, Any], str]]:
    """Return the record, row and column of each pointer to a cell of these chapters."""
    records = {
        chapter.results.source: chapter.results.record for chapter in chapters.values()
    }
    return [
        (records[pointer.file], records[pointer.file].rows[cell[0]], cell[1])
        for pointer in map(Pointer, sorted(pointers))
        if pointer.file in records and (cell := pointer.cell)
    ]


def flips_between(before: Chapters, after: Chapters) -> list[Flip]:
    """Return the claims that hold in one of two editions and fail in the other.

    If both editions have the same sections, also return claims that can be decided in
    only one of them. Claims that cannot tell because of noise are left out.
    """
    is_whole = set(before) == set(after)
    return [
        flip
        for flip in flips({"before": before, "after": after}, "after")
        if not any(claim.outcome.is_inconclusive for _, claim in flip.answers)
        if flip.is_decided or is_whole
    ]


def backed(
    flips: Sequence[Flip], compared: Sequence[Move], noise_file: str
) -> list[Flip]:
    """Return the flips of claims that read a cell that moved, or that read no cells.

    Other claims may flip back when they are measured again. The cells of the section on
    noise, whose records are called ``noise_file``, do not count.
    """
    moves_by_row = grouped((row.source, move) for move in compared for row in move.rows)
    backed_flips = []
    for flip in flips:
        may_lack_trace = False
        cells_read = set()
        for _, claim in flip.answers:
            pointers = list(map(Pointer, claim.outcome.reads))
            cells_read |= {
                pointer
                for pointer in pointers
                if pointer.cell and noise_file not in pointer.file
            }
            # A record may be stored without its traces.
            has_traces = any(pointer.is_trace for pointer in pointers)
            may_lack_trace |= has_traces and claim.outcome.name == "unknown"
        moved = (_has_moved(pointer, moves_by_row) for pointer in cells_read)
        if not may_lack_trace and (not cells_read or any(moved)):
            backed_flips.append(flip)
    return backed_flips


def _has_moved(pointer: Pointer, moves_by_row: Mapping[str, Sequence[Move]]) -> bool:
    """Return whether a cell moved.

    All cells of a row count as moved if a text or flag in it changed, or if the row was
    not compared, for example because one edition lacks it.
    """
    row, _, column = pointer.text.rpartition("/")
    moves = [move for move in moves_by_row.get(row, ()) if move.is_real]
    columns = [column if move.chance is None else move.column.name for move in moves]
    return row not in moves_by_row or column in columns


@dataclass(frozen=True)
class FlipList:
    """Lists the flips between some editions for a page, by section.

    It prints the sentences of the editions that differ from the page's own.
    """

    editions: Sequence[str]
    page_edition: str
    sections: Collection[str]
    flips: Sequence[Flip] = ()
    settings: Config = field(default_factory=Config)

    def of(self, releases: Releases) -> "FlipList":
        """Return this list with its flips.

        The cache of derived sections does not contain them, because the words of a claim
        come from templates.
        """
        compared = {edition: releases[edition] for edition in self.editions}
        decided = [
            flip for flip in flips(compared, self.page_edition) if flip.is_decided
        ]
        chapter = next(iter(releases[self.page_edition].values()))
        return replace(self, flips=decided, settings=chapter.results.columns.settings)

    def __html__(self) -> Markup:
        names = self.settings.short_name
        return macros().turns(self.flips, self.page_edition, self.sections, names)


@dataclass(frozen=True)
class Fault:
    """A reason why results cannot be trusted."""

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
    """All differences between two editions."""

    releases: tuple[str, str]
    faults: list[Fault]
    flips: list[Flip]
    cells: list[Move]
    notes: list[str]
    report: Report

    @cached_property
    def moves(self) -> list[Move]:
        """Return the values that changed, the most relevant first.

        Numbers must change by more than their noise.
        """
        moves = [cell for cell in self.cells if cell.is_real]
        return sorted(moves, key=attrgetter("relevance"), reverse=True)

    @cached_property
    def number_count(self) -> int:
        return sum(cell.chance is not None for cell in self.cells)

    @property
    def settings(self) -> list[Move]:
        """Return the defaults and options that changed."""
        return [move for move in self.moves if move.is_setting]

    @cached_property
    def alarms(self) -> list[Move]:
        """Return the settings and numbers that changed by more than their threshold.

        A number that became better is not an alarm.
        """
        return [move for move in self.moves if move.is_alarm]

    @cached_property
    def improvements(self) -> list[Move]:
        """Return the numbers that became better by more than their threshold."""
        return [
            move for move in self.moves if move.exceeds_threshold and not move.is_alarm
        ]

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
        """Return whether the comparison raises an alarm."""
        return bool(self.faults or self.flips or self.alarms)


def compare(
    before: Edition, after: Edition, timed: Sequence[Edition] = ()
) -> Comparison:
    """Compare the results of two editions.

    ``timed`` may contain the same two editions with sections that were timed in turn on
    one machine. For these sections, the results in ``timed`` are compared.
    """
    sides = before.chapters, after.chapters
    pairs = dict(common_chapters(*sides))
    if timed:
        pairs |= common_chapters(*(edition.chapters for edition in timed))
    compared = [cell for pair in pairs.values() for cell in moves_between(*pair)]
    faults = [*_faults_between(before, after), *faults_of(before), *faults_of(after)]
    noise_file = f"/{after.project.report.settings.noise_section}.json"
    return Comparison(
        releases=(before.project.release, after.project.release),
        faults=list(dict.fromkeys(faults)),
        flips=backed(flips_between(*sides), compared, noise_file),
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
                yield f"{state.section}: {edition} {release} has no results"
    sections_by_machines: dict[str, list[str]] = {}
    for section, pair in common_chapters(before.chapters, after.chapters).items():
        records = [chapter.results.record for chapter in pair]
        columns = pair[0].results.columns
        units = {**records[0].units, **records[1].units}
        has_costs = any(columns[name].is_cost for name in units)
        if has_costs and records[0].machine_for_speed != records[1].machine_for_speed:
            machines = " and on ".join(record.machine_in_full for record in records)
            sections_by_machines.setdefault(machines, []).append(section)
    for machines, names in sections_by_machines.items():
        yield f"speed and cost in {', '.join(names)}: measured on {machines}"


def faults_of(edition: Edition) -> list[Fault]:
    """Return the faults of an edition.

    These are missing records, records that cannot be read or shown, and claims that
    cannot tell because a run broke down.
    """
    release = edition.project.release
    manifest = edition.project.manifest
    faults = []
    for state in edition.left_out:
        if state.kind != "missing":
            kind = "damaged" if state.kind == "damaged" else "not shown"
            faults.append(Fault(release, state.section, kind, state.words))
        elif manifest and state.section in manifest.sections:
            reason = "it was measured, but its results are missing"
            faults.append(Fault(release, state.section, "missing", reason))
    for name, chapter in edition.chapters.items():
        for claim in chapter.section.claims:
            if claim.outcome.name == "unknown" and not claim.outcome.is_inconclusive:
                lost_rows = [
                    row
                    for _, row, column in cells(claim.outcome.reads, edition.chapters)
                    if row.get(column) is None
                ]
                for reason in list(filter(None, map(_breakdown, lost_rows)))[:1]:
                    faults.append(
                        Fault(release, name, "cannot tell", reason, claim.name)
                    )
    return faults


def _faults_between(before: Edition, after: Edition) -> Iterator[Fault]:
    """Yield the faults that only one of two editions has.

    If runs broke down in both editions, this is not a fault; the claims show the effect.
    """
    for state in after.left_out:
        # If an edition has a manifest, `faults_of` finds its missing sections.
        is_missing = state.kind == "missing" and not after.project.manifest
        if is_missing and state.section in before.chapters:
            package = after.project.report.settings.edition
            reason = (
                f"it has no results, but {package} {before.project.release} has some"
            )
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
                suffix = f", and {len(reasons) - 1} more" if reasons[1:] else ""
                release = edition.project.release
                yield Fault(release, section, "broken", reasons[0] + suffix)


def _breakdown(row: Mapping[str, Any]) -> str:
    """Return the case of a run that broke down and the reason, or an empty string."""
    reason = row.get("failure") or next(iter(implausible_cells(row).values()), "")
    return reason and f"{row['case']}: {reason}"
