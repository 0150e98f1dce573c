"""The pages of a release, in their order. A section's module names its own as ``page``, beside its ``order``."""

from dataclasses import dataclass

from measured_report import ReportError


@dataclass(frozen=True)
class Page:
    """One page of every release."""

    name: str
    label: str
    """What leads to it is called so."""
    texts: tuple[str, ...]
    """Its templates of prose; the first begins with the title of the page."""

    @property
    def file(self) -> str:
        return f"{self.name}.html"


def _page(name: str, label: str) -> Page:
    return Page(name, label, (f"pages/{name}.md.j2",))


FRONT = Page("index", "Overview", ("front.md.j2", "story.md.j2"))
HISTORY = _page("history", "History")
"""Where there is more than one edition: what all of them have side by side, and no section."""
PAGES = (
    FRONT,
    _page("evidence", "Suspects"),
    _page("cause", "Cause"),
    _page("fix", "Fix"),
    _page("cure", "Cure"),
    _page("limits", "Limits"),
    _page("scenes", "Other scenes"),
    _page("error", "Error and run time"),
    _page("cost", "Cost and speed"),
    _page("releases", "Releases"),
    HISTORY,
    _page("method", "Method"),
)
REPLAY = "replay.html"
"""Beside these: the kept runs, on a page by itself."""
SHAKES = {
    "3 cm": {"as-shipped": "shipped pads", "stiff-pads": "stiff pads"},
    "10 cm": {"as-shipped-10cm": "shipped pads", "stiff-pads-10cm": "stiff pads"},
    "held still": {"hold-60s": "shipped pads, held still"},
}
"""What can be chosen on the page of the replay, and the runs that it shows, by case."""
DEFAULT = "evidence"
"""The page of a section that names none."""


def page_named(name: str, place: str) -> Page:
    """ReportError where there is no such page for sections, as ``place`` says there is."""
    there = {page.name: page for page in PAGES if page not in (FRONT, HISTORY)}
    if name not in there:
        raise ReportError(f"{place} names the page {name!r}; there are: {', '.join(there)}")
    return there[name]
