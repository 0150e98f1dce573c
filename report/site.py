"""The site: a page for every release that has results, each checked, then drawn, then all put in place as a whole."""

import hashlib
import json
import shutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from markupsafe import Markup

from report.drawing import draw_all
from report.editions import Edition, editions_of
from report.page import Prose, Templates
from report.placing import aside, replace
from report.quantities import VALUES_FILE
from report.records.files import locked
from report.records.identity import files_digest, package_versions
from report.records.project import Project
from report.records.traces import BYTE_LIMIT, traces_of

INPUTS = ("experiments", "report", "templates", "assets", "results")
"""Folders that a page is made from."""
DIGEST_FILE = ".inputs"
"""Beside a page: the digest of all that it was made from."""


@dataclass(frozen=True)
class Link:
    """The page of one release, as another one leads to it."""

    release: str
    address: str
    """Where it lies, seen from the other one; empty for the page itself."""
    shown: Sequence[str]
    """Sections that it has."""


def build(project: Project) -> dict[str, Edition]:
    """Write the site and return the edition of each release; until the site is whole, the one that was there stays.

    Its page is the first of the site; those of other releases that have results lie in a folder each, and are written
    only when something that they are made from has changed.
    """
    templates = Templates(project.templates)
    with aside(project.site) as fresh, locked(project.results.parent, alone=False):
        editions = editions_of(project, templates)
        _write_site(fresh, project, editions, templates)
        replace(project.site, fresh)
    return editions


def _write_site(folder: Path, project: Project, editions: Mapping[str, Edition], templates: Templates) -> None:
    digest = _digest(project)
    places = {release: "" if release == project.release else f"newton-{release}/" for release in editions}
    kept = [release for release, place in places.items() if place and _read_digest(project.site / place) == digest]
    for release in kept:
        shutil.copytree(project.site / places[release], folder / places[release])
    to_write = {release: edition for release, edition in editions.items() if release not in kept}
    summaries = {release: edition.summary(templates) for release, edition in to_write.items()}
    drawn = _draw(to_write, summaries)
    for release, edition in to_write.items():
        here = folder / places[release]
        names = {"edition": edition, "summary": summaries[release], "drawn": drawn[release]}
        html = templates.layout("base.html.j2", names | {"links": _links(editions, places, release)})
        _write_page(here, edition, _local(html, release))
        _write_data(here / "data", release, editions)
        (here / DIGEST_FILE).write_text(digest, encoding="utf-8")
    (folder / ".gitkeep").touch()


def _links(editions: Mapping[str, Edition], places: Mapping[str, str], shown: str) -> list[Link]:
    """All releases as seen from the page of one, oldest first."""
    up = "../" if places[shown] else ""
    addresses = {release: "" if release == shown else f"{up}{place}index.html" for release, place in places.items()}
    return [Link(release, addresses[release], list(edition.chapters)) for release, edition in editions.items()]


def _draw(editions: Mapping[str, Edition], summaries: Mapping[str, Prose]) -> dict[str, dict[str, Markup]]:
    """The figures of each release by their ids."""
    placed = [
        (release, figure)
        for release, edition in editions.items()
        for prose in (summaries[release], *(chapter.prose for chapter in edition.chapters.values()))
        for figure in prose.figures
    ]
    drawn: dict[str, dict[str, Markup]] = {release: {} for release in editions}
    for (release, figure), html in zip(placed, draw_all([figure for _, figure in placed]), strict=True):
        drawn[release][figure.anchor] = html
    return drawn


def _write_page(folder: Path, edition: Edition, html: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "index.html").write_text(html, encoding="utf-8")
    shutil.copyfile(edition.project.root / "assets" / "style.css", folder / "style.css")
    for chapter in edition.chapters.values():
        for download in chapter.section.downloads:
            path = folder / "download" / download.name
            path.parent.mkdir(exist_ok=True)
            path.write_text(download.text, encoding="utf-8")


def _write_data(folder: Path, shown: str, editions: Mapping[str, Edition]) -> None:
    """All that the page of the release ``shown`` names: its own results and values, and those of the others."""
    for release, edition in editions.items():
        own = release == shown
        for chapter in edition.chapters.values():
            path = chapter.results.path
            there = folder / path.parent.name
            there.mkdir(parents=True, exist_ok=True)
            for file in (path, *(traces_of(path, chapter.results.record) if own else ())):
                shutil.copyfile(file, there / file.name)
        # What compares releases is derived for the page that it stands on alone.
        chapters = [chapter for chapter in edition.chapters.values() if own or not chapter.compares]
        values = {chapter.name: chapter.values for chapter in chapters}
        text = json.dumps(values, indent=1, ensure_ascii=False, allow_nan=False)
        place = folder / VALUES_FILE if own else folder / f"newton-{release}" / VALUES_FILE
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(_local(text, shown) + "\n", encoding="utf-8")


def _local(text: str, release: str) -> str:
    """``text`` as the page of a release has it: the addresses of its own values are shorter there."""
    return text.replace(f"newton-{release}/{VALUES_FILE}", VALUES_FILE)


def _digest(project: Project) -> str:
    """Of all that the pages are made from."""
    files = (path for folder in INPUTS for path in (project.root / folder).rglob("*"))
    sources = [path for path in files if "__pycache__" not in path.parts and path.is_file()]
    sources = [
        path for path in sources if path.stat().st_size <= BYTE_LIMIT
    ]  # larger ones are refused by their readers
    place = (project.release, project.profile, project.own_release)  # and not where the folder lies
    made_from = (place, package_versions(), files_digest(sources, project.root))
    return hashlib.sha256(repr(made_from).encode()).hexdigest()


def _read_digest(folder: Path) -> str | None:
    try:
        return (folder / DIGEST_FILE).read_text(encoding="utf-8")
    except OSError:
        return None
