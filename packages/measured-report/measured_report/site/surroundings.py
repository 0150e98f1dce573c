"""What stands around the pages: picture, feed, site map, all data in one file, and what tells who made it."""

import re
import uuid
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime

from measured_report import ROOT
from measured_report.changes.flips import flips_between
from measured_report.deriving.editions import Edition
from measured_report.deriving.keeping import Keeper
from measured_report.files.staging import Draft
from measured_report.pages.page import Templates
from measured_report.site.archive import ARCHIVE, archived
from measured_report.values.quantities import Quantity

ASSETS = ("style.css", "page.js", "favicon.svg")
"""Files of ``assets/`` that lie beside the pages of each release."""
CARD = "card.png"
TEXTS = {"404.html": "404.html.j2", "robots.txt": "robots.txt.j2", "sitemap.xml": "sitemap.xml.j2"}
FEED = "feed.xml"
CITATION_LINE = re.compile(r"^(?:  - )?([a-z-]+): (.+)$", re.MULTILINE)
CARD_CASES = {"shipped pads": "as-shipped", "stiff pads": "stiff-pads"}
"""What the picture shows of each release, by its name there."""


@dataclass(frozen=True)
class Entry:
    """One entry of the feed."""

    key: str
    title: str
    text: str
    address: str
    """Below the site."""
    updated: str

    @property
    def id(self) -> str:
        """The same for the same news, wherever the site lies."""
        return f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, f'shake-report/{self.key}')}"


def citation() -> dict[str, str]:
    """What CITATION.cff says, each key's first line."""
    found = CITATION_LINE.findall((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    return dict(reversed(found))


def write_surroundings(
    site: Draft,
    editions: Mapping[str, Edition],
    places: Mapping[str, str],
    tables: Mapping[str, bytes],
    templates: Templates,
    address: str,
    keeper: Keeper,
) -> None:
    """Write all that the site has once.

    Args:
        site: The site.
        editions: Every release by its name, oldest first.
        places: Where the pages of each lie in the site.
        tables: Rows of each record, by its file.
        templates: Those of the project.
        address: Where the site will lie; empty where that is not known.
        keeper: What was made before.
    """
    pages = [f"{places[name]}{page.file}" for name, edition in editions.items() for page in edition.pages]
    names = {"address": address, "pages": sorted(pages), "citation": citation(), "feed": FEED}
    for file, template in TEXTS.items():
        site.write(file, templates.layout(template, names))
    entries = sorted(_entries(editions, places), key=lambda entry: entry.updated, reverse=True)
    site.write(FEED, templates.layout("feed.xml.j2", {**names, "entries": entries}))
    site.copy("license.txt", ROOT / "LICENSE")
    slips = {release: _slips(edition) for release, edition in editions.items()}
    given = [f"{release} {slip}" for release, pair in slips.items() for slip in pair.items()]
    site.write(CARD, keeper.value("card", ROOT / "report" / "shared" / "card.py", given, lambda: _card(slips)))
    site.write(ARCHIVE, archived(editions, tables, templates))


def _entries(editions: Mapping[str, Edition], places: Mapping[str, str]) -> list[Entry]:
    found = []
    before: Edition | None = None
    for release, edition in editions.items():
        if not edition.chapters:
            continue
        dates = {name: _date(chapter.results.record.measured["date"]) for name, chapter in edition.chapters.items()}
        claims = [claim for chapter in edition.chapters.values() for claim in chapter.section.claims]
        text = claims[0].text if claims else ""
        place = places[release]
        found.append(Entry(release, f"Newton {release}", text, f"{place}index.html", max(dates.values())))
        for flip in flips_between(before.chapters, edition.chapters) if before else ():
            chapter = edition.chapters[flip.section]
            title = f"Newton {release}: {flip.claim}, {flip.outcomes}"
            where = f"{place}{chapter.page.file}#{flip.section}"
            found.append(Entry(f"{release}/{flip.claim}", title, flip.after.text, where, dates[flip.section]))
        before = edition
    return found


def _date(text: str) -> str:
    return datetime.fromisoformat(text).isoformat(timespec="seconds")


def _card(slips: Mapping[str, Mapping[str, Quantity | None]]) -> bytes:
    from report.shared.card import draw_card  # it takes Matplotlib, which takes long to import

    return draw_card(slips)


def _slips(edition: Edition) -> dict[str, Quantity | None]:
    found: dict[str, Quantity | None] = {}
    for label, case in CARD_CASES.items():
        rows = (chapter.results.row for chapter in edition.chapters.values())
        there = (row[case] for row in rows if case in row and "slip_mm" in row[case])
        found[label] = next((row.slip_mm for row in there), None)
    return found
