"""The pages of a site: what is on each, its figures drawn, and the data beside them."""

import json
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

from markupsafe import Markup

from measured_report import ROOT
from measured_report.deriving.cache import DerivedCache
from measured_report.deriving.chapters import Chapter
from measured_report.deriving.editions import Edition
from measured_report.files.config import config
from measured_report.files.staging import Draft
from measured_report.pages.outline import FRONT, Page
from measured_report.pages.prose import LAYOUT, Prose, Templates
from measured_report.parts.drawing import draw_all
from measured_report.records.traces import traces_of
from measured_report.site.archive import rows_csv
from measured_report.values.noise import NOISE
from measured_report.values.quantities import VALUES_FILE, local
from measured_report.values.results import Results

CARD = "card.png"  # the picture for links to the site
CITATION_LINE = re.compile(r"^(?:  - )?([a-z-]+): (.+)$", re.MULTILINE)
ICON = "favicon.svg"  # a report's own, in its ``assets/``, which need not be there
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
    """One release, as the pages of another one lead to it, from where its own lie at ``base``."""

    edition: Edition
    base: str
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
class Site:
    """A site that is being written: the pages of ``shown`` are the first; ``editions`` are by release, oldest first."""

    draft: Draft
    shown: str
    editions: Mapping[str, Edition]
    templates: Templates
    address: str
    """Where it will lie; empty where that is not known."""
    cache: DerivedCache

    @cached_property
    def places(self) -> dict[str, str]:
        """Where the pages of each release lie below the site."""
        folders = {release: f"{edition.project.results.name}/" for release, edition in self.editions.items()}
        return {**folders, self.shown: ""}

    @cached_property
    def records(self) -> list[Results]:
        return [chapter.results for edition in self.editions.values() for chapter in edition.chapters.values()]

    @cached_property
    def tables(self) -> dict[str, bytes]:
        return {results.source: rows_csv(results.record.rows) for results in self.records}

    def write(self, root_files: Callable[[], None]) -> None:
        """Draw all figures, and write data, ``root_files`` and pages of all releases."""
        places = self.places
        links = {release: _links(self.editions, places, release) for release in places}
        contents = {release: _contents(self.editions[release], self.templates, links[release]) for release in places}

        def write_data() -> None:
            for release, place in places.items():
                self._write_data(f"{place}data/", release)
                self.editions[release].extras.write(self.draft, place, self.templates)
            root_files()

        drawn = _draw(contents, self.cache, write_data)
        origins = {}
        for results in self.records:
            record = results.record
            said = (config().edition(record.origin.release), record.machine_text, record.time_text)
            origins[results.source] = ", ".join(said)
        for release, place in places.items():
            names = {
                "contents": contents[release],
                "links": links[release],
                "drawn": {anchor: html for (each, anchor), html in drawn.items() if each == release},
                "origins": json.dumps(origins, ensure_ascii=False),
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
        for path in (*(LAYOUT / name for name in ("style.css", "page.js")), *([icon] if icon.is_file() else [])):
            self.draft.copy(f"{place}{path.name}", path)
        for chapter in edition.chapters.values():
            for download in chapter.section.downloads:
                self.draft.write(f"{place}download/{download.name}", download.text)

    def _write_data(self, folder: str, shown: str) -> None:
        """Write all that the pages of the release ``shown`` name: its results and values, and those of the others."""
        for release, edition in self.editions.items():
            own, name = release == shown, edition.project.results.name
            for chapter in edition.chapters.values():
                path = chapter.results.path
                for file in (path, *(traces_of(path, chapter.results.record) if own else ())):
                    self.draft.copy(f"{folder}{name}/{file.name}", file)
                self.draft.write(f"{folder}{name}/{path.stem}.csv", self.tables[chapter.results.source])
            values = edition.values_text if own else edition.uncompared_text
            self.draft.write(f"{folder}{'' if own else f'{name}/'}{VALUES_FILE}", local(values, shown))


def _links(editions: Mapping[str, Edition], places: Mapping[str, str], shown: str) -> list[Link]:
    up = "../" if places[shown] else ""
    bases = {release: f"{up}{place}" for release, place in places.items()} | {shown: ""}
    return [Link(edition, bases[release], release == shown) for release, edition in editions.items()]


def _contents(edition: Edition, templates: Templates, links: Sequence[Link]) -> list[Content]:
    names = {"releases": links}
    return [Content(page, edition.texts(page, templates, names), found) for page, found in edition.pages.items()]


def undrawn(editions: Mapping[str, Edition], templates: Templates, shown: str) -> dict[tuple[str, str], Markup]:
    """Return the words of one release's pages by file and anchor of their parts; of a figure those below it."""
    contents = _contents(editions[shown], templates, _links(editions, dict.fromkeys(editions, ""), shown))
    words = Markup("<h2>{}</h2>{}")
    return {
        (content.page.file, part.anchor): words.format(
            part.title, part.html({figure.anchor: figure.undrawn for figure in part.figures})
        )
        for content in contents
        for part in content.parts
    }


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

    The front page has the ids of all sections for old links alone.
    """
    ids = {file: set(ID.findall(html)) for file, html in pages.items()}
    ids[FRONT.file] -= set(sections)
    places = {name: file for file in pages for name in ids[file]}

    def connect(file: str, link: re.Match) -> str:
        name = link[1]
        return link[0] if name in ids[file] or name not in places else f' href="{places[name]}#{name}"'

    return {file: INNER_LINK.sub(partial(connect, file), html) for file, html in pages.items()}


def _floors(edition: Edition) -> dict[str, tuple[float, float]]:
    """By column: how far apart runs of one case come out, and the largest value that this was seen at."""
    floors = edition.chapters[NOISE].results.floors if NOISE in edition.chapters else {}
    return {column: (floor.spread, floor.magnitude) for column, floor in floors.items()}


def citation() -> dict[str, str]:
    """Read what CITATION.cff says, each key's first line."""
    return dict(reversed(CITATION_LINE.findall((ROOT / "CITATION.cff").read_text(encoding="utf-8"))))
