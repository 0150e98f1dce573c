"""The command line that make calls; ``make help`` says what there is."""

import signal
import sys
from pathlib import Path

signal.signal(signal.SIGINT, signal.SIG_DFL)  # while this is being imported there is nothing to say about a Ctrl-C
sys.path.insert(0, str(Path(__file__).resolve().parent))  # which PYTHONSAFEPATH leaves out

import argparse
import io
import os
import shutil
import subprocess
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from report import ROOT, ReportError, UsageError
from report.records.clips import clips_state
from report.records.columns import UNPRINTABLE
from report.records.devices import DEVICES, NO_CUDA, has_cuda, measuring_device
from report.records.environment import add_group, environment_of, python_of
from report.records.files import settle
from report.records.identity import sections, sources_kept
from report.records.measure import measure, measure_headline
from report.records.project import PROFILES, Project, own_release
from report.records.stack import Stack, stack_of
from report.records.status import expected_packages, states_of, status_matrix, status_table

if TYPE_CHECKING:
    from report.bisect import Question
    from report.editions import Edition
    from report.site import Built


def main() -> int:
    os.environ.pop("PYTHONSAFEPATH", None)  # programs that are started from here are modules of this folder
    for stop in (signal.SIGINT, signal.SIGTERM):
        signal.signal(stop, signal.default_int_handler)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # closed, it is None
            stream.reconfigure(errors="replace")
    try:
        arguments = _parse_arguments()
        own = own_release()
        arguments.stack = stack_of(arguments.newton.asked if arguments.newton else own, arguments.pins)
        project = Project(str(arguments.stack.label), arguments.profile, own_release=own)
        settle(project.results.parent)
        with sources_kept(project.root):
            result = arguments.run(project, arguments)
        print(end="", flush=True)
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
        print(f"{error.filename or 'the output cannot be written'}: {error.strerror}", file=sys.stderr)
        return 1
    except ReportError as error:
        if said := " ".join(str(error).split()):  # whoever failed may have said it
            print(UNPRINTABLE.sub("?", said), file=sys.stderr)
        return 2 if isinstance(error, UsageError) else 1


def _drop_output() -> None:
    """What could not be written is not tried again at the end."""
    if sys.stdout:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def report(project: Project, arguments: argparse.Namespace) -> int:
    """Measure what is not fresh, where that may be done unasked, and build the site."""
    device = measuring_device(arguments.device, project.profile)
    if not device:
        _refuse_unmeasured(project, arguments.stack)
    stale = [state.section for state in states_of(project) if state.kind != "fresh"]
    failed = False
    if stale and device:
        try:
            project = measure(project, arguments.stack, stale, device)
        except UsageError:
            raise
        except ReportError as error:
            print(error, file=sys.stderr)
            failed = True
    damaged, lacking = _build(project, arguments.address)
    if lacking and not device:
        print(f"{NO_CUDA}, in up to hours")
    return int(failed or damaged)


def rerun(project: Project, arguments: argparse.Namespace) -> int:
    """Measure one section, fresh or not, and build the site."""
    device = measuring_device(arguments.device, project.profile)
    if not device:
        raise UsageError(NO_CUDA)
    project = measure(project, arguments.stack, [arguments.section], device)
    return int(_build(project, arguments.address)[0])


def page(project: Project, arguments: argparse.Namespace) -> int:
    """Build the site from what is measured, and measure nothing."""
    _refuse_unmeasured(project, arguments.stack)
    return int(_build(project, arguments.address)[0])


def status(project: Project, arguments: argparse.Namespace) -> int:
    """Print which sections of which releases are fresh, and what changed for those that are not."""
    _refuse_unmeasured(project, arguments.stack)
    print(status_matrix(project))
    print(f"\nnewton {project.release}")
    print(status_table([*states_of(project), clips_state(project)], project.profile))
    return 0


def clips(project: Project, arguments: argparse.Namespace) -> int:
    """Make the clips of a release from its kept poses."""
    add_group("clips", project.root)
    options = {"newton": project.release, "profile": project.profile, "device": arguments.device}
    given = [f"--{name}={value}" for name, value in options.items() if value]
    command = [sys.executable, "-m", "experiments.render", *given]
    return subprocess.run(command, cwd=project.root, check=False).returncode


def upgrade(project: Project, arguments: argparse.Namespace) -> int:
    """Measure the few sections that decide, say in five lines what changed, and build the site; 1 for an alarm."""
    from report.alarm import upgrade_said
    from report.compare import compare
    from report.editions import editions_of
    from report.page import Templates
    from report.upgrade import DECIDING, base_of, seconds_expected, verdict

    device = measuring_device(arguments.device, project.profile)
    base = arguments.since or stack_of(base_of(project) or project.own_release)
    sides = []
    for stack in (base, arguments.stack):
        side = project.of(str(stack.label))
        lacking = [section for section in DECIDING if not side.record_path(section).exists()]
        if device and stack is not base:  # of the base, what is there will do
            lacking = [
                state.section for state in states_of(side) if state.section in DECIDING and state.kind != "fresh"
            ]
        if lacking and not device:
            quick = replace(project, profile="quick")
            full, short = (seconds_expected(each, "cpu", DECIDING) / 60 for each in (project, quick))
            raise UsageError(f"{NO_CUDA}, in about {full:.0f} min, and with PROFILE=quick in about {short:.0f}")
        if lacking:
            minutes = seconds_expected(side, device, lacking) / 60
            print(f"newton {side.release}: measuring {', '.join(lacking)}, about {max(minutes, 1):.0f} min", flush=True)
            side = measure(side, stack, [section for section in DECIDING if section in lacking], device)
        sides.append(side)
    names = [side.release for side in sides]
    editions = editions_of(project, Templates(project.templates), among=names)
    comparison = compare(*(editions[name] for name in names))
    print(upgrade_said(comparison, verdict(comparison, *(editions[name] for name in names)), arguments.format))
    if arguments.format == "text":
        _build(sides[1], "")
    return int(comparison.is_alarm)


def bisect(project: Project, arguments: argparse.Namespace) -> int:
    """Find the first release or commit between A and B that a claim or a value changes in, and which package did it."""
    from report.bisect import Bisection, bisect_commits, bisect_releases, common_repository
    from report.page import Templates

    device = measuring_device(arguments.device, "quick")
    question, templates = _question(arguments), Templates(project.templates)
    search = Bisection(replace(project, profile="quick"), question, device, templates)
    try:
        search.ends(arguments.a, arguments.b)
    except UsageError as error:
        print(f"{error} in a quick run; it takes full ones", flush=True)
        search = replace(search, project=project)
    repository = common_repository(arguments.a, arguments.b)
    if not repository:
        print(bisect_releases(search, arguments.a, arguments.b))
        return 0
    ends = search.ends(arguments.a, arguments.b)
    clone = project.root / ".venv-bisect"
    judging = [sys.executable, str(project.root / "build.py"), "judge", "--newton", str(clone), "--device", device]
    judging += ["--profile", search.project.profile, f"--{'claim' if question.is_claim else 'value'}", question.text]
    print(bisect_commits(*repository, [*judging, "--first", str(ends[0]), "--last", str(ends[1])], clone))
    return 0


def newest(project: Project, arguments: argparse.Namespace) -> int:
    """Print, for a workflow, what the index has of Newton, or else of one other package, newer than all here."""
    from report.records.label import read_label
    from report.records.stack import releases_of
    from report.records.status import records_of

    known = [each for profile in PROFILES for each in _editions(replace(project, profile=profile))]
    latest = [read_label(release) for release in releases_of("newton")[-1:]]
    if latest and all(label.order > each.label.order for label in latest for each in known):
        print(f"newton={latest[0]}\nwith=")
        return 0
    newton = max((each.label for each in known), key=lambda label: label.order).version
    for package in ("warp-lang", "mujoco-warp"):
        used = {record.identity.packages[package] for each in known for record in records_of(each)}
        for version in releases_of(package)[-1:]:
            if version not in used:
                print(f"newton={newton}\nwith={package}=={version}")
                return 0
    return 0


def _editions(project: Project) -> list[Project]:
    return [project.of(release) for release in project.releases]


def judge(project: Project, arguments: argparse.Namespace) -> int:
    """Say for git bisect whether Newton is as the first end is (0) or as the last (1); 125 where it can't be told."""
    from report.bisect import CANNOT_TELL, Bisection
    from report.page import Templates

    question = _question(arguments)
    answer = Bisection(project, question, arguments.device, Templates(project.templates)).answer(arguments.stack)
    ends = (arguments.first, arguments.last) if question.is_claim else (float(arguments.first), float(arguments.last))
    return CANNOT_TELL if answer is None else int(not question.is_as(answer, *ends))


def history(project: Project, arguments: argparse.Namespace) -> int:
    """Print a value or a claim over all editions; without one, the numbers that say most."""
    from report.editions import editions_of
    from report.history import headline_questions, history
    from report.page import Templates

    asked = [_question(arguments)] if arguments.claim or arguments.value else headline_questions()
    editions = editions_of(project, Templates(project.templates))
    print("\n\n".join(history(editions, question) for question in asked))
    return 0


def retire(project: Project, arguments: argparse.Namespace) -> int:
    """Remove results, environment and page of an edition."""
    if project.is_own:
        raise UsageError(f"newton {project.release} is the project's own and stays; NEWTON=1.5.0 names another")
    quick = replace(project, profile="quick")
    folders = [project.results, quick.results, environment_of(arguments.stack, project.root)]
    there = [folder for folder in folders if folder.is_dir()]
    if not there:
        raise UsageError(f"NEWTON={arguments.stack.asked} has neither results nor an environment")
    for folder in there:
        shutil.rmtree(folder)
        print(f"removed {folder.relative_to(project.root)}/")
    return int(_build(project.of(project.own_release), arguments.address)[0])


def check(project: Project, arguments: argparse.Namespace) -> int:
    """Print every claim of the report with its outcome, what can't be trusted first; STRICT=1 makes that status 1."""
    from report.alarm import check, check_said
    from report.editions import editions_of
    from report.page import Templates

    _refuse_unmeasured(project, arguments.stack)
    edition = editions_of(project, Templates(project.templates))[project.release]
    found = check(edition)
    print(check_said(found, arguments.format))
    damaged = _say_damage([edition])
    return int(damaged or (arguments.strict and found.is_alarm))


def diff(project: Project, arguments: argparse.Namespace) -> int:
    """Print what differs between two editions, worst first; 1 when one can't be trusted or a claim flipped."""
    from report.alarm import diff_said
    from report.compare import compare
    from report.editions import derive_edition
    from report.page import Templates

    stacks = arguments.a, arguments.b
    sides = [project.of(str(stack.label)) for stack in stacks]
    for side, stack in zip(sides, stacks, strict=True):
        _refuse_unmeasured(side, stack)
    templates = Templates(project.templates)
    comparison = compare(*(derive_edition(side, templates) for side in sides))
    print(diff_said(comparison, arguments.format, all_values=arguments.values == "all"))
    return int(comparison.is_alarm)


def trace(project: Project, arguments: argparse.Namespace) -> int:
    """Print the way of one value, from the page back to rows, cases and command."""
    from report.editions import editions_of
    from report.page import Templates
    from report.way import Ways

    _refuse_unmeasured(project, arguments.stack)
    templates = Templates(project.templates)
    print(Ways(project, editions_of(project, templates), templates).text(arguments.value))
    return 0


def verify(project: Project, arguments: argparse.Namespace) -> int:
    """Measure the headline again, keep nothing of it, and compare it with what is tracked; 1 when they differ."""
    from report.editions import derive_edition
    from report.page import Templates
    from report.verdict import compared, text_of

    _refuse_unmeasured(project, arguments.stack)
    device = arguments.device or ("cuda" if has_cuda() else "cpu")
    found = measure_headline(project, arguments.stack, measuring_device(device, project.profile))
    edition = derive_edition(project, Templates(project.templates))
    comparisons = compared(edition, found)
    print(text_of(edition, found, comparisons))
    return int(not all(comparison.agrees for comparison in comparisons))


def publish(project: Project, arguments: argparse.Namespace) -> int:
    """Put a checked copy of the site at the target."""
    from report.publish import publish as publish_site

    print(f"published at {publish_site(project.site, arguments.target)}")
    return 0


def test(project: Project, arguments: argparse.Namespace) -> int:
    """Run the tests with one release."""
    python = python_of(arguments.stack, expected_packages(project), project.root)
    return subprocess.run([python, "-m", "pytest"], cwd=project.root, check=False).returncode


def worlds(project: Project, arguments: argparse.Namespace) -> int:
    """Build the site of each altered world, and write anew what it says otherwise, into tests/worlds/."""
    return subprocess.run([sys.executable, "-m", "tests.worlds"], cwd=project.root, check=False).returncode


def torture(project: Project, arguments: argparse.Namespace) -> int:
    """Kill, fill and damage whatever there is, and write how that went into docs/reliability.md."""
    return subprocess.run([sys.executable, "-m", "tests.torture"], cwd=project.root, check=False).returncode


def serve(project: Project, arguments: argparse.Namespace) -> int:
    """Serve the site until Ctrl-C, and build it again whenever something changes."""
    from report.serving import Server

    _refuse_unmeasured(project, arguments.stack)
    server = Server(project.site, arguments.port)
    print(f"serving {project.site} at http://127.0.0.1:{arguments.port}", flush=True)
    # In a process of its own, since what changes may be the program.
    command = [sys.executable, "build.py", "page", "--newton", arguments.stack.asked, "--profile", project.profile]
    server.follow(project.inputs, partial(subprocess.run, command, cwd=project.root, check=False))
    return 0


def _build(project: Project, address: str) -> tuple[bool, bool]:
    """Build the site, and say what it lacks; whether a record is damaged, and whether any is to be renewed."""
    from report.site import build

    releases = build(project, address)
    built = releases[project.release]
    missing = [state.section for state in built.left_out if state.kind == "missing"]
    lacking = [*missing, *(state.section for state in built.left_out if state.kind != "missing"), *built.stale]
    device = measuring_device(None, "full") or "cpu"
    for words, names in (("not measured", missing), ("stale", built.stale)):
        if names:
            print(f"{words}: {', '.join(names)}")
    if lacking:
        print(f"{project.rerun(lacking[0], None if device == 'cuda' else device)} measures one of them")
    print(f"built {project.site / 'index.html'}")
    return _say_damage(releases.values()), bool(lacking)


def _say_damage(releases: "Iterable[Edition | Built]") -> bool:
    """Name each record that can't be trusted; whether there is one."""
    damaged = [state for release in releases for state in release.left_out if state.kind == "damaged"]
    for state in damaged:
        print(f"damaged: {'; '.join(state.notes)}", file=sys.stderr)
    return bool(damaged)


def _refuse_unmeasured(project: Project, stack: Stack) -> None:
    """Where nothing is to be measured, an edition that has no results is taken for a mistake; the own one is not."""
    if not project.is_own and not any(state.kind != "missing" for state in states_of(project)):
        there = ", ".join(release for release in project.releases if release != project.release) or "none"
        measuring = f"make upgrade NEWTON={stack.asked} measures what decides"
        raise UsageError(f"NEWTON={stack.asked} has no results (there are: {there}); {measuring}")


def _question(arguments: argparse.Namespace) -> "Question":
    from report.bisect import Question

    if bool(arguments.claim) == bool(arguments.value):
        raise UsageError("one of CLAIM=reproduction.slips and VALUE=reproduction.as-shipped.slip_mm is needed")
    question = Question(arguments.claim or arguments.value, bool(arguments.claim))
    if question.section not in sections() or question.section == question.text:
        raise UsageError(
            f"{question.text} is in no section; reproduction.slips and reproduction.as-shipped.slip_mm are"
        )
    return question


def _section(name: str) -> str:
    if name not in sections():
        fault = f"SECTION={name} is no section" if name else "SECTION is missing"
        if name.isidentifier() and (ROOT / "experiments" / f"{name}.py").is_file():
            fault += f": there is no report/sections/{name}.py"
        raise UsageError(f"{fault}; use one of: {', '.join(sections())}")
    return name


def _edition(option: str, asked: str) -> Stack:
    return stack_of(asked, option=option)


def _pins(text: str) -> str:
    stack_of(own_release(), text)
    return text


def _one_of(option: str, names: Iterable[str], name: str) -> str:
    if name not in names:
        raise UsageError(f"{option}={name} is no {option.lower()}; use one of: {', '.join(names)}")
    return name


def _port(text: str) -> int:
    if not (text.isascii() and text.isdigit() and 0 < int(text[:6]) < 65536):
        raise UsageError(f"PORT={text} is no port; use a number from 1 to 65535")
    return int(text)


def _address(address: str) -> str:
    if address and not address.startswith(("https://", "http://")):
        raise UsageError(f"ADDRESS={address} is no address of a site; use one as https://example.org/shake/")
    return f"{address.rstrip('/')}/" if address else ""


def _flag(value: str) -> str:
    if value != "1":
        raise UsageError(f"a switch is on as =1 or left out, not ={value}")
    return value


FORMATS = ("text", "markdown", "json")
VALUES = ("sums", "all")
# An option's type checks its default as well, so one that must be given has a default that is refused.
OPTIONS: dict[str, dict[str, Any]] = {
    "section": {"type": _section, "default": "", "help": "section to measure"},
    "newton": {
        "type": partial(_edition, "NEWTON"),
        "help": "Newton, where not the project's own: a release, a checkout, a wheel, git+https://…@ref or a label",
    },
    "with": {"type": _pins, "dest": "pins", "default": "", "help": "versions of packages, as warp-lang==1.19.0"},
    "a": {"type": partial(_edition, "A"), "default": "", "help": "edition to compare from"},
    "b": {"type": partial(_edition, "B"), "default": "", "help": "edition to compare with it"},
    "since": {"type": partial(_edition, "SINCE"), "help": "edition to compare with; default: the one before"},
    "claim": {"type": str, "default": "", "help": "claim, as reproduction.slips"},
    "first": {"type": str, "default": "", "help": "what the first end answers"},
    "last": {"type": str, "default": "", "help": "what the last end answers"},
    "device": {"type": partial(_one_of, "DEVICE", DEVICES), "help": "cuda or cpu, to measure there on purpose"},
    "profile": {
        "type": partial(_one_of, "PROFILE", PROFILES),
        "default": "full",
        "help": "quick: small grids and short runs, kept apart",
    },
    "value": {
        "type": str,
        "default": "",
        "help": "value of the page, as stiffness.improvement, or one of a row, as reproduction.as-shipped.slip_mm",
    },
    "format": {
        "type": partial(_one_of, "FORMAT", FORMATS),
        "default": "text",
        "help": "text, markdown (a comment on a pull request) or json (docs/alarm.md)",
    },
    "values": {"type": partial(_one_of, "VALUES", VALUES), "default": "sums", "help": "all: each value that moved"},
    "strict": {"action": "store_true", "help": "status 1 when anything can't be trusted"},
    "target": {"type": str, "default": "", "help": "where to publish: dir:PATH, rsync:HOST:PATH or git:REMOTE"},
    "port": {"type": _port, "default": "8000", "help": "where to serve"},
    "address": {"type": _address, "default": "", "help": "where the site will lie, as https://example.org/shake/"},
}
COMMANDS = {
    report: ("newton", "with", "device", "profile", "address"),
    page: ("newton", "with", "profile", "address"),
    rerun: ("section", "newton", "with", "device", "profile", "address"),
    status: ("newton", "with", "profile"),
    clips: ("newton", "with", "device", "profile"),
    upgrade: ("newton", "with", "since", "device", "profile", "format"),
    bisect: ("claim", "value", "a", "b", "device"),
    judge: ("claim", "value", "newton", "first", "last", "device", "profile"),
    history: ("claim", "value", "profile"),
    newest: (),
    retire: ("newton", "with", "address"),
    check: ("newton", "with", "profile", "format", "strict"),
    diff: ("a", "b", "profile", "format", "values"),
    trace: ("value", "newton", "profile"),
    verify: ("newton", "device"),
    publish: ("target",),
    serve: ("port", "newton", "profile"),
    test: ("newton", "with"),
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
    given = {name: os.environ.pop(f"MAKE_{name.upper()}", "") for name in OPTIONS}
    given = {name: value for name, value in given.items() if value}
    for name, value in given.items():
        OPTIONS[name].get("type", _flag)(value)
    return given


if __name__ == "__main__":
    sys.exit(main())
