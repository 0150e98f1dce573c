"""Files at the root of the site, which it has once: feed, site map, picture for links, and all data in one file."""

import re
import uuid
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime

from measured_report import ROOT
from measured_report.changes.compare import flips
from measured_report.deriving.cache import DerivedCache
from measured_report.deriving.editions import Edition
from measured_report.deriving.extras import extras
from measured_report.files.config import config
from measured_report.files.staging import Draft
from measured_report.pages.page import Templates
from measured_report.site.archive import ARCHIVE, archived

CARD = "card.png"
TEMPLATES = ("404.html", "robots.txt", "sitemap.xml", "feed.xml")
CITATION_LINE = re.compile(r"^(?:  - )?([a-z-]+): (.+)$", re.MULTILINE)


@dataclass(frozen=True)
class Entry:
    """One entry of the feed."""

    id: str
    """The same for the same news, wherever the site lies."""
    title: str
    text: str
    address: str
    """Below the site."""
    updated: str


def citation() -> dict[str, str]:
    """Read what CITATION.cff says, each key's first line."""
    found = CITATION_LINE.findall((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    return dict(reversed(found))


def write_root_files(
    site: Draft,
    editions: Mapping[str, Edition],
    places: Mapping[str, str],
    tables: Mapping[str, bytes],
    templates: Templates,
    address: str,
    cache: DerivedCache,
) -> None:
    """Write all that the site has once.

    Args:
        site: The site.
        editions: Every release by its name, oldest first.
        places: Where the pages of each lie in the site.
        tables: Rows of each record, by its file.
        templates: Those of the project.
        address: Where the site will lie; empty where that is not known.
        cache: What was made before.
    """
    names = {
        "address": address,
        "pages": sorted(f"{places[name]}{page.file}" for name, edition in editions.items() for page in edition.pages),
        "citation": citation(),
        "id": _id(""),
        "entries": sorted(_entries(editions, places), key=lambda entry: entry.updated, reverse=True),
    }
    for file in TEMPLATES:
        site.write(file, templates.layout(f"{file}.j2", names))
    site.copy("license.txt", ROOT / "LICENSE")
    if card := extras().card(editions, cache):
        site.write(CARD, card)
    site.write(ARCHIVE, archived(editions, tables, templates))


def _entries(editions: Mapping[str, Edition], places: Mapping[str, str]) -> Iterator[Entry]:
    before: Edition | None = None
    for release, edition in editions.items():
        if not edition.chapters:
            continue
        name, place = config().edition(release), places[release]
        dates = {name: _date(chapter.results.record.measured["date"]) for name, chapter in edition.chapters.items()}
        claims = [claim for chapter in edition.chapters.values() for claim in chapter.section.claims]
        text = claims[0].text if claims else ""
        yield Entry(_id(release), name, text, f"{place}index.html", max(dates.values()))
        for flip in flips(before.chapters, edition.chapters) if before else ():
            claim = f"{flip.section}.{flip.before.name}"
            title = f"{name}: {claim}, {flip.before.outcome.said} → {flip.after.outcome.said}"
            where = f"{place}{edition.chapters[flip.section].page.file}#{flip.section}"
            yield Entry(_id(f"{release}/{claim}"), title, flip.after.text, where, dates[flip.section])
        before = edition


def _id(key: str) -> str:
    return f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, f'{config().name}/{key}')}"


def _date(text: str) -> str:
    return datetime.fromisoformat(text).isoformat(timespec="seconds")
