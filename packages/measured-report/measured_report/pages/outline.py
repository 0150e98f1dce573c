"""The pages of a release, in their order, as ``report.toml`` has them. A section's module names its own as ``page``.

Each is a table with a ``name``, the ``label`` of what leads to it (without one its name), its ``texts`` (without any
``pages/NAME.md.j2``), and ``compares`` for one that shows all editions side by side, where there are several, and no
section.
"""

from dataclasses import dataclass

from measured_report.files.config import FILE, config
from measured_report.files.errors import ReportError


@dataclass(frozen=True)
class Page:
    """One page of every release."""

    name: str
    label: str
    texts: tuple[str, ...]
    """Its templates of prose; the first begins with the title of the page."""
    compares: bool

    @property
    def file(self) -> str:
        return f"{self.name}.html"


def _page(name: str = "", label: str = "", texts: tuple = (), compares: bool = False, **other: object) -> Page:
    if not name or other:
        what = f"a page has {next(iter(other))}, which means nothing" if other else "a page has no name"
        raise ReportError(f"{FILE}: {what}")
    return Page(name, label or name.replace("_", " ").capitalize(), tuple(texts or [f"pages/{name}.md.j2"]), compares)


PAGES = tuple(_page(**fields) for fields in config().pages)
FRONT = PAGES[0]
OF_SECTIONS = {page.name: page for page in PAGES[1:] if not page.compares}


def page_of(section: str, name: str | None) -> Page:
    """The page that the module ``section`` names, or else the first that takes sections; ReportError for no such."""
    name = next(iter(OF_SECTIONS), "") if name is None else name
    if name not in OF_SECTIONS:
        raise ReportError(f"{section} names the page {name!r}; there are: {', '.join(OF_SECTIONS)}")
    return OF_SECTIONS[name]
