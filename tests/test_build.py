"""The command line: what it refuses, what it must not import, and the report of the tracked results."""

import gc
import signal
import subprocess
import sys
from collections.abc import Iterator

import pytest
from conftest import program

from measured_report.commands import options
from measured_report.commands.command_line import main
from measured_report.files.errors import UsageError
from measured_report.parts.section import UNDRAWN
from measured_report.site.check import check_site

NO_GPU = {"PATH": "/nowhere"}
"""Without nvidia-smi on it every machine has no GPU."""


def run(code: str) -> subprocess.CompletedProcess:
    return program("-c", code, **NO_GPU)


@pytest.fixture
def command(monkeypatch) -> Iterator[None]:
    """What ``command_line.main`` sets in its process, as it was before."""
    stops = {stop: signal.getsignal(stop) for stop in (signal.SIGINT, signal.SIGTERM, signal.SIGALRM)}
    monkeypatch.setattr(sys, "unraisablehook", sys.unraisablehook)
    monkeypatch.setenv("PATH", NO_GPU["PATH"])
    yield
    gc.unfreeze()
    for stop, handler in stops.items():
        signal.signal(stop, handler)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["rerun", "--section", "nothing"], "reproduction"),
        (["rerun", "--section", ""], "reproduction"),
        (["rerun", "--section", "frction"], "SECTION=frction is no section; near it: friction, "),
        (["bisect", "--claim", "gup.x", "--a", "1.4.0", "--b", "1.8.0"], "CLAIM=gup.x is in no section; near it: gap"),
        (["rerun", "--section", "reproduction"], "DEVICE=cpu"),
        (["rerun", "--section", "reproduction", "--device", "cuda"], "no CUDA device"),
        (["check", "--section", "nothing"], "--section nothing"),
        (["status", "--device", "cuda"], "--device cuda"),
        (["nothing"], "report"),
        (["report", "--device", "tpu"], "DEVICE=tpu"),
        (["report", "--device", "cuda"], "no CUDA device"),
        (["report", "--cluster", "local:0"], "CLUSTER=local:0"),
        (["report", "--device", "cuda", "--cluster", "local"], "no CUDA device"),
        (["rerun", "--section", "gap", "--cluster", "ssh:/nowhere"], "CLUSTER=ssh:/nowhere"),
        (["status", "--cluster", "local"], "--cluster local"),
        (["report", "--profile", "slow"], "PROFILE=slow"),
        (["status", "--newton", "new"], "NEWTON=new"),
        (["status", "--newton", "99.0"], "NEWTON=99.0"),
        (["report", "--newton", "99.0"], "NEWTON=99.0"),
        (["rerun", "--section", "gap", "--newton", "99.0", "--device", "cpu"], "NEWTON=99.0"),
        (["check", "--newton", "99.0"], "NEWTON=99.0"),
        (["diff", "--a", "1.4.0"], "B is missing: make diff A=1.4.0 B=1.8.0"),
        (["diff"], "A and B are missing: make diff A=1.4.0 B=1.8.0"),
        (["bisect", "--claim", "reproduction.slips", "--b", "1.8.0"], "A is missing: make bisect"),
        (["trace"], "VALUE is missing: make trace VALUE=stiffness.improvement"),
        (["diff", "--a", "1.4.0", "--b", "new"], "B=new"),
        (["diff", "--a", "1.4.0", "--b", "99.0"], "99.0 has no results"),
        (["verify", "--device", "cuda"], "no CUDA device"),
        (["verify", "--newton", "99.0"], "NEWTON=99.0"),
        (["publish", "--target", "ftp:x"], "TARGET="),
        (["serve", "--port", "x"], "PORT=x"),
        (["serve", "--port", "65536"], "PORT=65536"),
    ],
)
def test_bad_input_gets_one_line_and_status_2(arguments, message, command, monkeypatch, capfd):
    monkeypatch.setattr(sys, "argv", ["build.py", *arguments])
    assert main() == 2
    said = capfd.readouterr()
    assert message in said.err
    assert len(said.err.splitlines()) == 1
    assert said.out == ""


def test_the_program_ends_with_the_status_of_its_command():
    done = program("build.py", "nothing", **NO_GPU)
    assert (done.returncode, done.stdout, len(done.stderr.splitlines())) == (2, "", 1)


def test_a_section_that_is_measured_and_not_derived_is_named(tmp_path, monkeypatch):
    (tmp_path / "experiments").mkdir()
    (tmp_path / "experiments" / "weight.py").touch()
    monkeypatch.setattr(options, "ROOT", tmp_path)
    with pytest.raises(UsageError, match=r"there is no report/sections/weight\.py; use one of"):
        options.OPTIONS["section"]["type"]("weight")


def test_status_does_not_import_the_simulator():
    code = (
        "import sys, build; sys.argv = ['build.py', 'status']; build.main();"
        "sys.exit(bool({'warp', 'newton', 'mujoco', 'matplotlib', 'pandas'} & set(sys.modules)))"
    )
    done = run(code)
    assert done.returncode == 0, done.stderr
    assert "reproduction" in done.stdout


@pytest.mark.words
def test_the_tracked_results_make_a_report_without_the_simulator(site):
    assert check_site(site) == []
    assert [path for path in site.rglob("*.html") if UNDRAWN in path.read_text(encoding="utf-8")] == []


INTERRUPTED = """
import signal, sys, time
import build
from measured_report.commands import command_line

class Closing:
    def __del__(self):
        raise KeyboardInterrupt

signal.signal(signal.SIGALRM, signal.default_int_handler)
sys.unraisablehook = command_line.interrupt_again
try:
    Closing()
    time.sleep(10.0)
except KeyboardInterrupt:
    print("interrupted")
"""


def test_no_interrupt_is_dropped_or_taken_for_an_error():
    done = run(INTERRUPTED)
    assert (done.stdout, done.stderr) == ("interrupted\n", "")
    done = run(MADE)  # Python before 3.12 makes it an error of another kind
    assert (done.returncode, done.stderr) == (130, "stopped; what was measured before is kept\n")


MADE = """
import sys
import build
from measured_report.commands import command_line

class Hit:
    def __set_name__(self, owner, name):
        raise KeyboardInterrupt

def make_class():
    type("Made", (), {"hit": Hit()})

command_line._parse_arguments = make_class
sys.exit(command_line.main())
"""
