"""Flips: claims that editions answer differently, and what each of them says."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from markupsafe import Markup

from measured_report.changes.moves import Move, cost_terms
from measured_report.pages.editions import Chapters, Releases
from measured_report.pages.sections import Page
from measured_report.parts.claim import Claim
from measured_report.parts.macros import macros
from measured_report.records.columns import column_of
from measured_report.records.record import Record
from measured_report.values.noise import NOISE
from measured_report.values.quantities import Pointer


@dataclass(frozen=True)
class Flip:
    """Hold a claim that editions answer differently."""

    section: str
    name: str
    label: str
    page: Page
    said: Sequence[tuple[Sequence[str], Claim]]
    """Neighbouring editions that agree, and the claim as one of them words it; oldest first."""

    @property
    def claim(self) -> str:
        """Name it as CLAIM= does."""
        return f"{self.section}.{self.name}"

    @property
    def before(self) -> Claim:
        return self.said[0][1]

    @property
    def after(self) -> Claim:
        return self.said[-1][1]

    @property
    def outcomes(self) -> str:
        return f"{self.before.outcome.said} → {self.after.outcome.said}"

    @property
    def is_decided(self) -> bool:
        """Tell whether one edition upholds it and another doesn't; or else one of them can't tell."""
        return len({claim.outcome.name for _, claim in self.said} - {"unknown"}) > 1


def flips(releases: Releases, shown: str) -> Iterator[Flip]:
    """Yield the claims that editions answer differently.

    Of editions that agree the one of the page, ``shown``, has the word, or else the newest. That one can't tell says
    nothing where it lacks a section that another one has, unless it is for being near the noise; nor does what turns
    on a cost, or on the noise, of another machine than the page's.
    """
    sections = set().union(*releases.values())
    asked: dict[tuple[str, str], dict[str, Claim]] = {}
    for release, chapters in releases.items():
        for section, chapter in chapters.items():
            for claim in chapter.section.claims:
                if claim.outcome.name != "unknown" or claim.outcome.is_inconclusive or len(chapters) == len(sections):
                    asked.setdefault((section, claim.name), {})[release] = claim
    for (section, name), answers in asked.items():
        terms = {release: _terms_of(section, claim, releases[release]) for release, claim in answers.items()}
        here = terms.get(shown, next(iter(terms.values())))
        outcomes = {release: claim.outcome.name for release, claim in answers.items() if terms[release] == here}
        groups = [list(group) for _, group in groupby(outcomes, outcomes.__getitem__)]
        if len(groups) > 1:
            said = [(group, answers[shown if shown in group else group[-1]]) for group in groups]
            chapter = releases[next(iter(answers))][section]
            yield Flip(section, name, chapter.results.label, chapter.page, said)


def _terms_of(section: str, claim: Claim, chapters: Chapters) -> frozenset[tuple]:
    """Return what a claim turns on that is of the machine and not of the edition.

    Of costs that is what they were measured on and with, of the noise the processor; other claims have nothing of it.
    """
    if section == NOISE:
        return frozenset({(chapters[section].results.record.processor,)})
    costs = [pointer for pointer in claim.outcome.reads if "cost" in column_of(pointer.rpartition("/")[2]).kinds]
    return frozenset(cost_terms(record, row) for record, row, _ in cells(costs, chapters))


def cells(pointers: Collection[str], chapters: Chapters) -> list[tuple[Record, Mapping[str, Any], str]]:
    """Return record, row and column of each pointer to a cell of the edition's own records."""
    records = {chapter.results.source: chapter.results.record for chapter in chapters.values()}
    found = [pointer for pointer in map(Pointer, sorted(pointers)) if pointer.cell and pointer.file in records]
    return [(record := records[each.file], record.rows[each.cell[0]], each.cell[1]) for each in found if each.cell]


def flips_between(before: Chapters, after: Chapters) -> list[Flip]:
    """Return the claims that one of two editions upholds and the other doesn't.

    One that can't be told any more, or can be told now, is among them unless that may be for want of a section, or is
    for being near the noise, as another measurement of the same may.
    """
    is_whole = set(before) == set(after)
    found = flips({"before": before, "after": after}, "after")
    near = (flip for flip in found if not any(claim.outcome.is_inconclusive for _, claim in flip.said))
    return [flip for flip in near if flip.is_decided or is_whole]


def backed(flips: Sequence[Flip], compared: Sequence[Move]) -> list[Flip]:
    """Return the flips of which something moved that their tests read, or was measured in one edition alone.

    Where nothing did, the same measured again may flip as well; nor is it one that a replica has no traces.
    """
    of_rows: dict[str, list[Move]] = {}
    for move in compared:
        for row in move.rows:
            of_rows.setdefault(row, []).append(move)
    found = []
    for flip in flips:
        read = {pointer for _, claim in flip.said for pointer in claim.outcome.reads if Pointer(pointer).cell}
        read = {pointer for pointer in read if f"/{NOISE}.json#" not in pointer}
        moved = (_moved(of_rows.get(row), column) for row, _, column in (pointer.rpartition("/") for pointer in read))
        is_untold = any(".csv.gz" in claim.outcome.reason for _, claim in flip.said)
        found += [flip] if not is_untold and (not read or any(moved)) else []
    return found


def _moved(row: Sequence[Move] | None, column: str) -> bool:
    """Tell whether a number of a row did, or the row is lost in one of both; one that nothing compares has."""
    return row is None or any(move.is_real for move in row if move.column == column or move.noise is None)


@dataclass(frozen=True)
class FlipList:
    """List flips by section; printed, each has what other editions say than the page's own."""

    flips: Sequence[Flip]
    shown: str
    """The edition of the page, whose own sentences stand where they belong."""
    sections: Collection[str]
    """Sections of that edition, to link to."""

    def __html__(self) -> Markup:
        return macros().turns(self.flips, self.shown, self.sections)
