"""Find the commands, run one with its options, and return its exit status.

A command is a module in this folder or in ``report/commands/`` of a report. It has a
function ``run(project, arguments)`` and may have ``OPTIONS``, the keywords of
``add_argument`` by option. The first line of its docstring is its help text.
"""

import argparse
import os
import re
import signal
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any, NoReturn

from measured_report.editions.project import Project, own_release
from measured_report.editions.release import release_of
from measured_report.files.config import Config, Report
from measured_report.files.config import report as current
from measured_report.files.errors import (
    ReportError,
    UsageError,
    print_line,
    suggestion,
)
from measured_report.records.code import cached_sources

NO_MEMORY = "there is not enough memory"
OLDEST = 946_684_800  # seconds from 1970 to 2000
OWN = "report.commands"  # the package of the commands that a report defines itself


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        text = f"{' '.join(message.split()):.300}"
        if os.environ.get("MAKELEVEL") == "1":
            name = self.prog.rpartition(" ")[2]
            text = re.sub("--[a-z-]+", _variable_of_flag, text)
            raise UsageError(f"make {name}: {text} (see make help)")
        raise UsageError(f"{text} (see {self.prog} --help)")


def main() -> int:
    """Run the command given on the command line and return its exit status."""
    is_help = sys.argv[1:] in ([], ["-h"], ["--help"])
    return status_of(partial(_run, *(["help"] if is_help else sys.argv[1:])))


def status_of(run: Callable[[], int]) -> int:
    """Run a command and return its exit status.

    Print an error that the user can fix as one line.
    """
    try:
        if time.time() < OLDEST:
            raise UsageError(
                "the clock of this machine shows a time before 2000: set it, because "
                "every record would be from the future"
            )
        status = run()
        sys.stdout.flush()
        return status
    except KeyboardInterrupt:
        print("stopped: measurements that were completed are kept", file=sys.stderr)
        return 130
    except MemoryError as error:
        print_line(f"{str(error) or NO_MEMORY}: close other programs")
        return 1
    except UnicodeEncodeError as error:
        print_line(
            f"{error.object[:200]} cannot be written as {error.encoding}: rename the "
            "file or folder, or use a locale with UTF-8"
        )
        return 1
    except OSError as error:
        # A program that reads the output, such as head, may close it early.
        if not isinstance(error, BrokenPipeError):
            subject = error.filename or "the output cannot be written"
            print_line(f"{subject}: {error.strerror or error}")
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        return 1
    except ReportError as error:
        if str(error):  # the text is empty if the message was printed already
            print_line(str(error))
        return 2 if isinstance(error, UsageError) else 1


def _run(name: str, *typed: str) -> int:
    report = current()
    names = commands(report.root)
    if name not in names:
        raise UsageError(
            f"{name} is not a command{suggestion(name, names)}: use one of "
            f"{', '.join(names)}"
        )
    module = import_module(names[name])
    prog = f"build.py {name}"
    parser = Parser(prog=prog, description=help_of(module), allow_abbrev=False)
    parser.set_defaults(edition="", pins="", profile="full")
    for option, settings in options_of(module, report.settings).items():
        parser.add_argument(_flag(option), **settings)
    arguments = parser.parse_args([*_of_make(module, report), *typed])
    own = own_release(report=report)
    edition = arguments.edition or own
    arguments.release = release_of(edition, arguments.pins, report=report)
    project = Project(str(arguments.release), arguments.profile, report.root, own)
    # The imports, which may take seconds, are done. From here on, Ctrl-C prints a
    # message.
    for stop in (signal.SIGINT, signal.SIGTERM):
        signal.signal(stop, signal.default_int_handler)
    with cached_sources():
        return int(module.run(project, arguments) or 0)


def commands(root: Path) -> dict[str, str]:
    """Return the module of each command by name, the generator's commands first.

    The modules are not imported, because this takes a long time.
    """
    folders = {__package__: Path(__file__).parent, OWN: root.joinpath(*OWN.split("."))}
    names = {}
    for package, folder in folders.items():
        for path in sorted(folder.glob("*.py")):
            if b"\ndef run(" in path.read_bytes():
                names[path.stem] = f"{package}.{path.stem}"
    return names


def help_of(module: ModuleType) -> str:
    return (module.__doc__ or "").partition("\n")[0].rstrip(".")


def options_of(module: ModuleType, settings: Config) -> Mapping[str, Mapping[str, Any]]:
    """Return the options of a command by the make variables that set them."""
    options = {}
    for name, option in getattr(module, "OPTIONS", {}).items():
        is_edition = name == "edition" and settings.option
        options[settings.option if is_edition else variable_of(name)] = option
    return options


def variable_of(option: str) -> str:
    return option.upper().replace("-", "_")


def _variable_of_flag(flag: re.Match[str]) -> str:
    return f"{variable_of(flag[0].removeprefix('--'))}="


def _flag(variable: str) -> str:
    return f"--{variable.lower().replace('_', '-')}"


def _of_make(module: ModuleType, report: Report) -> Iterator[str]:
    """Yield the options that were given as variables of make.

    Raise UsageError for a variable that is not an option of the command, or, if make has
    several goals, of any command.
    """
    # Remove TYPED from the environment, so that programs started from here, such as the
    # tests, do not read these options as their own.
    typed = variables_of(os.environ.pop("TYPED", ""))
    options = options_of(module, report.settings)
    unknown = typed.keys() - options
    if unknown and os.environ.get("MAKELEVEL") == "1":
        variables = {*options}
        # A test of make test may run another command, with variables of its own.
        goal = module.__name__.rpartition(".")[2]
        is_only_goal = os.environ.get("GOALS", "").split() == [goal]
        for command in commands(report.root).values():
            variables |= {*options_of(import_module(command), report.settings)}
        for name in sorted(unknown - variables):
            similar = suggestion(name.upper(), variables)
            raise UsageError(
                f"{name}= is not a variable of make here{similar}: see make help"
            )
        if is_only_goal:
            raise UsageError(
                f"make {goal} does not take {min(unknown)}=: leave it out, or see "
                "make help"
            )
    for name, value in typed.items():
        if name not in options or not value:
            continue
        if "action" not in options[name]:
            yield f"{_flag(name)}={value}"
        elif value == "1":
            yield _flag(name)
        else:
            raise UsageError(
                f"{name}={value} is not a valid switch: use {name}=1 or leave it out"
            )


def variables_of(typed: str) -> dict[str, str]:
    """Return the variables given to make, except those that make uses itself."""
    values = {}
    # Make writes a backslash before spaces and backslashes, and doubles each $.
    for word in re.findall(r"(?:\\.|[^\\ \t])+", typed):
        plain = re.sub(r"\\(.)", r"\1", word).replace("$$", "$")
        name, value = re.split(":?=", plain, maxsplit=1)
        if name not in ("SHELL", "MAKEFLAGS", "PYTHON"):
            values[name] = value
    return values
