"""Print this help."""

from collections.abc import Mapping
from importlib import import_module

from measured_report.commands.command_line import commands, help_of, options_of
from measured_report.commands.options import Arguments
from measured_report.editions.project import Project
from measured_report.files.config import Report


def run(project: Project, arguments: Arguments) -> int:
    lines, texts = helps(project.report)
    for name, text in lines.items():
        print(f"make {name:9} {text}")
    print()
    for name, text in texts.items():
        print(f"{f'{name}=':10} {text}")
    return 0


def helps(report: Report) -> tuple[Mapping[str, str], Mapping[str, str]]:
    """Return the help of each command with its options, and that of each option."""
    lines = {}
    texts: dict[str, str] = {}
    for name, path in commands(report.root).items():
        module = import_module(path)
        options = {**options_of(module, report.settings)}
        if not report.settings.needs_device:
            options.pop("DEVICE", None)
        names = f" [{' '.join(options)}]" if options else ""
        lines[name] = f"{help_of(module)}{names}"
        texts |= {variable: option["help"] for variable, option in options.items()}
    texts["PYTHON"] = "a Python with all packages installed, for a host without network"
    return lines, texts
