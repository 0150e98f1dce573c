"""Print this."""

import argparse

from measured_report.commands.command_line import commands, help_of, options_of, parser_of, short_name
from measured_report.editions.project import Project


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Print all commands with the variables that each takes, and what each variable is."""
    said: dict[str, str] = {}
    for module in commands():
        options = options_of(parser_of(module))
        print(f"make {short_name(module):9} {help_of(module)}" + (f" [{' '.join(options)}]" if options else ""))
        said |= {name: action.help or "" for name, action in options.items()}
    print()
    for name, text in said.items():
        print(f"{f'{name}=':10} {text}")
    print(f"{'PYTHON=':10} a Python that has everything already, on a host without network")
    return 0
