"""The command line: finds the commands, hands one what was typed, and ends as it did.

A command is a module of this folder, or of a report's ``report/commands/``, that has ``run(project, arguments)``. The
first line of its docstring is its help, and ``OPTIONS`` are its options, as ``add_argument`` takes them.
"""

import argparse
import gc
import io
import os
import pkgutil
import signal
import sys
from collections.abc import Iterable, Iterator, Mapping
from importlib import import_module
from pathlib import Path
from types import ModuleType

from measured_report.editions.project import Project, own_release
from measured_report.editions.release import release_of
from measured_report.files.atomic import recover
from measured_report.files.errors import ReportError, UsageError
from measured_report.files.root import ROOT
from measured_report.files.suggestion import suggestion
from measured_report.records.code import cached_sources
from measured_report.records.columns import UNPRINTABLE
from measured_report.records.reading import load_record

OWN = "report.commands"
"""The package of a report's own commands, which need not be there."""
FOLDERS = {__package__: Path(__file__).parent, OWN: ROOT.joinpath(*OWN.split("."))}


class Parser(argparse.ArgumentParser):
    """A parser that says in one line what it can't read."""

    def error(self, message: str):
        raise UsageError(f"{' '.join(message.split()):.300}; see {self.prog} --help")


def main() -> int:
    """Run the command that was asked for; return its exit status, with one line for whatever can be mended."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # closed, it is None
            stream.reconfigure(errors="replace")
    try:
        for stop in (signal.SIGINT, signal.SIGTERM):
            signal.signal(stop, signal.default_int_handler)
        result = _run(*(sys.argv[1:] or ["help"]))
        print(end="", flush=True)
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # there is nothing left to stop
        gc.freeze()  # nor to be looked for before the process ends, which takes a third of a second after a build
        return result
    except BrokenPipeError:  # whoever reads the output, as head, has enough of it
        _drop_output()
        return 1
    except KeyboardInterrupt:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        print("stopped; what was measured before is kept", file=sys.stderr)
        return 130
    except OSError as error:
        _drop_output()
        print(f"{error.filename or 'the output cannot be written'}: {error.strerror or error}", file=sys.stderr)
        return 1
    except ReportError as error:
        if str(error):  # whoever failed may have said it
            _say(str(error))
        return 2 if isinstance(error, UsageError) else 1


def _run(name: str, *given: str) -> int:
    module = _command("help" if name in ("-h", "--help") else name)
    parser = parser_of(module)
    arguments = parser.parse_args([*_typed(parser), *given])
    own = own_release()
    arguments.release = release_of(arguments.edition or own, arguments.pins)
    project = Project(str(arguments.release), arguments.profile, own_release=own)
    damaged = recover(project.results.parent, load_record)
    for line in damaged:
        _say(line)
    with cached_sources(project.root):
        return module.run(project, arguments) or int(bool(damaged))


def _command(name: str) -> ModuleType:
    """Import a command, and not the others, which would take longer; UsageError for what is none."""
    found = (f"{package}.{name}" for package, folder in FOLDERS.items() if (folder / f"{name}.py").is_file())
    module = next((module for module in map(import_module, found) if hasattr(module, "run")), None)
    if not module:
        names = [short_name(each) for each in commands()]
        raise UsageError(f"{name} is no command{suggestion(name, names)}; use one of: {', '.join(names)}")
    return module


def commands(*packages: str) -> list[ModuleType]:
    """Import the commands of some packages; of all, the generator's first, where none is named."""
    found = (
        import_module(f"{package}.{each.name}")
        for package in packages or FOLDERS
        for each in pkgutil.iter_modules([str(FOLDERS[package])])
    )
    return [module for module in found if hasattr(module, "run")]


def short_name(module: ModuleType) -> str:
    """Return what a command is called by."""
    return module.__name__.rpartition(".")[2]


def parser_of(module: ModuleType) -> Parser:
    """Make the parser of a command."""
    parser = Parser(prog=f"build.py {short_name(module)}", description=help_of(module), allow_abbrev=False)
    parser.set_defaults(edition="", pins="", profile="full")
    for name, option in getattr(module, "OPTIONS", {}).items():
        parser.add_argument(f"--{name}", **option)
    return parser


def help_of(module: ModuleType) -> str:
    """Return the first line of a command's docstring."""
    return (module.__doc__ or "").partition("\n")[0].rstrip(".")


def options_of(parser: argparse.ArgumentParser) -> Mapping[str, argparse.Action]:
    """Return a command's options by the variables of make that set them."""
    found = {action.option_strings[-1].lstrip("-").upper().replace("-", "_"): action for action in parser._actions}
    return {name: action for name, action in found.items() if name != "HELP"}


def _typed(parser: argparse.ArgumentParser) -> Iterator[str]:
    """Yield the options that were typed as variables of make; UsageError for one that no command has."""
    # Taken out, since programs that are started from here, as the tests, are no part of what make was asked for.
    names = os.environ.pop("TYPED", "").split()
    typed = {name: os.environ.pop(f"TYPED_{name}", "") for name in names}
    options = options_of(parser)
    if os.environ.get("MAKELEVEL") == "1" and (others := typed.keys() - options):
        _refuse_unknown(others, {name for module in commands() for name in options_of(parser_of(module))})
    for name, action in options.items():
        if value := typed.get(name):
            if action.nargs == 0 and value != "1":
                raise UsageError(f"a switch is on as {name}=1 or left out, not {name}={value}")
            option = action.option_strings[-1]
            yield option if action.nargs == 0 else f"{option}={value}"


def _refuse_unknown(names: Iterable[str], known: Iterable[str]) -> None:
    for name in sorted({*names} - {*known}):
        raise UsageError(f"{name}= is no variable of make here{suggestion(name.upper(), known)}; see make help")


def _say(text: str) -> None:
    """Say in one line, without what moves a terminal, what is wrong."""
    print(UNPRINTABLE.sub("?", " ".join(text.split())), file=sys.stderr)


def _drop_output() -> None:
    if sys.stdout:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
