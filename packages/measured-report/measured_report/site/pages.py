"""Return the files of a site: its pages, figures and data."""

import csv
import gzip
import io
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from pathlib import Path
from typing import Any

from jinja2.utils import htmlsafe_json_dumps
from markupsafe import Markup

from measured_report.changes.alarm import calibration_values, rate_values
from measured_report.files.atomic import read_text
from measured_report.files.config import Page, Report
from measured_report.files.groups import grouped
from measured_report.findings.chapters import Chapter
from measured_report.findings.editions import Edition
from measured_report.findings.replicas import replica_files
from measured_report.pages.prose import LAYOUT, Templates, stylesheet
from measured_report.pages.wording import texts_of
from measured_report.parts.macros import macros
from measured_report.parts.prose import Prose
from measured_report.records.identity import sections
from measured_report.records.record import traces_of
from measured_report.records.replicas import FOLDER
from measured_report.site.compare import PAGE as COMPARE
from measured_report.site.compare import compare_page
from measured_report.site.evidence import Evidence
from measured_report.values.quantities import NOISE_FILE, VALUES_FILE, local
from measured_report.values.results import MEANS, Row

FORMULA = (*"=+-@\t\r\n", *"＝＋－＠")
"""First characters of a formula in a spreadsheet, by OWASP's page on CSV injection."""
POINTERS = re.compile(' data-src="([^"]+)"')
IDS = re.compile(r' id="([^"]+)"')
LINK = re.compile(r'(?<= href=")#([\w-]+)(?=")')
"""Matches a link to an id, which may be on another page."""
CITED = re.compile(r'(?<=<sup class="cited">)(\w+)(?=</sup>)')
"""Matches the name of a source, which each page replaces with its own number."""
File = str | bytes | Path
ICON = "favicon.svg"  # an optional file in the report's folder ``assets/``
LOGO = "static/logo.svg"
AUTHOR = re.compile(
    r"""
    ^\ +(?:-\ )?name:\ *(.+)$
    |^\ +-\ family-names:\ *(.+)\n\ +given-names:\ *(.+)$
    """,
    re.MULTILINE | re.VERBOSE,
)


def citation(report: Report) -> dict[str, Any]:
    """Return the title, license and authors in ``CITATION.cff``, first names first."""
    text = read_text(report.root / "CITATION.cff")
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
    """The texts and chapters of one page of an edition."""

    page: Page
    texts: list[Prose]  # the first has the title of the page
    chapters: list[Chapter]

    @property
    def parts(self) -> list[Prose]:
        proses = [chapter.prose for chapter in self.chapters if chapter.prose]
        return [*self.texts, *proses]

    @property
    def body(self) -> str:
        return "".join(part.body for part in self.parts)

    @property
    def cited(self) -> list[str]:
        """Return the names of all sources that the page cites, in order."""
        return list(dict.fromkeys(CITED.findall(self.body)))


def contents_of(
    editions: Mapping[str, Edition], release: str, templates: Templates
) -> list[Content]:
    """Return the contents of all pages in a release."""
    edition = editions[release]
    releases = {
        label: release_edition.uncompared for label, release_edition in editions.items()
    }
    names = {
        "false_alarms": rate_values(edition),
        "calibration": calibration_values(edition),
    }
    return [
        Content(page, texts_of(edition, page, releases, templates, names), chapters)
        for page, chapters in edition.pages.items()
    ]


def site_files(
    editions: Mapping[str, Edition], release: str, templates: Templates, address: str
) -> dict[str, File]:
    """Return the files of a site by name.

    The pages of ``release`` are at the root of the site. ``address`` is the web address
    of the site, or empty if it is not known.
    """
    first = editions[release]
    root, own = first.project.root, first.project.results.name
    contents = {name: contents_of(editions, name, templates) for name in editions}
    files: dict[str, File] = {".gitkeep": ""}
    if compared := compare_page(editions, templates):
        contents[release].append(Content(COMPARE, [compared[0]], []))
        files |= compared[1]
    cited = citation(first.report)
    layouts = {"404.html": "404.html.j2", "data/README.txt": "data.txt.j2"}
    if address:  # a feed needs absolute addresses
        layouts["feed.xml"] = "feed.xml.j2"
    shared = {"address": address, "editions": editions, "contents": contents, **cited}
    for name, template in layouts.items():
        files[name] = templates.layout(template, shared)
    about = {
        "citation": cited,
        "comparison": COMPARE.file if compared else "",
        "editions": editions.values(),
        "folder": own,
        "evidence": Evidence(editions),
        "site_address": address,
        "measurable": sections(root),
        "derived": {name for edition in editions.values() for name in edition.chapters},
        "icon": ICON if (root / "assets" / ICON).is_file() else "",
        "logo": LOGO if (root / LOGO).is_file() else "",
    }
    for name, edition in editions.items():
        pages = _pages(edition, contents[name], about, templates)
        pages |= edition.plugins.pages(templates)
        files |= {
            edition.folder + file: local(html, own) for file, html in pages.items()
        }
    pointers = {
        pointer
        for name, html in files.items()
        if name.endswith(".html")
        for sources in POINTERS.findall(str(html))
        for pointer in sources.split()
    }
    # The pointers of the first release's derived values do not contain its folder.
    printed = {
        f"{own}/{pointer}" if pointer.startswith(VALUES_FILE) else pointer
        for pointer in pointers
    }
    for edition in editions.values():
        files |= _files(edition)
        values = local(f"{_values(edition, printed)}\n", own)
        folder = f"data/{edition.project.results.name}"
        files[local(f"{folder}/{VALUES_FILE}", own)] = values
        files[f"{folder}/{NOISE_FILE}"] = _noises(edition, printed)
    if (license_file := first.report.root / "LICENSE").is_file():
        files["license.txt"] = license_file
    return files


def _pages(
    edition: Edition,
    contents: Sequence[Content],
    about: Mapping[str, Any],
    templates: Templates,
) -> dict[str, str]:
    """Return the pages of an edition as HTML by file."""
    address = about["site_address"]
    files = {
        anchor: content.page.file
        for content in reversed(contents)
        for number, prose in enumerate(content.parts)
        # The first part is the page itself, which does not have an id.
        for anchor in [*IDS.findall(prose.body), *([prose.anchor] if number else [])]
    }
    names = {
        **about,
        "edition": edition,
        "contents": [_linked(content, files, edition) for content in contents],
        "root": edition.root,
        "address": address and address + edition.folder,
    }
    pages = {}
    for content, linked in zip(contents, names["contents"], strict=True):
        references = [templates.references[name] for name in content.cited]
        evidence = about["evidence"].describe(POINTERS.findall(content.body))
        on_page = {
            **names,
            "content": linked,
            "evidence": htmlsafe_json_dumps(evidence, ensure_ascii=False),
            "references": references,
        }
        pages[content.page.file] = templates.layout("base.html.j2", on_page)
    return pages


def _linked(content: Content, files: Mapping[str, str], edition: Edition) -> Content:
    """Complete links to ids on other pages, and number the citations.

    A link to content that was left out leads to the front page, which gives the reason.
    """
    numbers = {name: number for number, name in enumerate(content.cited, 1)}
    front = edition.report.settings.front.file if edition.left_out else ""

    def link(match: re.Match[str]) -> str:
        if not (file := files.get(match[1])):
            return front or match[0]
        return match[0] if file == content.page.file else file + match[0]

    def linked(prose: Prose | None) -> Any:
        if prose is None:
            return None
        body = CITED.sub(
            lambda match: macros().cited(numbers[match[1]]), LINK.sub(link, prose.body)
        )
        return replace(prose, body=Markup(body))

    chapters = [
        replace(chapter, prose=linked(chapter.prose)) for chapter in content.chapters
    ]
    return Content(content.page, [*map(linked, content.texts)], chapters)


def _files(edition: Edition) -> dict[str, File]:
    """Return the other files of an edition: styles, drawings, downloads and data."""
    root, project = edition.project.root, edition.project
    paths = {"page.js": LAYOUT / "page.js", ICON: root / "assets" / ICON}
    for path in (root / "static").rglob("*"):
        paths[path.relative_to(root).as_posix()] = path
    files: dict[str, File] = {
        name: path for name, path in paths.items() if path.is_file()
    }
    files["style.css"] = stylesheet(root)
    style = f"><style>{(LAYOUT / 'theme.css').read_text(encoding='utf-8')}</style>"
    chapter_sections = [chapter.section for chapter in edition.chapters.values()]
    for section in [*chapter_sections, *edition.stories.values()]:
        for figure in section.figures.values():
            for end, svg in zip(("", "-narrow"), figure.pictures, strict=False):
                # A drawing is a separate file, so it needs the colours and the font.
                drawing = svg.replace(">", style, 1)
                files[f"figures/{figure.anchor}{end}.svg"] = drawing
        for name, text in section.downloads.items():
            files[f"download/{name}"] = text
    data: dict[str, File] = {path.name: path for path in edition.plugins.data}
    for chapter in edition.chapters.values():
        record, path = chapter.results.record, chapter.results.path
        table = rows_csv(record.rows).encode()
        data[f"{path.stem}.csv.gz"] = gzip.compress(table, mtime=0)
        data |= {file.name: file for file in (path, *traces_of(path, record))}
    for path in replica_files(project):
        if path.stem in edition.measurements.names:
            data[f"{FOLDER}/{path.name}"] = path
    return {
        **{edition.folder + name: file for name, file in files.items()},
        **{f"data/{project.results.name}/{name}": file for name, file in data.items()},
        **edition.plugins.files,
    }


def _values(edition: Edition, printed: set[str]) -> str:
    """Return the derived values and the used means of measurements as JSON."""
    chapters = edition.chapters
    derived = {
        name: dict(chapter.results.derived) for name, chapter in chapters.items()
    }
    used = printed.union(
        *(value.sources for values in derived.values() for value in values.values())
    )
    means = grouped(
        pointer.rpartition("/")[::2] for pointer in used if f"/{MEANS}." in pointer
    )
    for name, chapter in chapters.items():
        names = means.get(chapter.results.values_file, ())
        derived[name] |= chapter.results.means(names)
    if rates := rate_values(edition) | calibration_values(edition):
        derived[FOLDER] = dict(rates)
    entries = {
        name: {label: value.entry for label, value in values.items()}
        for name, values in derived.items()
    }
    return json.dumps(
        entries, ensure_ascii=False, allow_nan=False, separators=(",", ":")
    )


def _noises(edition: Edition, printed: set[str]) -> str:
    """Return the noise of each cell that a page prints, as JSON."""
    noises = {}
    for chapter in edition.chapters.values():
        for index in range(len(chapter.results.record.rows)):
            row = Row(chapter.results, index)
            for column in row.plain:
                if (pointer := f"{row.source}/{column}") in printed:
                    noises[pointer] = getattr(row[column], "noise", None)
    return json.dumps(noises, ensure_ascii=False, indent=0)


def rows_csv(rows: Sequence[Mapping[str, Any]]) -> str:
    """Return rows as CSV.

    Missing cells are empty. A text that a spreadsheet would take for a formula gets an
    apostrophe in front.
    """
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
