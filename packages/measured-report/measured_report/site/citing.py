"""Citing: who wrote the report, and how it is cited."""

import re
from dataclasses import dataclass

from measured_report.files.root import ROOT
from measured_report.pages.editions import Edition

FIELD = re.compile(r"^(title|license): *(.+)$", re.MULTILINE)
AUTHOR = re.compile(r"^ +(?:- )?name: *(.+)$|^ +- family-names: *(.+)\n +given-names: *(.+)$", re.MULTILINE)


@dataclass(frozen=True)
class Citation:
    """Citation of the report, as ``CITATION.cff`` has it."""

    title: str
    license: str
    authors: tuple[str, ...]
    """Names as people write them."""

    @property
    def names(self) -> str:
        return " and ".join(filter(None, [", ".join(self.authors[:-1]), *self.authors[-1:]]))


def citation() -> Citation:
    """Read ``CITATION.cff``."""
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    said = {name: value.strip("\"' ") for name, value in FIELD.findall(text)}
    people = ((name or f"{given} {family}") for name, family, given in AUTHOR.findall(text))
    return Citation(said["title"], said.get("license", ""), tuple(name.strip("\"' ") for name in people))


def measured_on(edition: Edition) -> str:
    """Return the day on which the last of its sections was measured; empty without any."""
    return max((chapter.results.record.measured["date"][:10] for chapter in edition.chapters.values()), default="")
