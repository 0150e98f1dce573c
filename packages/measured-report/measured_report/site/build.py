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
from measured_report.deriving.cache import DerivedCache
from measured_report.deriving.chapters import Chapter
from measured_report.deriving.dependencies import installed
from measured_report.deriving.editions import Edition, editions_of
from measured_report.editions.project import INPUTS, Project
from measured_report.editions.status import State, package_version
from measured_report.files.atomic import locked
from measured_report.files.cache import Cache
from measured_report.files.config import FILE, config
from measured_report.files.staging import Draft, digests_below, replace, staging_folder
from measured_report.pages.outline import FRONT, Page
from measured_report.pages.prose import LAYOUT, Prose, Templates
from measured_report.parts.drawing import draw_all
from measured_report.records.code import cached_sources, unchanged_files
from measured_report.records.identity import files_digest
from measured_report.records.provenance import package_versions
from measured_report.records.traces import BYTE_LIMIT, traces_of
from measured_report.site.archive import rows_csv
from measured_report.site.root_files import CARD, citation, write_root_files
from measured_report.values.noise import NOISE
from measured_report.values.quantities import VALUES_FILE, local
from measured_report.values.results import Results

OTHER_INPUTS = ("CITATION.cff", "LICENSE", FILE)
"""Files that the site is made from, besides the folders."""
WRITING_PACKAGES = ("jinja2", "markdown", "msgspec")
"""Packages that have a part in it, besides those that decide what is drawn."""
BUILT = "site"
"""What is kept of the last build."""
BESIDE = ("style.css", "page.js")
"""Files of the layout that lie beside the pages of each release."""
ICON = "favicon.svg"
"""A report's own, in its ``assets/``, which need not be there."""
ID = re.compile(r' id="([^"]+)"')
INNER_LINK = re.compile(r' href="#([^"]+)"')


@dataclass(frozen=True)
class Content:
    """What a page of one release has on it, its figures not yet drawn."""

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
        """Return that of the same page of it, or of its front where it has no such page."""
        return self.base + (page if page in self.edition.pages else FRONT).file

    def section(self, name: str) -> str:
        """Return the address of a section; empty where it has none of that name."""
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
        draft = Draft(fresh, project.site, there)
        with cached_sources(project.root), unchanged_files():
            derived, templates = DerivedCache(project.root), Templates(project.templates, cache)
            editions = editions_of(project, templates, derived)
            Site(draft, project.release, editions, templates, address, derived).write()
            templates.keep()
        replace(project.site, fresh)
        built = {release: _built(edition) for release, edition in editions.items()}
        cache.put(BUILT, (digest, draft.digests), built)
    return built


def _built(edition: Edition) -> Built:
    return Built([name for name, chapter in edition.chapters.items() if chapter.state.notes], edition.left_out)


@dataclass(frozen=True)
class Site:
    """A site that is being written."""

    draft: Draft
    shown: str
    """The release whose pages are the first."""
    editions: Mapping[str, Edition]
    """Every release by its name, oldest first."""
    templates: Templates
    address: str
    """Where it will lie; empty where that is not known."""
    cache: DerivedCache

    def write(self) -> None:
        """Draw all figures, and write data and pages of all releases."""
        folders = {release: f"{edition.project.results.name}/" for release, edition in self.editions.items()}
        places = {**folders, self.shown: ""}
        links = {release: _links(self.editions, places, release) for release in places}
        contents = {release: _contents(self.editions[release], self.templates, links[release]) for release in places}
        records = [chapter.results for edition in self.editions.values() for chapter in edition.chapters.values()]
        tables = {results.source: rows_csv(results.record.rows) for results in records}

        def write_data() -> None:
            for release, place in places.items():
                self._write_data(f"{place}data/", release, tables)
                self.editions[release].extras.write(self.draft, place, self.templates)
            write_root_files(self, places, tables)

        drawn = _draw(contents, self.cache, write_data)
        origins = json.dumps({results.source: _origin(results) for results in records}, ensure_ascii=False)
        for release, place in places.items():
            names = {
                "contents": contents[release],
                "links": links[release],
                "drawn": {anchor: html for (each, anchor), html in drawn.items() if each == release},
                "origins": origins,
            }
            self._write_pages(place, self.editions[release], names)

    def _write_pages(self, place: str, edition: Edition, names: Mapping[str, Any]) -> None:
        icon = edition.project.root / "assets" / ICON
        known = {
            "edition": edition,
            "site_address": self.address,
            "address": self.address and f"{self.address}{place}",
            "root": "../" if place else "",
            "card": CARD if CARD in self.draft.digests else "",
            "icon": ICON if icon.is_file() else "",
            "citation": citation(),
            "floors": json.dumps(_floors(edition)),
            **names,
        }
        layout = partial(self.templates.layout, "base.html.j2")
        pages = {content.page.file: layout({**known, "content": content}) for content in names["contents"]}
        for file, html in _connected(pages, edition.chapters).items():
            self.draft.write(f"{place}{file}", local(html, edition.project.release))
        for path in (*(LAYOUT / name for name in BESIDE), *([icon] if icon.is_file() else [])):
            self.draft.copy(f"{place}{path.name}", path)
        for chapter in edition.chapters.values():
            for download in chapter.section.downloads:
                self.draft.write(f"{place}download/{download.name}", download.text)

    def _write_data(self, folder: str, shown: str, tables: Mapping[str, bytes]) -> None:
        """All that the pages of the release ``shown`` name: its own results and values, and those of the others.

        ``tables`` are the rows of each record, by its file.
        """
        for release, edition in self.editions.items():
            own, name = release == shown, edition.project.results.name
            for chapter in edition.chapters.values():
                path = chapter.results.path
                for file in (path, *(traces_of(path, chapter.results.record) if own else ())):
                    self.draft.copy(f"{folder}{name}/{file.name}", file)
                self.draft.write(f"{folder}{name}/{path.stem}.csv", tables[chapter.results.source])
            values = edition.values_text if own else edition.uncompared_text
            self.draft.write(f"{folder}{'' if own else f'{name}/'}{VALUES_FILE}", local(values, shown))


def _links(editions: Mapping[str, Edition], places: Mapping[str, str], shown: str) -> list[Link]:
    """All releases as seen from the pages of one, oldest first."""
    up = "../" if places[shown] else ""
    return [
        Link(edition, "" if release == shown else f"{up}{places[release]}", release == shown)
        for release, edition in editions.items()
    ]


def _contents(edition: Edition, templates: Templates, links: Sequence[Link]) -> list[Content]:
    names = {"releases": links}
    return [Content(page, edition.texts(page, templates, names), found) for page, found in edition.pages.items()]


def undrawn(editions: Mapping[str, Edition], templates: Templates, shown: str) -> dict[tuple[str, str], Markup]:
    """Return the words of one release's pages by file and anchor of their parts; of a figure those below it."""
    contents = _contents(editions[shown], templates, _links(editions, dict.fromkeys(editions, ""), shown))
    parts = {(content.page.file, part.anchor): part for content in contents for part in content.parts}
    return {place: _undrawn(part) for place, part in parts.items()}


def _undrawn(part: Prose) -> Markup:
    figures = {figure.anchor: figure.undrawn for figure in part.figures}
    return Markup("<h2>{}</h2>{}").format(part.title, part.html(figures))


def _draw(
    contents: Mapping[str, Sequence[Content]], cache: DerivedCache, meanwhile: Callable[[], None]
) -> dict[tuple[str, str], Markup]:
    """The figures by release and id; one that several pages show is drawn once, and ``meanwhile`` done."""
    placed = {
        (release, figure.anchor): figure
        for release, found in contents.items()
        for content in found
        for prose in content.parts
        for figure in prose.figures
    }
    pictures = {place: figure.pictures for place, figure in placed.items() if figure.pictures}
    # A section is kept with all of its figures, those as well that are not shown as long as something else is.
    wanted = cache.figures | placed
    to_draw = {place: figure for place, figure in wanted.items() if figure.is_there and place not in pictures}
    pictures |= zip(to_draw, draw_all(list(to_draw.values()), meanwhile), strict=True)
    cache.keep(pictures)
    return {place: figure.html(pictures.get(place)) for place, figure in placed.items()}


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


def _origin(results: Results) -> str:
    """What a record was measured with, and when."""
    record = results.record
    return f"{config().edition(record.origin.release)}, {record.machine_text}, {record.time_text}"


def _floors(edition: Edition) -> dict[str, tuple[float, float]]:
    """By column: how far apart runs of one case come out, and the largest value that this was seen at."""
    floors = edition.chapters[NOISE].results.floors if NOISE in edition.chapters else {}
    return {column: (floor.spread, floor.magnitude) for column, floor in floors.items()}


def _digest(project: Project, address: str) -> str:
    """Of all that the pages are made from."""
    roots = {LAYOUT.parent: ["."], ROOT: INPUTS[:-1], project.root: INPUTS}  # often the same, but for the results
    digests = [files_digest(_inputs(root, folders), root) for root, folders in roots.items()]
    place = (project.release, project.profile, project.own_release)  # and not where the folder lies
    versions = [metadata.version(name) for name in WRITING_PACKAGES]
    # A checkout may be edited, and lie elsewhere.
    checkouts = [package_version(project.of(release)) for release in project.releases]
    made_from = (place, address, package_versions(), installed(), versions, checkouts, digests)
    return hashlib.sha256(repr(made_from).encode()).hexdigest()


def _inputs(root: Path, folders: Sequence[str]) -> list[Path]:
    files = [root / name for name in OTHER_INPUTS]
    files += (path for folder in folders for path in (root / folder).rglob("*") if "__pycache__" not in path.parts)
    # Larger ones are refused by their readers.
    return [path for path in files if path.is_file() and path.stat().st_size <= BYTE_LIMIT]
