"""Print this."""

from importlib import import_module

from measured_report.commands.command_line import commands, help_of, options_of
from measured_report.commands.options import Arguments
from measured_report.editions.project import Project
from measured_report.files.config import config


def run(project: Project, arguments: Arguments) -> int:
    said: dict[str, str] = {}
    for name, module in ((name, import_module(place)) for name, place in commands().items()):
        told = options_of(module).items()
        options = {each: option for each, option in told if each != "DEVICE" or config().needs_gpu}
        print(f"make {name:9} {help_of(module)}" + (f" [{' '.join(options)}]" if options else ""))
        said |= {variable: option["help"] for variable, option in options.items()}
    print()
    for name, text in {**said, "PYTHON": "a Python that has everything already, on a host without network"}.items():
        print(f"{f'{name}=':10} {text}")
    return 0
