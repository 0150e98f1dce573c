"""Check of a built site: what it shows is what was measured, and it needs nothing from elsewhere."""

import re
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from urllib.parse import SplitResult, unquote, urlsplit

from measured_report.files.config import Report, module_named
from measured_report.files.config import report as current_report
from measured_report.pages.prose import LAYOUT
from measured_report.site.check_numbers import SCRIPT, Data, PageReader, check_numbers

SCHEMES = {"", "http", "https", "mailto"}
"""Of addresses that a page may lead to; nothing that it leads to may run in it."""
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
    # Drawings that are files are parts of pages.
    files = sorted([*site.rglob("*.html"), *site.rglob("*.svg")])
    pages = {
        path.resolve(): PageReader(path.read_text(encoding="utf-8")) for path in files
    }
    for path, page in pages.items():
        problems = [*page.faults, *_check_safety(page, scripts)]
        problems += _check_links(page, path, pages, site)
        for claim in page.claims:
            if claim.get("data-outcome") not in OUTCOMES:
                problems.append(f"the claim {claim['data-claim']} has no outcome")
        problems += check_numbers(page, data)
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
    for text in page.inline:
        if text not in scripts:
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
