"""Print this."""

from importlib import import_module

from measured_report.commands.command_line import commands, help_of, options_of
from measured_report.commands.options import Arguments
from measured_report.editions.project import Project


def run(project: Project, arguments: Arguments) -> int:
    texts: dict[str, str] = {}
    for name, path in commands(project.root).items():
        options = {**options_of(module := import_module(path), project.settings)}
        if not project.settings.needs_device:
            options.pop("DEVICE", None)
        print(
            f"make {name:9} {help_of(module)}"
            + (f" [{' '.join(options)}]" if options else "")
        )
        texts |= {variable: option["help"] for variable, option in options.items()}
    print()
    for name, text in {
        **texts,
        "PYTHON": "a Python that has everything already, on a host without network",
    }.items():
        print(f"{f'{name}=':10} {text}")
    return 0
