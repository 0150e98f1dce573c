"""A cache of what sections make of their results, their figures drawn, as long as all that it was made from is so."""

import functools
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
from measured_report.records.code import Code, digest_of
from measured_report.values.quantities import Value

PACKAGES = ("numpy", "pandas", "matplotlib", "jinja2", "markupsafe", "markdown", "msgspec")
Key = tuple[str, str, str]  # profile, release and section


class Derivation(NamedTuple):
    """Hold a section without its words, the values that were derived for it, and the digest of all that made them."""

    section: Section
    values: Mapping[str, Value]
    digest: str = ""


@dataclass(frozen=True)
class DerivedCache:
    """Keep what sections of the project at ``root`` make; without one nothing is kept."""

    root: Path | None = None
    _new: dict[Key, Derivation] = field(default_factory=dict)
    code: Callable[[Path], str] = field(default_factory=lambda: code_digests())

    def derived(self, key: Key, code: Path, inputs: Sequence[str], derive: Callable[[], Derivation]) -> Derivation:
        """Return what ``derive``, of the module ``code``, makes, or has made of the same ``inputs`` before."""
        if self.root is None:
            return derive()
        digest = digest_of([*inputs, self.code(code)])
        if cached := Cache(self.root).get(".".join(key), digest):
            return cached
        section, values, _ = derive()
        tables = {name: item.rendered() if isinstance(item, Table) else item for name, item in section.tables.items()}
        self._new[key] = derivation = Derivation(replace(section, tables=tables), values, digest)
        return derivation

    def value(self, name: str, code: Path, inputs: Sequence[str], make: Callable[[], Any]) -> Any:
        """Return anything else, which ``make`` makes of the ``inputs`` alone."""
        if self.root is None:
            return make()
        digest = digest_of([*inputs, self.code(code)])
        if (cached := Cache(self.root).get(name, digest)) is None:
            cached = (make(),)  # which may be None
            Cache(self.root).put(name, digest, cached)
        return cached[0]

    @property
    def figures(self) -> dict[tuple[str, str], Figure]:
        """Collect the figures of what is to be kept, by release and id, whether a page shows them or not."""
        return {
            (release, f"{section}-{name}"): replace(figure, anchor=f"{section}-{name}")
            for (_, release, section), derivation in self._new.items()
            for name, figure in derivation.section.figures.items()
        }

    def keep(self, pictures: Mapping[tuple[str, str], Pictures]) -> None:
        """Keep what was derived, its figures drawn as ``pictures`` by release and id."""
        if self.root is None:
            return
        for key, (section, values, digest) in self._new.items():
            ids = {name: (key[1], f"{key[2]}-{name}") for name in section.figures}
            figures = {name: figure.rendered(pictures.get(ids[name])) for name, figure in section.figures.items()}
            Cache(self.root).put(".".join(key), digest, Derivation(replace(section, figures=figures), values, digest))
        self._new.clear()


def code_digests() -> Callable[[Path], str]:
    """Return what digests the code of a module, once, by files as they are when they are first read."""
    known = functools.cache(Code)

    @functools.cache
    def code_digest(module: Path) -> str:
        """Digest what decides what a module makes: packages, what it and this room import, and the files named."""
        root = next(folder for folder in module.parents if (folder / "report").is_dir())
        code = known(root, report().root)
        closure = {file for start in (Path(__file__).resolve(), module) for file in code.closure(str(start))}
        sources = {code.name_of(file): code.source(file) for file in closure}
        # What says what columns are is imported by nobody.
        named = {name for source in sources.values() for name in source.assets} | set(config().sources)
        paths = {name: report().root / name for name in named} | {macros.FILE.name: macros.FILE}
        digests = {name: code.digest(path) for name, path in paths.items() if path.is_file()}
        digests |= {name: source.digest for name, source in sources.items()}
        return digest_of([installed(), digests])

    return code_digest


@functools.cache
def installed() -> str:
    """Digest what is installed, as far as it decides what is made."""
    return digest_of([python_version(), *(f"{name} {metadata.version(name)}" for name in PACKAGES)])
