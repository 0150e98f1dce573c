"""Files that a site has once, at its root: the feed, the picture for links, and what its data are."""

import uuid
from collections.abc import Iterator, Mapping
from datetime import datetime
from operator import itemgetter

from measured_report.changes.flips import flips_between
from measured_report.files.config import config
from measured_report.files.root import ROOT
from measured_report.pages.editions import Edition
from measured_report.pages.plugins import plugins
from measured_report.site.pages import CARD, Site


def write_feed(site: Site) -> None:
    """Write all that the site has once."""
    entries = sorted(_entries(site.editions, site.places), key=itemgetter("updated"), reverse=True)
    names = {"address": site.address, "citation": site.citation, "id": _id(""), "entries": entries}
    for file in ("404.html", "feed.xml"):
        site.draft.write(file, site.templates.layout(f"{file}.j2", names))
    if (ROOT / "LICENSE").is_file():
        site.draft.copy("license.txt", ROOT / "LICENSE")
    if card := plugins().card(site.editions, site.cache):
        site.draft.write(CARD, card)
    site.draft.write("data/README.txt", site.templates.layout("data.txt.j2", {"editions": site.editions}))
    site.draft.write(".gitkeep", "")


def _entries(editions: Mapping[str, Edition], places: Mapping[str, str]) -> Iterator[dict[str, str]]:
    """Yield the feed's entries: editions and what flips with them; an id is the same for the same news anywhere."""
    before: Edition | None = None
    for release, edition in editions.items():
        if not edition.chapters:
            continue
        flips = flips_between(before.chapters, edition.chapters) if before else ()
        claims = [claim for chapter in edition.chapters.values() for claim in chapter.section.claims]
        said = [flip.after.text for flip in flips] or [claim.text for claim in claims[:1]]
        dates = [chapter.results.record.measured["date"] for chapter in edition.chapters.values()]
        yield {
            "id": _id(release),
            "title": ": ".join([config().name_of(release), *said[: len(flips)][:1]]),
            "text": " ".join(said),
            "address": f"{places[release]}index.html",
            "updated": datetime.fromisoformat(max(dates)).isoformat(timespec="seconds"),
        }
        before = edition


def _id(key: str) -> str:
    return f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, f'{config().name}/{key}')}"
