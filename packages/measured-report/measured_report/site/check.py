"""Check a built site: its numbers must agree with its data, and its links must work.

A page must also not run or fetch anything that is not a part of the site.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import SplitResult, unquote, urlsplit

from measured_report.files.columns import unprintable
from measured_report.files.config import Report, module_named
from measured_report.files.config import report as current
from measured_report.pages.prose import LAYOUT
from measured_report.site.check_numbers import Data, Number, check_number

SCRIPT = "page.js"  # the script of all pages
SCHEMES = {"", "http", "https", "mailto"}
"""Schemes of addresses that a page may link to; others can run code: ``javascript``."""
FETCHING = (
    "src srcset poster data xlink:href background action formaction ping manifest"
)
"""Attributes with an address that a browser fetches or sends data to.

The attribute ``href`` is fetched, too, except in an element ``a``.
"""
ACTIVE = "iframe frame object embed applet base form portal set animate"
"""Elements that run code, contain another page, or change the targets of links."""
WITHOUT_END = (
    "area base br col embed hr img input link meta source track wbr "
    "dd dt li option p td th tr"
)
"""Elements without an end tag, or whose end tag can be left out."""
MARKUP = re.compile(r"`|<!--|\|[ :]*---|\{ \w+ \}|\{\{|\{%")
"""Markup that a page prints if it is not closed or has a mistake."""
PICTURES = {
    ".gif": b"GIF8",
    ".jpeg": b"\xff\xd8",
    ".jpg": b"\xff\xd8",
    ".png": b"\x89PNG",
    ".svg": b"<",
}
"""Bytes at the beginning of each kind of picture."""
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
    """Collect the numbers, claims, links, scripts and fetched files of a page."""

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
        self.faults = list(filter(None, [unprintable(html)]))
        self._open: list[str] = []
        self._tag = ""  # the last start tag; empty after an end tag
        self._attributes: Mapping[str, str] = {}
        self._text = ""
        self._is_code = False
        self.feed(html)
        self.faults += [f"<{tag}> is not closed" for tag in self._open]

    def handle_starttag(
        self, tag: str, attrs: Sequence[tuple[str, str | None]]
    ) -> None:
        attributes = {name: value or "" for name, value in attrs}
        self._tag = tag
        self._attributes = attributes
        self._text = ""
        self._is_code |= tag == "code"
        if tag not in WITHOUT_END.split():
            self._open.append(tag)
        if tag == "img" and not attributes.get("alt"):
            self.faults.append(
                f"the picture {attributes.get('src')} has no text for readers who "
                "cannot see it: add one"
            )
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
        is_text = not self._is_code and self._tag not in ("script", "style", "template")
        if is_text and (match := MARKUP.search(data)):
            self.faults.append(f"prints {match[0]}, which looks like broken markup")
        if self._tag == "script":
            self.scripts[-1][1].append(data)
        elif self._tag == "style":
            self.styles += data

    def handle_endtag(self, tag: str) -> None:
        if tag == "data":
            self.numbers.append((self._attributes, self._text, self._is_code))
        while tag in self._open and (inner := self._open.pop()) != tag:
            self.faults.append(f"<{inner}> is not closed")
        self._is_code &= tag != "code"
        self._tag = ""


Pages = Mapping[Path, PageReader]


def check_site(site: Path) -> list[str]:
    """Return the problems of the site in folder ``site``, one line for each."""
    try:
        return list(_problems_of(site.resolve(), current()))
    except UNREADABLE as error:
        text = " ".join(str(error).split())
        return [f"the site cannot be read: {type(error).__name__}: {text:.200}"]


def faults_of_pages(site: Path) -> list[str]:
    """Return a line for each fault of the HTML, and for each link to a page or an id
    that does not exist.
    """
    site = site.resolve()
    pages = _pages(site, "*.html")
    return [
        f"{path.relative_to(site)}: {problem}"
        for path, page in pages.items()
        for problem in (*page.faults, *_check_links(page, path, pages, site))
    ]


def _pages(site: Path, *patterns: str) -> Pages:
    files = sorted(path for pattern in patterns for path in site.rglob(pattern))
    return {
        path.resolve(): PageReader(path.read_text(encoding="utf-8")) for path in files
    }


def _problems_of(site: Path, report: Report) -> Iterator[str]:
    scripts = module_named("plugins", report.settings.plugins).scripts()
    data = Data(site / "data", report)
    pages = _pages(site, "*.html", "*.svg")
    for path, page in pages.items():
        problems = [
            *_check_safety(page),
            *_check_links(page, path, pages, site),
        ]
        for claim in page.claims:
            if claim.get("data-outcome") not in OUTCOMES:
                problems.append(
                    f"the claim {claim['data-claim']} does not have an outcome"
                )
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
            yield f"{path.relative_to(site)} is not a script of the project"
    for path in sorted(site.rglob("*.css")):
        if FETCHING_STYLE.search(path.read_text(encoding="utf-8")):
            yield f"{path.relative_to(site)} fetches a file"
    if not (site / "index.html").is_file():
        yield "there is no index.html"


def _check_safety(page: PageReader) -> Iterator[str]:
    """Yield the scripts and fetched files of a page that are not parts of the site."""
    yield from (f"<{tag}> runs a script" for tag in page.active)
    for attributes, texts in page.scripts:
        text = "".join(texts)
        # The contents of script files are checked by _problems_of.
        is_file = attributes.get("src", "").endswith(".js") and not text.strip()
        is_plain = is_file and attributes.keys() <= {"src", "defer"}
        if not is_plain:
            yield "it runs a script that is not the project's own"
    for address in page.fetched:
        parts = _parts(address)
        is_data = parts.scheme == "data"
        is_image = is_data and parts.path.startswith((",", "image/", "font/"))
        if parts.netloc or (parts.scheme and not is_image):
            yield f"{address} is fetched from another site"
    if FETCHING_STYLE.search(page.styles):
        yield "a style fetches a file"


def _check_links(
    page: PageReader, path: Path, pages: Pages, site: Path
) -> Iterator[str]:
    for name in sorted(set(page.ids)):
        if page.ids.count(name) > 1:
            yield f"the id {name} is not unique"
    for address in page.links:
        if _parts(address).scheme not in SCHEMES:
            yield f"a link to {address} is not allowed"
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
            yield f"{address} does not exist"
        elif target.suffix.lower() in PICTURES:
            # A byte order mark and line breaks can come first.
            start = target.read_bytes()[:8]
            if PICTURES[target.suffix.lower()] not in start:
                yield f"{address} is not such a picture: save it again"


def _parts(address: str) -> SplitResult:
    """Split an address as browsers do, without control characters and with / for \\."""
    try:
        return urlsplit(re.sub("[\x00-\x20\x7f-\x9f]", "", address).replace("\\", "/"))
    except ValueError:
        return SplitResult("unreadable", "", "", "", "")
