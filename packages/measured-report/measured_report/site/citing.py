"""Citing: who wrote the report, where its sources lie, and how it is cited."""

import re
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from urllib.parse import urlsplit

from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.files.root import ROOT
from measured_report.pages.editions import Edition
from measured_report.records.provenance import git

KEY = re.compile(r"^([a-z-]+): *(.+)$", re.MULTILINE)
AUTHORS = re.compile(r"^authors:\n((?:[ -].*\n)+)", re.MULTILINE)
PART = re.compile(r"^ *(?:- )?([a-z-]+): *(.+)$", re.MULTILINE)
BRIEF = re.compile(r"(?:\w+@)?([\w.-]{2,}):(?!/)(.+)")
"""An address as ssh and scp have it: ``git@host:path``."""
SPECIAL = re.compile(r"[&%$#_{}]")


@dataclass(frozen=True)
class Citation:
    """Citation of the report, as ``CITATION.cff`` has it."""

    title: str
    license: str
    authors: Sequence[str]
    """Names as people write them."""
    is_group: bool
    """Set where the first author is no single person."""

    @property
    def names(self) -> str:
        return " and ".join(filter(None, [", ".join(self.authors[:-1]), *self.authors[-1:]]))

    def bibtex(self, edition: Edition, address: str, sources: str) -> str:
        """Return the entry of one edition for a bibliography; without an ``address`` it is found at its ``sources``."""
        date = measured_on(edition)
        authors = " and ".join(self.authors)
        fields = {
            "author": f"{{{_plain(authors)}}}" if self.is_group else _plain(authors),
            "title": f"{{{_plain(self.title)}}}",
            "year": date[:4],
            "month": str(int(date[5:7] or 0)) if date else "",
            "note": _plain(f"{config().name_of(edition.project.release)}, measured {date}" if date else ""),
            "url": address or sources,
        }
        lines = [f"  {name} = {{{text}}}," for name, text in fields.items() if text]
        key = re.sub(r"[^\w.-]", "-", f"{config().name}-{edition.project.release}")
        return "\n".join([f"@misc{{{key},", *lines, "}"])


def citation() -> Citation:
    """Read ``CITATION.cff``."""
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    said = {name: value.strip("\"' ") for name, value in KEY.findall(text)}
    block = AUTHORS.search(f"{text}\n")
    people = [dict(PART.findall(each)) for each in re.split(r"(?m)^ *(?=- )", block[1] if block else "") if each]
    names = [each.get("name") or f"{each.get('given-names', '')} {each.get('family-names', '')}" for each in people]
    authors = [name.strip("\"' ") for name in names]
    return Citation(said.get("title", ""), said.get("license", ""), authors, bool(people and "name" in people[0]))


def measured_on(edition: Edition) -> str:
    """Return the day on which the last of its sections was measured; empty without any."""
    dates = (chapter.results.record.measured["date"] for chapter in edition.chapters.values())
    return max((datetime.fromisoformat(date).date().isoformat() for date in dates), default="")


def sources(root: Path) -> str:
    """Return where the sources of the report at ``root`` lie on the web; empty where nobody says so.

    That is what ``report.toml`` says, or git's origin, without whatever was put into its address to get in.
    """
    if config().repository:
        return config().repository
    with suppress(UsageError):
        if Path(git(root, "rev-parse", "--show-toplevel")) == root.resolve():
            return web_address(git(root, "config", "--get", "remote.origin.url"))
    return ""


def web_address(remote: str) -> str:
    """Return the page of a git remote, which has no name, token or port in its address; empty for one with none."""
    brief = BRIEF.fullmatch(remote)
    parts = urlsplit(f"ssh://{brief[1]}/{brief[2]}" if brief and "://" not in remote else remote)
    if parts.scheme not in ("http", "https", "ssh", "git") or not parts.hostname:
        return ""
    return f"https://{parts.hostname}{parts.path.rstrip('/').removesuffix('.git')}"


def _plain(text: str) -> str:
    return SPECIAL.sub(lambda found: f"\\{found[0]}", text)
