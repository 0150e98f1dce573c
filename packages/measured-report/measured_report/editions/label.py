"""Labels: what an edition is called, after all that was installed and, where several measured it, the machine.

``1.8.0``, ``1.8.0+numpy-2.1.0``, ``1.9.0.dev0+g1a2b3c4`` (a commit), ``1.9.0.dev0+g1a2b3c4.edited``, ``1.8.0@cpu``.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from measured_report.files.config import config

VERSION = re.compile(r"[0-9]{1,4}(?:\.[0-9]{1,6}){1,4}(?:(?:a|b|rc)[0-9]{1,4})?(?:\.(?:post|dev)[0-9]{1,12})?")


@dataclass(frozen=True)
class Label:
    """What an edition is called, in its parts."""

    version: str
    """Version of the package whose releases are editions, with three numbers at least."""
    source: str = ""
    """Which code that is where the version does not say: ``g`` and a commit, ``w`` and the digest of a wheel, ``x`` and
    that of a folder; ``.edited`` behind it for a checkout that differs from its commit."""
    pins: tuple[tuple[str, str], ...] = ()
    """Package and version, of those that were asked for besides."""
    machine: str = ""
    """Where it was measured, when the label without it is of another machine."""

    def __str__(self) -> str:
        pins = (f"+{config().short_names.get(package, package)}-{version}" for package, version in self.pins)
        return self.package_version + "".join(pins) + (f"@{self.machine}" if self.machine else "")

    @property
    def package_version(self) -> str:
        """The version that is installed, with the code that it is of."""
        return f"{self.version}+{self.source}" if self.source else self.version

    @property
    def order(self) -> Any:
        """Sorts by version, as packages are: a development version and a candidate stand before the release."""
        from packaging.version import Version  # which a Python that makes the environment lacks

        return Version(self.version)

    def is_installed_with(self, versions: Mapping[str, str]) -> bool:
        """Whether these versions of packages are the ones that the label names."""
        return versions[config().package] == self.package_version and dict(self.pins).items() <= versions.items()


def read_label(text: str) -> Label | None:
    """The label that a text is; None when it is none. ``1.8`` is 1.8.0."""
    names, version = short_names(), VERSION.pattern
    found = re.fullmatch(
        rf"({version})(?:\+([a-z][0-9a-f]{{7}}(?:\.edited)?))?"
        rf"((?:\+(?:{'|'.join(map(re.escape, names)) or '(?!)'})-{version})*)(?:@([a-z0-9][a-z0-9-]{{0,60}}))?",
        text,
    )
    if not found:
        return None
    version, source, told, machine = found.groups(default="")
    pins = (part.rpartition("-") for part in told.split("+")[1:])
    return Label(full_version(version), source, tuple(sorted((names[name], pin) for name, _, pin in pins)), machine)


@cache
def short_names() -> Mapping[str, str]:
    """Package by its name in a label, of those that may be asked for besides."""
    return {config().short_names.get(package, package): package for package in config().packages[1:]}


def full_version(version: str) -> str:
    """The version with three numbers at least."""
    numbers = re.match(r"[0-9]+(?:\.[0-9]+)*", version)[0]
    return numbers + ".0" * (2 - numbers.count(".")) + version[len(numbers) :]
