"""Cache derived values, which are valid while their inputs stay the same."""

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
    """Cache the results of a report's modules, and read each entry from disk only once."""

    report: Report
    read: dict[tuple[str, str], Any] = field(default_factory=dict)
    code: Callable[[Path, Path], Code] = field(
        default_factory=lambda: functools.cache(Code)
    )
    digests: dict[Path | None, str] = field(default_factory=dict)  # of modules

    def get(self, name: str, key: str) -> Any:
        """Return an entry, or None if there is no complete one."""
        if not self.read.get((name, key)):
            self.read[name, key] = super().get(name, key)
        return self.read[name, key]

    def key(self, code: Path | None, inputs: Sequence[str]) -> str:
        """Return a digest of a module's inputs and code.

        Without a module, it is a digest of the generator's code.
        """
        if code not in self.digests:
            self.digests[code] = self._digest_of(code)
        return digest_of([*inputs, self.digests[code]])

    def _digest_of(self, module: Path | None) -> str:
        """Return a digest of a module, its imports, the files they name, and packages."""
        root = self.report.root
        if module:
            parents = (path for path in module.parents if (path / "report").is_dir())
            root = next(parents, root)
        code = self.code(root, self.report.root)
        own_file = Path(__file__).resolve()
        # Sections do not import the modules that evaluate replicas, but depend on them.
        starts = filter(None, (own_file, own_file.with_name("replicas.py"), module))
        digests = code.digests(map(str, starts), self.report.root)
        # Modules do not import report.toml, which describes the columns.
        paths = [self.report.root / name for name in self.report.settings.sources]
        other_digests = [
            code.digest(path) for path in (macros.FILE, *paths) if path.is_file()
        ]
        return digest_of([installed(), digests, other_digests])

    def value(
        self,
        name: str,
        code: Path | None,
        inputs: Sequence[str],
        make: Callable[[], Any],
    ) -> Any:
        """Return the result of ``make``, a function of the module ``code``, for inputs.

        Without a module it is a function of the generator.
        """
        key = self.key(code, inputs)
        if (entry := self.get(name, key)) is None:
            entry = (make(),)  # a tuple, because the result may be None
            self.put(name, key, entry)
        return entry[0]


@functools.cache
def installed() -> str:
    """Return a digest of the versions of Python and of the packages that results depend
    on.
    """
    versions = (f"{name} {metadata.version(name)}" for name in PACKAGES)
    return digest_of([python_version(), *versions])
