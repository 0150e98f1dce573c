"""What releases have side by side: cells, changes, marks, and the claims that they answer differently."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from markupsafe import Markup, escape

from measured_report.changes.costs import is_cost, terms_of
from measured_report.claims.claims import HOLDS, NEAR_NOISE, Claim, Outcome, beyond
from measured_report.deriving.chapters import Chapter, Chapters, Releases
from measured_report.pages.pages import PAGES, Page
from measured_report.values.noise import is_beyond, verdict
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_or_absent

SAME_RUNS = ("upgrade", "reproduction")
"""Sections that have the headline runs alike, so that a number can be taken from either."""


@dataclass(frozen=True)
class Headline:
    """A number that says much in one line."""

    label: str
    section: str
    case: str
    column: str
    unit: str
    device: str = ""
    """For a section that has the case on several devices and with several numbers of worlds: of which to take one."""
    worlds: int = 1

    @property
    def place(self) -> str:
        """As VALUE= says it."""
        return f"{self.section}.{self.case}.{self.column}"


def cell(releases: Releases, release: str, headline: Headline) -> Quantity:
    """What a release has in the place of a headline; without a number, and with a reason, when it has nothing."""
    sections = (headline.section, *(SAME_RUNS if headline.section in SAME_RUNS else ()))
    found = (chapter for section in sections if (chapter := releases[release].get(section)))
    chapter = next((each for each in found if headline.device or headline.case in each.results.row), None)
    row = _row(chapter.results, headline) if chapter else None
    reason = f"{headline.section} has not been measured so with Newton {release}"
    return cell_or_absent(row, headline.column, headline.unit, reason)


def _row(results: Results, headline: Headline) -> Row | None:
    if not headline.device:
        return results.row.get(headline.case)
    wanted = headline.case, headline.device, headline.worlds
    rows = [row for row in results.rows if "device" in row]
    return next((row for row in rows if (row.case, row.device, row.worlds.value) == wanted), None)


def up_to(releases: Releases, shown: str) -> Releases:
    """What the page of an edition compares: those before it and itself; the oldest is held against all that came."""
    names = list(releases)
    if shown not in names[1:]:
        return releases
    return {release: releases[release] for release in names[: names.index(shown) + 1]}


def floor(results: Results, releases: Releases, name: str, unit: str) -> Value:
    """The largest noise floor of that name that a release has."""
    floors = [release["noise"].results.derived[name] for release in releases.values() if "noise" in release]
    formula = "largest of the releases' noise floors"
    return results.value(name, formula, lambda *found: max(found), *floors, unit=unit, across=True, is_noise=True)


def change(results: Results, name: str, before: Quantity, after: Quantity) -> Value:
    return results.value(
        name, "later release less earlier one", lambda a, b: b - a, before, after, unit=before.unit, across=True
    )


def marked(difference: Value | None, noise: Quantity, column: str, before: Quantity, after: Quantity) -> Markup:
    """A number without its unit, and whether it is better or worse than the earlier one.

    Nothing is said of a cost that was not measured on the same processor.
    """
    told = difference is not None and None not in (difference.value, noise.value)
    if not told or not is_beyond(NEAR_NOISE * noise.value, before.value, after.value):
        return after.bare
    if is_cost(column) and len({origin.processor for origin in difference.origins}) > 1:
        return Markup('{} <span class="moved">other machine</span>').format(after.bare)
    word = verdict(column, before.value, after.value) or "moved"
    return Markup('{} <span class="moved {}">{}</span>').format(after.bare, word, word)


@dataclass(frozen=True)
class Turn:
    """A claim that releases answer differently, and what each says."""

    section: str
    label: str
    """What the section is called."""
    name: str
    page: Page
    said: Sequence[tuple[Sequence[str], Claim]]
    """Neighbouring releases that agree, and the claim as one of them words it."""

    @property
    def is_decided(self) -> bool:
        """Whether one release upholds it and another doesn't; or else one of them can't tell."""
        return len({claim.outcome.name for _, claim in self.said} - {"unknown"}) > 1


def turns(releases: Releases, shown: str) -> list[Turn]:
    """The claims that are upheld in one release and not in another, then those that not all of them can tell.

    Of releases that agree the one of the page, ``shown``, has the word, or else the newest. What a release can't tell
    says nothing where it lacks a section that another one has, unless it is for being near the noise; nor does what
    turns on a cost, or on the noise, of another machine than the page's.
    """
    sections = set().union(*releases.values())
    claims = {release: _claims(chapters) for release, chapters in releases.items()}
    found = []
    for section, name in dict.fromkeys(pair for those in claims.values() for pair in those):
        answers = [(release, those.get((section, name))) for release, those in claims.items()]
        answers = [
            (release, claim)
            for release, claim in answers
            if claim and (_is_told(claim) or len(releases[release]) == len(sections))
        ]
        terms = {release: terms_of(section, claim, releases[release]) for release, claim in answers}
        here = terms.get(shown, next(iter(terms.values()), None))
        answers = [(release, claim) for release, claim in answers if terms[release] == here]
        said = []
        for _, group in groupby(answers, lambda answer: answer[1].outcome.name):
            members = list(group)
            names = [release for release, _ in members]
            said.append((names, dict(members)[shown if shown in names else names[-1]]))
        if len(said) > 1:
            chapter = next(chapters[section] for chapters in releases.values() if section in chapters)
            found.append(Turn(section, chapter.results.label, name, chapter.page, said))
    return sorted(found, key=lambda turn: not turn.is_decided)


def _claims(chapters: Chapters) -> dict[tuple[str, str], Claim]:
    found: list[Chapter] = list(chapters.values())
    return {(chapter.name, claim.name): claim for chapter in found for claim in chapter.section.claims}


def _is_told(claim: Claim) -> bool:
    return claim.outcome.name != "unknown" or claim.outcome.is_near


@dataclass(frozen=True)
class TurnList:
    """The turns in words, by the pages that their sections are on; printed, each is a question with all answers."""

    turns: Sequence[Turn]
    shown: Sequence[str]
    """Sections of the page's release, to link to."""
    level: int = 4
    """Of the headings."""

    def __html__(self) -> Markup:
        # One link to a section is enough for whoever goes from link to link.
        first = {turn.section: turn for turn in reversed(self.turns)}
        groups = Markup("\n").join(
            Markup("<h{0}>{1}</h{0}>\n<dl>\n{2}\n</dl>").format(
                self.level,
                page.label,
                Markup("\n").join(
                    Markup("<dt>{}</dt>\n{}").format(
                        self._heading(turn, is_link=turn is first[turn.section]),
                        Markup("\n").join(_answer(names, claim) for names, claim in turn.said),
                    )
                    for turn in turns
                ),
            )
            for page in PAGES
            if (turns := [turn for turn in self.turns if turn.page == page])
        )
        return Markup('<figure class="turns">\n{}\n</figure>').format(groups or Markup("<p>None.</p>"))

    def _heading(self, turn: Turn, *, is_link: bool) -> Markup:
        is_linked = is_link and turn.section in self.shown
        place = Markup('<a href="#{}">{}</a>').format(turn.section, turn.label) if is_linked else escape(turn.label)
        return Markup("{}: {}").format(place, turn.said[0][1].said("asks").rstrip(","))


def _answer(names: Sequence[str], claim: Claim) -> Markup:
    """What a release says to the question; its sentence says whether that is a yes or a no."""
    if claim.outcome.name != "unknown":
        return Markup("<dd><b>In {}:</b> {}</dd>").format(", ".join(names), claim.sentence)
    return Markup("<dd><b>Cannot be told in {}:</b> {}</dd>").format(
        ", ".join(names), claim.outcome.reason or "no reason"
    )


@dataclass(frozen=True)
class Ends:
    """The oldest and the newest release that has results, between which changes are told."""

    releases: Releases

    @property
    def old(self) -> str:
        return next(iter(self.releases))

    @property
    def new(self) -> str:
        return next(reversed(list(self.releases)))

    @property
    def one(self) -> Outcome | None:
        """Why nothing can be told, when both are the same."""
        return Outcome("unknown", f"only Newton {self.old} has results") if self.old == self.new else None

    def cells(self, headline: Headline) -> tuple[Quantity, Quantity]:
        return cell(self.releases, self.old, headline), cell(self.releases, self.new, headline)

    def live(self, case: str, column: str, unit: str) -> tuple[Quantity, Quantity]:
        """What this section measured in the two."""
        return self.cells(Headline("", "upgrade", case, column, unit))


def unchanged(before: Quantity, after: Quantity, moved: Value, noise: Quantity) -> Outcome:
    """Whether a change is no more than noise and rounding; clearly more is the opposite."""
    return _unchanged(before, after, moved, noise).having_read(before, after, moved, noise)


def _unchanged(before: Quantity, after: Quantity, moved: Value, noise: Quantity) -> Outcome:
    for quantity in (moved, noise):
        if quantity.value is None:
            return Outcome("unknown", quantity.reason)
    return beyond(moved, noise) if is_beyond(noise.value, before.value, after.value) else HOLDS


def machines_differ(releases: Releases, section: str) -> Outcome | None:
    """Unknown, when the oldest and the newest release were not measured on one and the same machine."""
    records = [release[section].results.record for release in releases.values() if section in release]
    if records and records[0].machine_for_speed != records[-1].machine_for_speed:
        return Outcome("unknown", f"measured on {records[0].machine_in_full} and on {records[-1].machine_in_full}")
    return None
