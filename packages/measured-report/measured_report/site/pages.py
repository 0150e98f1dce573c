"""The pages of a site: what is on each, its figures drawn, and the data beside them."""

import csv
import io
import json
import re
import uuid
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import timezone
from functools import cached_property
from itertools import chain
from operator import itemgetter
from typing import Any

from markupsafe import Markup

from measured_report.changes.flips import flips_between
from measured_report.changes.rate import rate_of
from measured_report.editions.replicas import replica_files
from measured_report.files.config import config
from measured_report.files.root import ROOT
from measured_report.files.staging import Draft
from measured_report.pages.cache import DerivedCache
from measured_report.pages.editions import Chapter, Edition
from measured_report.pages.plugins import plugins
from measured_report.pages.prose import LAYOUT, Prose, Templates, stylesheet
from measured_report.pages.sections import FRONT, Page
from measured_report.parts.macros import Picture, macros
from measured_report.parts.section import Pictures, draw
from measured_report.records.record import traces_of
from measured_report.records.replicas import FOLDER
from measured_report.values.noise import NOISE
from measured_report.values.quantities import VALUES_FILE, local

FORMULA = (*"=+-@\t\r\n", *"＝＋－＠")  # as OWASP has it
CARD = "card.png"  # the picture for links to the site
ID = re.compile(r' id="([^"]+)"')
ICON = "favicon.svg"  # a report's own, in its ``assets/``, which need not be there
FIELD = re.compile(r"^(title|license): *(.+)$", re.MULTILINE)
AUTHOR = re.compile(r"^ +(?:- )?name: *(.+)$|^ +- family-names: *(.+)\n +given-names: *(.+)$", re.MULTILINE)


@dataclass(frozen=True)
class Citation:
    """Say how the report is cited, as ``CITATION.cff`` has it."""

    title: str
    license: str
    authors: tuple[str, ...]
    """Names as people write them."""

    @property
    def names(self) -> str:
        return " and ".join(filter(None, [", ".join(self.authors[:-1]), *self.authors[-1:]]))


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
    """Set for the other one itself."""

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

    draft: Draft
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
        links = {release: _links(self.editions, places, release) for release in places}
        contents = {release: _contents(self.editions[release], self.templates, links[release]) for release in places}
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
            names = {
                "contents": contents[release],
                "links": links[release],
                "origins": json.dumps(origins, ensure_ascii=False),
            }
            own = {anchor: pair for (each, anchor), pair in pictures.items() if each == release}
            self._write_pages(places[release], edition, own, names)

    def _write_pages(
        self, place: str, edition: Edition, pictures: Mapping[str, Pictures], names: Mapping[str, Any]
    ) -> None:
        icon, chapters = edition.project.root / "assets" / ICON, edition.chapters.values()
        known = {
            "edition": edition,
            "site_address": self.address,
            "address": self.address and f"{self.address}{place}",
            "root": edition.root,
            "folder": self.editions[self.shown].project.results.name,
            "card": CARD if CARD in self.draft.digests else "",
            "icon": ICON if icon.is_file() else "",
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
            self.draft.write(f"{place}{file}", local(html, self.shown))
        self.draft.write(f"{place}style.css", stylesheet())
        for path in (LAYOUT / "page.js", *([icon] if icon.is_file() else [])):
            self.draft.copy(f"{place}{path.name}", path)
        for download in chain.from_iterable(chapter.section.downloads for chapter in chapters):
            self.draft.write(f"{place}download/{download.name}", download.text)

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
                    self.draft.write(
                        f"{place}{address}{end}.svg",
                        local(picture.file if isinstance(picture, Picture) else picture, self.shown),
                    )
            else:
                found[figure.anchor] = figure.html(drawn, root=root)
                has_drawing = has_drawing or bool(drawn and all(drawn))
        return found

    def _write_once(self) -> None:
        """Write what the site has once, at its root: the feed, the picture for links, and what its data are."""
        entries = sorted(_entries(self.editions, self.places), key=itemgetter("updated"), reverse=True)
        names = {"address": self.address, "citation": self.citation, "id": _id(""), "entries": entries}
        for file in ("404.html", "feed.xml"):
            self.draft.write(file, self.templates.layout(f"{file}.j2", names))
        if (ROOT / "LICENSE").is_file():
            self.draft.copy("license.txt", ROOT / "LICENSE")
        if card := plugins().card(self.editions, self.cache):
            self.draft.write(CARD, card)
        self.draft.write("data/README.txt", self.templates.layout("data.txt.j2", {"editions": self.editions}))
        self.draft.write(".gitkeep", "")

    def _write_data(self, edition: Edition) -> None:
        """Write all that pages name of a release: what was measured, as it is kept and as tables, and its values."""
        folder = f"data/{edition.project.results.name}/"
        for chapter in edition.chapters.values():
            path = chapter.results.path
            for file in (path, *traces_of(path, chapter.results.record)):
                self.draft.copy(f"{folder}{file.name}", file)
            self.draft.write(f"{folder}{path.stem}.csv", rows_csv(chapter.results.record.rows))
        for file in replica_files(edition.project):
            self.draft.copy(f"{folder}{FOLDER}/{file.name}", file)
        for file in edition.plugins.data:
            self.draft.copy(f"{folder}{file.name}", file)
        for name, file in edition.plugins.files.items():
            self.draft.copy(name, file)
        values = edition.values_text(rate_of(edition).values(edition.project))
        self.draft.write(local(f"{folder}{VALUES_FILE}", self.shown), local(values, self.shown))


def _entries(editions: Mapping[str, Edition], places: Mapping[str, str]) -> Iterator[dict[str, str]]:
    """Yield the feed's entries: editions and what flips with them; an id is the same for the same news anywhere."""
    before: Edition | None = None
    for release, edition in editions.items():
        if not edition.chapters:
            continue
        flips = flips_between(before.chapters, edition.chapters) if before else ()
        claims = [claim for chapter in edition.chapters.values() for claim in chapter.section.claims]
        said = [flip.after.text for flip in flips] or [claim.text for claim in claims[:1]]
        times = [chapter.results.record.time for chapter in edition.chapters.values()]
        yield {
            "id": _id(release),
            "title": ": ".join([config().name_of(release), *said[: len(flips)][:1]]),
            "text": " ".join(said),
            "address": f"{places[release]}index.html",
            "updated": max(times).astimezone(timezone.utc).isoformat(timespec="seconds"),
        }
        before = edition


def _id(key: str) -> str:
    return f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, f'{config().name}/{key}')}"


def rows_csv(rows: Sequence[Mapping[str, Any]]) -> str:
    """Write rows as a table; what a row lacks is empty, and text that a spreadsheet takes for a formula is quoted."""
    text = io.StringIO()
    table = csv.DictWriter(text, dict.fromkeys(chain.from_iterable(rows)), lineterminator="\n")
    table.writeheader()
    table.writerows({column: _inert(cell) for column, cell in row.items()} for row in rows)
    return text.getvalue()


def _inert(cell: Any) -> Any:
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(FORMULA) else cell


def _links(editions: Mapping[str, Edition], places: Mapping[str, str], shown: str) -> list[Link]:
    up = "../" if places[shown] else ""
    bases = {release: f"{up}{place}" for release, place in places.items()} | {shown: ""}
    return [Link(edition, bases[release], release == shown) for release, edition in editions.items()]


def _contents(edition: Edition, templates: Templates, links: Sequence[Link]) -> list[Content]:
    names = {"releases": links, "false_alarms": rate_of(edition).values(edition.project)}
    return [Content(page, edition.texts(page, templates, names), found) for page, found in edition.pages.items()]


def contents_of(editions: Mapping[str, Edition], templates: Templates, shown: str) -> list[Content]:
    """Return the pages of one release as they are without a site."""
    return _contents(editions[shown], templates, _links(editions, dict.fromkeys(editions, ""), shown))


def undrawn(editions: Mapping[str, Edition], templates: Templates, shown: str) -> dict[tuple[str, str], Markup]:
    """Return the words of one release's pages by file and anchor of their parts; of a figure those below it."""
    words = Markup("<h2>{}</h2>{}")
    return {
        (content.page.file, part.anchor): words.format(
            part.title, part.html({figure.anchor: figure.undrawn for figure in part.figures})
        )
        for content in contents_of(editions, templates, shown)
        for part in content.parts
    }


def _draw(contents: Mapping[str, Sequence[Content]], cache: DerivedCache) -> dict[tuple[str, str], Pictures]:
    """Draw each figure once, by release and id."""
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
    pictures |= zip(to_draw, draw(list(to_draw.values())), strict=True)
    cache.keep(pictures)
    return pictures


def _addresses(content: Content, contents: Sequence[Content], edition: Edition) -> dict[str, str]:
    """Find where the links of a page to ids lead: to the page that has the id.

    Where the edition lacks sections, a link to what is on no page leads to the front page, which names them.
    """
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
