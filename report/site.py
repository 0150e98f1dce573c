"""The site: a page for every release that has results, each checked, then drawn, then all put in place as a whole."""

import hashlib
import json
import os
import shutil
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from markupsafe import Markup

from report.assemble import Derivation, Derived, Report, assemble, derive_release, derive_releases, values_file_of
from report.drawing import draw_all
from report.format import format_time
from report.identity import files_digest, package_versions
from report.page import Templates
from report.project import Project
from report.quantities import VALUES_FILE
from report.traces import traces_of

INPUTS = ("experiments", "report", "templates", "assets", "results")
"""Folders that a page is made from."""
DIGEST_FILE = ".inputs"
"""Beside a page: the digest of all that it was made from."""


@dataclass(frozen=True)
class Edition:
    """The page of one release, as another one leads to it."""

    release: str
    address: str
    """Where it lies, seen from the other one; empty for the page itself."""
    shown: Sequence[str]
    """Sections that it has."""


def build(project: Project) -> Report:
    """Write the site and return the report of ``project``; until it is whole, the site that was there stays.

    Its page is the first of the site; those of other releases that have results lie in a folder each, and are written
    only when something that they are made from has changed.
    """
    fresh = project.root / f".site-{os.getpid()}"
    derivations = derive_releases(project)
    # The first page has its values in another place than it has them on the others.
    first = derive_release(project, VALUES_FILE)
    reports = [assemble(project, derivations | {project.release: first})]
    reports += [assemble(project.of(name), derivations) for name in derivations if name != project.release]
    try:
        _write_site(fresh, reports, derivations)
        _replace(project.site, fresh)
    finally:
        shutil.rmtree(fresh, ignore_errors=True)
    return reports[0]


def _write_site(folder: Path, reports: Sequence[Report], derivations: Mapping[str, Derivation]) -> None:
    site, digest = reports[0].project.site, _digest(reports[0].project)
    places = {report.project.release: f"newton-{report.project.release}/" for report in reports}
    places[reports[0].project.release] = ""
    kept = [release for release, place in places.items() if place and _read_digest(site / place) == digest]
    for release in kept:
        shutil.copytree(site / places[release], folder / places[release])
    to_write = [report for report in reports if report.project.release not in kept]
    for report, drawn in zip(to_write, _draw(to_write), strict=True):
        here = folder / places[report.project.release]
        _write_page(here, report, _editions(reports, places, report), drawn)
        _write_data(here / "data", report, derivations)
        (here / DIGEST_FILE).write_text(digest, encoding="utf-8")
    (folder / ".gitkeep").touch()


def _editions(reports: Sequence[Report], places: Mapping[str, str], page: Report) -> list[Edition]:
    """All releases as seen from one page, oldest first."""
    up = "../" if places[page.project.release] else ""
    shown = {report.project.release: report.shown for report in reports}
    addresses = {name: "" if name == page.project.release else f"{up}{places[name]}index.html" for name in shown}
    return [Edition(name, addresses[name], shown[name]) for name in page.project.releases]


def _draw(reports: Sequence[Report]) -> list[dict[str, Markup]]:
    """The figures of each report by name."""
    placed = [
        (number, figure)
        for number, report in enumerate(reports)
        for prose in (report.summary, *(chapter.prose for chapter in report.chapters))
        for figure in prose.figures
    ]
    drawn: list[dict[str, Markup]] = [{} for _ in reports]
    for (number, figure), html in zip(placed, draw_all([figure for _, figure in placed]), strict=True):
        drawn[number][figure.name] = html
    return drawn


def _write_page(folder: Path, report: Report, editions: Sequence[Edition], drawn: Mapping[str, Markup]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    names = {"report": report, "editions": editions, "drawn": drawn, "format_time": format_time}
    html = Templates(report.project.templates).layout("base.html.j2", names)
    (folder / "index.html").write_text(html, encoding="utf-8")
    shutil.copyfile(report.project.root / "assets" / "style.css", folder / "style.css")
    for chapter in report.chapters:
        for download in chapter.section.downloads:
            path = folder / "download" / download.name
            path.parent.mkdir(exist_ok=True)
            path.write_text(download.text, encoding="utf-8")


def _write_data(folder: Path, report: Report, derivations: Mapping[str, Derivation]) -> None:
    """All that a page names: its own results and values, and those of the other releases."""
    for release, derivation in derivations.items():
        own = release == report.project.release
        for section in derivation.sections.values():
            path = section.results.path
            there = folder / path.parent.name
            there.mkdir(parents=True, exist_ok=True)
            for file in (path, *(traces_of(path) if own else ())):
                shutil.copyfile(file, there / file.name)
        if not own:
            _write_values(folder / values_file_of(release), derivation.sections.values())
    for name in {VALUES_FILE, report.values_file}:
        _write_values(folder / name, report.chapters)


def _write_values(path: Path, sections: Iterable[Derived]) -> None:
    values = {section.name: section.values for section in sections}
    path.parent.mkdir(parents=True, exist_ok=True)
    text = json.dumps(values, indent=1, ensure_ascii=False, allow_nan=False)
    path.write_text(text + "\n", encoding="utf-8")


def _digest(project: Project) -> str:
    """Of all that the pages are made from."""
    files = (path for folder in INPUTS for path in (project.root / folder).rglob("*"))
    sources = [path for path in files if "__pycache__" not in path.parts]
    made_from = (project, package_versions(), files_digest(sources, project.root))
    return hashlib.sha256(repr(made_from).encode()).hexdigest()


def _read_digest(folder: Path) -> str | None:
    try:
        return (folder / DIGEST_FILE).read_text(encoding="utf-8")
    except OSError:
        return None


def _replace(site: Path, fresh: Path) -> None:
    old = fresh.with_name(f"{fresh.name}-old")
    if site.exists():
        os.rename(site, old)
    os.rename(fresh, site)
    shutil.rmtree(old, ignore_errors=True)
