"""Run the tests, which do not need an accelerator."""

import subprocess

from measured_report.commands.options import Arguments, shared
from measured_report.editions.environment import add_group, python_of
from measured_report.editions.project import Project
from measured_report.editions.status import expected_packages

FAST = {
    "action": "store_true",
    "help": "1: run only the tests that a change of texts or figures can break",
}
OPTIONS = {**shared("edition"), "fast": FAST}


def run(project: Project, arguments: Arguments) -> int:
    python = python_of(arguments.release, expected_packages(project), project.root)
    add_group("dev", project.root, python)
    command = [
        str(python),
        "-m",
        "pytest",
        *(["-m", "words and not slow"] if arguments.fast else []),
    ]
    return subprocess.run(command, cwd=project.root, check=False).returncode
