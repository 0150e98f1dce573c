"""The command line: which commands there are, the options of each, and how each may end."""

import argparse
import gc
import io
import os
import pkgutil
import signal
import sys
from collections.abc import Callable, Mapping
from functools import partial

from measured_report.commands.options import EDITION, OPTIONS, flag
from measured_report.commands.programs import programs
from measured_report.editions.project import Project, own_release
from measured_report.editions.stack import stack_of
from measured_report.files.atomic import recover
from measured_report.files.errors import ReportError, UsageError
from measured_report.files.suggestion import suggestion
from measured_report.records.code import cached_sources
from measured_report.records.columns import UNPRINTABLE
from measured_report.records.reading import load_record

COMMANDS = {
    "building:report": (EDITION, "with", "device", "cluster", "profile", "address"),
    "building:page": (EDITION, "with", "profile", "address"),
    "building:rerun": ("section", EDITION, "with", "device", "cluster", "profile", "address"),
    "building:status": (EDITION, "with", "profile"),
    "editions:upgrade": (EDITION, "with", "since", "device", "profile", "format"),
    "editions:bisect": ("claim", "value", "a", "b", "device", "yes"),
    "editions:history": ("claim", "value", "profile"),
    "editions:newest": (),
    "editions:retire": (EDITION, "with", "list", "address"),
    "findings:check": (EDITION, "with", "profile", "format", "strict"),
    "findings:diff": ("a", "b", "profile", "format", "values"),
    "findings:trace": ("value", EDITION, "profile"),
    "findings:verify": (EDITION, "device", "lab"),
    "building:publish": ("target",),
    "building:serve": ("port", EDITION, "profile"),
    "building:test": (EDITION, "with", "fast"),
}
"""What there is to run in every report, ``module:function`` beside this one, and the options that each has."""


def main() -> int:
    """Run the command that was asked for; its exit status, with one line for whatever can be mended."""
    sys.unraisablehook = interrupt_again
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # closed, it is None
            stream.reconfigure(errors="replace")
    try:
        for stop in (signal.SIGINT, signal.SIGTERM, signal.SIGALRM):
            signal.signal(stop, signal.default_int_handler)
        arguments = _parse_arguments()
        own = own_release()
        arguments.stack = stack_of(arguments.edition.asked if arguments.edition else own, arguments.pins)
        project = Project(str(arguments.stack.label), arguments.profile, own_release=own)
        damaged = recover(project.results.parent, load_record)
        for line in damaged:
            _say(line)
        with cached_sources(project.root):
            result = arguments.run(project, arguments) or int(bool(damaged))
        print(end="", flush=True)
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # there is nothing left to stop
        gc.freeze()  # nor to be looked for before the process ends, which takes a third of a second after a build
        return result
    except BrokenPipeError:  # whoever reads the output, as head, has enough of it
        _drop_output()
        return 1
    except (KeyboardInterrupt, RuntimeError) as error:
        # Python before 3.12 makes the latter of the former while it makes a class.
        if not any(isinstance(each, KeyboardInterrupt) for each in (error, error.__cause__)):
            raise
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


def interrupt_again(unraisable: "sys.UnraisableHookArgs") -> None:
    """Raise Ctrl-C a moment later where Python can't, as in a callback of an import, and would drop it."""
    if isinstance(unraisable.exc_value, KeyboardInterrupt):
        signal.setitimer(signal.ITIMER_REAL, 0.01)
    else:
        sys.__unraisablehook__(unraisable)


def _say(text: str) -> None:
    """Say in one line, without what moves a terminal, what is wrong."""
    print(UNPRINTABLE.sub("?", " ".join(text.split())), file=sys.stderr)


def _drop_output() -> None:
    if sys.stdout:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


class _Parser(argparse.ArgumentParser):
    """One that says in one line what it can't read."""

    def error(self, message: str):
        raise UsageError(f"{' '.join(message.split()):.300}; see {self.prog} --help")


def _parse_arguments() -> argparse.Namespace:
    given = _given_to_make()
    parser = _Parser(prog="build.py", description="What make calls; make help says what there is.", allow_abbrev=False)
    parser.set_defaults(edition=None, pins="", profile="full")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    known: list[tuple[str, Callable[..., int], str, tuple[str, ...]]]
    known = [(place.partition(":")[2], partial(_run, place), "", options) for place, options in COMMANDS.items()]
    known += [(name, program.run, program.help, program.options) for name, program in programs().items()]
    for name, run, said, options in known:
        command = commands.add_parser(name, help=said, description=said, allow_abbrev=False)
        command.set_defaults(run=run)
        for option in options:
            default = {"default": given[option]} if option in given else {}
            command.add_argument(f"--{option}", **{**OPTIONS[option], **default})
    return parser.parse_args()


def _run(place: str, project: Project, arguments: argparse.Namespace) -> int:
    """Run a command, and import what it alone needs."""
    return pkgutil.resolve_name(f"measured_report.commands.{place}")(project, arguments)


def _given_to_make() -> Mapping[str, str]:
    """Read what the variables of make's command line say, as the Makefile passes it on; refuse what makes no sense."""
    # Programs that are started from here, as the tests, are no part of what make was asked for.
    known, unknown = (os.environ.pop(f"MAKE_{names}", "").split() for names in ("KNOWN", "UNKNOWN"))
    given = {name: os.environ.pop(f"MAKE_{name.upper()}", "") for name in OPTIONS}
    for name in unknown:
        raise UsageError(f"{name}= is no variable of make here{suggestion(name.upper(), known)}; see make help")
    given = {name: value for name, value in given.items() if value}
    for name, value in given.items():
        OPTIONS[name].get("type", flag)(value)
    return given
