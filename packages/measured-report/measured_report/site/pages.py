"""The pages of a site: what is on each, its figures drawn, and the data beside them."""

import csv
import io
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

from markupsafe import Markup

from measured_report.changes.alarm import rate_of, rate_values
from measured_report.files.config import Page, config
from measured_report.files.processes import forked
from measured_report.files.root import ROOT
from measured_report.pages.cache import DerivedCache
from measured_report.pages.editions import Chapter, Edition
from measured_report.pages.prose import LAYOUT, Prose, Templates, stylesheet
from measured_report.pages.replicas import replica_files
from measured_report.pages.sections import FRONT
from measured_report.parts.macros import Picture, macros
from measured_report.parts.section import Pictures
from measured_report.records.identity import sections
from measured_report.records.record import traces_of
from measured_report.records.replicas import FOLDER
from measured_report.values.noise import NOISE
from measured_report.values.quantities import VALUES_FILE, local

FORMULA = (*"=+-@\t\r\n", *"＝＋－＠")  # as OWASP has it
ID = re.compile(r' id="([^"]+)"')
ICON = "favicon.svg"  # a report's own, in its ``assets/``, which need not be there
LOGO = "static/logo.svg"
FIELD = re.compile(r"^(title|license): *(.+)$", re.MULTILINE)
AUTHOR = re.compile(r"^ +(?:- )?name: *(.+)$|^ +- family-names: *(.+)\n +given-names: *(.+)$", re.MULTILINE)


class Citation(NamedTuple):
    """Say how the report is cited, as ``CITATION.cff`` has it, with names as people write them."""

    title: str
    license: str
    authors: tuple[str, ...]


def citation() -> Citation:
    """Read ``CITATION.cff``."""
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    said = {name: value.strip("\"' ") for name, value in FIELD.findall(text)}
    people = ((name or f"{given} {family}") for name, family, given in AUTHOR.findall(text))
    return Citation(said["title"], said.get("license", ""), tuple(name.strip("\"' ") for name in people))


@dataclass(frozen=True)
class Content:
    """Collect what is on a page of one release, its figures not yet drawn."""

    page: Page
    texts: Sequence[Prose]
    chapters: Sequence[Chapter]

    @property
    def parts(self) -> list[Prose]:
        return [*self.texts, *(chapter.prose for chapter in self.chapters if chapter.prose)]

    @property
    def ids(self) -> set[str]:
        """Collect the ids of its parts, but for the first, which is the page, and of what is in them."""
        inner = {name for part in self.parts for name in (*ID.findall(part.body), *(f.anchor for f in part.figures))}
        return inner | {part.anchor for part in self.parts[1:]}


@dataclass(frozen=True)
class Link:
    """Lead to a release from the pages of another one, from where its own lie at ``base``."""

    edition: Edition
    base: str
    is_shown: bool

    @property
    def release(self) -> str:
        return self.edition.project.release

    @property
    def sections(self) -> dict[str, Mapping[str, Any]]:
        """Return what other releases can name of its sections."""
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
    """Write a site: the pages of ``shown`` are the first; ``editions`` are by release, oldest first."""

    folder: Path
    shown: str
    editions: Mapping[str, Edition]
    templates: Templates
    address: str
    """Address that it will have; empty where that is not known."""
    citation: Citation
    cache: DerivedCache

    @cached_property
    def places(self) -> dict[str, str]:
        """Tell where the pages of each release lie below the site."""
        folders = {release: f"{edition.project.results.name}/" for release, edition in self.editions.items()}
        return {**folders, self.shown: ""}

    def write(self) -> None:
        """Draw all figures, and write data and pages of all releases, and what is there once."""
        places = self.places
        links = {release: links_of(self.editions, places, release) for release in places}
        contents = {release: contents_of(self.editions[release], self.templates, links[release]) for release in places}
        pictures = _draw(contents, self.cache)
        for edition in self.editions.values():
            self._write_data(edition)
        self._write_once()
        origins = {}
        for chapter in chain.from_iterable(edition.chapters.values() for edition in self.editions.values()):
            record = chapter.results.record
            said = (config().name_of(record.origin.release), record.machine_text, record.time_text)
            origins[chapter.results.source] = ", ".join(said)
        for release, edition in self.editions.items():
            told = json.dumps(origins, ensure_ascii=False)
            names = {"contents": contents[release], "links": links[release], "origins": told}
            own = {anchor: pair for (each, anchor), pair in pictures.items() if each == release}
            self._write_pages(places[release], edition, own, names)

    def _write_pages(
        self, place: str, edition: Edition, pictures: Mapping[str, Pictures], names: Mapping[str, Any]
    ) -> None:
        icon, chapters = edition.project.root / "assets" / ICON, edition.chapters.values()
        known = {
            "edition": edition,
            "measurable": sections(edition.project.root),
            "site_address": self.address,
            "address": self.address and f"{self.address}{place}",
            "root": edition.root,
            "folder": self.editions[self.shown].project.results.name,
            "icon": ICON if icon.is_file() else "",
            "logo": LOGO if (edition.project.root / LOGO).is_file() else "",
            "citation": self.citation,
            "sources": config().repository,
            "measured_on": max((each.results.record.measured["date"][:10] for each in chapters), default=""),
            "floors": json.dumps(_floors(edition)),
            **names,
        }
        pages = dict(edition.plugins.pages(self.templates))
        for content in names["contents"]:
            figures = self._drawn(content, place, pictures, edition.root)
            cited = dict.fromkeys(mark for part in content.parts for mark in part.marks if not mark.startswith("#"))
            marks = {mark: macros().cited(number) for number, mark in enumerate(cited, 1)}
            own = {
                "content": content,
                "shown": {**figures, **marks, **_addresses(content, names["contents"], edition)},
                "references": [self.templates.references[mark.partition(" ")[2]] for mark in cited],
            }
            pages[content.page.file] = self.templates.layout("base.html.j2", {**known, **own})
        for file, html in pages.items():
            self._write(f"{place}{file}", local(html, self.shown))
        self._write(f"{place}style.css", stylesheet(edition.project.root))
        for path in (LAYOUT / "page.js", *([icon] if icon.is_file() else [])):
            self._write(f"{place}{path.name}", path)
        for path in (path for path in (edition.project.root / "static").rglob("*") if path.is_file()):
            self._write(f"{place}{path.relative_to(edition.project.root).as_posix()}", path)
        for download in chain.from_iterable(chapter.section.downloads for chapter in chapters):
            self._write(f"{place}download/{download.name}", download.text)

    def _drawn(self, content: Content, place: str, pictures: Mapping[str, Pictures], root: str) -> dict[str, Markup]:
        """Show the figures of a page by their ids: the first is a part of it, and those behind it are files."""
        found: dict[str, Markup] = {}
        has_drawing = False
        for figure in (figure for prose in content.parts for figure in prose.figures):
            drawn = pictures.get(figure.anchor)
            if has_drawing and drawn and all(drawn):
                address = f"figures/{figure.anchor}"
                found[figure.anchor] = figure.html(drawn, address, root)
                for end, picture in zip(("", "-narrow"), drawn, strict=True):
                    self._write(
                        f"{place}{address}{end}.svg",
                        local(macros().drawing_file(picture) if isinstance(picture, Picture) else picture, self.shown),
                    )
            else:
                found[figure.anchor] = figure.html(drawn, root=root)
                has_drawing = has_drawing or bool(drawn and all(drawn))
        return found

    def _write(self, name: str, content: str | bytes | Path) -> None:
        data = content.read_bytes() if isinstance(content, Path) else content
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_bytes(data.encode() if isinstance(data, str) else data)

    def _write_once(self) -> None:
        self._write("404.html", self.templates.layout("404.html.j2", {"address": self.address}))
        if (ROOT / "LICENSE").is_file():
            self._write("license.txt", ROOT / "LICENSE")
        self._write("data/README.txt", self.templates.layout("data.txt.j2", {"editions": self.editions}))
        self._write(".gitkeep", "")

    def _write_data(self, edition: Edition) -> None:
        folder = f"data/{edition.project.results.name}/"
        for chapter in edition.chapters.values():
            path = chapter.results.path
            for file in (path, *traces_of(path, chapter.results.record)):
                self._write(f"{folder}{file.name}", file)
            self._write(f"{folder}{path.stem}.csv", rows_csv(chapter.results.record.rows))
        for file in replica_files(edition.project):
            self._write(f"{folder}{FOLDER}/{file.name}", file)
        for file in edition.plugins.data:
            self._write(f"{folder}{file.name}", file)
        for name, file in edition.plugins.files.items():
            self._write(name, file)
        values = edition.values_text(rate_values(rate_of(edition), edition.project))
        self._write(local(f"{folder}{VALUES_FILE}", self.shown), local(values, self.shown))


def rows_csv(rows: Sequence[Mapping[str, Any]]) -> str:
    """Write rows as a table; what a row lacks is empty, and text that a spreadsheet takes for a formula is quoted."""
    text = io.StringIO()
    table = csv.DictWriter(text, dict.fromkeys(chain.from_iterable(rows)), lineterminator="\n")
    table.writeheader()
    table.writerows({column: _inert(cell) for column, cell in row.items()} for row in rows)
    return text.getvalue()


def _inert(cell: Any) -> Any:
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(FORMULA) else cell


def links_of(editions: Mapping[str, Edition], places: Mapping[str, str], shown: str) -> list[Link]:
    """Return what leads from the pages of one release to those of all, which lie at ``places`` below the site."""
    up = "../" if places[shown] else ""
    bases = {release: f"{up}{place}" for release, place in places.items()} | {shown: ""}
    return [Link(edition, bases[release], release == shown) for release, edition in editions.items()]


def contents_of(edition: Edition, templates: Templates, links: Sequence[Link]) -> list[Content]:
    """Put the pages of a release into words; nothing is drawn yet."""
    names = {"releases": links, "false_alarms": rate_values(rate_of(edition), edition.project)}
    return [Content(page, edition.texts(page, templates, names), found) for page, found in edition.pages.items()]


def _draw(contents: Mapping[str, Sequence[Content]], cache: DerivedCache) -> dict[tuple[str, str], Pictures]:
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
    to_draw = [place for place, figure in wanted.items() if figure.is_there and place not in pictures]
    pictures |= zip(to_draw, forked(lambda number: wanted[to_draw[number]].drawn(), len(to_draw)), strict=True)
    cache.keep(pictures)
    return pictures


def _addresses(content: Content, contents: Sequence[Content], edition: Edition) -> dict[str, str]:
    """Find where a page's links to ids lead: to the page that has it, or to the front, which names what is left out."""
    files = {anchor: each.page.file for each in reversed(contents) for anchor in each.ids}
    lost = FRONT.file if edition.left_out else ""
    found = {}
    for link in (mark for part in content.parts for mark in part.marks if mark.startswith("#")):
        file = files.get(link[1:], "")
        elsewhere = f"{file}{link}" if file else lost or link
        found[link] = link if file == content.page.file else elsewhere
    return found


def _floors(edition: Edition) -> dict[str, tuple[float, float]]:
    """Return by column how far apart runs of one case come out, and the largest value that this was seen at."""
    floors = edition.chapters[NOISE].results.floors if NOISE in edition.chapters else {}
    return {column: (floor.spread, floor.magnitude) for column, floor in floors.items()}
