"""The command line: finds the commands, hands one what was typed, and ends as it did.

A command is a module here or in a report's ``report/commands/`` that has ``run(project, arguments)``, and may have
``OPTIONS``, as ``add_argument`` takes them. The first line of its docstring is its help.
"""

import argparse
import os
import re
import signal
import sys
from collections.abc import Iterator, Mapping
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any, NoReturn

from measured_report.editions.project import Project, own_release
from measured_report.editions.release import release_of
from measured_report.files.config import Config, Report
from measured_report.files.config import report as current
from measured_report.files.errors import (
    UNPRINTABLE,
    ReportError,
    UsageError,
    suggestion,
    without_secrets,
)
from measured_report.records.code import cached_sources

OWN = (
    "report.commands"  # the package of a report's own commands, which need not be there
)


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        text = f"{' '.join(message.split()):.300}; see {self.prog} --help"
        if os.environ.get("MAKELEVEL") == "1":
            text = re.sub(
                "--([a-z-]+)",
                lambda flag: f"{flag[1].upper().replace('-', '_')}=",
                text.partition(";")[0],
            )
            text = f"make {self.prog.rpartition(' ')[2]}: {text}; make help says what it takes"
        raise UsageError(text)


def main() -> int:
    """Run the command that was asked for; return its exit status, with one line for whatever can be mended."""
    _open_closed()
    try:
        result = _run(
            *(
                sys.argv[1:]
                if sys.argv[1:] not in ([], ["-h"], ["--help"])
                else ["help"]
            )
        )
        sys.stdout.flush()
        return result
    except KeyboardInterrupt:
        print("stopped; what was measured before is kept", file=sys.stderr)
        return 130
    except OSError as error:
        if not isinstance(
            error, BrokenPipeError
        ):  # else whoever reads the output, as head, has enough of it
            _say(
                f"{error.filename or 'the output cannot be written'}: {error.strerror or error}"
            )
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        return 1
    except ReportError as error:
        if str(error):  # whoever failed may have said it
            _say(str(error))
        return 2 if isinstance(error, UsageError) else 1


def _open_closed() -> None:
    """Open what was closed of input, output and errors: what is opened next would get what is printed."""
    while (free := os.open(os.devnull, os.O_RDWR)) <= 2:
        os.set_inheritable(free, True)
        setattr(
            sys,
            ("stdin", "stdout", "stderr")[free],
            os.fdopen(free, "w" if free else "r"),
        )
    os.close(free)


def _run(name: str, *typed: str) -> int:
    report = current()
    names = commands(report.root)
    if name not in names:
        raise UsageError(
            f"{name} is no command{suggestion(name, names)}; use one of: {', '.join(names)}"
        )
    module = import_module(names[name])
    parser = Parser(
        prog=f"build.py {name}", description=help_of(module), allow_abbrev=False
    )
    parser.set_defaults(edition="", pins="", profile="full")
    for option, settings in options_of(module, report.settings).items():
        parser.add_argument(_flag(option), **settings)
    arguments = parser.parse_args([*_typed(module, report), *typed])
    release = own_release(report=report)
    arguments.release = release_of(
        arguments.edition or release, arguments.pins, report=report
    )
    project = Project(str(arguments.release), arguments.profile, report.root, release)
    for stop in (
        signal.SIGINT,
        signal.SIGTERM,
        signal.SIGALRM,
    ):  # not while anything is being imported
        signal.signal(stop, signal.default_int_handler)
    sys.unraisablehook = _stop_again
    with cached_sources():
        return int(module.run(project, arguments) or 0)


def _stop_again(ignored: Any) -> None:
    """Let a Ctrl-C come again that Python passes over, as it does in a fork."""
    if ignored.exc_type is KeyboardInterrupt:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
    else:
        sys.__unraisablehook__(ignored)


def commands(root: Path) -> dict[str, str]:
    """Find the module of each command by its name, the generator's first; none is imported, which takes long."""
    folders = {__package__: Path(__file__).parent, OWN: root.joinpath(*OWN.split("."))}
    modules = (
        (package, path)
        for package, folder in folders.items()
        for path in sorted(folder.glob("*.py"))
    )
    return {
        path.stem: f"{package}.{path.stem}"
        for package, path in modules
        if b"\ndef run(" in path.read_bytes()
    }


def help_of(module: ModuleType) -> str:
    return (module.__doc__ or "").partition("\n")[0].rstrip(".")


def options_of(module: ModuleType, settings: Config) -> Mapping[str, Mapping[str, Any]]:
    """Return a command's options by the variables of make that set them."""
    options = getattr(module, "OPTIONS", {})
    return {
        settings.option or "EDITION" if name == "edition" else name.upper(): options[
            name
        ]
        for name in options
    }


def _flag(variable: str) -> str:
    return f"--{variable.lower().replace('_', '-')}"


def _typed(module: ModuleType, report: Report) -> Iterator[str]:
    """Yield the options that were typed as variables of make; UsageError for one that no command has."""
    # Taken out, since programs that are started from here, as the tests, are no part of what make was asked for.
    typed = variables_of(os.environ.pop("TYPED", ""))
    options = options_of(module, report.settings)
    if os.environ.get("MAKELEVEL") == "1" and typed.keys() - options:
        modules = map(import_module, commands(report.root).values())
        variables = {
            name for command in modules for name in options_of(command, report.settings)
        }
        for name in sorted(typed.keys() - variables):
            raise UsageError(
                f"{name}= is no variable of make here{suggestion(name.upper(), variables)}; see make help"
            )
    for name, value in typed.items():
        if name in options and value:
            is_switch, option = "action" in options[name], _flag(name)
            if is_switch and value != "1":
                raise UsageError(
                    f"a switch is on as {name}=1 or left out, not {name}={value}"
                )
            yield option if is_switch else f"{option}={value}"


def variables_of(typed: str) -> dict[str, str]:
    """Return the values of variables that make was called with, but for those that are make's own to read."""
    words = re.findall(
        r"(?:\\.|[^\\ \t])+", typed
    )  # make writes a backslash before blanks and itself, and $ twice
    plain = (re.sub(r"\\(.)", r"\1", word).replace("$$", "$") for word in words)
    values = dict(re.split(":?=", word, maxsplit=1) for word in plain)
    return {
        name: value
        for name, value in values.items()
        if name not in ("SHELL", "MAKEFLAGS", "PYTHON")
    }


def _say(text: str) -> None:
    print(
        UNPRINTABLE.sub("?", " ".join(without_secrets(text).split())), file=sys.stderr
    )
