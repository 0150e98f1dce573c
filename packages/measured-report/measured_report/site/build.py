"""The site: the pages of every release that has results, each checked, then drawn, then all put in place as a whole."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from measured_report.changes.checks import (
    blind_spots,
    gaps,
    idle_settings,
    refuse_unknown_names,
)
from measured_report.editions.project import INPUTS, Project
from measured_report.editions.status import State, package_version
from measured_report.files.atomic import (
    digests_below,
    replace,
    short_path,
    staging_folder,
    sums,
    write_file,
)
from measured_report.files.cache import Cache
from measured_report.files.config import FILE
from measured_report.files.errors import ReportError
from measured_report.findings.cache import installed
from measured_report.findings.editions import Edition
from measured_report.pages.prose import GENERATOR, Templates
from measured_report.pages.wording import worded_editions
from measured_report.records.identity import (
    files_digest,
    package_versions,
    sections,
    sources,
)
from measured_report.records.record import BYTE_LIMIT, trace_path
from measured_report.records.replicas import SUMS
from measured_report.site.pages import site_files
from measured_report.values.quantities import lost_reason

OTHER_INPUTS = (
    "CITATION.cff",
    "LICENSE",
    FILE,
)  # files that the site is made from, besides the folders
BUILT = "site"  # what is kept of the last build


@dataclass(frozen=True)
class Built:
    """List what a release's pages lack: sections that something changed under since, and those that are left out."""

    stale: Sequence[str]
    left_out: Sequence[State]
    gaps: Sequence[
        str
    ] = ()  # of the own release what was measured and is no answer, as the next
    notes: Sequence[str] = ()


def build(project: Project, address: str = "") -> dict[str, Built]:
    """Write the site, which may be known to lie at ``address``, whole or not at all; say what it lacks, by release."""
    cache = Cache(project.root)
    with project.report, staging_folder(project.site) as fresh:
        digest, digests = inputs_digest(project, address), digests_below(project.site)
        if (
            project.site.is_symlink()
            and SUMS not in digests
            and any(project.site.iterdir())
        ):
            elsewhere = f"{project.site.name} is a link to {project.site.resolve()}"
            raise ReportError(
                f"{elsewhere}, where something lies that no build made; it was left alone"
            )
        if previous := cache.get(BUILT, (digest, digests)):
            return previous
        templates = Templates(project.templates, project.report)
        editions = worded_editions(project, templates)
        refuse_unknown_names(
            editions, editions.get(project.own_release or project.release)
        )
        files = site_files(editions, project.release, templates, address)
        for name, content in files.items():
            if isinstance(content, Path):
                content = content.read_bytes()
            write_file(fresh / name, content)
        write_file(fresh / SUMS, sums(digests_below(fresh)))
        replace(project.site, fresh)
        built = {}
        for release, edition in editions.items():
            stale = [
                name
                for name, chapter in edition.chapters.items()
                if chapter.state.notes
            ]
            notes = _notes(edition) if edition.project.is_own else ()
            built[release] = Built(
                stale, [*edition.left_out, *edition.plugins.left_out], *notes
            )
        cache.put(BUILT, (digest, digests_below(project.site)), built)
    return built


def _notes(edition: Edition) -> tuple[list[str], list[str]]:
    """Say what of an edition is no answer, and what is of nothing, or can't be told."""
    lost = [
        f"{name}: its words print what is not there: {reason}"
        for name, chapter in edition.chapters.items()
        for item in (chapter.prose.printed if chapter.prose else ())
        if (reason := lost_reason(item))
    ]
    idle = _records_of_nothing(edition) + idle_settings(edition)
    return gaps(edition) + lost, blind_spots(edition) + idle


def _records_of_nothing(edition: Edition) -> list[str]:
    """Say which records are of no section, as those of one that was renamed, which traces of none, and so on."""
    results, known = edition.project.results, sections(edition.project.root)
    editions = map(edition.report.settings.edition_folder, edition.project.releases)
    strange = sorted(
        {path.parent.name for path in results.parent.glob("*/*.json")}.difference(
            editions
        )
    )
    paths = (
        path
        for path in sorted(results.glob("*.json"))
        if path not in edition.plugins.data
    )
    lines = [f"results/{name} is of no edition" for name in strange]
    for name, chapter in edition.chapters.items():
        sealed = {
            trace_path(chapter.results.path, case)
            for case in chapter.results.record.traces
        }
        strays = sorted({*results.glob(f"{name}.*.csv.gz")} - sealed)
        lines += [f"{short_path(path)} is no trace of {name}" for path in strays]
    return lines + [
        f"{short_path(path)} is of no section"
        for path in paths
        if path.stem not in known
    ]


def inputs_digest(project: Project, address: str = "") -> str:
    # The last two are often the same, but for the results.
    roots = {GENERATOR: ["."], project.report.root: INPUTS[:-1], project.root: INPUTS}
    digests = [
        sources(),
        *(
            files_digest(_inputs(root, folders), root)
            for root, folders in roots.items()
        ),
    ]
    selection = (
        project.release,
        project.profile,
        project.own_release,
    )  # and not where the folder lies
    # A checkout may be edited, and lie elsewhere.
    checkouts = [package_version(project.of(release)) for release in project.releases]
    made_from = (
        selection,
        address,
        sources(),
        package_versions(),
        installed(),
        checkouts,
        digests,
    )
    return hashlib.sha256(repr(made_from).encode()).hexdigest()


def _inputs(root: Path, folders: Sequence[str]) -> list[Path]:
    below = (
        path
        for folder in folders
        for path in (root / folder).rglob("*")
        if "__pycache__" not in path.parts
    )
    files = (
        path for path in (*map(root.joinpath, OTHER_INPUTS), *below) if path.is_file()
    )
    return [
        path for path in files if path.stat().st_size <= BYTE_LIMIT
    ]  # larger ones are refused by their readers
