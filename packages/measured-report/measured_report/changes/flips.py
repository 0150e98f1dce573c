"""Flips: claims that editions answer differently, and what each of them says."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from markupsafe import Markup

from measured_report.changes.costs import terms_of
from measured_report.pages.chapters import Chapters, Releases
from measured_report.pages.outline import PAGES, Page
from measured_report.parts.claim import Claim
from measured_report.parts.macros import macros

NUMBER = re.compile(r"<data[^>]*>[^<]*</data>(&nbsp;[^\s,.;:)]+)?")
"""A number in a sentence, with its unit."""
Answer = tuple[list[str], list[str], Claim]
"""Editions that word a claim so, those that do with other numbers, and the claim."""


@dataclass(frozen=True)
class Flip:
    """A claim that editions answer differently."""

    section: str
    name: str
    label: str
    page: Page
    said: Sequence[tuple[Sequence[str], Claim]]
    """Neighbouring editions that agree, and the claim as one of them words it; oldest first."""
    answers: Mapping[str, Claim]
    """The claim of each of them."""

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
    def text(self) -> str:
        return f"{self.claim}: {self.outcomes}\n  {self.before.text}\n  {self.after.text}"

    @property
    def is_decided(self) -> bool:
        """Tell whether one edition upholds it and another doesn't; or else one of them can't tell."""
        return len({claim.outcome.name for _, claim in self.said} - {"unknown"}) > 1

    @property
    def is_inconclusive(self) -> bool:
        """Tell whether one of them can't tell for being near the noise, as another measurement of the same may."""
        return any(claim.outcome.is_inconclusive for _, claim in self.said)


def flips(releases: Releases, shown: str) -> Iterator[Flip]:
    """Yield the claims that editions answer differently.

    Of editions that agree the one of the page, ``shown``, has the word, or else the newest. That one can't tell says
    nothing where it lacks a section that another one has, unless it is for being near the noise; nor does what turns
    on a cost, or on the noise, of another machine than the page's.
    """
    sections = set().union(*releases.values())
    claims = {release: _claims(chapters) for release, chapters in releases.items()}
    for section, name in dict.fromkeys(pair for those in claims.values() for pair in those):
        asked = {release: those[section, name] for release, those in claims.items() if (section, name) in those}
        answers = {
            release: claim
            for release, claim in asked.items()
            if not _is_for_want(claim) or len(releases[release]) == len(sections)
        }
        terms = {release: terms_of(section, claim, releases[release]) for release, claim in answers.items()}
        here = terms.get(shown, next(iter(terms.values()), None))
        outcomes = {release: claim.outcome.name for release, claim in answers.items() if terms[release] == here}
        groups = [list(group) for _, group in groupby(outcomes, outcomes.__getitem__)]
        if len(groups) > 1:
            said = [(group, answers[shown if shown in group else group[-1]]) for group in groups]
            chapter = next(chapters[section] for chapters in releases.values() if section in chapters)
            yield Flip(section, name, chapter.results.label, chapter.page, said, answers)


def _is_for_want(claim: Claim) -> bool:
    """Tell whether it can't tell, maybe for want of a section."""
    return claim.outcome.name == "unknown" and not claim.outcome.is_inconclusive


def _claims(chapters: Chapters) -> dict[tuple[str, str], Claim]:
    return {(name, claim.name): claim for name, chapter in chapters.items() for claim in chapter.section.claims}


def flips_between(before: Chapters, after: Chapters) -> list[Flip]:
    """Return the claims that one of two editions upholds and the other doesn't.

    One that can't be told any more, or can be told now, is among them unless that may be for want of a section, or is
    for being near the noise.
    """
    is_whole = set(before) == set(after)
    found = flips({"before": before, "after": after}, "after")
    return [flip for flip in found if not flip.is_inconclusive and (flip.is_decided or is_whole)]


@dataclass(frozen=True)
class FlipList:
    """Flips by the pages that their sections are on; printed, each has what others say than the page's own edition."""

    flips: Sequence[Flip]
    shown: str
    """The edition of the page, whose own sentences stand where they belong."""
    sections: Collection[str]
    """Sections of that edition, to link to."""

    def __html__(self) -> Markup:
        by_page = {page: [flip for flip in self.flips if flip.page == page] for page in PAGES}
        return macros().turns([(page, self._of_page(found)) for page, found in by_page.items() if found])

    def _of_page(self, flips: Sequence[Flip]) -> list[tuple[str, str, list[Answer]]]:
        """List the sections of a page: what each is called, its id, and what others say to its claims."""
        found = []
        for section, group in groupby(flips, lambda flip: flip.section):
            own = list(group)
            anchor = section if section in self.sections else ""
            found.append((own[0].label, anchor, [answer for flip in own for answer in self._worded(flip)]))
        return found

    def _worded(self, flip: Flip) -> Iterator[Answer]:
        """Yield the newest sentence of each wording of other editions that agree."""
        for names in (names for names, _ in flip.said if self.shown not in names):
            wordings: dict[str, list[str]] = {}
            for name in names:
                wordings.setdefault(NUMBER.sub("#", flip.answers[name].sentence), []).append(name)
            for alike in wordings.values():
                said = flip.answers[alike[-1]]
                exactly = [name for name in alike if flip.answers[name].text == said.text]
                yield exactly, [name for name in alike if name not in exactly], said
