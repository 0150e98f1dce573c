"""Check of a built site: what it shows is what was measured, and its links lead somewhere.

That a page runs nothing but its own scripts, and fetches nothing from elsewhere, browsers see to: each has a policy.
"""

from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from urllib.parse import unquote, urlsplit

from measured_report.site.check_numbers import Data, check_bounds, check_numbers
from measured_report.site.page_reader import PageReader

SCHEMES = {"", "http", "https", "mailto", "data"}
OUTCOMES = {"holds", "fails", "unknown"}


def check_site(site: Path) -> list[str]:
    """Say what is wrong with the site in folder ``site``, a line each; empty when nothing is."""
    try:
        return [*_problems_of(site.resolve())]
    except (ArithmeticError, AttributeError, LookupError, OSError, RecursionError, TypeError, ValueError) as error:
        return [f"it can't be read: {type(error).__name__}: {' '.join(str(error).split()):.200}"]


def _problems_of(site: Path) -> Iterator[str]:
    pages = {path: PageReader(path.read_text(encoding="utf-8")) for path in sorted(site.rglob("*.html"))}
    data = Data(site / "data")
    for path, page in pages.items():
        numbers = check_numbers(page, data)
        for problem in (*_check_page(page), *_check_links(page, path, pages, site), *(numbers or check_bounds(page))):
            yield f"{path.relative_to(site)}: {problem}"
    for folder in {path.parent for path in pages}:
        if not any(page.claims for path, page in pages.items() if path.parent == folder):
            yield f"{folder.relative_to(site) / 'index.html'}: there is no claim on any page"
    if site / "index.html" not in pages:
        yield "there is no index.html"


def _check_page(page: PageReader) -> Iterator[str]:
    for claim in page.claims:
        if claim.get("data-outcome") not in OUTCOMES:
            yield f"the claim {claim['data-claim']} has no outcome"
    for name, count in Counter(page.ids).items():
        if count > 1:
            yield f"the id {name} is not unique"
    if not page.policy.startswith("default-src 'none'"):
        yield "no policy keeps it from what lies elsewhere"


def _check_links(page: PageReader, path: Path, pages: Mapping[Path, PageReader], site: Path) -> Iterator[str]:
    for address in page.links:
        parts = urlsplit(address)
        if parts.scheme not in SCHEMES:
            yield f"{address} is no address that a page may lead to"
        if parts.scheme or parts.netloc:
            continue
        target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
        if parts.path.startswith("/") or not target.is_relative_to(site):
            yield f"{address} leaves the site"
        elif not target.exists() or (
            target in pages and parts.fragment and unquote(parts.fragment) not in pages[target].ids
        ):
            yield f"{address} leads nowhere"
