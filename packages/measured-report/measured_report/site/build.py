"""Build the site: write the pages of all measured releases and replace the old site."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain
from pathlib import Path

from measured_report.changes.checks import (
    blind_spots,
    gaps,
    idle_settings,
    refuse_unknown_names,
)
from measured_report.editions.project import INPUTS, MANIFEST, Project
from measured_report.editions.status import Kind, State
from measured_report.files import atomic
from measured_report.files.atomic import files_in, short_path
from measured_report.files.cache import Cache
from measured_report.files.config import FILE
from measured_report.files.errors import ReportError
from measured_report.findings.cache import installed
from measured_report.findings.editions import Edition
from measured_report.pages.prose import GENERATOR, Templates
from measured_report.pages.wording import worded_editions
from measured_report.records.code import digest_of, read_source
from measured_report.records.identity import (
    files_digest,
    package_versions,
    sections,
)
from measured_report.records.record import trace_path
from measured_report.records.replicas import SUMS
from measured_report.site.check import faults_of_pages
from measured_report.site.pages import site_files
from measured_report.values.quantities import lost_reason

OTHER_INPUTS = ("CITATION.cff", "LICENSE", FILE)
"""Files that the site depends on, besides the folders in ``INPUTS``."""
BUILT = "site"  # the name of the cache entry with the result of the last build

Built = tuple[Mapping[str, Sequence[State]], Sequence[str]]
"""The sections of each release that are not fresh, and notes on the own release."""


def build(project: Project, address: str = "") -> Built:
    """Write the site and return the sections that are not fresh, with notes.

    The old site is replaced only if all files can be written. ``address`` is the web
    address of the site, if it is known.
    """
    cache = Cache(project.root)
    with project.report, atomic.staging_folder(project.site) as fresh:
        digest = inputs_digest(project, address)
        digests = atomic.digests_below(project.site)
        if (
            project.site.is_symlink()
            and SUMS not in digests
            and any(project.site.iterdir())
        ):
            raise ReportError(
                f"{project.site.name} is a link to {project.site.resolve()}, which "
                "contains files that no build wrote: move them or remove the link"
            )
        if previous := cache.get(BUILT, (digest, digests)):
            return previous
        _refuse_code(project.report.root)
        templates = Templates(project.templates)
        editions = worded_editions(project, templates)
        own = editions.get(project.own_release or project.release)
        refuse_unknown_names(editions, own)
        files = site_files(editions, project.release, templates, address)
        for name, content in files.items():
            if isinstance(content, Path):
                content = content.read_bytes()
            atomic.write_file(fresh / name, content)
        faults = faults_of_pages(fresh)
        # Written last, because it contains the digests of all other files.
        atomic.write_file(fresh / SUMS, atomic.sums(atomic.digests_below(fresh)))
        atomic.put_in_place(project.site, fresh)
        states = {name: [*_not_fresh(edition)] for name, edition in editions.items()}
        notes = _notes(own) if own else []
        built = (states, [*notes, *faults])
        cache.put(BUILT, (digest, atomic.digests_below(project.site)), built)
    return built


def _refuse_code(root: Path) -> None:
    """Raise ReportError for the first figure that draws numbers typed in the code, and
    for numbers that are not from records.
    """
    for path in sorted((root / "report").rglob("*.py")):
        if re.match("_(?!_)", path.name):  # a draft
            continue
        name = path.relative_to(root).as_posix()
        source = read_source(path, name)
        for line in source.random:
            raise ReportError(
                f"{name}:{line} uses numbers without a record, such as random numbers, "
                "the time or a file: measure them in experiments/, or use random.Random(1)"
            )
        for line in source.typed:
            raise ReportError(
                f"{name}:{line} draws numbers that are typed in the code: draw numbers "
                "of the results, or values of results.chosen(…)"
            )


def _not_fresh(edition: Edition) -> Iterator[State]:
    """Yield the stale sections and the sections that are left out."""
    for chapter in edition.chapters.values():
        if chapter.state.kind == Kind.STALE:
            yield replace(chapter.state, record=None)
    yield from edition.left_out
    yield from edition.plugins.left_out


def _notes(edition: Edition) -> list[str]:
    """Return notes on missing numbers and claims, blind spots and unused settings."""
    missing = [
        f"{name}: its text prints a missing number: {reason}"
        for name, chapter in edition.chapters.items()
        for value in (chapter.prose.printed if chapter.prose else ())
        if (reason := lost_reason(value))
    ]
    unused = idle_settings(edition) + _stray_results(edition)
    return gaps(edition) + missing + blind_spots(edition) + unused


def _stray_results(edition: Edition) -> list[str]:
    """Return a line for each folder, record and trace in results/ that no code reads.

    They occur, for example, if a section was renamed or a folder's name is misspelt.
    """
    results = edition.project.results
    settings = edition.report.settings
    folders = {path.parent for path in files_in(results.parent, "*/*.json")}
    edition_folders = set(map(settings.edition_folder, edition.project.releases))
    lines = [
        f"{short_path(folder)} is not an edition: rename or remove it"
        for folder in sorted(folders)
        if folder.name not in edition_folders
    ]
    lines += [
        f"{short_path(folder)} has no {MANIFEST}, so a lost record would not be "
        "noticed: restore it or measure a section again"
        for folder in sorted(folders)
        if folder.name in edition_folders and not (folder / MANIFEST).exists()
    ]
    names = sections(edition.project.root)
    for path in files_in(results, "*.json"):
        if path.stem not in names and path not in edition.plugins.data:
            lines.append(
                f"{short_path(path)} does not belong to a section: rename or remove it"
            )
    for name, chapter in edition.chapters.items():
        record = chapter.results.record
        cases = [f"{row['case']}-" for row in record.rows]
        section = chapter.section
        drawn = chain(*(figure.sources for figure in section.figures.values()))
        read_files = {source.source for source in drawn}
        read_files.update(*(claim.outcome.reads for claim in section.claims))
        for case in record.traces:
            path = trace_path(chapter.results.path, case)
            # A trace can belong to all cases that begin with its name.
            is_of_case = any(name.startswith(f"{case}-") for name in cases)
            if not is_of_case and f"{results.name}/{path.name}" not in read_files:
                lines.append(
                    f"{short_path(path)} is a trace of {case}, which is not a case of "
                    f"{name}: correct its name in measure"
                )
        traces = {trace_path(chapter.results.path, case) for case in record.traces}
        lines += [
            f"{short_path(path)} is not a trace of {name}: remove it"
            for path in files_in(results, f"{name}.*.csv.gz")
            if path not in traces
        ]
    return lines


def inputs_digest(project: Project, address: str = "") -> str:
    """Return a digest of everything that the site depends on."""
    # The last two folders are often the same. Results are read from the second only.
    roots = {GENERATOR: ["."], project.report.root: INPUTS[:-1], project.root: INPUTS}
    digests = [
        files_digest([*_inputs(root, folders)], root) for root, folders in roots.items()
    ]
    selection = [project.release, project.profile, project.own_release, address]
    packages = [dict(package_versions()), installed()]
    return digest_of([selection, project.report.sources, packages, digests])


def _inputs(root: Path, folders: Sequence[str]) -> Iterator[Path]:
    """Yield the files and folders of a report."""
    paths = [root / name for name in OTHER_INPUTS]
    for folder in folders:
        paths += (root / folder).rglob("*")
    yield from (path for path in paths if "__pycache__" not in path.parts)
