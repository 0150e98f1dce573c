"""The cache of what is derived: an entry counts while all that it was made from is the same."""

import functools
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from importlib import metadata
from pathlib import Path
from platform import python_version
from typing import Any

from measured_report.files.cache import Cache
from measured_report.files.config import Report
from measured_report.parts import macros
from measured_report.records.code import Code, digest_of

PACKAGES = (
    "numpy",
    "scipy",
    "pandas",
    "matplotlib",
    "jinja2",
    "markupsafe",
    "markdown",
    "msgspec",
)


@dataclass(frozen=True)
class DerivedCache(Cache):
    """Keep what modules of a report make; each entry and each module is read once."""

    report: Report
    read: dict[tuple[str, str], Any] = field(default_factory=dict)
    code: Callable[[Path, Path], Code] = field(
        default_factory=lambda: functools.cache(Code)
    )
    digests: dict[Path, str] = field(default_factory=dict)  # of code

    def get(self, name: str, key: str) -> Any:
        """Return what is kept, read once; None when there is nothing whole."""
        if not self.read.get((name, key)):
            self.read[name, key] = super().get(name, key)
        return self.read[name, key]

    def key(self, code: Path, inputs: Sequence[str]) -> str:
        """Digest all that the module ``code`` makes something from."""
        if code not in self.digests:
            self.digests[code] = self._digest_of(code)
        return digest_of([*inputs, self.digests[code]])

    def _digest_of(self, module: Path) -> str:
        """Digest a module with all that it imports, the files that they name, and packages."""
        root = next(each for each in module.parents if (each / "report").is_dir())
        code = self.code(root, self.report.root)
        starts = (Path(__file__).resolve(), module)
        closure = {file for start in starts for file in code.closure(str(start))}
        sources = {code.name_of(file): code.source(file) for file in closure}
        # No module imports the settings, which say what columns are.
        named = set(self.report.settings.sources)
        named.update(name for source in sources.values() for name in source.assets)
        paths = {name: self.report.root / name for name in named}
        paths[macros.FILE.name] = macros.FILE
        digests = {
            name: code.digest(path) for name, path in paths.items() if path.is_file()
        }
        digests |= {name: source.digest for name, source in sources.items()}
        return digest_of([installed(), digests])

    def value(
        self, name: str, code: Path, inputs: Sequence[str], make: Callable[[], Any]
    ) -> Any:
        """Return what ``make``, of the module ``code``, makes of the ``inputs``."""
        key = self.key(code, inputs)
        if (kept := self.get(name, key)) is None:
            kept = (make(),)  # which may be None
            self.put(name, key, kept)
        return kept[0]


@functools.cache
def installed() -> str:
    """Digest the versions of Python and of the packages that decide what is made."""
    versions = (f"{name} {metadata.version(name)}" for name in PACKAGES)
    return digest_of([python_version(), *versions])
