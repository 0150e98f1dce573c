"""Editions: what every section of a release that has results comes to, without its words."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeVar

from measured_report.editions.project import MANIFEST, Project, read_manifest
from measured_report.editions.status import NOT_SHOWN, State, states_of
from measured_report.files.atomic import RecordError, short_path
from measured_report.files.config import config, module_of
from measured_report.files.errors import ReportError, bug_of
from measured_report.findings.cache import Derivation, DerivedCache
from measured_report.findings.chapters import (
    Chapter,
    Chapters,
    Releases,
    before,
    digests_of,
    results_digest,
)
from measured_report.findings.replicas import Measurements, measurements_of
from measured_report.findings.sections import (
    Read,
    derive_by,
    derive_section,
    file_of,
    outline_of,
)
from measured_report.parts.section import Section
from measured_report.records.code import files, unchanged_files
from measured_report.records.replicas import FOLDER
from measured_report.records.syntax import digest_of
from measured_report.values.evidence import Evidence
from measured_report.values.results import Results, ResultsError

Some = TypeVar("Some", bound="Edition")


@dataclass(frozen=True)
class Edition:
    """Hold what the results of one release make."""

    project: Project
    chapters: Chapters
    left_out: list[State]  # sections with results that are missing, damaged, or too old for what is derived or said
    cache: DerivedCache = field(default_factory=DerivedCache)
    measurements: Measurements = field(default_factory=Measurements)

    @property
    def uncompared(self) -> Chapters:
        """Return its chapters; of those that compare releases, and say what is so on one page alone, the results."""
        compared = filter(lambda chapter: chapter.compares, self.chapters.values())
        return {**self.chapters, **{chapter.name: replace(chapter, section=Section()) for chapter in compared}}

    def with_chapters(
        self: Some, make: Callable[[State, Chapters], Chapter], states: Iterable[State] | None = None
    ) -> Some:
        """Return the same with what ``make`` makes of sections, its own or others; one that it can't is left out."""
        chapters, left_out = dict(self.chapters), list(self.left_out)
        for state in [chapter.state for chapter in self.chapters.values()] if states is None else states:
            try:
                chapters[state.section] = make(state, chapters)
            except Exception as error:
                left_out.append(_left_out(self.project, state, error))
                chapters.pop(state.section, None)
        return replace(self, chapters=chapters, left_out=left_out)

    def derive(self, state: State, results: Results, chapters: Chapters, releases: Releases | None = None) -> Chapter:
        """Derive a section of its results and of chapters before it that it reads; one that compares takes releases."""
        outline = outline_of(state.section)
        read = {name: chapters[name] for name in (chapters if outline.compares else outline.reads) if name in chapters}
        others = Read(outline, {name: chapter.results for name, chapter in read.items()})
        _ = [others.get(name) for name in outline.reads]  # which refuses one that stands after it, read or not
        results = replace(results, others=others, label=outline.label, labels=outline.labels)
        digest, section = results_digest(results) if self.cache.root else "", Section()
        if releases or not outline.compares:

            def make() -> Derivation:
                bare = replace(results, derived={})
                return Derivation(derive_section(bare, releases or {}), bare.derived)

            noise = repr(results.evidence.repeats), self.measurements.digest
            inputs = [digest, *noise, *digests_of({"": read, **(releases or {})})]
            key = (self.project.profile, self.project.release, state.section)
            derivation = self.cache.derived(key, outline.file, inputs, make)
            results, section = replace(results, derived=dict(derivation.values)), derivation.section
            digest = digest_of([derivation.digest, state.notes])
        section = self.measurements.confirmed(state.section, section)
        # Others read its claims, in whose outcomes replicas have a part.
        outcomes = [(claim.name, repr(claim.outcome), claim.outcome.is_opposite) for claim in section.claims]
        return Chapter(state, results, section, outline.page, outline.compares, digest_of([digest, outcomes]))

    def story(self, name: str, releases: Releases) -> Section:
        """Return what ``derive(chapters)`` or ``derive(releases, shown)`` of the story's module ``name`` derives."""
        package = module_of("text_modules").__name__ if config().text_modules else ""
        module, file = f"{package}.{name}", file_of(package, name) if package else None
        arguments = files().source(file, name).top.get("derive", 0) if file else 0
        if not (file and arguments):
            return Section()
        inputs = (releases, self.project.release) if arguments > 1 else (self.chapters,)
        key = (self.project.profile, self.project.release, name)
        digests = digests_of(releases if arguments > 1 else {"": self.chapters})
        try:
            return self.cache.derived(key, file, digests, lambda: Derivation(derive_by(module, *inputs), {})).section
        except Exception as error:
            self.left_out.append(State(name, NOT_SHOWN, notes=(bug_of(error),)))
            return Section()


def editions_of(project: Project, cache: DerivedCache | None = None, among: Sequence[str] = ()) -> dict[str, Edition]:
    """Derive what the results of every release make, oldest first; ``among``: of these alone."""
    cache = cache or DerivedCache(project.root)
    with project.report, unchanged_files():
        bare = {release: derive_edition(project.of(release), cache) for release in among or project.releases}
        releases = {release: edition.chapters for release, edition in bare.items()}
        return {release: _compared(edition, releases) for release, edition in bare.items()}


def derive_edition(project: Project, cache: DerivedCache | None = None) -> Edition:
    """Derive what the results of one release make by themselves: what compares releases has its results alone."""
    states, cache = states_of(project), cache or DerivedCache()
    left_out = [state for state in states if not state.record]
    tracked = {state.section: state.record for state in states if state.record}
    try:  # what a manifest that can't be read says is missed is missed unseen
        read_manifest(project.results)
    except RecordError as error:
        left_out.append(State(MANIFEST, "damaged", notes=(str(error),)))
    measurements = measurements_of(project, tracked, cache)
    left_out += [State(FOLDER, "damaged", notes=(fault,)) for fault in measurements.damaged]
    edition = Edition(project, {}, left_out, cache, measurements)

    def derive(state: State, chapters: Chapters) -> Chapter:
        assert state.record
        evidence = measurements.evidence.get(state.section, Evidence())
        results = Results(state.record, project.record_path(state.section), evidence=evidence)
        return edition.derive(state, results, chapters)

    measured = sorted(filter(lambda state: state.record, states), key=lambda state: outline_of(state.section).order)
    return edition.with_chapters(derive, measured)


def _compared(edition: Edition, releases: Releases) -> Edition:
    def derive(state: State, chapters: Chapters) -> Chapter:
        return edition.derive(state, chapters[state.section].results, before(state.section, chapters), releases)

    return edition.with_chapters(derive, [chapter.state for chapter in edition.chapters.values() if chapter.compares])


def _left_out(project: Project, state: State, error: Exception) -> State:
    """Say why a section can't be shown; what is wrong with its code stops the build where the record is fresh."""
    is_wrong = isinstance(error, ReportError) and not isinstance(error, RecordError | ResultsError)
    if is_wrong and state.kind == "fresh" and project.is_own:
        raise error
    message = str(error) if isinstance(error, ReportError) else bug_of(error)
    kind = "damaged" if isinstance(error, RecordError) else NOT_SHOWN if state.kind == "fresh" else state.kind
    prefix = "" if isinstance(error, RecordError) else f"{short_path(project.record_path(state.section))}: "
    return replace(state, kind=kind, record=None, notes=(prefix + " ".join(message.split()),))
