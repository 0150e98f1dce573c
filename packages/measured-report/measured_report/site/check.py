"""Check of a built site: its numbers are those of the data, and it needs nothing from elsewhere."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import SplitResult, unquote, urlsplit

from measured_report.files.config import Report, module_named
from measured_report.files.config import report as current_report
from measured_report.pages.prose import LAYOUT
from measured_report.site.check_numbers import Data, Number, check_number

SCRIPT = "page.js"  # the one script that pages run: the project's own, beside them
SCHEMES = {"", "http", "https", "mailto"}
"""Of addresses that a page may lead to; nothing that it leads to may run in it."""
FETCHING = (
    "src srcset poster data xlink:href background action formaction ping manifest"
)
"""Attributes whose address a browser fetches or sends to, as it does every href but that of ``a``."""
ACTIVE = "iframe frame object embed applet base form portal set animate"
"""Elements that run, hold another page, or change where links lead."""
OUTCOMES = {"holds", "fails", "unknown"}
FETCHING_STYLE = re.compile(r"@import|url\(\s*['\"]?(?!#|data:)", re.IGNORECASE)
UNREADABLE = (
    ArithmeticError,
    AttributeError,
    LookupError,
    OSError,
    RecursionError,
    TypeError,
    ValueError,
)


class PageReader(HTMLParser):
    """Read a page or a drawing: its numbers, and what it leads to, fetches and runs."""

    def __init__(self, html: str):
        super().__init__()
        self.ids: list[str] = []
        self.links: list[str] = []
        self.fetched: list[str] = []
        self.active: list[str] = []
        self.claims: list[Mapping[str, str]] = []
        self.numbers: list[Number] = []
        self.scripts: list[tuple[Mapping[str, str], list[str]]] = []
        self.styles = ""
        self._tag = ""  # the element that began last, while nothing ended behind it
        self._attributes: Mapping[str, str] = {}
        self._text = ""
        self._is_code = False
        self.feed(html)

    def handle_starttag(
        self, tag: str, attrs: Sequence[tuple[str, str | None]]
    ) -> None:
        attributes = {name: value or "" for name, value in attrs}
        self._tag = tag
        self._attributes = attributes
        self._text = ""
        self._is_code |= tag == "code"
        is_named = attributes.get("rel") in ("canonical", "alternate")
        is_refresh = "refresh" in attributes.get("http-equiv", "").lower()
        if tag in ACTIVE.split() or is_refresh:
            self.active.append(tag)
        if tag == "script":
            self.scripts.append((attributes, []))
        if "data-claim" in attributes:
            self.claims.append(attributes)
        for name, value in attributes.items():
            if name == "id":
                self.ids.append(value)
            elif name == "style":
                self.styles += value
            elif name.startswith("on") or name == "srcdoc":
                self.active.append(tag)
            elif name == "href" and tag == "a":
                self.links.append(value)
            elif name in FETCHING.split() or (name == "href" and not is_named):
                self.fetched.append(value)

    def handle_data(self, data: str) -> None:
        self._text += data
        if self._tag == "script":
            self.scripts[-1][1].append(data)
        elif self._tag == "style":
            self.styles += data

    def handle_endtag(self, tag: str) -> None:
        if tag == "data":
            self.numbers.append((self._attributes, self._text, self._is_code))
        self._is_code &= tag != "code"
        self._tag = ""


Pages = Mapping[Path, PageReader]


def check_site(site: Path, report: Report | None = None) -> list[str]:
    """Say what is wrong with the site in folder ``site``, a line each; empty when nothing is."""
    try:
        return list(_problems_of(site.resolve(), report or current_report()))
    except UNREADABLE as error:
        text = " ".join(str(error).split())
        return [f"it can't be read: {type(error).__name__}: {text:.200}"]


def _problems_of(site: Path, report: Report) -> Iterator[str]:
    scripts = module_named("plugins", report.settings.plugins).scripts()
    data = Data(site / "data", report)
    files = sorted([*site.rglob("*.html"), *site.rglob("*.svg")])
    pages = {
        path.resolve(): PageReader(path.read_text(encoding="utf-8")) for path in files
    }
    for path, page in pages.items():
        problems = [
            *_check_safety(page, scripts),
            *_check_links(page, path, pages, site),
        ]
        for claim in page.claims:
            if claim.get("data-outcome") not in OUTCOMES:
                problems.append(f"the claim {claim['data-claim']} has no outcome")
        for number in page.numbers:
            problems += check_number(number, data)
        yield from (f"{path.relative_to(site)}: {problem}" for problem in problems)
    html = {path: page for path, page in pages.items() if path.suffix == ".html"}
    for folder in {path.parent for path in html}:
        if not any(page.claims for path, page in html.items() if path.parent == folder):
            index = folder.relative_to(site) / "index.html"
            yield f"{index}: there is no claim on any page"
    allowed = {(LAYOUT / SCRIPT).read_text(encoding="utf-8"), *scripts}
    for path in sorted(site.rglob("*.js")):
        if path.read_text(encoding="utf-8", errors="replace") not in allowed:
            yield f"{path.relative_to(site)} is not the project's script"
    for path in sorted(site.rglob("*.css")):
        if FETCHING_STYLE.search(path.read_text(encoding="utf-8")):
            yield f"{path.relative_to(site)} fetches something"
    if not (site / "index.html").is_file():
        yield "there is no index.html"


def _check_safety(page: PageReader, scripts: Collection[str]) -> Iterator[str]:
    """Say what runs on a page, or is fetched for it, that is not the report's own."""
    yield from (f"<{tag}> runs a script" for tag in page.active)
    for attributes, texts in page.scripts:
        text = "".join(texts)
        # A file's bytes are checked where they lie, so that it need only be one of the site.
        is_file = attributes.get("src", "").endswith(".js") and not text.strip()
        is_plain = is_file and attributes.keys() <= {"src", "defer"}
        if not is_plain and (attributes or text not in scripts):
            yield "a script runs that is not the project's own"
    for address in page.fetched:
        parts = _parts(address)
        is_data = parts.scheme == "data"
        is_image = is_data and parts.path.startswith((",", "image/", "font/"))
        if parts.netloc or (parts.scheme and not is_image):
            yield f"{address} is fetched from elsewhere"
    if FETCHING_STYLE.search(page.styles):
        yield "a style fetches something"


def _check_links(
    page: PageReader, path: Path, pages: Pages, site: Path
) -> Iterator[str]:
    for name in sorted(set(page.ids)):
        if page.ids.count(name) > 1:
            yield f"the id {name} is not unique"
    for address in page.links:
        if _parts(address).scheme not in SCHEMES:
            yield f"{address} is no address that a page may lead to"
    for address in page.links + page.fetched:
        parts = _parts(address)
        if parts.scheme or parts.netloc:
            continue
        target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
        fragment = unquote(parts.fragment)
        if parts.path.startswith("/") or not target.is_relative_to(site):
            yield f"{address} leaves the site"
        elif not target.exists() or (
            target in pages and fragment and fragment not in pages[target].ids
        ):
            yield f"{address} leads nowhere"


def _parts(address: str) -> SplitResult:
    """Read an address as browsers do, which pass over blanks and control characters, and take \\ for /."""
    try:
        return urlsplit(re.sub("[\x00-\x20\x7f-\x9f]", "", address).replace("\\", "/"))
    except ValueError:
        return SplitResult("unreadable", "", "", "", "")
