"""Editions: every section of a release that has results is derived and put into words; nothing is drawn yet."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from hashlib import sha256
from importlib import import_module
from itertools import takewhile
from typing import Any

from markupsafe import Markup

from measured_report.editions.project import MANIFEST, Project, read_manifest
from measured_report.editions.status import State, states_of
from measured_report.files.atomic import RecordError, short_path
from measured_report.files.config import config
from measured_report.files.errors import ReportError
from measured_report.pages.cache import Derivation, DerivedCache
from measured_report.pages.chapters import Chapter, Chapters, Releases, stale_mark, values_text
from measured_report.pages.outline import FRONT, PAGES, Page
from measured_report.pages.passages import teller
from measured_report.pages.plugins import Plugins, plugins
from measured_report.pages.prose import Prose, Templates, Text
from measured_report.pages.sections import LostError, Read, derive_section, file_of, outline_of
from measured_report.parts.claim import HOLDS, Claim
from measured_report.parts.contradictions import refuse_contradictions
from measured_report.parts.macros import macros
from measured_report.parts.section import Section
from measured_report.records.code import files
from measured_report.records.identity import files_digest, sections
from measured_report.records.record import traces_of
from measured_report.values.noise import NOISE, noise_floors
from measured_report.values.results import Results, ResultsError


@dataclass(frozen=True)
class Edition:
    """What the results of one release make."""

    project: Project
    chapters: Chapters
    left_out: list[State]
    """Sections whose results are missing, damaged, or too old for the words that are now said of them."""
    cache: DerivedCache = field(default_factory=DerivedCache)
    root: str = ""
    """The way from its pages to the root of the site."""
    full: Chapters = field(default_factory=dict)
    """Chapters of full runs, where these are short ones: a claim that they answer otherwise says so."""

    @cached_property
    def pages(self) -> dict[Page, list[Chapter]]:
        """Its pages with what each shows; one that would show nothing is not there."""
        chapters = sorted(self.chapters.values(), key=lambda chapter: not outline_of(chapter.name).leads)
        shown = {page: [chapter for chapter in chapters if chapter.page == page] for page in PAGES}
        always = {page for page in PAGES if page == FRONT or (page.compares and len(self.project.releases) > 1)}
        return {page: found for page, found in shown.items() if found or page in always}

    @property
    def uncompared(self) -> Chapters:
        """Its chapters; of those that compare releases, and say what is so on one page alone, their results."""
        bare = {name: replace(each, section=Section()) for name, each in self.chapters.items() if each.compares}
        return {**self.chapters, **bare}

    @cached_property
    def values_text(self) -> str:
        return values_text(self.chapters.values())

    @cached_property
    def plugins(self) -> Plugins:
        """What the report shows of it besides."""
        return plugins().Plugins(self)

    def is_section(self, name: str) -> bool:
        """Whether a name of what is left out is that of a section, which can be measured again."""
        return name in sections(self.project.root)

    def unmeasured(self, page: Page) -> list[State]:
        """Return the sections of a page, or of all for the front page, that have not been measured."""
        missing = (state for state in self.left_out if state.kind == "missing")
        return [state for state in missing if page in (FRONT, outline_of(state.section).page)]

    def texts(self, page: Page, templates: Templates, names: Mapping[str, Any]) -> list[Prose]:
        """Put a page's own texts into words; ``names`` are what they can name besides the sections and ``plugins``."""
        found = {text.name.rpartition("/")[2].partition(".")[0]: text for text in map(templates.text, page.texts)}
        told = {
            anchor: self._worded(anchor, text, self._told_or_left_out(anchor, names)) for anchor, text in found.items()
        }
        levels = [1, *[2] * len(found)]  # the first has the title of the page
        return [self._prose_or_bare(*each, told, names) for each in zip(levels, found.items(), strict=False)]

    def _prose_or_bare(
        self, level: int, named: tuple[str, Text], told: Mapping[str, Section], names: Mapping[str, Any]
    ) -> Prose:
        """Put one text into words; where what was measured can't be said so, as if nothing had been."""
        anchor, text = named
        try:
            return self._prose(level, named, told, names)
        except ReportError as error:
            is_untold = any(state.section == anchor for state in self.left_out)
            lacks = is_untold or any(state.kind == "damaged" for state in self.left_out)
            if not (lacks or isinstance(error, ResultsError)):
                raise
            if not is_untold:
                self.left_out.append(State(anchor, "damaged", notes=(f"{anchor}: nothing can be said ({error})",)))
            bare = {**told, anchor: self._worded(anchor, text, Section())}
            return replace(self, chapters={})._prose(level, named, bare, names)

    def _worded(self, anchor: str, text: Text, section: Section) -> Section:
        """What a text tells, in its words."""
        if not section.claims:  # where what it is about was not measured there is nothing to tell
            section = replace(section, unmeasured=[word for _, word in text.words])
        story = f"{config().story.replace('.', '/')}/"
        return section.worded(anchor, text.name, text.words, story, "make page")

    def _prose(
        self, level: int, named: tuple[str, Text], told: Mapping[str, Section], names: Mapping[str, Any]
    ) -> Prose:
        """Put one text into words, which may need claims of all texts ``told`` of its page."""
        anchor, text = named
        section, sections = told[anchor], {name: chapter.section for name, chapter in self.chapters.items()}
        known = {
            "release": self.project.release,
            "sections": _Names({name: chapter.names for name, chapter in self.chapters.items()}),
            **_things(anchor, {**told, **sections}, partial(stale_mark, self.chapters.values())),
            "claim": _finder(anchor, "claim", {claim.name: self._html(claim, anchor) for claim in section.claims}),
        }
        return text.prose(anchor, {**known, **self.plugins.names(section), **names}, level)

    def _told_or_left_out(self, name: str, names: Mapping[str, Any]) -> Section:
        """What a text tells; nothing where what was measured lacks what it is about, which is then named."""
        try:
            return self._told(name, names)
        except (ArithmeticError, AssertionError, AttributeError, LookupError, TypeError, ValueError) as error:
            words = " ".join(f"{name}: nothing can be told ({type(error).__name__}: {error})".split())
            self.left_out.append(State(name, "damaged", notes=(words,)))
            return Section()

    def _html(self, claim: Claim, text: str) -> Markup:
        """A claim of a text, with a mark where it rests on a stale section; the one called ``title`` has none."""
        mark = "" if claim.name == "title" else stale_mark(self.chapters.values(), claim.outcome.reads)
        return claim.html(text) + mark

    def _told(self, name: str, names: Mapping[str, Any]) -> Section:
        """What ``derive(chapters)`` or ``derive(releases, shown)`` of the story's module ``name`` derives."""
        file = file_of(config().story, name) if config().story else None
        arguments = files().source(file, name).top.get("derive", 0) if file else 0
        if not (file and arguments):
            return Section()
        places: dict[str, Chapters] = {"": self.chapters}
        if arguments > 1:
            places = {link.release: link.edition.uncompared for link in names["releases"]}

        def derive() -> Derivation:
            derive = import_module(f"{config().story}.{name}").derive
            return derive(places, self.project.release) if arguments > 1 else derive(self.chapters), {}

        place = (self.project.profile, self.project.release, name)
        return self.cache.derived(place, file, _digests(places), derive).section


class _Names(dict[str, Mapping[str, Any]]):
    """What each section's words can name; of one that was not measured there is nothing to say."""

    def __missing__(self, name: str) -> Mapping[str, Any]:
        outline_of(name)  # for a name that no section has
        return dict.fromkeys(("claim", "table", "figure", "download"), lambda thing: Markup(""))


def editions_of(
    project: Project, templates: Templates, cache: DerivedCache | None = None, among: Sequence[str] | None = None
) -> dict[str, Edition]:
    """Derive what the results of every release make, oldest first; ``among``: of these alone."""
    shown = project.releases if among is None else among
    cache = cache or DerivedCache()
    derived = {}
    for release in shown:
        root = "" if release == project.release else "../"
        derived[release] = replace(derive_edition(project.of(release), templates, cache), root=root)
    releases = {release: edition.chapters for release, edition in derived.items()}
    return {release: _compared(edition, releases, templates) for release, edition in derived.items()}


def derive_edition(project: Project, templates: Templates, cache: DerivedCache | None = None) -> Edition:
    """Derive what the results of one release make by themselves: what compares releases has its results alone."""
    states = [_with_noise(project, state) for state in states_of(project)]
    edition = _derived(project, states, templates, cache)
    unfit = [state for state in edition.left_out if state.section == NOISE]
    if unfit and any(state.record for state in states if state.section == NOISE):
        # What no page can show of the noise is no measure of other numbers.
        states = [unfit[0] if state.section == NOISE else state for state in states]
        edition = _derived(project, states, templates, cache)
    return edition


def _derived(project: Project, states: Sequence[State], templates: Templates, cache: DerivedCache | None) -> Edition:
    floors = noise_floors(state.record for state in states if state.record and state.section == NOISE)
    there = sorted((state for state in states if state.record), key=lambda state: outline_of(state.section).order)
    measured = [
        (state, Results(state.record, project.record_path(state.section), floors=floors))
        for state in there
        if state.record
    ]
    left_out = [*(state for state in states if not state.record), *_damaged_manifest(project)]
    edition = Edition(project, {}, left_out, cache or DerivedCache(), full=_of_full_runs(project, templates))
    return _with_chapters(edition, measured, {}, templates)


def _of_full_runs(project: Project, templates: Templates) -> Chapters:
    full = replace(project, profile="full")
    return derive_edition(full, templates).chapters if project.profile != "full" and full.results.is_dir() else {}


def _with_noise(project: Project, state: State) -> State:
    """The same, or, of a record on noise from which none can be told, that it is damaged."""
    try:
        noise_floors([state.record] if state.record and state.section == NOISE else [])
    except (ArithmeticError, LookupError, TypeError, ValueError) as error:
        return _left_out(project, state, LostError(f"no noise can be told from it ({type(error).__name__}: {error})"))
    return state


def _damaged_manifest(project: Project) -> list[State]:
    """Say of a manifest that can't be read that it is damaged: what it says is missed is missed unseen."""
    try:
        read_manifest(project.results)
    except RecordError as error:
        return [State(MANIFEST, "damaged", notes=(str(error),))]
    return []


def _compared(edition: Edition, releases: Releases, templates: Templates) -> Edition:
    """The same with the sections that compare releases."""
    measured = [(chapter.state, chapter.results) for chapter in edition.chapters.values() if chapter.compares]
    compared = _with_chapters(edition, measured, releases, templates)
    sections = {name: chapter.section for name, chapter in compared.chapters.items()}
    refuse_contradictions(edition.project.templates, sections)
    return compared


def _with_chapters(
    edition: Edition, measured: Sequence[tuple[State, Results]], releases: Releases, templates: Templates
) -> Edition:
    """An edition with these sections, each made of what there is by then; what can't be shown is left out."""
    found, left_out = dict(edition.chapters), list(edition.left_out)
    for state, results in measured:
        try:
            found[state.section] = _chapter(edition, state, results, found, releases, templates)
        except Exception as error:
            left_out.append(_left_out(edition.project, state, error))
            found.pop(state.section, None)
    return replace(edition, chapters=found, left_out=left_out)


def _chapter(
    edition: Edition, state: State, results: Results, told: Chapters, releases: Releases, templates: Templates
) -> Chapter:
    """Derive a section and put it into words; one that compares, without ``releases``, has its results alone.

    It may read those of the chapters ``told`` that stand before it; its words may ask of all whether a claim holds.
    """
    project, name, outline = edition.project, state.section, outline_of(state.section)
    before = dict(takewhile(lambda item: item[0] != name, told.items()))
    before = {other: before[other] for other in (before if outline.compares else outline.reads) if other in before}
    others = Read(outline, {other: chapter.results for other, chapter in before.items()})
    results = replace(results, others=others, label=outline.label, labels=outline.labels)
    digest = results_digest(results)
    if outline.compares and not releases:
        return Chapter(state, results, Section(), {}, None, outline.page, compares=True, digest=digest)

    def derive() -> Derivation:
        own = replace(results, derived={})
        return derive_section(own, releases).tabled(), own.derived

    given = [digest, repr(sorted(results.floors.items())), *_digests({"": before, **releases})]
    entry = edition.cache.derived((project.profile, project.release, name), outline.file, given, derive)
    results = replace(results, derived=dict(entry.values))
    text = templates.text(f"sections/{name}.md.j2")
    section = entry.section.worded(name, text.name, text.words, outline.source, project.rerun(name))
    if name in edition.full:
        section = _marked(section, edition.full[name].section)
    unmeasured = dict.fromkeys(section.unmeasured, Markup(""))
    names = {
        "release": results.record.origin.release,
        "row": results.row,
        "rows": results.rows,
        "value": results.derived,
        **_things(name, {**{other: chapter.section for other, chapter in told.items()}, name: section}),
        "claim": _finder(name, "claim", unmeasured | {claim.name: claim.html(name) for claim in section.claims}),
        "download": _finder(name, "download", {download.name: download for download in section.downloads}),
    }
    # Others read its claims, whose outcomes its words have a part in, and none of its words.
    outcomes = [(claim.name, repr(claim.outcome), claim.outcome.is_opposite) for claim in section.claims]
    digest = sha256(repr((entry.digest, outcomes, state.notes)).encode()).hexdigest()
    if not outline.compares:
        edition.cache.tell(project.release, section, name)
    prose = text.prose(name, names)
    return Chapter(state, results, section, names, prose, outline.page, outline.compares, digest)


def _marked(section: Section, full: Section) -> Section:
    """Put a mark before each claim that full runs answer otherwise."""
    told = {claim.name: claim for claim in full.claims}
    marks = {
        claim.name: macros().otherwise(told[claim.name].text)
        for claim in section.claims
        if claim.name in told and told[claim.name].outcome.name != claim.outcome.name
    }
    return replace(section, claims=[replace(each, mark=marks.get(each.name, each.mark)) for each in section.claims])


def _digests(places: Releases) -> list[str]:
    """Return a text for each chapter, by which others know whether it is the same."""
    return [f"{place} {name} {each.digest}" for place, told in places.items() for name, each in told.items()]


def results_digest(results: Results) -> str:
    """Digest a record and its traces."""
    folder = results.path.parent
    return files_digest([results.path, *traces_of(results.path, results.record)], folder) + folder.name


def _left_out(project: Project, state: State, error: Exception) -> State:
    """A section that can't be shown, for the rest of the page stands without it.

    A record may lack anything, or have what nobody thought of. What is wrong with a section's code or its words,
    whatever was measured, stops the build where the record is fresh and the project's own.
    """
    is_wrong = isinstance(error, ReportError) and not isinstance(error, RecordError | ResultsError | LostError)
    if is_wrong and state.kind == "fresh" and project.is_own:
        raise error
    words = str(error) if isinstance(error, ReportError) else f"{type(error).__name__}: {error}"
    kind = "damaged" if state.kind == "fresh" or isinstance(error, RecordError) else state.kind
    place = "" if isinstance(error, RecordError) else f"{short_path(project.record_path(state.section))}: "
    return replace(state, kind=kind, record=None, notes=(place + " ".join(words.split()),))


def _things(
    own: str, sections: Mapping[str, Section], mark: Callable[[frozenset[str]], Markup] = lambda reads: Markup("")
) -> dict[str, Callable[..., Any]]:
    """What finds tables and figures of the section ``own`` for its words, says its passages, and which claims hold.

    That is asked of ``claim``, its own, or of ``section.claim``; what was not measured does not hold. A passage has a
    ``mark`` by what it rests on.
    """
    section = sections[own]

    def find(name: str, claim: str) -> Claim | None:
        if name not in sections:
            outline_of(name)  # for a name that no section has
            return None
        claims = {each.name: each for each in sections[name].claims}
        if claim not in claims and claim not in sections[name].unmeasured:
            raise ReportError(f"{name} has no claim {claim!r}; it has: {', '.join(claims) or 'none'}")
        return claims.get(claim)

    def holds(asked: str) -> bool:
        name, _, claim = asked.rpartition(".")
        found = find(name or own, claim)
        return found is not None and found.outcome == HOLDS

    finders = {"table": _finder(own, "table", section.tables), "figure": _finder(own, "figure", section.figures)}
    return {"holds": holds, "passage": teller(find, mark), **finders}


def _finder(section: str, kind: str, things: Mapping[str, Any]) -> Callable[[str], Any]:
    def find(name: str) -> Any:
        if name not in things:
            raise ReportError(f"{section} has no {kind} {name!r}; it has: {', '.join(things) or 'none'}")
        return things[name]

    return find
