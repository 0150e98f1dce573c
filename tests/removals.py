"""Find sentences that change although they do not read the removed data.

Each removal takes away one row, one record or one release of the tracked results, or
makes a row's numbers non-finite; then the report is derived again. A sentence is a
claim; it reads the cells of its test and of its numbers. Noise is estimated from all
measurements together, so the noise of all other numbers is kept.

    .venv/bin/python -m tests.removals [EVERY [FIRST]]

EVERY=1, the default, tries all removals. A larger number tries each EVERYth, from the
one with the index FIRST, so that several processes can share them.
"""

import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from importlib import import_module
from inspect import signature
from typing import Any

from measured_report.editions.project import Project, own_release
from measured_report.files.columns import REASON, is_number
from measured_report.files.config import report
from measured_report.files.errors import ReportError
from measured_report.findings.chapters import Chapter, Releases
from measured_report.findings.editions import Edition, editions_of
from measured_report.findings.sections import derive_section
from measured_report.pages.prose import Templates
from measured_report.pages.wording import template_of
from measured_report.parts.claim import Claim
from measured_report.parts.section import Section
from measured_report.records.record import Record
from measured_report.values.evidence import repeats_of
from measured_report.values.quantities import VALUES_FILE, Quantity
from measured_report.values.results import Results

NON_FINITE = "the state was not finite in frame 300"
OF_ALL = {("upgrade", "claims_stand")}
"""Sentences that read the outcomes of all other claims of an edition."""
Sentence = tuple[str, str, str]  # by release, by section or text, and by claim


@dataclass(frozen=True)
class Said:
    """Holds the answer of a claim, and the cells and traces that it reads."""

    text: str
    reads: frozenset[str]


@dataclass(frozen=True)
class Removal:
    """Names the removed release, record or row."""

    release: str
    section: str = ""
    row: int | None = None
    is_broken: bool = False  # the row remains, but its numbers are not finite

    def __str__(self) -> str:
        parts = [self.release, self.section, "" if self.row is None else str(self.row)]
        return (
            f"{'break' if self.is_broken else 'drop'} {' '.join(filter(None, parts))}"
        )

    def record(self, record: Record) -> Record:
        """Return the record without the row, or with a broken one."""
        assert self.row is not None
        row = record.rows[self.row]
        rows = [*record.rows[: self.row], *record.rows[self.row + 1 :]]
        if self.is_broken:
            rows.insert(self.row, broken(row))
        return replace(record, rows=rows)

    def takes(self, pointer: str, folder: str) -> bool:
        """Return whether a pointer leads to a removed cell."""
        if not self.section:
            return pointer.startswith(f"{folder}/")
        if self.row is None:
            values = f"{folder}/{VALUES_FILE}#/{self.section}/"
            return pointer.startswith((f"{folder}/{self.section}.", values))
        return pointer.startswith(f"{folder}/{self.section}.json#/rows/{self.row}/")


def broken(row: Mapping[str, Any]) -> dict[str, Any]:
    """Return a row whose measured numbers are not finite."""
    lost = [
        name
        for name, cell in row.items()
        if is_number(cell) and not report().columns[name].is_setting
    ]
    gone = dict.fromkeys(lost) | {name + REASON: NON_FINITE for name in lost}
    failed = {"failure": NON_FINITE} if "failure" in row else {}
    return {**row, **gone, **failed}


@dataclass
class World:
    """Holds the answers of the tracked results, and derives again the sections that a
    removal changes.
    """

    editions: Mapping[str, Edition]
    templates: Templates
    faults: list[str] = field(default_factory=list)

    @cached_property
    def releases(self) -> Releases:
        return {name: each.chapters for name, each in self.editions.items()}

    @cached_property
    def texts(self) -> dict[str, str]:
        """Return the templates with derived values, by name."""
        files = [file for page in report().settings.pages for file in page.texts]
        names = {file.rpartition("/")[2].partition(".")[0]: file for file in files}
        return {name: file for name, file in names.items() if self._module(name)}

    def _module(self, name: str) -> Any:
        package = report().settings.text_modules
        try:
            return import_module(f"{package}.{name}")
        except ModuleNotFoundError:
            return None

    @cached_property
    def said(self) -> dict[Sentence, Said]:
        """Return the answers of the tracked results."""
        return self._said_of(self.releases, self.releases)

    def _said_of(self, releases: Releases, changed: Releases) -> dict[Sentence, Said]:
        """Return the answers of the changed chapters and of all texts."""
        said = {}
        for release, chapters in changed.items():
            for name, chapter in chapters.items():
                template = template_of(name)
                said |= self._sentences(release, name, template, chapter.section)
        uncompared = {
            release: {
                name: replace(each, section=Section()) if each.compares else each
                for name, each in chapters.items()
            }
            for release, chapters in releases.items()
        }
        for release in releases:
            for name, file in self.texts.items():
                try:
                    derive = self._module(name).derive
                    has_all = len(signature(derive).parameters) > 1
                    asked = (uncompared, release) if has_all else (releases[release],)
                    section = derive(*asked)
                except Exception as error:
                    self.faults.append(f"{release} {name}: {error!r}")
                    continue
                if not section.claims:
                    names = [name for _, name in self.templates.words(file)]
                    section = replace(section, unmeasured=names)
                said |= self._sentences(release, name, file, section)
        return said

    def _sentences(
        self, release: str, name: str, template: str, section: Section
    ) -> dict[Sentence, Said]:
        try:
            worded = section.worded(name, template, self.templates.words(template))
        except ReportError as error:
            self.faults.append(f"{release} {name}: {error}")
            return {}
        return {
            (release, name, claim.name): Said(
                f"{claim.outcome.answer}: {claim.text}", reads_of(claim)
            )
            for claim in worded.claims
        }

    def without(self, removal: Removal) -> tuple[Releases, Releases]:
        """Return all chapters without the removed data, and the chapters that changed."""
        releases = {name: dict(each) for name, each in self.releases.items()}
        changed: dict[str, dict[str, Chapter]] = {name: {} for name in releases}
        gone: set[str] = set()
        if not removal.section:
            del releases[removal.release]
        elif removal.row is None:
            del releases[removal.release][removal.section]
            gone.add(removal.section)
        for release, chapters in releases.items():
            for name, chapter in list(chapters.items()):
                is_row = (release, name) == (removal.release, removal.section)
                reads = {*chapter.outline.reads} & {*changed[release], *gone}
                is_near = release == removal.release and bool(reads)
                if not (is_row or is_near or chapter.compares):
                    continue
                results = chapter.results
                if is_row:
                    results = self._changed(results, removal.record(results.record))
                others = {
                    other: chapters[other].results
                    for other in results.others
                    if other in chapters
                }
                results = replace(results, others=others, derived={})
                try:
                    section = derive_section(results, releases)
                except Exception as error:
                    self.faults.append(f"{release} {name}: {error}")
                    del chapters[name]
                    continue
                chapters[name] = replace(chapter, results=results, section=section)
                changed[release][name] = chapters[name]
        return releases, changed

    def with_rows_of(self, chapter: Chapter, other: Chapter) -> Chapter:
        """Return a chapter with the measurements of another one."""
        record = replace(chapter.results.record, rows=other.results.record.rows)
        results = replace(
            chapter.results, record=record, evidence=other.results.evidence
        )
        return replace(chapter, results=results)

    def _changed(self, results: Results, record: Record) -> Results:
        evidence = results.evidence
        if record.section == report().settings.noise_section:
            evidence = replace(
                evidence, repeats=repeats_of(record.rows, results.columns)
            )
        return replace(results, record=record, evidence=evidence)

    def changed(self, removal: Removal) -> dict[Sentence, str | None]:
        """Return the sentences that a removal changes, or None for those that are gone."""
        releases, changed = self.without(removal)
        after = self._said_of(releases, changed)
        derived = {(release, name) for release in changed for name in changed[release]}
        derived |= {(release, name) for release in releases for name in self.texts}
        derived.add((removal.release, removal.section))
        now = {key: each.text for key, each in after.items()}
        return {
            key: now.get(key)
            for key, each in self.said.items()
            if key[:2] in derived and now.get(key) != each.text
        }

    def unread(self, removal: Removal) -> dict[Sentence, tuple[str, str]]:
        """Return sentences that changed without reading removed data, as pairs of
        before and after.
        """
        folder = self.editions[removal.release].project.results.name
        releases, changed = self.without(removal)
        after = self._said_of(releases, changed)
        found = {}
        for sentence, said in self.said.items():
            release, name, claim = sentence
            is_gone = removal.row is None and (removal.release, removal.section) in (
                (release, name),
                (release, ""),
            )
            is_read = any(removal.takes(read, folder) for read in said.reads)
            if is_gone or is_read or (name, claim) in OF_ALL:
                continue
            now = after.get(sentence)
            if now and now.text != said.text:
                found[sentence] = (said.text, now.text)
            elif not now and (name in changed[release] or name in self.texts):
                found[sentence] = (said.text, "gone")
        return found


def reads_of(claim: Claim) -> frozenset[str]:
    """Return pointers to all cells that a claim's test and its numbers read."""
    numbers = [each for each in claim.numbers.values() if isinstance(each, Quantity)]
    tests = (claim.outcome.reads, claim.effect.reads)
    return frozenset().union(*tests, *(number.reads for number in numbers))


def removals_of(world: World, among: tuple[str, ...]) -> Iterator[Removal]:
    """Yield removals of each release, record and row, and a broken copy of each row."""
    for release in world.releases:
        yield Removal(release)
    for release in among:
        for section, chapter in world.releases[release].items():
            yield Removal(release, section)
            for row in range(len(chapter.results.record.rows)):
                yield Removal(release, section, row)
                yield Removal(release, section, row, is_broken=True)


def tracked_world() -> World:
    project = Project(own_release())
    editions = editions_of(project, draws=True)
    return World(editions, Templates(project.templates))


def main() -> int:
    """Print each sentence that changes without reading removed data, and each error.

    Return 1 if there are any.
    """
    numbers = [int(text) for text in sys.argv[1:]]
    every = numbers[0] if numbers else 1
    first = numbers[1] if len(numbers) > 1 else 0
    world = tracked_world()
    removals = list(removals_of(world, (own_release(), "1.8.0")))[first::every]
    count = 0
    for removal in removals:
        world.faults.clear()
        for sentence, (before, after) in world.unread(removal).items():
            name = ".".join(sentence)
            print(f"{removal}: {name}\n  - {before}\n  + {after}", flush=True)
            count += 1
        for fault in world.faults:
            print(f"{removal}: {fault}", flush=True)
            count += 1
    print(f"{len(removals)} removals, {count} sentences changed unread")
    return int(count > 0)


if __name__ == "__main__":
    sys.exit(main())
