"""Editions: every section of a release that has results is derived and put into words; nothing is drawn yet."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from hashlib import sha256
from importlib import import_module
from typing import Any

from measured_report import ROOT, ReportError
from measured_report.claims.claims import HOLDS
from measured_report.deriving.chapters import Chapter, Chapters, Releases, values_text
from measured_report.deriving.derived import Earlier, LostError, Noted, Outline, Reads, derive_section, outline_of
from measured_report.deriving.keeping import Derivation, Keeper, Made
from measured_report.deriving.short import marked
from measured_report.editions.project import Project
from measured_report.editions.status import State, states_of
from measured_report.files.files import RecordError, short_path
from measured_report.pages.page import Prose, Templates, Text
from measured_report.pages.pages import FRONT, HISTORY, PAGES, REPLAY, Page
from measured_report.parts.contradictions import refuse_contradictions
from measured_report.parts.parts import Making, Section
from measured_report.records.identity import files_digest
from measured_report.records.traces import traces_of
from measured_report.values.noise import NOISE, noise_floors
from measured_report.values.results import Results, ResultsError
from report.media.clips import Clips, clips_of
from report.story.cards import cards_of
from report.story.found import Found

RETOLD = ("front", "story")
"""Templates of which a module of report/story/ retells the findings of the sections, in claims of its own."""


@dataclass(frozen=True)
class Edition:
    """What the results of one release make."""

    project: Project
    chapters: Chapters
    left_out: Sequence[State]
    """Sections whose results are missing, damaged, or too old for the words that are now said of them."""
    keeper: Keeper = field(default_factory=Keeper)

    @cached_property
    def pages(self) -> dict[Page, list[Chapter]]:
        """Its pages with what each shows; one that would show nothing is not there."""
        chapters = sorted(self.chapters.values(), key=lambda chapter: not outline_of(chapter.name).leads)
        shown = {page: [chapter for chapter in chapters if chapter.page == page] for page in PAGES}
        always = (FRONT, HISTORY) if len(self.project.releases) > 1 else (FRONT,)
        return {page: found for page, found in shown.items() if found or page in always}

    @property
    def uncompared(self) -> Chapters:
        """Its chapters; of those that compare releases, and say what is so on one page alone, their results."""
        return {
            name: replace(chapter, section=Section()) if chapter.compares else chapter
            for name, chapter in self.chapters.items()
        }

    @cached_property
    def values_text(self) -> str:
        """Its values file."""
        return values_text(self.chapters.values())

    @cached_property
    def uncompared_text(self) -> str:
        """Its values file for the pages of others: what compares releases is derived for its own alone."""
        return values_text(chapter for chapter in self.chapters.values() if not chapter.compares)

    @cached_property
    def clips(self) -> Clips | None:
        """Its clips; None when there are none that can be shown."""
        return clips_of(self.project)

    @cached_property
    def replay(self) -> dict[str, Any] | None:
        """The runs of its replay; None where they are not kept."""
        if "poses" not in self.chapters:
            return None
        project, results = self.project, self.chapters["poses"].results
        name, code = f"{project.profile}.{project.release}.replay", ROOT / "report" / "media" / "packed.py"
        return self.keeper.value(name, code, [_results_digest(results)], lambda: _replayed(results))

    def unmeasured(self, page: Page) -> list[State]:
        """The sections of a page, or of all for the front page, that have not been measured."""
        missing = [state for state in self.left_out if state.kind == "missing"]
        return [state for state in missing if page in (FRONT, outline_of(state.section).page)]

    def texts(self, page: Page, templates: Templates, names: Mapping[str, Any]) -> list[Prose]:
        """The words of a page besides those of its sections; ``names`` are what they can name, and the sections."""
        levels = [1] + [2] * (len(page.texts) - 1)  # the first has the title of the page
        texts = zip(page.texts, levels, strict=True)
        return [self._text(templates.text(template), names, level) for template, level in texts]

    def _text(self, text: Text, names: Mapping[str, Any], level: int) -> Prose:
        anchor = text.name.rpartition("/")[2].partition(".")[0]
        section = self._retold(anchor) if anchor in RETOLD else Section()
        if anchor == HISTORY.name:
            section = self._history({link.release: link.edition.uncompared for link in names["releases"]})
        if not section.claims:  # where the shake test was not measured there is nothing to tell
            section = replace(section, unmeasured=[word for _, word in text.words])
        section = section.worded(anchor, text.name, text.words, Making("report/story/", "make page"))
        found = Found(self.chapters)
        sections = {name: chapter.section for name, chapter in self.chapters.items()}
        known = {
            "release": self.project.release,
            "sections": {name: chapter.names for name, chapter in self.chapters.items()},
            "is_told": bool(section.claims),
            "does_slip": found.does_slip,
            "overview": "overview" in section.figures,
            "cards": cards_of(self.chapters),
            "clips": self.clips,
            "replay": REPLAY if self.replay else "",
            "value": found.value,
            "cell": found.cell,
            "claim": _finder(anchor, "claim", {claim.name: found.marked(claim, anchor) for claim in section.claims}),
            "holds": _asker({**sections, anchor: section}, anchor),
            "table": _finder(anchor, "table", section.tables),
            "figure": _finder(anchor, "figure", section.figures),
        }
        return text.prose(anchor, {**known, **names}, level)

    def _retold(self, name: str) -> Section:
        def make(reads: Reads) -> Section:
            return getattr(import_module(f"report.story.{name}"), f"{name}_of")(Noted(reads))

        return self._told(name, {"": self.chapters}, make)

    def _history(self, releases: Releases) -> Section:
        def make(reads: Reads) -> Section:
            from report.story.history import history_of

            return history_of({release: Noted(reads, release) for release in releases}, self.project.release)

        return self._told(HISTORY.name, releases, make)

    def _told(self, name: str, places: Releases, make: Callable[[Reads], Section]) -> Section:
        """What a module of report/story/ makes of the chapters of one release, or of all by their labels."""
        digests = {(place, each): chapter.digest for place, found in places.items() for each, chapter in found.items()}
        code = ROOT / "report" / "story" / f"{name}.py"
        place = self.project.profile, self.project.release, name
        return self.keeper.made(place, code, (), Reads(places, digests), lambda reads: (make(reads), {})).section


def editions_of(
    project: Project, templates: Templates, keeper: Keeper | None = None, among: Sequence[str] | None = None
) -> dict[str, Edition]:
    """What the results of every release make, oldest first; ``among``: of these alone."""
    keeper = keeper or Keeper()
    shown = project.releases if among is None else among
    derived = {release: derive_edition(project.of(release), templates, keeper) for release in shown}
    releases = {release: edition.chapters for release, edition in derived.items()}
    editions = {release: _compared(edition, releases, templates, keeper) for release, edition in derived.items()}
    return editions if project.profile == "full" else _with_marks(project, editions, templates)


def _with_marks(project: Project, editions: Mapping[str, Edition], templates: Templates) -> dict[str, Edition]:
    """The same with a mark at each claim that full runs, where there are any, answer otherwise."""
    full = replace(project, profile="full")
    there = [release for release in editions if full.of(release).results.is_dir()]
    told = {release: derive_edition(full.of(release), templates).chapters for release in there}
    chapters = marked({release: edition.chapters for release, edition in editions.items()}, told)
    return {release: replace(edition, chapters=chapters[release]) for release, edition in editions.items()}


def derive_edition(project: Project, templates: Templates, keeper: Keeper | None = None) -> Edition:
    """What the results of one release make by themselves: a section that compares releases has its results alone."""
    keeper = keeper or Keeper()
    states = states_of(project)
    left_out = [state for state in states if not state.record]
    outlines = [(state, outline_of(state.section)) for state in states if state.record]
    floors = noise_floors(state.record for state, _ in outlines if state.section == NOISE)
    found: dict[str, Chapter] = {}
    for state, outline in sorted(outlines, key=lambda pair: pair[1].order):
        others = {name: chapter.results for name, chapter in found.items()}
        path = project.record_path(state.section)
        results = Results(state.record, path, others, floors=floors, label=outline.label)
        try:
            if outline.compares:
                digest = _results_digest(results)
                chapter = Chapter(state, results, Section(), {}, None, outline.page, compares=True, digest=digest)
            else:
                made = _made(project, results, outline, found, {}, keeper)
                chapter = _chapter(project, state, results, outline, made, templates, found)
                keeper.tell(project.release, chapter.section, chapter.name)
        except Exception as error:
            left_out.append(_left_out(project, state, error))
        else:
            found[state.section] = chapter
    return Edition(project, found, left_out, keeper)


def _compared(edition: Edition, releases: Releases, templates: Templates, keeper: Keeper) -> Edition:
    """The same with the sections that compare releases."""
    chapters, left_out = dict(edition.chapters), list(edition.left_out)
    project = edition.project
    for name, chapter in edition.chapters.items():
        if chapter.compares:
            results, outline = chapter.results, outline_of(name)
            try:
                before = {each: edition.chapters[each] for each in results.others}
                made = _made(project, results, outline, before, releases, keeper)
                full = _chapter(project, chapter.state, results, outline, made, templates, edition.chapters)
                chapters[name] = replace(full, compares=True)
            except Exception as error:
                left_out.append(_left_out(edition.project, chapter.state, error))
                del chapters[name]
    refuse_contradictions(edition.project.templates, {name: chapter.section for name, chapter in chapters.items()})
    return Edition(edition.project, chapters, left_out, keeper)


def _made(
    project: Project, results: Results, outline: Outline, before: Chapters, releases: Releases, keeper: Keeper
) -> Made:
    """What a section makes of its results, and of those of the sections before it, or of all releases."""

    def make(reads: Reads) -> Derivation:
        given = replace(results, others=Earlier(Noted(reads), outline), derived={})
        return derive_section(given, {release: Noted(reads, release) for release in releases}), given.derived

    places: dict[str, Mapping[str, Any]] = {"": results.others, **releases}
    digests = {("", name): chapter.digest for name, chapter in before.items()}
    for release, chapters in releases.items():
        digests |= {(release, name): chapter.digest for name, chapter in chapters.items()}
    place = project.profile, project.release, results.record.section
    given = [_results_digest(results), repr(sorted(results.floors.items()))]
    return keeper.made(place, outline.file, given, Reads(places, digests), make)


def _results_digest(results: Results) -> str:
    """Of a record and its traces."""
    folder = results.path.parent
    return files_digest([results.path, *traces_of(results.path, results.record)], folder) + folder.name


def _replayed(results: Results) -> dict[str, Any] | None:
    from report.media.packed import replayed_runs  # it takes NumPy, which takes long to import

    return replayed_runs(results)


def _chapter(
    project: Project,
    state: State,
    results: Results,
    outline: Outline,
    made: Made,
    templates: Templates,
    before: Chapters,
) -> Chapter:
    name = state.section
    results = replace(results, derived=dict(made.values))
    text = templates.text(f"sections/{name}.md.j2")
    section = made.section.worded(name, text.name, text.words, Making(outline.source, project.rerun(name)))
    names = _names(results, section, before)
    # Others read its claims, whose outcomes its words have a part in, and none of its words.
    outcomes = [(claim.name, repr(claim.outcome), claim.outcome.is_opposite) for claim in section.claims]
    digest = sha256(repr((made.digest, outcomes, state.notes)).encode()).hexdigest()
    return Chapter(state, results, section, names, text.prose(name, names), outline.page, digest=digest)


def _left_out(project: Project, state: State, error: Exception) -> State:
    """A section that can't be shown, for the rest of the page stands without it.

    A record of older code may lack anything. One that is fresh should not: then it is damaged, or its section is wrong.
    A fault of the template, which is not the record's, stops the build.
    """
    if state.kind == "fresh" and project.is_own and not isinstance(error, RecordError | ResultsError | LostError):
        raise error
    words = str(error) if isinstance(error, ReportError) else f"{type(error).__name__}: {error}"
    kind = "damaged" if state.kind == "fresh" or isinstance(error, RecordError) else state.kind
    place = "" if isinstance(error, RecordError) else f"{short_path(project.record_path(state.section))}: "
    return replace(state, kind=kind, record=None, notes=(place + " ".join(words.split()),))


def _names(results: Results, section: Section, before: Chapters) -> dict[str, Any]:
    name = results.record.section
    claims = {claim.name: claim.html(name) for claim in section.claims}
    return {
        "release": results.record.identity.packages["newton"],
        "row": results.row,
        "rows": results.rows,
        "value": results.derived,
        "claim": _finder(name, "claim", claims),
        "holds": _asker({**{chapter: found.section for chapter, found in before.items()}, name: section}, name),
        "table": _finder(name, "table", section.tables),
        "figure": _finder(name, "figure", section.figures),
        "download": _finder(name, "download", {download.name: download for download in section.downloads}),
    }


def _asker(sections: Mapping[str, Section], own: str = "") -> Callable[[str], bool]:
    """Says of ``claim``, in the section ``own``, or of ``section.claim`` whether it holds; what was not measured does
    not."""

    def holds(name: str) -> bool:
        section, _, claim = name.rpartition(".")
        section = section or own
        if section not in sections:
            return False
        claims = {each.name: each.outcome == HOLDS for each in sections[section].claims}
        if claim not in claims and claim not in sections[section].unmeasured:
            raise ReportError(f"{section} has no claim {claim!r}; it has: {', '.join(claims) or 'none'}")
        return claims.get(claim, False)

    return holds


def _finder(section: str, kind: str, things: Mapping[str, Any]) -> Callable[[str], Any]:
    def find(name: str) -> Any:
        if name not in things:
            raise ReportError(f"{section} has no {kind} {name!r}; it has: {', '.join(things) or 'none'}")
        return things[name]

    return find
