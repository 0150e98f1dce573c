"""Runs the lint as a program: ``newton-lint TARGET…``.

docs/lint.md documents the options.
"""

import argparse
import contextlib
import os
import re
import sys
import traceback
from collections.abc import Sequence
from importlib import metadata
from pathlib import Path
from typing import Any, NoReturn

import mujoco

from newton_lint.findings import SEVERITIES
from newton_lint.grips import SLIP_MM_S
from newton_lint.mend import fixed, fixed_again
from newton_lint.output import Detail, printable, written
from newton_lint.prediction import Load
from newton_lint.report import Request, report_of
from newton_lint.scene import Engine
from newton_lint.settings import table_of
from newton_lint.target import TargetError, read_target, targets_of

# Exit statuses.
CLEAN = 0
FOUND = 1
UNFIT = 2
BROKEN = 3
STOPPED = 130
PROGRAM = "newton-lint"
GONE = {
    "closed",
    "creep",
    "dampratio",
    "default-gap",
    "fixed",
    "gap",
    "grip",
    "hull",
    "override",
    "unsettled",
    "unused",
    "visual",
}
"""Rules of earlier releases, which a table of a project may still ignore."""
RULE = re.compile(r"^\| `([\w-]+)` \| (\w+) \| (.+) \| .+ \|$", re.MULTILINE)
"""Matches a row of rules.md."""


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """Print the error as one line and exit."""
        self.exit(UNFIT, f"{message}; see {PROGRAM} --help\n")


def main(arguments: Sequence[str] | None = None) -> int:
    arguments = list(sys.argv[1:] if arguments is None else arguments)
    for stream in (sys.stdout, sys.stderr):
        # A terminal in Latin-1 has no ². A StringIO in a test cannot be reconfigured.
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    # By default MuJoCo writes warnings to MUJOCO_LOG.TXT in the current folder.
    mujoco.set_mju_user_warning(lambda _: None)
    try:
        return _linted(lint_parser().parse_args(arguments))
    except TargetError as error:
        print(error, file=sys.stderr)
        return UNFIT
    except OSError as error:  # The disk is full, or the output is closed.
        with contextlib.suppress(OSError, ValueError):
            print(f"{PROGRAM}: {error}", file=sys.stderr)
        return UNFIT
    except KeyboardInterrupt:
        return STOPPED
    except Exception:  # Python would exit with 1, which means findings.
        traceback.print_exc()
        return BROKEN


def rules() -> dict[str, str]:
    """Return the description and severity of each rule."""
    text = Path(__file__).with_name("rules.md").read_text(encoding="utf-8")
    return {
        name: f"{name} ({severity}): {description}"
        for name, severity, description in RULE.findall(text)
    }


def _linted(options: argparse.Namespace) -> int:
    if options.version:
        print(PROGRAM, version())
        return CLEAN
    if options.explain and {*options.target[:1]} & {*rules()}:
        print(rules()[options.target[0]])
        return CLEAN
    if not options.target:
        raise TargetError(f"expected a TARGET; see {PROGRAM} --help")
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
            scene = read_target(target)
            if (
                (options.fix or options.dry_run)
                and scene.path
                and scene.model is not None
            ):
                report, lines = fixed(scene, request, paths, options.dry_run)
                fixes += lines
            else:
                report = report_of(scene, request)
            reports.append(report)
        except TargetError as error:
            unread.append(str(error))
    if options.fix and not options.dry_run and not unread and len(targets) > 1:
        fixes += fixed_again(targets, request, paths)
    least = options.fail_on or table.get("fail-on", "warning")
    try:
        if reports or form == "json":
            notes = options.notes or least == "note"
            detail = Detail(notes, rules() if options.explain else {})
            print(written(reports, form, detail), flush=True)
    except BrokenPipeError:
        # The reader, for example head, has stopped. Python flushes again at its end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    for line in (*unread, *fixes):
        print(printable(line), file=sys.stderr)
    if unread:
        return UNFIT
    if least != "never" and any(
        report.worst() >= SEVERITIES.index(least) for report in reports
    ):
        return FOUND
    return CLEAN


def request_of(options: argparse.Namespace, table: dict[str, Any]) -> Request:
    """Return the request of the command line, with defaults from pyproject.toml."""
    ignore = [
        *table.get("ignore", []),
        *map(str.strip, options.ignore.split(",") if options.ignore else []),
    ]
    for rule in GONE.intersection(ignore):
        print(
            f"{PROGRAM}: the ignored rule {rule} does not exist any more",
            file=sys.stderr,
        )
    if unknown := [rule for rule in ignore if rule not in (*rules(), *GONE)]:
        rule_names = ", ".join(rules())
        raise TargetError(
            f"cannot ignore unknown rule {', '.join(unknown)}: choose from {rule_names}"
        )
    return Request(
        engine=Engine(
            options.engine or table.get("engine", "mujoco"),
            options.dt,
            options.cone,
            options.impratio,
        ),
        load=Load(options.acceleration, options.load),
        below_mm_s=options.below or table.get("below", SLIP_MM_S),
        ignore=frozenset(ignore),
        step=not options.no_step,
    )


def version() -> str:
    with contextlib.suppress(metadata.PackageNotFoundError):
        return metadata.version(PROGRAM)
    return "(not installed)"


def lint_parser() -> Parser:
    """Return the parser of the main command."""
    parser = Parser(
        prog=PROGRAM,
        description="Step scenes in MuJoCo for 2 s, list faults and parameters"
        " that MuJoCo does not use as they are written, and recommend changes.",
    )
    add = parser.add_argument
    add(
        "target",
        metavar="TARGET",
        nargs="*",
        help="FILE.xml, FILE.urdf, FILE.usd, a folder, FILE.py:function or"
        " module:function",
    )
    add("--format", choices=("text", "json", "github"), help="default: text")
    add("--json", action="store_true", help="the same as --format json")
    add(
        "--fail-on",
        choices=(*SEVERITIES, "never"),
        help="lowest severity that gives exit status 1; default: warning",
    )
    add("--version", action="store_true", help="print the version")
    add(
        "--explain",
        action="store_true",
        help="print the details of each finding, or describe the rule named as TARGET",
    )
    add("--notes", action="store_true", help="print notes too")
    add("--ignore", metavar="RULES", help="rules to ignore, separated by commas")
    add(
        "--fix",
        action="store_true",
        help="write the recommended changes into the files",
    )
    add(
        "--dry-run",
        action="store_true",
        help="like --fix, but print the patch instead of writing it",
    )
    add("--no-step", action="store_true", help="do not simulate the scene")
    add(
        "--exclude",
        action="append",
        default=[],
        metavar="PATTERN",
        help="leave out files that match this pattern when reading folders",
    )
    default = "default: that of the scene"
    add(
        "--engine",
        choices=("mujoco", "warp", "newton"),
        help="engine whose rules apply; default: mujoco",
    )
    add("--dt", type=positive, metavar="S", help=f"time step [s]; {default}")
    add("--cone", choices=("pyramidal", "elliptic"), help=f"friction cone; {default}")
    add("--impratio", type=positive, metavar="X", help=f"impratio; {default}")
    add(
        "--below",
        type=positive,
        metavar="MM/S",
        help="lowest speed of creep to report (a tenth of it in a grip); default: 1",
    )
    add(
        "--load",
        type=positive,
        default=0.0,
        metavar="N",
        help="tangential force on each contact point [N]",
    )
    add(
        "--acceleration",
        type=positive,
        default=0.0,
        metavar="M/S²",
        help="acceleration that contacts and grips have to bear",
    )
    return parser


def positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0.0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"expected a positive number, got {text}")
    return value
