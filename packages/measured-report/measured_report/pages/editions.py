"""Editions: every section of a release that has results is derived and put into words; nothing is drawn yet."""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from importlib import import_module
from itertools import takewhile
from typing import Any

from markupsafe import Markup

from measured_report.editions.project import MANIFEST, Project, read_manifest
from measured_report.editions.status import NOT_SHOWN, State, states_of
from measured_report.files.atomic import RecordError, short_path
from measured_report.files.config import Page, config
from measured_report.files.errors import ReportError, bug_of
from measured_report.pages.cache import Derivation, DerivedCache
from measured_report.pages.passages import teller
from measured_report.pages.plugins import Plugins, plugins
from measured_report.pages.prose import Prose, Templates, Text
from measured_report.pages.replicas import Measurements, floors_in, measurements_of
from measured_report.pages.sections import FRONT, PAGES, Read, derive_section, file_of, outline_of
from measured_report.parts.citations import refuse_contradictions
from measured_report.parts.claim import HOLDS, Claim
from measured_report.parts.section import Section
from measured_report.records.code import digest_of, files
from measured_report.records.identity import files_digest
from measured_report.records.record import traces_of
from measured_report.records.replicas import FOLDER
from measured_report.values.quantities import Value
from measured_report.values.results import Results, ResultsError
from measured_report.values.scatter import Apart


@dataclass(frozen=True)
class Chapter:
    """Hold what a section of one release makes."""

    state: State
    results: Results
    section: Section
    names: Mapping[str, Any]
    """What its template can name, and other templates through ``sections``."""
    prose: Prose | None
    """None for a section that compares releases until it has them."""
    page: Page
    compares: bool = False
    """Set where it compares releases, so that what it derives is of one page alone."""
    digest: str = ""
    """Covers all that it was made from, as far as others read it; empty where nothing is kept."""

    @property
    def name(self) -> str:
        return self.state.section

    @property
    def code(self) -> Iterator[tuple[str, int]]:
        """Yield the file and the line of what measures it and of what derives it."""
        for package, function in (("experiments", "measure"), ("report.sections", "derive")):
            if file := file_of(package, self.name):
                lines = file.read_text(encoding="utf-8").splitlines()
                found = (number for number, line in enumerate(lines, 1) if line.startswith(f"def {function}("))
                inside = file.parts[-2:] if file.name == "__init__.py" else file.parts[-1:]
                yield "/".join([*package.split("."), *inside]), next(found, 1)


Chapters = Mapping[str, Chapter]
Releases = Mapping[str, Chapters]
"""The chapters of every release that has results, oldest first."""


@dataclass(frozen=True)
class Edition:
    """Hold what the results of one release make."""

    project: Project
    chapters: Chapters
    left_out: list[State]
    """Sections whose results are missing, damaged, or too old for the words that are now said of them."""
    cache: DerivedCache = field(default_factory=DerivedCache)
    measurements: Measurements = field(default_factory=Measurements)
    root: str = ""
    """The way from its pages to the root of the site."""

    @cached_property
    def pages(self) -> dict[Page, list[Chapter]]:
        """Return its pages with what each shows; one that would show nothing is not there."""
        chapters = sorted(self.chapters.values(), key=lambda chapter: not outline_of(chapter.name).leads)
        shown = {page: [chapter for chapter in chapters if chapter.page == page] for page in PAGES}
        return {page: found for page, found in shown.items() if found or page == FRONT}

    @property
    def uncompared(self) -> Chapters:
        """Return its chapters; of those that compare releases, and say what is so on one page alone, the results."""
        bare = {name: replace(each, section=Section()) for name, each in self.chapters.items() if each.compares}
        return {**self.chapters, **bare}

    def values_text(self, false_alarms: Mapping[str, Value]) -> str:
        """Write the site's values file: what each chapter derived, by its name, and how often it rings for nothing."""
        derived = {name: chapter.results.derived for name, chapter in self.chapters.items()}
        derived |= {FOLDER: dict(false_alarms)} if false_alarms else {}
        values = {name: {each: value.entry for each, value in found.items()} for name, found in derived.items()}
        return json.dumps(values, ensure_ascii=False, allow_nan=False, separators=(",", ":")) + "\n"

    @cached_property
    def plugins(self) -> Plugins:
        """Show what the report has besides."""
        return plugins().Plugins(self)

    def unmeasured(self, page: Page) -> list[State]:
        """Return the sections of a page, or of all for the front page, that have not been measured."""
        missing = (state for state in self.left_out if state.kind == "missing")
        return [state for state in missing if page in (FRONT, outline_of(state.section).page)]

    def texts(self, page: Page, templates: Templates, names: Mapping[str, Any]) -> list[Prose]:
        """Put a page's own texts into words; what can't be said is said as if nothing had been measured."""
        found = {text.name.rpartition("/")[2].partition(".")[0]: text for text in map(templates.text, page.texts)}
        told = {anchor: _worded(anchor, text, self._told(anchor, names)) for anchor, text in found.items()}
        said: list[Prose] = []
        for anchor, text in found.items():
            level = 2 if said else 1  # the first has the title of the page
            try:
                said.append(self._prose(level, anchor, text, told, names))
            except ReportError as error:
                is_lacking = any(state.kind in ("damaged", NOT_SHOWN) for state in self.left_out)
                if not (is_lacking or isinstance(error, ResultsError)):
                    raise
                if all(state.section != anchor for state in self.left_out):
                    self.left_out.append(State(anchor, NOT_SHOWN, notes=(str(error),)))
                bare = {**told, anchor: _worded(anchor, text, Section())}
                said.append(replace(self, chapters={})._prose(level, anchor, text, bare, names))
        return said

    def _prose(
        self, level: int, anchor: str, text: Text, told: Mapping[str, Section], names: Mapping[str, Any]
    ) -> Prose:
        section, sections = told[anchor], {name: chapter.section for name, chapter in self.chapters.items()}
        # A text that tells nothing of its own is no stand-in for the section of its name.
        asked = {name: each for name, each in told.items() if each.claims or each.unmeasured}
        known = {
            "release": self.project.release,
            "sections": _Names({name: chapter.names for name, chapter in self.chapters.items()}),
            **_things(anchor, section, {**asked, **sections}),
            "claim": _finder(anchor, "claim", {claim.name: claim.html(anchor) for claim in section.claims}),
        }
        return text.prose(anchor, {**known, **self.plugins.names(section), **names}, level)

    def _told(self, name: str, names: Mapping[str, Any]) -> Section:
        """Return what ``derive(chapters)`` or ``derive(releases, shown)`` of the story's module ``name`` derives."""
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
        try:
            return self.cache.derived(place, file, _digests(places), derive).section
        except Exception as error:
            self.left_out.append(State(name, NOT_SHOWN, notes=(bug_of(error),)))
            return Section()


def _worded(anchor: str, text: Text, section: Section) -> Section:
    """Give what a text tells its words; where what it is about was not measured there is nothing to tell."""
    if not section.claims:
        section = replace(section, unmeasured=[word for _, word in text.words])
    return section.worded(anchor, text.name, text.words)


class _Names(dict[str, Mapping[str, Any]]):
    """Hold what each section's words can name; of one that was not measured there is nothing to say."""

    def __missing__(self, name: str) -> Mapping[str, Any]:
        outline_of(name)  # for a name that no section has
        return dict.fromkeys(("claim", "table", "figure", "download"), lambda thing: Markup(""))


def editions_of(
    project: Project, templates: Templates | None = None, cache: DerivedCache | None = None, among: Sequence[str] = ()
) -> dict[str, Edition]:
    """Derive what the results of every release make, oldest first; ``among``: of these alone."""
    templates, cache, derived = templates or Templates(project.templates), cache or DerivedCache(), {}
    for release in among or project.releases:
        root = "" if release == project.release else "../"
        derived[release] = replace(derive_edition(project.of(release), templates, cache), root=root)
    releases = {release: edition.chapters for release, edition in derived.items()}
    for release, edition in derived.items():  # with the sections that compare releases
        compared = [(chapter.state, chapter.results) for chapter in edition.chapters.values() if chapter.compares]
        derived[release] = edition = _with_chapters(edition, compared, releases, templates)
        refuse_contradictions(templates.pairs, {name: chapter.section for name, chapter in edition.chapters.items()})
    return derived


def derive_edition(project: Project, templates: Templates, cache: DerivedCache | None = None) -> Edition:
    """Derive what the results of one release make by themselves: what compares releases has its results alone."""
    states, measurements = states_of(project), Measurements()
    left_out = [state for state in states if not state.record]
    tracked = {state.section: state.record for state in states if state.record}
    try:  # what a manifest that can't be read says is missed is missed unseen
        read_manifest(project.results)
    except RecordError as error:
        left_out.append(State(MANIFEST, "damaged", notes=(str(error),)))
    try:
        measurements = measurements_of(project, tracked, cache or DerivedCache())
    except RecordError as error:
        left_out.append(State(FOLDER, "damaged", notes=(str(error),)))
    floors, apart, measured = floors_in(tracked), measurements.apart, []
    for state in sorted(states, key=lambda each: outline_of(each.section).order):
        if state.record:
            path, known = project.record_path(state.section), apart.get(state.section, Apart())
            measured.append((state, Results(state.record, path, floors=floors, apart=known)))
    edition = Edition(project, {}, left_out, cache or DerivedCache(), measurements=measurements)
    return _with_chapters(edition, measured, {}, templates)


def _with_chapters(
    edition: Edition, measured: Sequence[tuple[State, Results]], releases: Releases, templates: Templates
) -> Edition:
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
    """Derive a section, from those ``told`` that it reads, and put it into words; one that compares takes releases."""
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
        return derive_section(own, releases), own.derived

    noise = [repr(sorted(results.floors.items())), edition.measurements.digest]
    given = [digest, *noise, *_digests({"": before, **releases})]
    entry = edition.cache.derived((project.profile, project.release, name), outline.file, given, derive)
    results = replace(results, derived=dict(entry.values))
    text = templates.text(f"sections/{name}.md.j2")
    tables = {key: thing.of(releases) if hasattr(thing, "of") else thing for key, thing in entry.section.tables.items()}
    section = edition.measurements.confirmed(name, replace(entry.section, tables=tables))
    section = section.worded(name, text.name, text.words)
    unmeasured = dict.fromkeys(section.unmeasured, Markup(""))
    names = {
        "release": results.record.origin.release,
        "row": results.row,
        "rows": results.rows,
        "value": results.derived,
        **_things(name, section, {**{other: chapter.section for other, chapter in told.items()}, name: section}),
        "claim": _finder(name, "claim", unmeasured | {claim.name: claim.html(name) for claim in section.claims}),
        "download": _finder(name, "download", {download.name: download for download in section.downloads}),
    }
    # Others read its claims, whose outcomes its words have a part in, and none of its words.
    outcomes = [(claim.name, repr(claim.outcome), claim.outcome.is_opposite) for claim in section.claims]
    digest = digest_of([entry.digest, outcomes, state.notes])
    prose = text.prose(name, names)
    return Chapter(state, results, section, names, prose, outline.page, outline.compares, digest)


def _digests(places: Releases) -> list[str]:
    return [f"{place} {name} {each.digest}" for place, told in places.items() for name, each in told.items()]


def results_digest(results: Results) -> str:
    """Digest a record and its traces."""
    folder = results.path.parent
    return files_digest([results.path, *traces_of(results.path, results.record)], folder) + folder.name


def _left_out(project: Project, state: State, error: Exception) -> State:
    """Say why a section can't be shown; what is wrong with its code stops the build where the record is fresh."""
    is_wrong = isinstance(error, ReportError) and not isinstance(error, RecordError | ResultsError)
    if is_wrong and state.kind == "fresh" and project.is_own:
        raise error
    words = str(error) if isinstance(error, ReportError) else bug_of(error)
    kind = "damaged" if isinstance(error, RecordError) else NOT_SHOWN if state.kind == "fresh" else state.kind
    place = "" if isinstance(error, RecordError) else f"{short_path(project.record_path(state.section))}: "
    return replace(state, kind=kind, record=None, notes=(place + " ".join(words.split()),))


def _things(own: str, section: Section, sections: Mapping[str, Section]) -> dict[str, Callable[..., Any]]:
    """Find tables and figures of the section ``own`` for its words, say its passages, and which claims hold."""

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
    return {"holds": holds, "passage": teller(find), **finders}


def _finder(section: str, kind: str, things: Mapping[str, Any]) -> Callable[[str], Any]:
    def find(name: str) -> Any:
        if name not in things:
            raise ReportError(f"{section} has no {kind} {name!r}; it has: {', '.join(things) or 'none'}")
        return things[name]

    return find
