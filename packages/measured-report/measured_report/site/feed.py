"""Files that a site has once, at its root: the feed, the site map, the picture for links, and all data in one file."""

import uuid
from collections.abc import Iterator, Mapping
from datetime import datetime
from operator import itemgetter

from measured_report.changes.flips import flips_between
from measured_report.files.config import config
from measured_report.files.root import ROOT
from measured_report.pages.editions import Edition
from measured_report.pages.plugins import plugins
from measured_report.site.data import archived
from measured_report.site.pages import CARD, Site

TEMPLATES = ("404.html", "robots.txt", "feed.xml", "sitemap.xml")


def write_feed(site: Site) -> None:
    """Write all that the site has once."""
    pages = (
        f"{site.places[release]}{page.file}" for release, edition in site.editions.items() for page in edition.pages
    )
    entries = sorted(_entries(site.editions, site.places), key=itemgetter("updated"), reverse=True)
    names = {"address": site.address, "pages": sorted(pages), "citation": site.citation, "id": _id("")}
    for file in TEMPLATES if site.address else TEMPLATES[:-1]:  # a map of a site takes whole addresses
        site.draft.write(file, site.templates.layout(f"{file}.j2", {**names, "entries": entries}))
    if (ROOT / "LICENSE").is_file():
        site.draft.copy("license.txt", ROOT / "LICENSE")
    if card := plugins().card(site.editions, site.cache):
        site.draft.write(CARD, card)
    readme = site.templates.layout("archive.txt.j2", {"editions": site.editions})
    data = [name.removeprefix("data/") for name in site.draft.digests if name.startswith("data/")]
    site.draft.write("data.zip", archived(site.draft.folder / "data", data, readme))
    site.draft.write(".gitkeep", "")


def _entries(editions: Mapping[str, Edition], places: Mapping[str, str]) -> Iterator[dict[str, str]]:
    """Yield the feed's entries: editions and what flips with them; an id is the same for the same news anywhere."""
    before: Edition | None = None
    older = ""
    for release, edition in editions.items():
        if not edition.chapters:
            continue
        name, place = config().name_of(release), places[release]
        dates = {name: _date(chapter.results.record.measured["date"]) for name, chapter in edition.chapters.items()}
        claims = [claim for chapter in edition.chapters.values() for claim in chapter.section.claims]
        text = claims[0].text if claims else ""
        yield _entry(release, name, text, f"{place}index.html", max(dates.values()))
        for flip in flips_between(before.chapters, edition.chapters) if before else ():
            title, text = f"{name}: {flip.after.text}", f"{older}: {flip.before.text}"
            where = f"{place}{edition.chapters[flip.section].page.file}#{flip.section}"
            yield _entry(f"{release}/{flip.claim}", title, text, where, dates[flip.section])
        before, older = edition, name


def _entry(key: str, title: str, text: str, address: str, updated: str) -> dict[str, str]:
    return {"id": _id(key), "title": title, "text": text, "address": address, "updated": updated}


def _id(key: str) -> str:
    return f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, f'{config().name}/{key}')}"


def _date(text: str) -> str:
    return datetime.fromisoformat(text).isoformat(timespec="seconds")
