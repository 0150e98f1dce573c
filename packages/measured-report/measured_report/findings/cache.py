"""The cache of what is derived: an entry counts while all that it was made from is the same."""

import functools
import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from importlib import metadata
from pathlib import Path
from platform import python_version
from typing import Any

from measured_report.files.cache import Cache
from measured_report.files.config import Report
from measured_report.parts import macros
from measured_report.records.code import files, roots_of
from measured_report.records.syntax import digest_of

PACKAGES = (
    "numpy",
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
    digests: dict[Path, str] = field(default_factory=dict)  # of code

    def get(self, name: str, key: str) -> Any:
        if (name, key) not in self.read:
            if (kept := super().get(name, key)) is None:
                return None
            self.read[name, key] = kept
        return self.read[name, key]

    def key(self, code: Path, inputs: Sequence[str]) -> str:
        """Digest all that the module ``code`` makes something from."""
        if code not in self.digests:
            self.digests[code] = code_digest(code, self.report)
        return digest_of([*inputs, self.digests[code]])

    def value(
        self, name: str, code: Path, inputs: Sequence[str], make: Callable[[], Any]
    ) -> Any:
        """Return what ``make``, of the module ``code``, makes of the ``inputs``."""
        key = self.key(code, inputs)
        if (kept := self.get(name, key)) is None:
            kept = (make(),)  # which may be None
            self.put(name, key, kept)
        return kept[0]


def code_digest(code: Path, report: Report) -> str:
    """Digest a module with all that it imports, the files that they name, and packages."""
    root = next(folder for folder in code.parents if (folder / "report").is_dir())
    roots = [*roots_of(root), *roots_of(report.root)]
    graph = files().graph(tuple(dict.fromkeys(roots)))
    starts = (Path(__file__).resolve(), code)
    closure = {file for start in starts for file in graph.closure(str(start))}
    sources = {graph.name_of(file): graph.source(file) for file in closure}
    # No module imports the settings, which say what columns are.
    named = {name for source in sources.values() for name in source.assets}
    named.update(report.settings.sources)
    paths = {name: report.root / name for name in named}
    paths[macros.FILE.name] = macros.FILE
    digests = {
        name: hashlib.sha256(path.read_bytes()).hexdigest()
        for name, path in paths.items()
        if path.is_file()
    }
    digests |= {name: source.digest for name, source in sources.items()}
    return digest_of([installed(), digests])


@functools.cache
def installed() -> str:
    """Digest the versions of Python and of the packages that decide what is made."""
    versions = (f"{name} {metadata.version(name)}" for name in PACKAGES)
    return digest_of([python_version(), *versions])
