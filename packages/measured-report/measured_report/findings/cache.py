"""A cache of what sections make of their results, their figures drawn, as long as all that it was made from is so."""

import functools
import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib import metadata
from pathlib import Path
from platform import python_version
from typing import Any, NamedTuple

from measured_report.files.cache import Cache
from measured_report.files.config import config, report
from measured_report.parts import macros
from measured_report.parts.section import Figure, Pictures, Section, Table
from measured_report.records.code import files, roots_of
from measured_report.records.syntax import digest_of
from measured_report.values.quantities import Value

PACKAGES = ("numpy", "pandas", "matplotlib", "markupsafe")
Derivation = tuple[Section, Mapping[str, Value]]  # a section without its words, and the values that were derived for it
Place = tuple[str, str, str]


class Entry(NamedTuple):
    """Hold a section, kept from before or derived now, with the digest of all that it was made from."""

    digest: str
    section: Section
    values: Mapping[str, Value]


@dataclass(frozen=True)
class DerivedCache:
    """Keep what sections of the project at ``root`` make; without one nothing is kept."""

    root: Path | None = None
    _new: dict[Place, Entry] = field(default_factory=dict)
    code: Callable[[Path], str] = field(default_factory=lambda: functools.cache(code_digest))

    def derived(self, place: Place, code: Path, given: Sequence[str], derive: Callable[[], Derivation]) -> Entry:
        """Return what ``derive``, of the module ``code``, makes, or has made of the same ``given`` texts before."""
        if self.root is None:
            return Entry("", *derive())
        digest = digest_of([*given, self.code(code)])
        if entry := Cache(self.root).get(".".join(place), digest):
            return entry
        section, values = derive()
        tables = {name: each.rendered() if isinstance(each, Table) else each for name, each in section.tables.items()}
        self._new[place] = entry = Entry(digest, replace(section, tables=tables), values)
        return entry

    def value(self, name: str, code: Path, given: Sequence[str], make: Callable[[], Any]) -> Any:
        """Return anything else, which ``make`` makes of what is given alone."""
        if self.root is None:
            return make()
        own = digest_of([*given, self.code(code)])
        kept = Cache(self.root).get(name, own)
        if kept is None:
            kept = (make(),)  # which may be None
            Cache(self.root).put(name, own, kept)
        return kept[0]

    @property
    def figures(self) -> dict[tuple[str, str], Figure]:
        """Collect the figures of what is to be kept, by release and id, whether a page shows them or not."""
        return {
            (release, f"{section}-{name}"): replace(figure, anchor=f"{section}-{name}")
            for (_, release, section), entry in self._new.items()
            for name, figure in entry.section.figures.items()
        }

    def keep(self, pictures: Mapping[tuple[str, str], Pictures]) -> None:
        """Keep what was derived, its figures drawn as ``pictures`` by release and id."""
        if self.root is None:
            return
        for place, entry in self._new.items():
            (_, release, section), figures = place, entry.section.figures
            drawn = {
                name: each.rendered(pictures.get((release, f"{section}-{name}"))) for name, each in figures.items()
            }
            kept = entry._replace(section=replace(entry.section, figures=drawn))
            Cache(self.root).put(".".join(place), entry.digest, kept)
        self._new.clear()


def code_digest(code: Path) -> str:
    """Digest what decides what a module makes: what is installed, what it and this room import, and the files named."""
    root = next(folder for folder in code.parents if (folder / "report").is_dir())
    graph = files().graph(tuple(dict.fromkeys([*roots_of(root), *roots_of(report().root)])))
    closure = {file for start in (Path(__file__).resolve(), code) for file in graph.closure(str(start))}
    sources = {graph.name_of(file): graph.source(file) for file in closure}
    # What says what columns are is imported by nobody.
    named = {name for source in sources.values() for name in source.assets} | set(config().sources)
    paths = {name: report().root / name for name in named}
    found = {name: path.read_bytes() for name, path in paths.items() if path.is_file()}
    found[macros.FILE.name] = macros.FILE.read_bytes()
    digests = {name: hashlib.sha256(content).hexdigest() for name, content in found.items()}
    return digest_of([installed(), digests | {name: source.digest for name, source in sources.items()}])


@functools.cache
def installed() -> str:
    """Digest what is installed, as far as it decides what is made."""
    return digest_of([python_version(), *(f"{name} {metadata.version(name)}" for name in PACKAGES)])
