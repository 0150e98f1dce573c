"""The lint as a program: ``newton-lint TARGET…``, or ``newton-lint prescribe``, ``pair`` and ``page``.

See docs/lint.md.
"""

import argparse
import contextlib
import importlib
import os
import re
import sys
import traceback
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NoReturn

# Exit status.
CLEAN = 0
FOUND = 1
UNFIT = 2
BROKEN = 3
STOPPED = 130
PROGRAM = "newton-lint"
SUBCOMMANDS = ("prescribe", "page", "pair")
"""Commands besides the lint itself, each a module."""
SEVERITIES = ("note", "warning", "error")
RULE = re.compile(r"^\| `([\w-]+)` \| (\w+) \| (.+) \| .+ \|$", re.MULTILINE)
"""A row of rules.md."""


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """Return what was asked for can't be: one line, as for a target that can't be read."""
        self.exit(UNFIT, f"{message}; {PROGRAM} --help says what there is\n")


def main(arguments: Sequence[str] | None = None) -> int:
    arguments = list(sys.argv[1:] if arguments is None else arguments)
    for stream in (sys.stdout, sys.stderr):
        if hasattr(
            stream, "reconfigure"
        ):  # a StringIO of a test has none; a terminal in Latin-1 has no ²
            stream.reconfigure(errors="backslashreplace")
    try:
        # What a function of the user's imports may render, or count on NumPy's threads.
        if arguments[:1] != ["page"] and not any(
            ".py:" in argument for argument in arguments
        ):
            _import_mujoco()
        from newton_lint.target import TargetError, mujoco

        mujoco.set_mju_user_warning(
            lambda _: None
        )  # which else writes MUJOCO_LOG.TXT where the user stands
        try:
            if arguments and arguments[0] in SUBCOMMANDS:
                return importlib.import_module(f"newton_lint.{arguments[0]}").main(
                    arguments[1:]
                )
            return _linted(lint_parser().parse_args(arguments))
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


def rules() -> dict[str, str]:
    """Return what each rule finds, and with which severity."""
    text = Path(__file__).with_name("rules.md").read_text(encoding="utf-8")
    return {
        name: f"{name} ({severity}): {what}"
        for name, severity, what in RULE.findall(text)
    }


class Tell(argparse.Action):
    def __call__(self, parser, namespace, rule, option_string=None) -> None:
        """Print the version, or what a rule finds."""
        if option_string == "--version":
            print(PROGRAM, version())
        else:
            print(
                rules().get(rule)
                or parser.error(
                    f"there is no rule {rule}: there are {', '.join(rules())}"
                )
            )
        parser.exit(CLEAN)


def _linted(options: argparse.Namespace) -> int:
    from newton_lint.mend import fixed, fixed_again
    from newton_lint.output import printable, written
    from newton_lint.report import report_of
    from newton_lint.settings import table_of
    from newton_lint.target import TargetError, read_target, targets_of

    table = table_of(Path.cwd())
    request = request_of(options, table)
    form = "json" if options.json else options.format or table.get("format", "text")
    reports = []
    unread = []
    fixes = []
    targets = list(
        targets_of(options.target, [*options.exclude, *table.get("exclude", [])])
    )
    paths = list(dict.fromkeys(path for path in map(Path, targets) if path.is_file()))
    for target in targets:
        try:
            read = read_target(target)
            if (
                (options.fix or options.dry_run)
                and read.path
                and read.model is not None
            ):
                report, lines, why = fixed(read, request, paths, options.dry_run)
                fixes += lines
                unread += [why] if why else []
            else:
                report = report_of(read, request)
            reports.append(report)
        except TargetError as error:
            unread.append(str(error))
    if options.fix and not options.dry_run and not unread and len(targets) > 1:
        fixes += fixed_again(targets, request, paths)
    try:
        if reports or form in ("json", "sarif"):
            print(written(reports, form, unread), flush=True)
    except (
        BrokenPipeError
    ):  # who reads the output may stop before its end, as head does
        os.dup2(
            os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno()
        )  # Python flushes once more when it ends
    for line in (*unread, *fixes):
        print(printable(line), file=sys.stderr)
    if unread:
        return UNFIT
    least = options.fail_on or table.get("fail-on", "warning")
    if least != "never" and any(
        report.worst() >= SEVERITIES.index(least) for report in reports
    ):
        return FOUND
    return CLEAN


def request_of(options: argparse.Namespace, table: dict[str, Any]):
    """Return what is asked for, of the command before the project's table."""
    from newton_lint.prediction import Load
    from newton_lint.report import Request
    from newton_lint.target import TargetError

    ignore = [
        *table.get("ignore", []),
        *map(str.strip, options.ignore.split(",") if options.ignore else []),
    ]
    if unknown := [rule for rule in ignore if rule not in rules()]:
        raise TargetError(
            f"there is no rule {', '.join(unknown)} to ignore: there are {', '.join(rules())}"
        )
    return Request(
        engine_of(options, table),
        Load(options.acceleration, options.load),
        work_of(options),
        options.below or table.get("below"),
        frozenset(ignore),
        not options.no_step,
    )


def engine_of(options: argparse.Namespace, table: dict[str, Any]):
    from newton_lint.scene import Engine

    return Engine(
        options.engine or table.get("engine", "mujoco"),
        options.dt,
        options.cone,
        options.impratio,
    )


def work_of(options: argparse.Namespace):
    from newton_lint.settle import SETTLE_S, Work

    return (
        Work(options.hold, options.settle or SETTLE_S, options.turn, options.lift)
        if options.hold
        else None
    )


def version() -> str:
    metadata = importlib.import_module(
        "importlib.metadata"
    )  # which takes as long as all that a rule does
    with contextlib.suppress(metadata.PackageNotFoundError):
        return metadata.version(PROGRAM)
    return "of a checkout"


def lint_parser() -> Parser:
    """Make the parser of the lint's own options."""
    parser = Parser(
        prog=PROGRAM,
        description="Names contact parameters that MuJoCo does not use as they are written, predicts creep, says what"
        " to do.",
        epilog="Also: newton-lint prescribe searches settings for a grasp, page writes a page, pair tells of a"
        " contact.",
    )
    add = parser.add_argument
    add(
        "target",
        metavar="TARGET",
        nargs="+",
        help="FILE.xml, FILE.urdf, FILE.usd, a folder, FILE.py:function, or module:function",
    )
    add("--format", choices=("text", "json", "sarif", "github"), help="default: text")
    add("--json", action="store_true", help="the same as --format json")
    add(
        "--fail-on",
        choices=(*SEVERITIES, "never"),
        help="least severity that ends with status 1; default: warning",
    )
    add("--version", action=Tell, nargs=0, help="say which release it is")
    add("--explain", action=Tell, metavar="RULE", help="say what a rule finds")
    add(
        "--ignore", metavar="RULES", help="rules that do not count, with commas between"
    )
    add(
        "--fix",
        action="store_true",
        help="write changes that were measured to do no harm into the files",
    )
    add(
        "--dry-run",
        action="store_true",
        help="the same, and print the patch in place of writing it",
    )
    add("--no-step", action="store_true", help="do not simulate the scene")
    add(
        "--exclude",
        action="append",
        default=[],
        metavar="PATTERN",
        help="files of folders that are left out",
    )
    add_work(parser)
    add(
        "--load",
        type=positive,
        default=0.0,
        metavar="N",
        help="tangential force on each contact point",
    )
    add(
        "--turn",
        type=positive,
        default=0.0,
        metavar="RAD/S",
        help="what holds it turns about the vertical",
    )
    add(
        "--acceleration",
        type=positive,
        default=0.0,
        metavar="M/S²",
        help="ω² r of a support that turns",
    )
    return parser


def add_work(parser: argparse.ArgumentParser) -> None:
    """Add options of the engine, and of a body that is held."""
    add = parser.add_argument
    default = "default: what the scene says"
    add(
        "--engine",
        choices=("mujoco", "warp", "newton"),
        help="whose rules count; default: mujoco",
    )
    add("--dt", type=positive, metavar="S", help=f"the solver's step; {default}")
    add("--cone", choices=("pyramidal", "elliptic"), help=default)
    add("--impratio", type=positive, metavar="X", help=default)
    add(
        "--hold",
        metavar="BODY",
        help="predict how this body creeps, gripped in the first keyframe or at the start",
    )
    add(
        "--settle",
        type=positive,
        metavar="S",
        help="time that its grip gets to settle; default: 0.5",
    )
    add(
        "--lift",
        type=positive,
        default=0.0,
        metavar="M/S²",
        help="what holds it accelerates upward",
    )
    add(
        "--below",
        type=positive,
        metavar="MM/S",
        help="creep that is not too fast; prescribe's default: 0.1",
    )


def positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0.0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is no positive number")
    return value
