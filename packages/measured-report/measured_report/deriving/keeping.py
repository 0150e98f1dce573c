"""Keeping: what sections make of their results, figures drawn, is kept by all that it was made from.

An entry has what else was read while the section was derived, each with a digest of what that was made from, and counts
as long as these are the same.
"""

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from importlib import metadata
from pathlib import Path
from platform import python_version
from typing import Any

from measured_report import ROOT
from measured_report.claims.claims import Claim
from measured_report.deriving.derived import Reads
from measured_report.files.cache import Cache
from measured_report.files.config import config
from measured_report.parts.parts import Figure, Pictures, Section
from measured_report.records.code import files, roots_of
from measured_report.values.quantities import Value

PACKAGES = ("numpy", "pandas", "matplotlib", "markupsafe")
"""What decides how numbers are computed and figures are drawn."""
FONT = "matplotlib/mpl-data/fonts/ttf/DejaVuSans.ttf"
"""How wide its letters are decides where things stand."""
READ_BY_NAME = config().sources
"""What says what columns are, and nobody imports."""

Derivation = tuple[Section, Mapping[str, Value]]
"""A section without its words, and the values that were derived for it."""


@dataclass(frozen=True)
class Made:
    """A section, kept from before or derived now."""

    place: tuple[str, str, str]
    """Profile, release and section."""
    own: str
    """Digest of its code and of what it was given."""
    reads: Mapping[tuple[str, str], str]
    """Digests of what else it read, by place and name."""
    section: Section
    values: Mapping[str, Value]

    @property
    def digest(self) -> str:
        """Of all that it was made from."""
        return digest_of(self.own, *map(repr, sorted(self.reads.items())))


@dataclass(frozen=True)
class Keeper:
    """What is kept of the project at ``root``; without one nothing is."""

    root: Path | None = None
    _derived: list[Made] = field(default_factory=list)
    """What is to be kept once its figures are drawn."""
    _claims: dict[tuple[str, str, str], Claim] = field(default_factory=dict)
    """Claims with their words, by release, section and name."""
    _codes: dict[Path, str] = field(default_factory=dict)
    """Digests of code, by its module."""

    def tell(self, release: str, section: Section, name: str) -> None:
        """Say what the claims of a section are: others that show one are kept with its name alone."""
        self._claims.update({(release, name, claim.name): claim for claim in section.claims})

    def made(
        self,
        place: tuple[str, str, str],
        code: Path,
        given: Sequence[str],
        reads: Reads,
        make: Callable[[Reads], Derivation],
    ) -> Made:
        """What ``make`` makes, or has made of the same before.

        Args:
            place: Profile, release and section, which it is kept as.
            code: The module that makes it.
            given: Digests, or texts, of what it is given.
            reads: What else it may read.
            make: Derives the section and its values.
        """
        if self.root is None:
            return Made(place, "", {}, *make(reads))
        own = digest_of(*given, *sorted(reads.places), self._code(code))
        kept: Made | None = Cache(self.root).get(".".join(place), own, self._claims.__getitem__)
        if kept and all(reads.digest(*what) == digest for what, digest in kept.reads.items()):
            return kept
        section, values = make(reads)
        reads.is_closed = True
        found = Made(place, own, reads.notes, section, values)
        self._derived.append(found)
        return found

    def value(self, name: str, code: Path, given: Sequence[str], make: Callable[[], Any]) -> Any:
        """The same for anything else, which is made of what is given alone."""
        if self.root is None:
            return make()
        own = digest_of(*given, self._code(code))
        kept = Cache(self.root).get(name, own)
        if kept is None:
            kept = (make(),)  # which may be None
            Cache(self.root).put(name, own, kept)
        return kept[0]

    def _code(self, module: Path) -> str:
        if module not in self._codes:
            self._codes[module] = code_digest(module)
        return self._codes[module]

    def figures(self, release: str, section: str) -> dict[str, Figure]:
        """The figures of a section that is to be kept, by their ids, whether its page shows them or not."""
        found = [made for made in self._derived if made.place[1:] == (release, section)]
        return {anchor: figure for made in found for anchor, figure in _placed(made).items()}

    def keep(self, pictures: Mapping[tuple[str, str], Pictures]) -> None:
        """Keep what was derived and all of whose figures are among ``pictures``, by release and id of the figure."""
        if self.root is None:
            return
        names = {id(claim): name for name, claim in self._claims.items()}
        for made in self._derived:
            drawn = {name: pictures.get((made.place[1], _anchor(made, name))) for name in made.section.figures}
            if all(drawn[name] or not figure.is_there for name, figure in made.section.figures.items()):
                kept = replace(made, section=made.section.kept(drawn))
                Cache(self.root).put(".".join(made.place), made.own, kept, lambda thing: names.get(id(thing)))
        self._derived.clear()


def _placed(made: Made) -> dict[str, Figure]:
    """Its figures, as they are drawn, by their ids."""
    named = {_anchor(made, name): figure for name, figure in made.section.figures.items()}
    return {anchor: replace(figure, anchor=anchor) for anchor, figure in named.items()}


def _anchor(made: Made, figure: str) -> str:
    return f"{made.place[2]}-{figure}"


def digest_of(*texts: str) -> str:
    return hashlib.sha256(repr(texts).encode()).hexdigest()


def code_digest(code: Path) -> str:
    """Of a module, and of all else of the project and of what is installed that decides what it makes."""
    return digest_of(surroundings(), *map(repr, sorted(files_of(code).items())))


def files_of(code: Path) -> dict[str, str]:
    """Digests, by name, of a module, of all that it imports of the project, and of the files that these name."""
    root = next(folder for folder in code.parents if (folder / "report").is_dir())
    graph = files().graph(tuple(dict.fromkeys([*roots_of(root), *roots_of(ROOT)])))
    closure = {*graph.closure(str(Path(__file__).resolve())), *graph.closure(str(code))}
    sources = {graph.name_of(file): graph.source(file) for file in closure}
    named = {name for source in sources.values() for name in source.assets} | set(READ_BY_NAME)
    found = {name: (ROOT / name).read_bytes() for name in named if (ROOT / name).is_file()}
    digests = {name: hashlib.sha256(content).hexdigest() for name, content in found.items()}
    return digests | {name: source.digest for name, source in sources.items()}


@cache
def surroundings() -> str:
    """Digest of what is installed, as far as it decides what is made."""
    font = Path(str(metadata.distribution("matplotlib").locate_file(FONT)))
    versions = [f"{name} {metadata.version(name)}" for name in PACKAGES]
    return digest_of(python_version(), *versions, hashlib.sha256(font.read_bytes()).hexdigest())
