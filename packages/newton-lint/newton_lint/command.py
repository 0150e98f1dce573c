"""The lint as a program: ``newton-lint TARGET…``, or ``newton-lint prescribe`` and ``newton-lint page``.

See docs/lint.md.
"""

import argparse
import contextlib
import importlib
import os
import sys
import traceback
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NoReturn

CLEAN, FOUND, UNFIT, BROKEN = 0, 1, 2, 3
"""Exit status."""
PROGRAM = "newton-lint"
OTHERS = ("prescribe", "page")
"""Commands besides the lint itself, each a module."""
SEVERITIES = ("note", "warning", "error")


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """Return what was asked for can't be: one line, as for a target that can't be read."""
        self.exit(UNFIT, f"{message}; {PROGRAM} --help says what there is\n")


def main(arguments: Sequence[str] | None = None) -> int:
    given = list(sys.argv[1:] if arguments is None else arguments)
    try:
        if not any(".py:" in each or given[:1] == ["page"] for each in given):
            _import_mujoco_without_windows()
        from newton_lint.target import TargetError

        try:
            if given and given[0] in OTHERS:
                return importlib.import_module(f"newton_lint.{given[0]}").main(given[1:])
            return _linted(parser().parse_args(given))
        except TargetError as error:
            print(error, file=sys.stderr)
            return UNFIT
    except Exception:  # a fault of the lint itself, which Python would end with the status of a finding
        traceback.print_exc()
        return BROKEN


def _import_mujoco_without_windows() -> None:
    """Import MuJoCo without what opens windows, which takes a quarter of the time and which reading needs none of."""
    if "mujoco" in sys.modules or "MUJOCO_GL" in os.environ:
        return
    os.environ["MUJOCO_GL"] = "disable"
    importlib.import_module("mujoco")
    del os.environ["MUJOCO_GL"]


def _linted(given: argparse.Namespace) -> int:
    from newton_lint.output import written
    from newton_lint.report import report_of
    from newton_lint.settings import table_of
    from newton_lint.target import TargetError, found_in, read_target

    table = table_of(Path.cwd())
    asked = asked_of(given, table)
    reports, unread = [], 0
    for target in found_in(given.target):
        try:
            reports.append(report_of(read_target(target), asked))
        except TargetError as error:
            print(error, file=sys.stderr)
            unread += 1
    if reports:
        form = "json" if given.json else given.format or table.get("format", "text")
        with _pipe_may_close():
            print(written(reports, form, given.all))
    if given.fix:
        _fixed(reports)
    if unread:
        return UNFIT
    least = given.fail_on or table.get("fail-on", "warning")
    failed = least != "never" and any(report.worst() >= SEVERITIES.index(least) for report in reports)
    return FOUND if failed else CLEAN


def _fixed(reports: Sequence[Any]) -> None:
    from newton_lint.fix import fix

    for report in reports:
        advised = (finding.advice for finding in report.findings if finding.advice and finding.severity != "note")
        if report.source:
            for line in fix((change for advice in advised for change in advice.changes), report.source):
                print(line, file=sys.stderr)


def asked_of(given: argparse.Namespace, table: dict[str, Any]):
    """Return what is asked for, of the command before the project's table."""
    from newton_lint.prediction import Load
    from newton_lint.report import Asked

    ignore = [*table.get("ignore", []), *(given.ignore.split(",") if given.ignore else [])]
    load = Load(given.acceleration, given.load)
    return Asked(engine_of(given, table), load, work_of(given), given.below or table.get("below"), frozenset(ignore))


def engine_of(given: argparse.Namespace, table: dict[str, Any]):
    from newton_lint.scene import Engine

    return Engine(given.engine or table.get("engine", "mujoco"), given.dt, given.cone, given.impratio)


def work_of(given: argparse.Namespace):
    from newton_lint.settle import SETTLE_S, Work

    return Work(given.hold, given.settle or SETTLE_S, given.turn, given.lift) if given.hold else None


@contextlib.contextmanager
def _pipe_may_close() -> Iterator[None]:
    """Let who reads the output stop before its end, as head does."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # Python flushes once more when it ends


def parser() -> Parser:
    """Make the parser of the lint's own options."""
    about = (
        "Names contact parameters that MuJoCo does not use as they are written, predicts creep, says what to change."
    )
    others = "Also: newton-lint prescribe searches settings for a body that is held, newton-lint page writes a page."
    made = Parser(prog=PROGRAM, description=about, epilog=others)
    add = made.add_argument
    targets = "FILE.xml, FILE.urdf, FILE.usd, a folder, FILE.py:function, or module:function"
    add("target", metavar="TARGET", nargs="+", help=targets)
    add("--format", choices=("text", "json", "sarif", "github"), help="default: text")
    add("--json", action="store_true", help="the same as --format json")
    add("--fail-on", choices=(*SEVERITIES, "never"), help="least severity that ends with status 1; default: warning")
    add("--ignore", metavar="RULES", help="rules that do not count, with commas between")
    add("--all", action="store_true", help="every predicted creep, not the worst five alone")
    add("--fix", action="store_true", help="write the first change of each finding into the files")
    add_work(made)
    add("--load", type=positive, default=0.0, metavar="N", help="tangential force on each contact point")
    add("--acceleration", type=positive, default=0.0, metavar="M/S²", help="ω² r of a support that turns")
    return made


def add_work(made: argparse.ArgumentParser) -> None:
    """Add options of the engine, and of a body that is held."""
    add, own = made.add_argument, "default: what the scene says"
    add("--engine", choices=("mujoco", "warp", "newton"), help="whose rules count; default: mujoco")
    add("--dt", type=positive, metavar="S", help=f"the solver's step; {own}")
    add("--cone", choices=("pyramidal", "elliptic"), help=own)
    add("--impratio", type=positive, metavar="X", help=own)
    add(
        "--hold",
        metavar="BODY",
        help="predict how this body creeps, which the first keyframe or the start has in its grip",
    )
    add("--settle", type=positive, metavar="S", help="time that its grip gets to settle; default: 0.5")
    add("--turn", type=positive, default=0.0, metavar="RAD/S", help="what holds it turns about the vertical")
    add("--lift", type=positive, default=0.0, metavar="M/S²", help="what holds it accelerates upward")
    add("--below", type=positive, metavar="MM/S", help="creep that is not too fast; prescribe's default: 0.1")


def positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0.0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is no positive number")
    return value
