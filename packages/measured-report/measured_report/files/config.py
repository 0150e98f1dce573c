"""What ``report.toml`` says: all that has to be known of a report besides its rooms."""

import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from measured_report import ROOT, ReportError

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

FILE = "report.toml"


@dataclass(frozen=True)
class Config:
    """The fields of ``report.toml``, as they are without it."""

    packages: tuple[str, ...] = ()
    """Whose versions are part of what a record depends on; the first is the one whose releases are editions."""
    host: str = "measured_report.measuring.host"
    """The module that says how this report measures on a host; the one named here says what it may have."""


@cache
def config(root: Path = ROOT) -> Config:
    """ReportError, one line, where the file is not whole."""
    path = root / FILE
    try:
        fields = tomllib.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
        return Config(**{name: tuple(value) if isinstance(value, list) else value for name, value in fields.items()})
    except (OSError, ValueError, TypeError) as error:
        raise ReportError(f"{FILE}: {' '.join(str(error).split())}") from None
