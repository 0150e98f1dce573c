"""Check of a built site: what it shows is what was measured, and it needs nothing from elsewhere."""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from urllib.parse import SplitResult, unquote, urlsplit

from measured_report.files.config import Report
from measured_report.files.config import report as current_report
from measured_report.pages.plugins import plugins
from measured_report.pages.prose import LAYOUT
from measured_report.site.check_numbers import SCRIPT, Data, PageReader, check_numbers

SCHEMES = {"", "http", "https", "mailto"}  # a page may lead anywhere, but nothing that it leads to may run in it
OUTCOMES = {"holds", "fails", "unknown"}
FETCHING_STYLE = re.compile(r"@import|url\(\s*['\"]?(?!#|data:)", re.IGNORECASE)


def check_site(site: Path, report: Report | None = None) -> list[str]:
    """Say what is wrong with the site in folder ``site``, a line each; empty when nothing is."""
    try:
        return list(_problems_of(site, report or current_report()))
    except (ArithmeticError, AttributeError, LookupError, OSError, RecursionError, TypeError, ValueError) as error:
        return [f"it can't be read: {type(error).__name__}: {' '.join(str(error).split()):.200}"]


def _problems_of(site: Path, report: Report) -> Iterator[str]:
    files = sorted([*site.rglob("*.html"), *site.rglob("*.svg")])  # drawings are parts of pages
    pages = {path.resolve(): PageReader(path.read_text(encoding="utf-8")) for path in files}
    data, scripts = Data(site / "data", report), plugins(report).scripts()
    for path, page in pages.items():
        problems = page.faults + [f"<{tag}> runs a script" for tag in page.scripts]
        problems += ["a script runs that is not the project's own" for text in page.inline if text not in scripts]
        problems += [f"{address} is fetched from elsewhere" for address in page.fetched if _is_elsewhere(address)]
        problems += ["a style fetches something"] if FETCHING_STYLE.search(page.styles) else []
        problems += _check_links(page, path, pages, site)
        unsaid = (claim["data-claim"] for claim in page.claims if claim.get("data-outcome") not in OUTCOMES)
        problems += [f"the claim {name} has no outcome" for name in unsaid]
        problems += check_numbers(page, data)
        yield from (f"{path.relative_to(site.resolve())}: {problem}" for problem in problems)
    for folder in {path.parent for path in pages if path.suffix == ".html"}:
        if not any(page.claims for path, page in pages.items() if path.parent == folder):
            yield f"{folder.relative_to(site.resolve()) / 'index.html'}: there is no claim on any page"
    allowed = {(LAYOUT / SCRIPT).read_text(encoding="utf-8"), *scripts}
    for path in sorted(site.rglob("*.js")):
        if path.read_text(encoding="utf-8", errors="replace") not in allowed:
            yield f"{path.relative_to(site)} is not the project's script"
    styles = (path for path in sorted(site.rglob("*.css")) if FETCHING_STYLE.search(path.read_text(encoding="utf-8")))
    yield from (f"{path.relative_to(site)} fetches something" for path in styles)
    if not (site / "index.html").is_file():
        yield "there is no index.html"


def _check_links(page: PageReader, path: Path, pages: Mapping[Path, PageReader], site: Path) -> Iterator[str]:
    yield from (f"the id {name} is not unique" for name in sorted(set(page.ids)) if page.ids.count(name) > 1)
    for address in page.links + page.fetched:
        parts = _parts(address)
        if address in page.links and parts.scheme not in SCHEMES:
            yield f"{address} is no address that a page may lead to"
        if parts.scheme or parts.netloc:
            continue
        target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
        fragment = unquote(parts.fragment)
        if parts.path.startswith("/") or not target.is_relative_to(site.resolve()):
            yield f"{address} leaves the site"
        elif not target.exists() or (target in pages and fragment and fragment not in pages[target].ids):
            yield f"{address} leads nowhere"


def _is_elsewhere(address: str) -> bool:
    parts = _parts(address)
    is_image = parts.scheme == "data" and parts.path.startswith((",", "image/", "font/"))
    return bool(parts.netloc or (parts.scheme and not is_image))


def _parts(address: str) -> SplitResult:
    """Read an address as browsers do, which pass over blanks and control characters, and take \\ for /."""
    try:
        return urlsplit(re.sub("[\x00-\x20\x7f-\x9f]", "", address).replace("\\", "/"))
    except ValueError:
        return SplitResult("unreadable", "", "", "", "")
