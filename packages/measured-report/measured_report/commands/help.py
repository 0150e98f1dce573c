"""Print this help."""

from importlib import import_module

from measured_report.commands.command_line import commands, help_of, options_of
from measured_report.commands.options import Arguments
from measured_report.editions.project import Project


def run(project: Project, arguments: Arguments) -> int:
    texts: dict[str, str] = {}
    for name, path in commands(project.root).items():
        module = import_module(path)
        options = {**options_of(module, project.settings)}
        if not project.settings.needs_device:
            options.pop("DEVICE", None)
        names = f" [{' '.join(options)}]" if options else ""
        print(f"make {name:9} {help_of(module)}{names}")
        texts |= {variable: option["help"] for variable, option in options.items()}
    texts["PYTHON"] = "a Python with all packages installed, for a host without network"
    print()
    for name, text in texts.items():
        print(f"{f'{name}=':10} {text}")
    return 0
