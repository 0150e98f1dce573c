"""A cache of what sections make of their results, their figures drawn, as long as all that it was made from is so."""

import functools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from measured_report.files.cache import Cache
from measured_report.pages.dependencies import code_digest, digest_of
from measured_report.parts.claim import Claim
from measured_report.parts.section import Figure, Pictures, Section
from measured_report.values.quantities import Value

Derivation = tuple[Section, Mapping[str, Value]]
"""A section without its words, and the values that were derived for it."""


@dataclass(frozen=True)
class Entry:
    """A section, kept from before or derived now."""

    place: tuple[str, str, str]
    """Profile, release and section."""
    digest: str
    """Digest of all that it was made from."""
    section: Section
    values: Mapping[str, Value]

    @property
    def figures(self) -> dict[tuple[str, str], Figure]:
        """Its figures by release and id."""
        _, release, section = self.place
        named = {f"{section}-{name}": figure for name, figure in self.section.figures.items()}
        return {(release, anchor): replace(figure, anchor=anchor) for anchor, figure in named.items()}


@dataclass(frozen=True)
class DerivedCache:
    """What is kept of the project at ``root``; without one nothing is."""

    root: Path | None = None
    _new: list[Entry] = field(default_factory=list)
    """What is to be kept once its figures are drawn."""
    _claims: dict[tuple[str, str, str], Claim] = field(default_factory=dict)
    """Claims with their words, by release, section and name."""
    _code: Callable[[Path], str] = field(default_factory=lambda: functools.cache(code_digest))

    def tell(self, release: str, section: Section, name: str) -> None:
        """Say what the claims of a section are: others that show one are kept with its name alone."""
        self._claims.update({(release, name, claim.name): claim for claim in section.claims})

    def derived(
        self, place: tuple[str, str, str], code: Path, given: Sequence[str], derive: Callable[[], Derivation]
    ) -> Entry:
        """Return what ``derive``, of the module ``code``, makes, or has made of the same ``given`` before.

        What is given stands there as digests or texts.
        """
        if self.root is None:
            return Entry(place, "", *derive())
        digest = digest_of(*given, self._code(code))
        kept: Entry | None = Cache(self.root).get(".".join(place), digest, self._claims.__getitem__)
        if kept:
            return kept
        entry = Entry(place, digest, *derive())
        self._new.append(entry)
        return entry

    def value(self, name: str, code: Path, given: Sequence[str], make: Callable[[], Any]) -> Any:
        """Return anything else, which ``make`` makes of what is given alone."""
        if self.root is None:
            return make()
        own = digest_of(*given, self._code(code))
        kept = Cache(self.root).get(name, own)
        if kept is None:
            kept = (make(),)  # which may be None
            Cache(self.root).put(name, own, kept)
        return kept[0]

    @property
    def figures(self) -> dict[tuple[str, str], Figure]:
        """The figures of what is to be kept, by release and id, whether a page shows them or not."""
        return {place: figure for entry in self._new for place, figure in entry.figures.items()}

    def keep(self, pictures: Mapping[tuple[str, str], Pictures]) -> None:
        """Keep what was derived and all of whose figures are among ``pictures``, by release and id of the figure."""
        if self.root is None:
            return
        names = {id(claim): name for name, claim in self._claims.items()}
        for entry in self._new:
            if all(place in pictures or not figure.is_there for place, figure in entry.figures.items()):
                drawn = dict(zip(entry.section.figures, map(pictures.get, entry.figures), strict=True))
                kept = replace(entry, section=entry.section.kept(drawn))
                Cache(self.root).put(".".join(entry.place), entry.digest, kept, lambda thing: names.get(id(thing)))
        self._new.clear()
