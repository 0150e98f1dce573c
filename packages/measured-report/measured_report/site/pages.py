"""The pages of a site, its figures, and the data beside them."""

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
from measured_report.files.config import Page, Report
from measured_report.files.groups import grouped
from measured_report.findings.chapters import Chapter
from measured_report.findings.editions import Edition
from measured_report.findings.replicas import replica_files
from measured_report.pages.prose import LAYOUT, Templates, stylesheet
from measured_report.pages.wording import texts_of
from measured_report.parts.macros import macros
from measured_report.parts.prose import Prose
from measured_report.parts.section import Figure
from measured_report.records.identity import sections
from measured_report.records.record import traces_of
from measured_report.records.replicas import FOLDER
from measured_report.site.series import PAGE as SERIES
from measured_report.site.series import series_page
from measured_report.values.quantities import VALUES_FILE, local
from measured_report.values.results import MEANS

FORMULA = (
    *"=+-@\t\r\n",
    *"＝＋－＠",
)  # begins a formula in a spreadsheet, as OWASP has it
POINTERS = re.compile(' data-src="([^"]+)"')
IDS = re.compile(r' id="([^"]+)"')
ICON = "favicon.svg"  # a report's own, in its ``assets/``, which need not be there
LOGO = "static/logo.svg"
AUTHOR = re.compile(
    r"""
    ^\ +(?:-\ )?name:\ *(.+)$
    |^\ +-\ family-names:\ *(.+)\n\ +given-names:\ *(.+)$
    """,
    re.MULTILINE | re.VERBOSE,
)


def citation(report: Report) -> dict[str, Any]:
    """Read how the report is cited, ``CITATION.cff``, with names as people write them."""
    text = (report.root / "CITATION.cff").read_text(encoding="utf-8")
    fields = dict(re.findall(r"(?m)^(title|license): *(.+)$", text))
    authors = [
        name or f"{first_name} {last_name}"
        for name, last_name, first_name in AUTHOR.findall(text)
    ]
    return {
        "license": "",
        **{name: field.strip("\"' ") for name, field in fields.items()},
        "authors": [name.strip("\"' ") for name in authors],
    }


@dataclass(frozen=True)
class Content:
    """Collect what one page of an edition shows, its figures not yet in the words."""

    page: Page
    texts: list[Prose]  # the first has the title of the page
    chapters: list[Chapter]

    @property
    def parts(self) -> list[Prose]:
        said = [chapter.prose for chapter in self.chapters if chapter.prose]
        return [*self.texts, *said]

    @property
    def figures(self) -> list[Figure]:
        return [figure for prose in self.parts for figure in prose.figures]

    @property
    def marks(self) -> list[str]:
        """List the links and citations of its words, each once."""
        return list(dict.fromkeys(mark for prose in self.parts for mark in prose.marks))

    @property
    def ids(self) -> set[str]:
        """Collect the ids on it, but for that of its first part, which is the page."""
        inner = {name for prose in self.parts for name in IDS.findall(prose.body)}
        figures = {figure.anchor for figure in self.figures}
        return inner | figures | {prose.anchor for prose in self.parts[1:]}


def contents_of(
    editions: Mapping[str, Edition], release: str, templates: Templates
) -> list[Content]:
    """Put the pages of a release into words."""
    edition = editions[release]
    releases = {other: side.uncompared for other, side in editions.items()}
    names = {"false_alarms": rate_values(edition)}
    return [
        Content(page, texts_of(edition, page, releases, templates, names), chapters)
        for page, chapters in edition.pages.items()
    ]


@dataclass(frozen=True)
class Site:
    """Write a site: the pages of ``shown`` are the first; ``editions`` are by release, oldest first."""

    folder: Path
    shown: str
    editions: Mapping[str, Edition]
    templates: Templates
    address: str  # address that it will have; empty where that is not known

    @property
    def own(self) -> str:
        """Return the folder of the data of the edition that is shown first."""
        return self.editions[self.shown].project.results.name

    def write(self) -> None:
        """Write data and pages of all releases, and what is there once."""
        report = self.editions[self.shown].report
        contents = {
            release: contents_of(self.editions, release, self.templates)
            for release in self.editions
        }
        releases = {name: edition.chapters for name, edition in self.editions.items()}
        if history := series_page(releases, self.templates):
            contents[self.shown].append(Content(SERIES, [history], []))
        license_file = report.root / "LICENSE"
        if license_file.is_file():
            self._write("license.txt", license_file)
        self._write(".gitkeep", "")
        cited = citation(report)
        shared = {
            "address": self.address,
            "editions": self.editions,
            "contents": contents,
            **cited,
        }
        layouts = {"404.html": "404.html.j2", "data/README.txt": "data.txt.j2"}
        if self.address:  # a feed has whole addresses
            layouts["feed.xml"] = "feed.xml.j2"
        for name, template in layouts.items():
            self._write(name, self.templates.layout(template, shared))
        about = {
            "citation": cited,
            "editions": self.editions.values(),
            "folder": self.editions[self.shown].project.results.name,
            "origins": json.dumps(self._origins(), ensure_ascii=False),
            "site_address": self.address,
        }
        for release, edition in self.editions.items():
            self._write_pages(edition, contents[release], about)
            self._write_files(edition)
        printed = self._printed()
        for edition in self.editions.values():
            self._write_values(edition, printed)

    def _origins(self) -> dict[str, str]:
        """Say of each record where and when it was measured."""
        origins = {}
        for edition in self.editions.values():
            for chapter in edition.chapters.values():
                record = chapter.results.record
                name = edition.report.settings.name_of(record.origin.release)
                origin = (name, record.machine_text, record.time_text)
                origins[chapter.results.source] = ", ".join(origin)
        return origins

    def _printed(self) -> set[str]:
        """Collect the pointers of all pages and drawings, as other releases have them."""
        folder = f"{self.editions[self.shown].project.results.name}/"
        pointers: set[str] = set()
        for path in (*self.folder.rglob("*.html"), *self.folder.rglob("*.svg")):
            for sources in POINTERS.findall(path.read_text(encoding="utf-8")):
                pointers.update(sources.split())
        return {
            folder + pointer if pointer.startswith(VALUES_FILE) else pointer
            for pointer in pointers
        }

    def _write_pages(
        self, edition: Edition, contents: Sequence[Content], about: Mapping[str, Any]
    ) -> None:
        root = edition.project.root
        icon = root / "assets" / ICON
        names = {
            **about,
            "edition": edition,
            "contents": contents,
            "measurable": sections(root),
            "root": edition.root,
            "address": self.address and self.address + edition.folder,
            "icon": ICON if icon.is_file() else "",
            "logo": LOGO if (root / LOGO).is_file() else "",
        }
        pages = dict(edition.plugins.pages(self.templates))
        for content in contents:
            cited = [mark for mark in content.marks if not mark.startswith("#")]
            shown = {
                **self._figures(content, edition),
                **_addresses(content, contents, edition),
                **{mark: macros().cited(at) for at, mark in enumerate(cited, 1)},
            }
            references = self.templates.references
            on_page = {
                "content": content,
                "shown": shown,
                "references": [references[mark.split(" ")[1]] for mark in cited],
            }
            html = self.templates.layout("base.html.j2", {**names, **on_page})
            pages[content.page.file] = html
        for file, html in pages.items():
            self._write(edition.folder + file, local(html, self.own))

    def _figures(self, content: Content, edition: Edition) -> dict[str, Markup]:
        """Show the figures of a page: the first is a part of it, the others are files."""
        shown: dict[str, Markup] = {}
        has_drawing = False
        for figure in content.figures:
            address = f"figures/{figure.anchor}" if has_drawing else ""
            if address:
                for end, picture in zip(("", "-narrow"), figure.pictures, strict=False):
                    svg = local(macros().drawing_file(picture), self.own)
                    self._write(f"{edition.folder}{address}{end}.svg", svg)
            shown[figure.anchor] = figure.html(address, edition.root)
            has_drawing |= bool(figure.pictures)
        return shown

    def _write_files(self, edition: Edition) -> None:
        """Write what lies beside the pages of an edition: styles, downloads and data."""
        root, project = edition.project.root, edition.project
        folder = edition.folder
        self._write(f"{folder}style.css", stylesheet(root))
        beside = {"page.js": LAYOUT / "page.js", ICON: root / "assets" / ICON}
        for path in (root / "static").rglob("*"):
            beside[path.relative_to(root).as_posix()] = path
        for name, path in beside.items():
            if path.is_file():
                self._write(folder + name, path)
        data = f"data/{project.results.name}/"
        files = [*edition.plugins.data]
        for chapter in edition.chapters.values():
            record, path = chapter.results.record, chapter.results.path
            self._write(f"{data}{path.stem}.csv", rows_csv(record.rows))
            files += [path, *traces_of(path, record)]
            for download in chapter.section.downloads:
                self._write(f"{folder}download/{download.name}", download.text)
        for path in files:
            self._write(data + path.name, path)
        for path in replica_files(project):
            if path.stem in edition.measurements.names:
                self._write(f"{data}{FOLDER}/{path.name}", path)
        for name, file in edition.plugins.files.items():
            self._write(name, file)

    def _write_values(self, edition: Edition, printed: set[str]) -> None:
        """Write derived values; of means of measurements those that are used somewhere."""
        chapters = edition.chapters
        derived = {name: dict(each.results.derived) for name, each in chapters.items()}
        used = printed.union(
            *(value.sources for values in derived.values() for value in values.values())
        )
        means = grouped(
            pointer.rpartition("/")[::2] for pointer in used if f"/{MEANS}." in pointer
        )
        for name, chapter in chapters.items():
            names = means.get(chapter.results.values_file, ())
            derived[name] |= chapter.results.means(names)
        if rates := rate_values(edition):  # how often an alarm is false
            derived[FOLDER] = dict(rates)
        entries = {
            name: {label: value.entry for label, value in values.items()}
            for name, values in derived.items()
        }
        text = json.dumps(
            entries, ensure_ascii=False, allow_nan=False, separators=(",", ":")
        )
        file = f"data/{edition.project.results.name}/{VALUES_FILE}"
        self._write(local(file, self.own), local(f"{text}\n", self.own))

    def _write(self, name: str, content: str | bytes | Path) -> None:
        if isinstance(content, Path):
            content = content.read_bytes()
        write_file(self.folder / name, content)


def rows_csv(rows: Sequence[Mapping[str, Any]]) -> str:
    """Write rows as a table; what a row lacks is empty, and text like a formula is quoted."""
    text = io.StringIO()
    columns = dict.fromkeys(chain.from_iterable(rows))
    table = csv.DictWriter(text, columns, lineterminator="\n")
    table.writeheader()
    for row in rows:
        quoted = {
            name: f"'{cell}"
            for name, cell in row.items()
            if isinstance(cell, str) and cell.startswith(FORMULA)
        }
        table.writerow({**row, **quoted})
    return text.getvalue()


def _addresses(
    content: Content, contents: Sequence[Content], edition: Edition
) -> dict[str, str]:
    """Return where a page's links to ids lead: to the page with the id.

    If that was left out they lead to the front page, which says so.
    """
    files = {
        anchor: target.page.file
        for target in reversed(contents)
        for anchor in target.ids
    }
    front = edition.report.settings.front.file if edition.left_out else ""
    addresses = {}
    for link in content.marks:
        if link.startswith("#"):
            if not (file := files.get(link[1:])):
                addresses[link] = front or link
            else:
                addresses[link] = link if file == content.page.file else file + link
    return addresses
