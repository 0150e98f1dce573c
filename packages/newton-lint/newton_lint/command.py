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

CLEAN, FOUND, UNFIT, BROKEN, STOPPED = 0, 1, 2, 3, 130
"""Exit status."""
PROGRAM = "newton-lint"
OTHERS = ("prescribe", "page", "pair")
"""Commands besides the lint itself, each a module."""
SEVERITIES = ("note", "warning", "error")


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """Return what was asked for can't be: one line, as for a target that can't be read."""
        self.exit(UNFIT, f"{message}; {PROGRAM} --help says what there is\n")


def main(arguments: Sequence[str] | None = None) -> int:
    given = list(sys.argv[1:] if arguments is None else arguments)
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    try:
        if not any(".py:" in each or given[:1] == ["page"] for each in given):
            _import_mujoco()
        from newton_lint.target import TargetError, mujoco

        mujoco.set_mju_user_warning(lambda _: None)  # which else writes MUJOCO_LOG.TXT where the user stands
        try:
            if given and given[0] in OTHERS:
                return importlib.import_module(f"newton_lint.{given[0]}").main(given[1:])
            return _linted(parser().parse_args(given))
        except TargetError as error:
            print(error, file=sys.stderr)
            return UNFIT
        except OSError as error:  # a full disk, or nobody who reads
            with contextlib.suppress(OSError, ValueError):
                print(f"{PROGRAM}: {error}", file=sys.stderr)
            return UNFIT
    except KeyboardInterrupt:
        return STOPPED
    except Exception:  # a fault of the lint itself, which Python would end with the status of a finding
        traceback.print_exc()
        return BROKEN


def _import_mujoco() -> None:
    """Import MuJoCo without windows, and NumPy without threads: each takes a quarter of the time, and none is used."""
    unused = {"MUJOCO_GL": "disable", "OPENBLAS_NUM_THREADS": "1"}
    if "mujoco" not in sys.modules and not unused.keys() & os.environ.keys():
        os.environ.update(unused)
        importlib.import_module("mujoco")
        for name in unused:
            del os.environ[name]


def _linted(given: argparse.Namespace) -> int:
    from newton_lint.output import shown, written
    from newton_lint.report import report_of
    from newton_lint.settings import table_of
    from newton_lint.target import TargetError, found_in, read_target

    table = table_of(Path.cwd())
    asked = asked_of(given, table)
    form = "json" if given.json else given.format or table.get("format", "text")
    reports, unread, fixes = [], [], []
    targets = list(found_in(given.target, [*given.exclude, *table.get("exclude", [])]))
    paths = list(dict.fromkeys(path for path in map(Path, targets) if path.is_file()))
    for target in targets:
        try:
            read = read_target(target)
            if (given.fix or given.dry_run) and read.path and read.model is not None:
                mend = importlib.import_module("newton_lint.mend")
                report, lines, why = mend.fixed(read, asked, paths, given.dry_run)
                fixes += lines
                unread += [why] if why else []
            else:
                report = report_of(read, asked)
            reports.append(report)
        except TargetError as error:
            unread.append(str(error))
    if given.fix and not given.dry_run and not unread and len(targets) > 1:
        fixes += importlib.import_module("newton_lint.mend").fixed_again(targets, asked, paths)
    with _pipe_may_close():
        if reports or form in ("json", "sarif"):
            print(written(reports, form, unread))
    for line in (*unread, *fixes):
        print(shown(line), file=sys.stderr)
    if unread:
        return UNFIT
    least = given.fail_on or table.get("fail-on", "warning")
    failed = least != "never" and any(report.worst() >= SEVERITIES.index(least) for report in reports)
    return FOUND if failed else CLEAN


def asked_of(given: argparse.Namespace, table: dict[str, Any]):
    """Return what is asked for, of the command before the project's table."""
    from newton_lint.prediction import Load
    from newton_lint.report import Asked

    ignore = [*table.get("ignore", []), *(given.ignore.split(",") if given.ignore else [])]
    load = Load(given.acceleration, given.load, given.press)
    below = given.below or table.get("below")
    return Asked(engine_of(given, table), load, work_of(given), below, frozenset(ignore), not given.no_step)


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
        print(end="", flush=True)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # Python flushes once more when it ends


def parser() -> Parser:
    """Make the parser of the lint's own options."""
    about = "Names contact parameters that MuJoCo does not use as they are written, predicts creep, says what to do."
    others = "Also: newton-lint prescribe searches settings for a grasp, page writes a page, pair tells of a contact."
    made = Parser(prog=PROGRAM, description=about, epilog=others)
    add = made.add_argument
    targets = "FILE.xml, FILE.urdf, FILE.usd, a folder, FILE.py:function, or module:function"
    add("target", metavar="TARGET", nargs="+", help=targets)
    add("--format", choices=("text", "json", "sarif", "github"), help="default: text")
    add("--json", action="store_true", help="the same as --format json")
    add("--fail-on", choices=(*SEVERITIES, "never"), help="least severity that ends with status 1; default: warning")
    add("--ignore", metavar="RULES", help="rules that do not count, with commas between")
    add("--fix", action="store_true", help="write changes that were measured to do no harm into the files")
    add("--dry-run", action="store_true", help="the same, and print the patch in place of writing it")
    add("--no-step", action="store_true", help="do not simulate the scene for 0.2 s")
    add("--exclude", action="append", default=[], metavar="PATTERN", help="files of folders that are left out")
    add("--press", type=positive, default=0.0, metavar="N", help="normal force on each contact point: how deep it goes")
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
    add("--hold", metavar="BODY", help="predict how this body creeps, gripped in the first keyframe or at the start")
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
