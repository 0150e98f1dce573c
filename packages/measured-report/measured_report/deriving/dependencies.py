"""Dependencies: what a section reads of others while it is derived, and the code and packages that it is derived by."""

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import metadata
from pathlib import Path
from platform import python_version
from typing import Any

from measured_report.deriving.chapters import Releases
from measured_report.deriving.sections import Outline, outline_of
from measured_report.files.config import config
from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT
from measured_report.parts import macros
from measured_report.records.code import files, roots_of

NAMES = "*"  # in the place of a name: all that there are
PACKAGES = ("numpy", "pandas", "matplotlib", "markupsafe")
"""What decides how numbers are computed and figures are drawn."""
FONT = "matplotlib/mpl-data/fonts/ttf/DejaVuSans.ttf"  # how wide its letters are decides where things stand
READ_BY_NAME = config().sources
"""What says what columns are, and nobody imports."""


@dataclass
class Dependencies:
    """What others have that a section may read; what it does read is noted."""

    places: Releases
    """Chapters by place: an edition, or nothing for the own one."""
    notes: dict[tuple[str, str], str] = field(default_factory=dict)
    """Digests of what was read, by place and name."""
    is_closed: bool = False
    """Whether the section is derived: what its figures read has been noted then."""

    def digest(self, place: str, name: str) -> str:
        """Return that of one chapter, which need not be there, or of the names of all."""
        there = self.places.get(place, {})
        if name == NAMES:
            return " ".join(there)
        return there[name].digest if name in there else ""

    def note(self, place: str, name: str) -> None:
        """Note that this was read; ReportError for a figure that reads more than its section did."""
        if self.is_closed and (place, name) not in self.notes:
            what = f"{place} {name}".strip()
            raise ReportError(f"a figure reads {what} only while it is drawn; derive has to read it as well")
        self.notes[place, name] = self.digest(place, name)


@dataclass(frozen=True)
class Tracked(Mapping[str, Any]):
    """The chapters of one place, of which whatever is read is noted; for a ``reader`` the results of those before it.

    What asks for a later one would never find it.
    """

    dependencies: Dependencies
    place: str = ""
    reader: Outline | None = None

    def __getitem__(self, name: str) -> Any:
        if self.reader and outline_of(name).order >= self.reader.order:
            raise ReportError(f"{self.reader.source} reads {name}, which stands after it: give it a higher order")
        self.dependencies.note(self.place, name)
        chapter = self.dependencies.places[self.place][name]
        return chapter.results if self.reader else chapter

    def __iter__(self) -> Iterator[str]:
        self.dependencies.note(self.place, NAMES)
        return iter(self.dependencies.places[self.place])

    def __len__(self) -> int:
        return sum(1 for _ in self)


def digest_of(*texts: str) -> str:
    """Digest texts, told apart."""
    return hashlib.sha256(repr(texts).encode()).hexdigest()


def code_digest(code: Path) -> str:
    """Digest a module, and all else of the project and of what is installed that decides what it makes."""
    return digest_of(installed(), *map(repr, sorted(files_of(code).items())))


def files_of(code: Path) -> dict[str, str]:
    """Digest, by name, a module, what it and this room import of the project, and the files that all these name."""
    root = next(folder for folder in code.parents if (folder / "report").is_dir())
    graph = files().graph(tuple(dict.fromkeys([*roots_of(root), *roots_of(ROOT)])))
    own = Path(__file__).resolve()
    closure = {file for start in (own, own.with_name("cache.py"), code) for file in graph.closure(str(start))}
    sources = {graph.name_of(file): graph.source(file) for file in closure}
    named = {name for source in sources.values() for name in source.assets} | set(READ_BY_NAME)
    found = {name: (ROOT / name).read_bytes() for name in named if (ROOT / name).is_file()}
    found[macros.FILE.name] = macros.FILE.read_bytes()
    digests = {name: hashlib.sha256(content).hexdigest() for name, content in found.items()}
    return digests | {name: source.digest for name, source in sources.items()}


@cache
def installed() -> str:
    """Digest what is installed, as far as it decides what is made."""
    font = Path(str(metadata.distribution("matplotlib").locate_file(FONT))).read_bytes()
    versions = [f"{name} {metadata.version(name)}" for name in PACKAGES]
    return digest_of(python_version(), *versions, hashlib.sha256(font).hexdigest())
