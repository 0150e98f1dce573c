"""The pages of a site: what is on each, its figures drawn, and the data beside them."""

import csv
import io
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Any

from markupsafe import Markup

from measured_report.changes.alarm import rate_values
from measured_report.files.atomic import write_file
from measured_report.files.config import Page, config, report
from measured_report.files.groups import grouped
from measured_report.files.processes import forked
from measured_report.findings.cache import DerivedCache
from measured_report.findings.replicas import replica_files
from measured_report.pages.editions import WordedChapter, WordedEdition
from measured_report.pages.prose import LAYOUT, Prose, Templates, stylesheet
from measured_report.parts.macros import Picture, macros
from measured_report.parts.section import Figure, Pictures
from measured_report.records.identity import sections
from measured_report.records.record import traces_of
from measured_report.records.replicas import FOLDER
from measured_report.site.series import PAGE as SERIES
from measured_report.site.series import series_page
from measured_report.values.quantities import VALUES_FILE, local
from measured_report.values.results import MEANS

FORMULA = (*"=+-@\t\r\n", *"＝＋－＠")  # as OWASP has it
POINTERS = re.compile(' data-src="([^"]+)"')
ICON = "favicon.svg"  # a report's own, in its ``assets/``, which need not be there
LOGO = "static/logo.svg"
DrawnFigures = Mapping[tuple[str, str], Pictures]  # by release and id
AUTHOR = re.compile(r"^ +(?:- )?name: *(.+)$|^ +- family-names: *(.+)\n +given-names: *(.+)$", re.MULTILINE)


def citation() -> dict[str, Any]:
    """Read how the report is cited, ``CITATION.cff``, with names as people write them."""
    text = (report().root / "CITATION.cff").read_text(encoding="utf-8")
    fields = {name: value.strip("\"' ") for name, value in re.findall(r"(?m)^(title|license): *(.+)$", text)}
    people = ((name or f"{first_name} {last_name}") for name, last_name, first_name in AUTHOR.findall(text))
    return {"license": "", **fields, "authors": [name.strip("\"' ") for name in people]}


@dataclass(frozen=True)
class Content:
    """Collect what is on a page of one release, its figures not yet drawn."""

    page: Page
    texts: Sequence[Prose]
    chapters: Sequence[WordedChapter]

    @property
    def parts(self) -> list[Prose]:
        return [*self.texts, *(chapter.prose for chapter in self.chapters)]

    @property
    def figures(self) -> list[Figure]:
        return [figure for prose in self.parts for figure in prose.figures]

    @property
    def ids(self) -> set[str]:
        """Collect the ids of its parts, but for the first, which is the page, and of what is in them."""
        inner = {name for prose in self.parts for name in re.findall(r' id="([^"]+)"', prose.body)}
        return inner | {figure.anchor for figure in self.figures} | {prose.anchor for prose in self.parts[1:]}


@dataclass(frozen=True)
class Site:
    """Write a site: the pages of ``shown`` are the first; ``editions`` are by release, oldest first."""

    folder: Path
    shown: str
    editions: Mapping[str, WordedEdition]
    templates: Templates
    address: str  # address that it will have; empty where that is not known
    cache: DerivedCache

    @property
    def own(self) -> str:
        """Return the folder of the data of the edition that is shown first."""
        return self.editions[self.shown].project.results.name

    def write(self) -> None:
        """Draw all figures, and write data and pages of all releases, and what is there once."""
        contents = {release: contents_of(self.editions, release, self.templates) for release in self.editions}
        releases = {release: edition.chapters for release, edition in self.editions.items()}
        if history := series_page(releases, self.templates):
            contents[self.shown].append(Content(SERIES, [history], []))
        pictures = _draw(contents, self.cache)
        self._write("404.html", self.templates.layout("404.html.j2", {"address": self.address}))
        if (report().root / "LICENSE").is_file():
            self._write("license.txt", report().root / "LICENSE")
        self._write("data/README.txt", self.templates.layout("data.txt.j2", {"editions": self.editions}))
        self._write(".gitkeep", "")
        origins = {}
        for results in (chapter.results for edition in self.editions.values() for chapter in edition.chapters.values()):
            release = config().name_of(results.record.origin.release)
            origins[results.source] = ", ".join((release, results.record.machine_text, results.record.time_text))
        origins_json = json.dumps(origins, ensure_ascii=False)
        for release, edition in self.editions.items():
            names = {"contents": contents[release], "editions": self.editions.values(), "origins": origins_json}
            self._write_pages(edition, pictures, names)
        if self.address:  # a feed has whole addresses
            names = {"address": self.address, "editions": self.editions, "contents": contents, **citation()}
            self._write("feed.xml", self.templates.layout("feed.xml.j2", names))
        printed = self._printed()
        for edition in self.editions.values():
            self._write_data(edition, printed)

    def _printed(self) -> set[str]:
        """Collect the pointers of all pages and drawings to values, as other releases have them."""
        texts = (path.read_text(encoding="utf-8") for end in ("html", "svg") for path in self.folder.rglob(f"*.{end}"))
        pointers = {pointer for text in texts for match in POINTERS.findall(text) for pointer in match.split()}
        folder = f"{self.editions[self.shown].project.results.name}/"
        return {folder + pointer if pointer.startswith(VALUES_FILE) else pointer for pointer in pointers}

    def _write_pages(self, edition: WordedEdition, pictures: DrawnFigures, names: Mapping[str, Any]) -> None:
        root, folder, chapters = edition.project.root, edition.folder, edition.chapters.values()
        icon = root / "assets" / ICON
        about = {"edition": edition, "measurable": sections(root), "citation": citation()}
        addresses = {"site_address": self.address, "address": self.address and f"{self.address}{folder}"}
        folders = {"root": edition.root, "folder": self.editions[self.shown].project.results.name}
        images = {"icon": ICON if icon.is_file() else "", "logo": LOGO if (root / LOGO).is_file() else ""}
        shared = {**about, **addresses, **folders, **images, **names}
        pages = dict(edition.plugins.pages(self.templates))
        for content in names["contents"]:
            figures = self._drawn(content, edition, pictures)
            cited = dict.fromkeys(mark for prose in content.parts for mark in prose.marks if not mark.startswith("#"))
            marks = {mark: macros().cited(number) for number, mark in enumerate(cited, 1)}
            shown = {**figures, **marks, **_addresses(content, names["contents"], edition)}
            references = [self.templates.references[mark.partition(" ")[2]] for mark in cited]
            content_names = {"content": content, "shown": shown, "references": references}
            pages[content.page.file] = self.templates.layout("base.html.j2", {**shared, **content_names})
        for file, html in pages.items():
            self._write(f"{folder}{file}", local(html, self.own))
        self._write(f"{folder}style.css", stylesheet(root))
        static = {path.relative_to(root).as_posix(): path for path in (root / "static").rglob("*")}
        for name, path in {"page.js": LAYOUT / "page.js", ICON: icon, **static}.items():
            if path.is_file():
                self._write(f"{folder}{name}", path)
        for download in chain.from_iterable(chapter.section.downloads for chapter in chapters):
            self._write(f"{folder}download/{download.name}", download.text)

    def _drawn(self, content: Content, edition: WordedEdition, pictures: DrawnFigures) -> dict[str, Markup]:
        """Show the figures of a page by their ids: the first is a part of it, and those behind it are files."""
        drawings: dict[str, Markup] = {}
        has_drawing = False
        for figure in content.figures:
            drawn = pictures.get((edition.project.release, figure.anchor))
            is_whole = bool(drawn and all(drawn))
            address = f"figures/{figure.anchor}" if has_drawing and is_whole else ""
            drawings[figure.anchor] = figure.html(drawn, address, edition.root)
            for end, picture in zip(("", "-narrow"), drawn or (), strict=True) if address else ():
                svg = macros().drawing_file(picture) if isinstance(picture, Picture) else picture
                self._write(f"{edition.folder}{address}{end}.svg", local(svg, self.own))
            has_drawing |= is_whole
        return drawings

    def _write(self, name: str, content: str | bytes | Path) -> None:
        data = content.read_bytes() if isinstance(content, Path) else content
        write_file(self.folder / name, data)

    def _write_data(self, edition: WordedEdition, printed: set[str]) -> None:
        folder = f"data/{edition.project.results.name}/"
        files: dict[str, Path | bytes] = {f"{folder}{source.name}": source for source in edition.plugins.data}
        files |= edition.plugins.files
        replicas = filter(lambda source: source.stem in edition.measurements.names, replica_files(edition.project))
        files |= {f"{folder}{FOLDER}/{source.name}": source for source in replicas}
        for chapter in edition.chapters.values():
            path = chapter.results.path
            self._write(f"{folder}{path.stem}.csv", rows_csv(chapter.results.record.rows))
            files |= {f"{folder}{source.name}": source for source in (path, *traces_of(path, chapter.results.record))}
        for name, source in files.items():
            self._write(name, source)
        # Of means of measurements it has those that are printed, or that other values are made of.
        derived = {name: dict(chapter.results.derived) for name, chapter in edition.chapters.items()}
        wanted = printed.union(*(value.sources for values in derived.values() for value in values.values()))
        means = grouped(pointer.rpartition("/")[::2] for pointer in wanted if f"/{MEANS}." in pointer)
        for name, chapter in edition.chapters.items():
            derived[name] |= chapter.results.means(means.get(chapter.results.values_file, ()))
        if rates := rate_values(edition):  # how often it rings for nothing
            derived[FOLDER] = dict(rates)
        entries = {name: {label: value.entry for label, value in values.items()} for name, values in derived.items()}
        text = json.dumps(entries, ensure_ascii=False, allow_nan=False, separators=(",", ":")) + "\n"
        self._write(local(f"{folder}{VALUES_FILE}", self.own), local(text, self.own))


def rows_csv(rows: Sequence[Mapping[str, Any]]) -> str:
    """Write rows as a table; what a row lacks is empty, and text that a spreadsheet takes for a formula is quoted."""
    text = io.StringIO()
    table = csv.DictWriter(text, dict.fromkeys(chain.from_iterable(rows)), lineterminator="\n")
    table.writeheader()
    for row in rows:
        formulas = (name for name, cell in row.items() if isinstance(cell, str) and cell.startswith(FORMULA))
        table.writerow({**row, **{name: f"'{row[name]}" for name in formulas}})
    return text.getvalue()


def contents_of(editions: Mapping[str, WordedEdition], release: str, templates: Templates) -> list[Content]:
    """Put the pages of a release into words; nothing is drawn yet."""
    edition, releases = editions[release], {name: side.uncompared for name, side in editions.items()}
    names = {"false_alarms": rate_values(edition)}
    texts = {page: edition.texts(page, templates, releases, names) for page in edition.pages}
    return [Content(page, texts[page], chapters) for page, chapters in edition.pages.items()]


def _draw(contents: Mapping[str, Sequence[Content]], cache: DerivedCache) -> DrawnFigures:
    figures_of = {release: [figure for page in pages for figure in page.figures] for release, pages in contents.items()}
    placed = {(release, figure.anchor): figure for release, figures in figures_of.items() for figure in figures}
    pictures = {key: figure.pictures for key, figure in placed.items() if figure.pictures}
    # A section is kept with all of its figures, those as well that are not shown as long as something else is.
    wanted = cache.figures | placed
    to_draw = [key for key, figure in wanted.items() if figure.is_there and key not in pictures]
    pictures |= zip(to_draw, forked(lambda number: wanted[to_draw[number]].drawn(), len(to_draw)), strict=True)
    cache.keep(pictures)
    return pictures


def _addresses(content: Content, contents: Sequence[Content], edition: WordedEdition) -> dict[str, str]:
    """Find where a page's links to ids lead: to the page that has it, or to the front, which names what is left out."""
    files = {anchor: target.page.file for target in reversed(contents) for anchor in target.ids}
    lost = config().front.file if edition.left_out else ""
    addresses = {}
    for link in (mark for prose in content.parts for mark in prose.marks if mark.startswith("#")):
        file = files.get(link[1:], "")
        addresses[link] = link if file == content.page.file else f"{file}{link}" if file else lost or link
    return addresses
