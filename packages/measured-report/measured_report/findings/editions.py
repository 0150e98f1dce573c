"""Read editions from disk and derive their findings.

An edition is one release measured on one machine.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from importlib import import_module
from itertools import pairwise
from typing import Any

from measured_report.editions.project import Project
from measured_report.editions.status import Kind, State, other_damage, states_of
from measured_report.files.atomic import RecordError, short_path
from measured_report.files.config import Page, Report, module_named
from measured_report.files.errors import ReportError, bug_of
from measured_report.files.processes import forked
from measured_report.findings.cache import DerivedCache
from measured_report.findings.chapters import (
    Chapter,
    Chapters,
    Releases,
    before,
    results_digest,
)
from measured_report.findings.replicas import (
    Measurements,
    measured_digest,
    measurements_of,
)
from measured_report.findings.sections import (
    LAST,
    Outline,
    derive_by,
    derive_section,
    file_of,
    outline_of,
)
from measured_report.parts.claim import Claim
from measured_report.parts.section import Section
from measured_report.records.code import read_source
from measured_report.records.replicas import FOLDER
from measured_report.values.evidence import Evidence
from measured_report.values.quantities import Pointer, Value
from measured_report.values.results import Results, ResultsError

Derived = tuple[Section, Mapping[str, Value]]


@dataclass(eq=False)
class Edition:
    """Holds the results of one release and everything that is derived from them.

    Each stage of a build replaces the chapters.
    """

    project: Project
    cache: DerivedCache
    draws: bool = False  # whether to draw figures and store results in the cache
    root: str = ""  # the relative path from its pages to the root of the site
    chapters: dict[str, Chapter] = field(default_factory=dict)  # in order
    left_out: list[State] = field(default_factory=list)
    """Sections, replicas and texts that were not measured or cannot be shown."""
    stories: dict[str, Section] = field(default_factory=dict)  # rendered texts by name

    @cached_property
    def report(self) -> Report:
        return self.project.report

    @property
    def folder(self) -> str:
        """Return the folder of its pages below the site."""
        return f"{self.project.results.name}/" if self.root else ""

    @cached_property
    def pages(self) -> dict[Page, list[Chapter]]:
        """Return the pages that have chapters or are always there, with their chapters."""
        chapters = list(self.chapters.values())
        chapters.sort(key=lambda chapter: not chapter.outline.first)
        pages = {}
        for page in self.report.settings.pages:
            members = [chapter for chapter in chapters if chapter.page == page]
            if members or page.always or page == self.report.settings.front:
                pages[page] = members
        return pages

    def address(self, page: Page) -> str:
        """Return the address of a page below the site, or of the front page if no page
        is given.
        """
        existing_page = page if page in self.pages else self.report.settings.front
        return self.folder + existing_page.file

    @property
    def measured_on(self) -> str:
        """Return the date of its newest record, or an empty string."""
        records = (chapter.results.record for chapter in self.chapters.values())
        return max((record.measured["date"][:10] for record in records), default="")

    @cached_property
    def plugins(self) -> Any:
        """Return the parts that the report adds to the pages of this edition."""
        return module_named("plugins", self.report.settings.plugins).Plugins(self)

    def unmeasured(self, page: Page) -> list[State]:
        """Return the sections of a page without a record. The front page has all of them."""
        missing = [state for state in self.left_out if state.kind == Kind.MISSING]
        if page == self.report.settings.front:
            return missing
        return [
            state for state in missing if self._outline_of(state.section).page == page
        ]

    @property
    def uncompared(self) -> dict[str, Chapter]:
        """Return all chapters; those that compare releases have no findings yet."""
        return {
            name: replace(chapter, section=Section()) if chapter.compares else chapter
            for name, chapter in self.chapters.items()
        }

    def update(self, change: Callable[[Chapter], Chapter]) -> None:
        """Replace each chapter with a changed copy, and leave out chapters whose change
        fails.
        """
        for name, chapter in list(self.chapters.items()):
            try:
                self.chapters[name] = change(chapter)
            except Exception as error:
                del self.chapters[name]
                self.leave_out(chapter.state, error)

    def leave_out(self, state: State, error: Exception) -> None:
        """Note why a section cannot be shown; raise errors of the code or of templates."""
        is_fresh = state.kind == Kind.FRESH
        is_of_results = isinstance(error, RecordError | ResultsError)
        is_of_code = isinstance(error, ReportError) and not is_of_results
        if is_of_code and is_fresh and self.project.is_own:
            raise error
        message = str(error) if isinstance(error, ReportError) else bug_of(error)
        note = " ".join(message.split())
        kind = Kind.NOT_SHOWN if is_fresh else state.kind
        if isinstance(error, RecordError):
            kind = Kind.DAMAGED
        else:
            path = short_path(self.project.record_path(state.section))
            note = f"{path}: {note}"
        self.left_out.append(replace(state, kind=kind, record=None, notes=(note,)))

    def set_keys(self, releases: Releases | None = None) -> None:
        """Set the digest of each chapter's inputs.

        With ``releases``, only chapters that compare releases are set.
        """

        def with_key(chapter: Chapter) -> Chapter:
            if releases is not None and not chapter.compares:
                return chapter
            inputs = [
                results_digest(chapter.results),
                self._measured,
                *_digests_of({"": self._read_by(chapter), **(releases or {})}),
            ]
            return replace(chapter, key=self.cache.key(chapter.outline.file, inputs))

        self.update(with_key)

    def lacks(self, *, compares: bool) -> bool:
        """Return whether the cache lacks a chapter that compares releases or, without
        ``releases``, any other chapter.
        """
        return any(
            chapter.compares == compares
            and not self.cache.get(self._entry(name), chapter.key)
            for name, chapter in self.chapters.items()
        )

    def derive(self, releases: Releases | None = None) -> None:
        """Derive the chapters that compare releases or, without ``releases``, all other
        chapters.
        """
        if releases is None:
            for fault in self.measurements.damaged:
                self.left_out.append(State(FOLDER, Kind.DAMAGED, notes=(fault,)))
        self.update(partial(self._derived, releases=releases))

    @cached_property
    def measurements(self) -> Measurements:
        """Return the evidence from all measurements of this edition."""
        return measurements_of(self.project, self.cache)

    def _derived(self, chapter: Chapter, releases: Releases | None) -> Chapter:
        name, outline = chapter.name, chapter.outline
        if releases is not None and not outline.compares:
            return chapter
        for name_read in outline.reads:
            order = self._outline_of(name_read).order
            # Sections of the same order are derived by their names.
            if (order, name_read) >= (outline.order, name):
                raise ReportError(
                    f"{outline.source} reads {name_read}, which comes after it: "
                    f"give {name} a higher order"
                )
        results = replace(
            chapter.results,
            evidence=self.measurements.evidence.get(name, Evidence()),
            others={
                name_read.name: name_read.results
                for name_read in self._read_by(chapter).values()
            },
            derived={},
        )
        chapter = replace(chapter, results=results)
        # It needs the results of all editions, which are derived first.
        if outline.compares and releases is None:
            return chapter

        def derive() -> Derived:
            return derive_section(results, releases or {}), results.derived

        section, values = self._cached(self._entry(name), chapter.key, name, derive)
        results.derived.update(values)
        claims = [self._with_count(claim, name) for claim in section.claims]
        return replace(chapter, section=replace(section, claims=claims))

    def _with_count(self, claim: Claim, section: str) -> Claim:
        """Return a claim with the number of measurements that decide it, in words."""
        # Replicas do not have traces.
        has_traces = any(Pointer(pointer).is_trace for pointer in claim.outcome.reads)
        if claim.outcome.name == "unknown" or has_traces:
            return claim
        return replace(claim, confirmed=self.measurements.words.get(section, ""))

    def story(self, name: str, releases: Releases) -> Section:
        """Derive the findings of a text; its module takes chapters or all releases."""
        package = self.report.settings.text_modules
        if package:
            module_named("text_modules", package)
        file = file_of(package, name) if package else None
        count = read_source(file, name).top.get("derive", 0) if file else 0
        if not (file and count):
            return Section()
        chapters_read = releases if count > 1 else {"": self.chapters}
        inputs = (releases, self.project.release) if count > 1 else (self.chapters,)

        def derive() -> Derived:
            return derive_by(f"{package}.{name}", *inputs), {}

        key = self.cache.key(file, _digests_of(chapters_read))
        try:
            return self._cached(self._entry(f"{name}.text"), key, name, derive)[0]
        except Exception as error:
            self.left_out.append(State(name, Kind.NOT_SHOWN, notes=(bug_of(error),)))
            return Section()

    def _cached(
        self, entry: str, key: str, anchor: str, derive: Callable[[], Derived]
    ) -> Derived:
        """Return a section and its values from the cache, or derive and draw them."""
        if cached := self.cache.get(entry, key):
            return cached
        section, values = derive()
        if self.draws:
            section = section.drawn(anchor)
            self.cache.put(entry, key, (section, values))
        return section, values

    def _entry(self, name: str) -> str:
        return f"{self.project.profile}.{self.project.release}.{name}"

    def _outline_of(self, section: str) -> Outline:
        return outline_of(section, self.report)

    def _read_by(self, chapter: Chapter) -> Chapters:
        """Return the chapters whose results a chapter can read."""
        earlier_chapters = before(chapter.name, self.chapters)
        if chapter.compares:
            return earlier_chapters
        reads = chapter.outline.reads
        return {
            name: earlier for name, earlier in earlier_chapters.items() if name in reads
        }

    @cached_property
    def _measured(self) -> str:
        """Return a digest of the measurements of all editions, on which the noise
        depends.
        """
        return measured_digest(self.project)


def _digests_of(releases: Releases) -> list[str]:
    return [
        f"{release} {chapter.name} {chapter.key} {chapter.state.notes}"
        for release, chapters in releases.items()
        for chapter in chapters.values()
    ]


def editions_of(
    project: Project, among: Sequence[str] = (), *, draws: bool = False
) -> dict[str, Edition]:
    """Derive the editions named in ``among``, or all of them by default, oldest first."""
    cache = DerivedCache(project.root, project.report)
    with project.report:
        editions = {
            release: read_edition(project.of(release), cache)
            for release in among or project.releases
        }
        for release, edition in editions.items():
            edition.draws = draws
            edition.root = "" if release == project.release else "../"
        _derive(editions)
        chapters = {
            release: edition_of_release.chapters
            for release, edition_of_release in editions.items()
        }
        _derive(
            editions,
            {
                name: dict(edition_of_release)
                for name, edition_of_release in chapters.items()
            },
        )
    return editions


def _derive(editions: Mapping[str, Edition], releases: Releases | None = None) -> None:
    """Derive editions.

    Editions that are not in the cache are derived first, in parallel.
    """
    for edition in editions.values():
        edition.set_keys(releases)
    lacking = [
        edition
        for edition in editions.values()
        if edition.draws and edition.lacks(compares=releases is not None)
    ]
    lacking.sort(key=lambda edition: -len(edition.chapters))

    def derive_copy(index: int) -> None:
        edition = lacking[index]
        copy = replace(edition, chapters=dict(edition.chapters), left_out=[])
        copy.derive(releases)

    if len(lacking) > 1:
        for name in ("pandas", "measured_report.parts.figures"):
            import_module(name)  # done once here, instead of in each process
        _ = lacking[0].measurements  # the same: evaluated once, and stored in the cache
        forked(derive_copy, len(lacking))
    for edition in editions.values():
        edition.derive(releases)


def derive_edition(project: Project) -> Edition:
    """Derive one edition. Sections that compare releases then see no other release."""
    edition = read_edition(project, DerivedCache(project.root, project.report))
    edition.set_keys()
    edition.derive()
    return edition


def read_edition(project: Project, cache: DerivedCache) -> Edition:
    """Read the records of one edition, except missing and damaged ones."""
    code = cache.code(project.root, project.report.root)
    states = states_of(project, code)
    edition = Edition(project, cache)
    edition.left_out += [state for state in states if not state.record]
    edition.left_out += other_damage(project)
    chapters = []
    for state in states:
        if record := state.record:
            try:
                outline = outline_of(state.section, edition.report)
            except ReportError as error:
                edition.leave_out(state, error)
                continue
            results = Results(
                record,
                project.record_path(state.section),
                label=outline.label,
                labels=outline.labels,
                columns=edition.report.columns,
            )
            chapters.append(Chapter(state, outline, results))
    chapters.sort(key=lambda chapter: chapter.outline.order)
    outlines = [chapter.outline for chapter in chapters]
    for outline, next_outline in pairwise(outlines):
        if outline.order == next_outline.order != LAST:
            raise ReportError(
                f"{outline.source} and {next_outline.source} both have the order "
                f"{outline.order}: change one of them"
            )
    edition.chapters = {chapter.name: chapter for chapter in chapters}
    return edition
