"""The site: the pages of every release that has results, each checked, then drawn, then all put in place as a whole."""

import hashlib
import json
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from importlib import metadata
from pathlib import Path
from typing import Any

from markupsafe import Markup

from measured_report import ROOT
from measured_report.deriving.chapters import Chapter
from measured_report.deriving.editions import Edition, editions_of
from measured_report.deriving.keeping import Keeper, surroundings
from measured_report.editions.project import INPUTS, Project
from measured_report.editions.status import State, package_version
from measured_report.files.cache import Cache
from measured_report.files.files import locked
from measured_report.files.staging import Draft, digests_below, replace, staging_folder
from measured_report.pages.page import Prose, Templates
from measured_report.pages.pages import FRONT, Page
from measured_report.parts.drawing import draw_all
from measured_report.records.code import cached_sources, unchanged_files
from measured_report.records.identity import files_digest
from measured_report.records.provenance import package_versions
from measured_report.records.traces import BYTE_LIMIT, traces_of
from measured_report.site.archive import rows_csv
from measured_report.site.surroundings import ASSETS, citation, write_surroundings
from measured_report.values.noise import NOISE
from measured_report.values.quantities import VALUES_FILE, local
from report.media.replay import write_replay

OTHER_INPUTS = ("report.toml", "CITATION.cff", "LICENSE")
"""Files that the site is made from, besides the folders."""
WRITING_PACKAGES = ("jinja2", "markdown", "msgspec")
"""Packages that have a part in it, besides those that decide what is drawn."""
BUILT = "site"
"""What is kept of the last build."""
ID = re.compile(r' id="([^"]+)"')
INNER_LINK = re.compile(r' href="#([^"]+)"')


@dataclass(frozen=True)
class Leaf:
    """A page of one release, its figures not yet drawn."""

    page: Page
    texts: Sequence[Prose]
    chapters: Sequence[Chapter]

    @property
    def parts(self) -> list[Prose]:
        return [*self.texts, *(chapter.prose for chapter in self.chapters)]


@dataclass(frozen=True)
class Link:
    """One release, as the pages of another one lead to it."""

    edition: Edition
    base: str
    """Where its pages lie, seen from the other one's."""
    is_shown: bool
    """Whether it is the other one itself."""

    @property
    def release(self) -> str:
        return self.edition.project.release

    @property
    def sections(self) -> dict[str, Mapping[str, Any]]:
        """What other releases can name of its sections."""
        chapters = self.edition.chapters.values()
        return {chapter.name: chapter.names for chapter in chapters if self.is_shown or not chapter.compares}

    def address(self, page: Page) -> str:
        """The same page of it, or its front where it has no such page."""
        return self.base + (page if page in self.edition.pages else FRONT).file

    def section(self, name: str) -> str:
        """Address of a section; empty where it has none of that name."""
        chapter = self.edition.chapters.get(name)
        return f"{self.base}{chapter.page.file}#{name}" if chapter else ""


@dataclass(frozen=True)
class Built:
    """What the pages of a release lack."""

    stale: Sequence[str]
    """Sections that are shown as they were measured before something changed."""
    left_out: Sequence[State]


def build(project: Project, address: str = "") -> dict[str, Built]:
    """Write the site and say what it lacks, by release; until the site is whole, the one that was there stays.

    Its pages are the first of the site; those of other releases that have results lie in a folder each. What was made
    before from the same is not made again, and files that would be the same stay.

    Args:
        project: What to show.
        address: Where the site will lie, with a slash at its end; empty where that is not known.
    """
    cache = Cache(project.root)
    with staging_folder(project.site) as fresh, locked(project.results.parent, alone=False):
        cache.sweep()
        digest, there = _digest(project, address), digests_below(project.site)
        if kept := cache.get(BUILT, (digest, there)):
            return kept
        site = Draft(fresh, project.site, there)
        with cached_sources(project.root), unchanged_files():
            keeper, templates = Keeper(project.root), Templates(project.templates, cache)
            editions = editions_of(project, templates, keeper)
            _write_site(site, project, editions, templates, address, keeper)
            templates.keep()
        replace(project.site, fresh)
        built = {release: _built(edition) for release, edition in editions.items()}
        cache.put(BUILT, (digest, site.digests), built)
    return built


def _built(edition: Edition) -> Built:
    return Built([name for name, chapter in edition.chapters.items() if chapter.state.notes], edition.left_out)


def _write_site(
    site: Draft, project: Project, editions: Mapping[str, Edition], templates: Templates, address: str, keeper: Keeper
) -> None:
    places = {release: "" if release == project.release else f"newton-{release}/" for release in editions}
    links = {release: _links(editions, places, release) for release in editions}
    leaves = {release: _leaves(editions[release], templates, links[release]) for release in editions}
    chapters = [chapter for edition in editions.values() for chapter in edition.chapters.values()]
    tables = {chapter.results.source: rows_csv(chapter.results.record.rows) for chapter in chapters}

    def write_data() -> None:
        for release in editions:
            _write_data(site, f"{places[release]}data/", release, editions, tables)
            write_replay(site, places[release], editions[release], templates)
        write_surroundings(site, editions, places, tables, templates, address, keeper)
        site.write(".gitkeep", "")

    drawn = _draw(leaves, keeper, write_data)
    for release in editions:
        here = places[release]
        names = {
            "edition": editions[release],
            "leaves": leaves[release],
            "links": links[release],
            "drawn": drawn[release],
            "site_address": address,
            "address": address and f"{address}{places[release]}",
            "root": "../" if places[release] else "",
            "citation": citation(),
            "origins": json.dumps(_origins(editions), ensure_ascii=False),
            "floors": json.dumps(_floors(editions[release])),
        }
        pages = {leaf.page.file: templates.layout("base.html.j2", {**names, "leaf": leaf}) for leaf in leaves[release]}
        _write_pages(site, here, editions[release], _connected(pages, editions[release].chapters))


def _links(editions: Mapping[str, Edition], places: Mapping[str, str], shown: str) -> list[Link]:
    """All releases as seen from the pages of one, oldest first."""
    up = "../" if places[shown] else ""
    return [
        Link(edition, "" if release == shown else f"{up}{places[release]}", release == shown)
        for release, edition in editions.items()
    ]


def _leaves(edition: Edition, templates: Templates, links: Sequence[Link]) -> list[Leaf]:
    names = {"releases": links}
    return [Leaf(page, edition.texts(page, templates, names), chapters) for page, chapters in edition.pages.items()]


def undrawn(editions: Mapping[str, Edition], templates: Templates, shown: str) -> dict[tuple[str, str], Markup]:
    """The words of one release's pages by file and anchor of their parts; of a figure those below it."""
    leaves = _leaves(editions[shown], templates, _links(editions, dict.fromkeys(editions, ""), shown))
    parts = {(leaf.page.file, part.anchor): part for leaf in leaves for part in leaf.parts}
    return {place: _told(part) for place, part in parts.items()}


def _told(part: Prose) -> Markup:
    figures = {figure.anchor: figure.undrawn for figure in part.figures}
    return Markup("<h2>{}</h2>{}").format(part.title, part.html(figures))


def _draw(
    leaves: Mapping[str, Sequence[Leaf]], keeper: Keeper, meanwhile: Callable[[], None]
) -> dict[str, dict[str, Markup]]:
    """The figures of each release by their ids; one that several pages show is drawn once, and ``meanwhile`` done."""
    placed = {
        (release, figure.anchor): figure
        for release, found in leaves.items()
        for leaf in found
        for prose in leaf.parts
        for figure in prose.figures
    }
    pictures = {place: figure.pictures for place, figure in placed.items() if figure.pictures}
    # A section is kept with all of its figures, those as well that are not shown as long as something else is.
    others = {
        (release, anchor): figure
        for release, found in leaves.items()
        for leaf in found
        for prose in leaf.parts
        for anchor, figure in keeper.figures(release, prose.anchor).items()
    }
    to_draw = {
        place: figure for place, figure in (others | placed).items() if figure.is_there and place not in pictures
    }
    pictures |= zip(to_draw, draw_all(list(to_draw.values()), meanwhile), strict=True)
    keeper.keep(pictures)
    drawn: dict[str, dict[str, Markup]] = {release: {} for release in leaves}
    for (release, anchor), figure in placed.items():
        drawn[release][anchor] = figure.html(pictures.get((release, anchor)))
    return drawn


def _connected(pages: Mapping[str, str], sections: Collection[str]) -> dict[str, str]:
    """Pages by file, with links to what is not on their own page leading to the page that it is on.

    The front page has the ids of all sections, for old links, but they are not there.
    """
    ids = {file: set(ID.findall(html)) for file, html in pages.items()}
    ids[FRONT.file] -= set(sections)
    places = {name: file for file in pages for name in ids[file]}

    def connect(file: str, link: re.Match) -> str:
        name = link[1]
        return link[0] if name in ids[file] or name not in places else f' href="{places[name]}#{name}"'

    return {file: INNER_LINK.sub(partial(connect, file), html) for file, html in pages.items()}


def _origins(editions: Mapping[str, Edition]) -> dict[str, str]:
    """By file of a record: what it was measured with, and when."""
    chapters = [chapter for edition in editions.values() for chapter in edition.chapters.values()]
    records = {chapter.results.source: chapter.results.record for chapter in chapters}
    return {
        source: f"Newton {record.origin.release}, {record.machine_text}, {record.time_text}"
        for source, record in records.items()
    }


def _floors(edition: Edition) -> dict[str, tuple[float, float]]:
    """By column: how far apart runs of one case come out, and the largest value that this was seen at."""
    floors = edition.chapters[NOISE].results.floors if NOISE in edition.chapters else {}
    return {column: (floor.spread, floor.magnitude) for column, floor in floors.items()}


def _write_pages(site: Draft, folder: str, edition: Edition, pages: Mapping[str, str]) -> None:
    for file, html in pages.items():
        site.write(f"{folder}{file}", local(html, edition.project.release))
    for name in ASSETS:
        site.copy(f"{folder}{name}", edition.project.root / "assets" / name)
    for chapter in edition.chapters.values():
        for download in chapter.section.downloads:
            site.write(f"{folder}download/{download.name}", download.text)


def _write_data(
    site: Draft, folder: str, shown: str, editions: Mapping[str, Edition], tables: Mapping[str, bytes]
) -> None:
    """All that the page of the release ``shown`` names: its own results and values, and those of the others.

    ``tables`` are the rows of each record, by its file.
    """
    for release, edition in editions.items():
        own = release == shown
        for chapter in edition.chapters.values():
            path = chapter.results.path
            there = f"{folder}{path.parent.name}/"
            for file in (path, *(traces_of(path, chapter.results.record) if own else ())):
                site.copy(f"{there}{file.name}", file)
            site.write(f"{there}{path.stem}.csv", tables[chapter.results.source])
        values = edition.values_text if own else edition.uncompared_text
        site.write(f"{folder}{'' if own else f'newton-{release}/'}{VALUES_FILE}", local(values, shown))


def _digest(project: Project, address: str) -> str:
    """Of all that the pages are made from."""
    roots = {ROOT: INPUTS[:-1], project.root: INPUTS}  # often the same, but for the results
    digests = [files_digest(_inputs(root, folders), root) for root, folders in roots.items()]
    place = (project.release, project.profile, project.own_release)  # and not where the folder lies
    versions = [metadata.version(name) for name in WRITING_PACKAGES]
    checkouts = [
        package_version(project.of(release)) for release in project.releases
    ]  # may be edited, and lie elsewhere
    made_from = (place, address, package_versions(), surroundings(), versions, checkouts, digests)
    return hashlib.sha256(repr(made_from).encode()).hexdigest()


def _inputs(root: Path, folders: Sequence[str]) -> list[Path]:
    files = [root / name for name in OTHER_INPUTS]
    files += (path for folder in folders for path in (root / folder).rglob("*") if "__pycache__" not in path.parts)
    # Larger ones are refused by their readers.
    return [path for path in files if path.is_file() and path.stat().st_size <= BYTE_LIMIT]
