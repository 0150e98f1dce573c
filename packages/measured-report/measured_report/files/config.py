"""Define the report with its settings, and return the current report."""

import sys
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path
from types import ModuleType
from typing import TypeVar

from measured_report.files import root
from measured_report.files.columns import Schema, case_parameters
from measured_report.files.git import web_address
from measured_report.files.settings import (
    FILE,
    Config,
    Page,
    module_named,
    read_settings,
    read_toml,
    tomllib,
)

__all__ = [
    "FILE",
    "Config",
    "Page",
    "Report",
    "module_named",
    "read_toml",
    "tomllib",
]
ROOMS = ("experiments", "report")
"""The packages that every report defines."""
T = TypeVar("T")


@dataclass(eq=False)
class Report:
    """Describe a report; ``with report:`` makes it the current one.

    All code of this package takes its settings from the current report, and imports the
    modules ``experiments`` and ``report`` of its folder.
    """

    root: Path
    _modules: dict[str, ModuleType] = field(default_factory=dict)
    _path: list[str] = field(default_factory=list)

    @cached_property
    def settings(self) -> Config:
        """Return the settings of ``report.toml``."""
        return read_settings(self.root)

    @cached_property
    def columns(self) -> Schema:
        """Return the schema of the report's columns."""
        return Schema(self.settings, case_parameters(self.settings))

    @cached_property
    def sources(self) -> str:
        """Return the address of the sources on the web.

        It is the one in ``report.toml``, or else git's origin.
        """
        return self.settings.repository or web_address(self.root)

    @cached_property
    def host(self) -> ModuleType:
        """Return the module that measures on a host."""
        return module_named("host", self.settings.host)

    @cached_property
    def accelerator(self) -> ModuleType:
        """Return the module that describes the accelerators of a host."""
        return module_named("accelerator", self.settings.accelerator)

    def __enter__(self) -> "Report":
        self._follow(report())
        _entered.append(self)
        return self

    def __exit__(self, *_: object) -> None:
        exited = _entered.pop()
        report()._follow(exited)

    def _follow(self, former: "Report") -> None:
        """Replace the root and the modules of the former report with those of this
        report. The former report keeps its modules for the next time it is entered.
        """
        if self is former:
            return
        names = [name for name in sys.modules if name.partition(".")[0] in ROOMS]
        former._path = sys.path[:]
        former._modules = {name: sys.modules.pop(name) for name in names}
        # Remove the former root, because a package without an __init__.py would be
        # found there first.
        paths = (path for path in sys.path if Path(path).resolve() != former.root)
        sys.path[:] = self._path or [
            str(self.root),
            *map(str, sorted(self.root.glob("packages/*"))),
            *paths,
        ]
        sys.modules.update(self._modules)
        root.ROOT = self.root


@cache
def report_in(folder: Path) -> Report:
    return Report(folder)


_entered = [report_in(root.ROOT)]


def report() -> Report:
    """Return the current report, at first the one in ``files/root.py``."""
    return _entered[-1]
