"""The command line that make calls; ``make help`` says what there is."""

import signal
import sys
from pathlib import Path

signal.signal(signal.SIGINT, signal.SIG_DFL)  # while this is being imported there is nothing to say about a Ctrl-C
HERE = Path(__file__).resolve().parent
PACKAGES = [str(folder) for folder in sorted((HERE / "packages").glob("*"))]
sys.path[:0] = [str(HERE), *PACKAGES]  # the first is what PYTHONSAFEPATH leaves out

import argparse
import io
import os
import subprocess
from collections.abc import Mapping

from measured_report import ReportError, UsageError
from measured_report.commands.building import clips, page, publish, report, rerun, serve, status
from measured_report.commands.editions import bisect, history, newest, retire, upgrade
from measured_report.commands.findings import check, diff, trace, verify
from measured_report.commands.options import OPTIONS, flag
from measured_report.editions.environment import add_cluster, python_of
from measured_report.editions.project import Project, own_release
from measured_report.editions.stack import stack_of
from measured_report.editions.status import expected_packages
from measured_report.files.files import recover
from measured_report.files.suggestion import suggestion
from measured_report.records.code import cached_sources
from measured_report.records.columns import UNPRINTABLE

AGAIN_S = 0.01


def main() -> int:
    os.environ.pop("PYTHONSAFEPATH", None)  # programs that are started from here are modules of this folder
    os.environ["PYTHONPATH"] = os.pathsep.join([*PACKAGES, *filter(None, [os.environ.get("PYTHONPATH")])])
    sys.unraisablehook = interrupt_again
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # closed, it is None
            stream.reconfigure(errors="replace")
    try:
        for stop in (signal.SIGINT, signal.SIGTERM, signal.SIGALRM):
            signal.signal(stop, signal.default_int_handler)
        arguments = _parse_arguments()
        own = own_release()
        arguments.stack = stack_of(arguments.newton.asked if arguments.newton else own, arguments.pins)
        project = Project(str(arguments.stack.label), arguments.profile, own_release=own)
        recover(project.results.parent)
        with cached_sources(project.root):
            result = arguments.run(project, arguments)
        print(end="", flush=True)
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # there is nothing left to stop
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
        if said := " ".join(str(error).split()):  # whoever failed may have said it
            print(UNPRINTABLE.sub("?", said), file=sys.stderr)
        return 2 if isinstance(error, UsageError) else 1


def interrupt_again(unraisable: "sys.UnraisableHookArgs") -> None:
    """Where Python can't raise, as in a callback of an import, it would drop what Ctrl-C raises: that comes again."""
    if isinstance(unraisable.exc_value, KeyboardInterrupt):
        signal.setitimer(signal.ITIMER_REAL, AGAIN_S)
    else:
        sys.__unraisablehook__(unraisable)


def _drop_output() -> None:
    """What could not be written is not tried again at the end."""
    if sys.stdout:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def test(project: Project, arguments: argparse.Namespace) -> int:
    """Run the tests with one release."""
    python = python_of(arguments.stack, expected_packages(project), project.root)
    _add_cluster(python, project)
    chosen = ["-m", "words and not slow"] if arguments.fast else []
    return subprocess.run([python, "-m", "pytest", *chosen], cwd=project.root, check=False).returncode


def worlds(project: Project, arguments: argparse.Namespace) -> int:
    """Build the site of each scenario, and write anew which claims it changes, into tests/worlds/."""
    return subprocess.run([sys.executable, "-m", "tests.worlds"], cwd=project.root, check=False).returncode


def torture(project: Project, arguments: argparse.Namespace) -> int:
    """Kill, fill and damage whatever there is, and write how that went into docs/reliability.md."""
    _add_cluster(Path(sys.executable), project)
    return subprocess.run([sys.executable, "-m", "tests.torture"], cwd=project.root, check=False).returncode


def _add_cluster(python: Path, project: Project) -> None:
    """Install what the tests of clusters take; a Python that is not the project's is left as it is."""
    if python.is_relative_to(project.root):
        add_cluster(python, project.root)


COMMANDS = {
    report: ("newton", "with", "device", "cluster", "profile", "address"),
    page: ("newton", "with", "profile", "address"),
    rerun: ("section", "newton", "with", "device", "cluster", "profile", "address"),
    status: ("newton", "with", "profile"),
    clips: ("newton", "with", "device", "profile"),
    upgrade: ("newton", "with", "since", "device", "profile", "format"),
    bisect: ("claim", "value", "a", "b", "device"),
    history: ("claim", "value", "profile"),
    newest: (),
    retire: ("newton", "with", "address"),
    check: ("newton", "with", "profile", "format", "strict"),
    diff: ("a", "b", "profile", "format", "values"),
    trace: ("value", "newton", "profile"),
    verify: ("newton", "device"),
    publish: ("target",),
    serve: ("port", "newton", "profile"),
    test: ("newton", "with", "fast"),
    worlds: (),
    torture: (),
}
"""What there is to run, and the options that each has."""


class _Parser(argparse.ArgumentParser):
    """One that says in one line what it can't read."""

    def error(self, message: str):
        raise UsageError(f"{' '.join(message.split()):.300}; see {self.prog} --help")


def _parse_arguments() -> argparse.Namespace:
    given = _given_to_make()
    parser = _Parser(prog="build.py", description=__doc__, allow_abbrev=False)
    parser.set_defaults(newton=None, pins="", profile="full")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for run, options in COMMANDS.items():
        command = commands.add_parser(run.__name__, help=run.__doc__, description=run.__doc__, allow_abbrev=False)
        command.set_defaults(run=run)
        for option in options:
            default = {"default": given[option]} if option in given else {}
            command.add_argument(f"--{option}", **{**OPTIONS[option], **default})
    return parser.parse_args()


def _given_to_make() -> Mapping[str, str]:
    """What the variables of make's command line say, as the Makefile passes it on; what makes no sense is refused."""
    # Programs that are started from here, as the tests, are no part of what make was asked for.
    known, unknown = (os.environ.pop(f"MAKE_{names}", "").split() for names in ("KNOWN", "UNKNOWN"))
    given = {name: os.environ.pop(f"MAKE_{name.upper()}", "") for name in OPTIONS}
    for name in unknown:
        raise UsageError(f"{name}= is no variable of make here{suggestion(name.upper(), known)}; see make help")
    given = {name: value for name, value in given.items() if value}
    for name, value in given.items():
        OPTIONS[name].get("type", flag)(value)
    return given


if __name__ == "__main__":
    sys.exit(main())
