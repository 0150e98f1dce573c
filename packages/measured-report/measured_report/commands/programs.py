"""Programs of the report's own that the command line offers as well; ``report.toml`` describes them."""

import argparse
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from measured_report.editions.environment import add_cluster, add_group
from measured_report.editions.project import Project
from measured_report.files.config import FILE, config
from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT


@dataclass(frozen=True)
class Program:
    """A program, run as ``python -m MODULE`` with those of its options that are given."""

    module: str
    help: str
    options: tuple[str, ...] = ()
    needs: str = ""
    """What it takes besides: ``cluster``, or a dependency group of pyproject.toml."""
    state: str = ""
    """``module:function`` that says of a project whether what it makes is fresh."""

    def run(self, project: Project, arguments: argparse.Namespace) -> int:
        """Run it for the release that was asked for; its exit status."""
        if self.needs == "cluster":
            add_tests_cluster(Path(sys.executable), project)
        elif self.needs:
            add_group(self.needs, project.root)
        given = {**vars(arguments), config(project.root).package: project.release}
        options = [f"--{name}={given[name]}" for name in self.options if given[name]]
        return subprocess.run([sys.executable, "-m", self.module, *options], cwd=project.root, check=False).returncode


def programs(root: Path = ROOT) -> Mapping[str, Program]:
    """The programs by the names of their commands; ReportError where one has other fields."""
    try:
        described = config(root).commands.items()
        return {name: Program(**{**each, "options": tuple(each.get("options", ()))}) for name, each in described}
    except TypeError as error:
        raise ReportError(f"{FILE}: commands: {' '.join(str(error).split())}") from None


def add_tests_cluster(python: Path, project: Project) -> None:
    """Install what the tests of clusters take; a Python that is not the project's is left as it is."""
    if python.is_relative_to(project.root):
        add_cluster(python, project.root)
