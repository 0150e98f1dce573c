"""Labels: what an edition is called, after all that was installed and, where several measured it, the machine.

``1.8.0``, ``1.8.0+warp-1.19.0``, ``1.9.0.dev0+g1a2b3c4`` (a commit), ``1.9.0.dev0+g1a2b3c4.edited``, ``1.8.0@cpu``.
"""

import re
from dataclasses import dataclass

_VERSION = r"[0-9]{1,4}(?:\.[0-9]{1,6}){1,4}(?:(?:a|b|rc)[0-9]{1,4})?(?:\.(?:post|dev)[0-9]{1,12})?"
_NUMBERS = re.compile(r"[0-9]+")
SHORT = {"warp": "warp-lang", "mujoco-warp": "mujoco-warp", "mujoco": "mujoco"}
"""Package by its name in a label."""
_LABEL = re.compile(
    rf"(?P<version>{_VERSION})(?P<source>\+[a-z][0-9a-f]{{7}}(?:\.edited)?)?"
    rf"(?P<pins>(?:\+(?:{'|'.join(SHORT)})-{_VERSION})*)(?:@(?P<machine>[a-z0-9][a-z0-9-]{{0,60}}))?"
)
VERSION = re.compile(_VERSION)
COMPONENTS = 3


@dataclass(frozen=True)
class Label:
    """What an edition is called, in its parts."""

    version: str
    """Version of Newton, with three numbers at least."""
    source: str = ""
    """Which code that is where the version does not say: ``g`` and a commit, ``w`` and the digest of a wheel, ``x`` and
    that of a folder; ``.edited`` behind it for a checkout that differs from its commit."""
    pins: tuple[tuple[str, str], ...] = ()
    """Package and version, of those that were asked for besides."""
    machine: str = ""
    """Where it was measured, when the label without it is of another machine."""

    def __str__(self) -> str:
        short = {package: name for name, package in SHORT.items()}
        parts = [self.newton, *(f"{short[package]}-{version}" for package, version in self.pins)]
        return "+".join(parts) + (f"@{self.machine}" if self.machine else "")

    @property
    def newton(self) -> str:
        """What is installed of Newton."""
        return f"{self.version}+{self.source}" if self.source else self.version

    @property
    def order(self) -> tuple:
        """By version, a development version and a candidate before the release; then by what else is in it."""
        numbers, *rest = re.split(r"((?:a|b|rc)[0-9]+|\.(?:dev|post)[0-9]+)", self.version, maxsplit=1)
        stage = "".join(rest)
        rank = -1 if stage.startswith(".dev") else 1 if not stage else 2 if stage.startswith(".post") else 0
        return tuple(map(int, numbers.split("."))), rank, tuple(map(int, _NUMBERS.findall(stage)))


def read_label(text: str) -> Label | None:
    """The label that a text is; None when it is none. ``1.8`` is 1.8.0."""
    found = _LABEL.fullmatch(text)
    if not found:
        return None
    pins = [part.rpartition("-")[::2] for part in found["pins"].split("+") if part]
    return Label(
        version=full_version(found["version"]),
        source=(found["source"] or "").removeprefix("+"),
        pins=tuple(sorted((SHORT[name], version) for name, version in pins)),
        machine=found["machine"] or "",
    )


def full_version(version: str) -> str:
    """The version with three numbers at least."""
    numbers = re.match(r"[0-9]+(?:\.[0-9]+)*", version)[0]
    missing = COMPONENTS - len(numbers.split("."))
    return numbers + ".0" * missing + version[len(numbers) :]
