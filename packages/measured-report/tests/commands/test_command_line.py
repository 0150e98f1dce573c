"""Test the inputs that the command line refuses, and the modules that it must not
import.
"""

import signal
import subprocess
import sys
from collections.abc import Iterator

import pytest
from toys import program

from measured_report.commands.command_line import main

STOPPED = "stopped: measurements that were completed are kept"
NO_GPU = {"PATH": "/nowhere"}
"""Environment without nvidia-smi, as on a machine without a GPU."""


@pytest.fixture
def command(monkeypatch) -> Iterator[None]:
    """Restore the state of the process that ``command_line.main`` changes."""
    stops = {stop: signal.getsignal(stop) for stop in (signal.SIGINT, signal.SIGTERM)}
    monkeypatch.setenv("PATH", NO_GPU["PATH"])
    monkeypatch.setattr("sys.unraisablehook", sys.unraisablehook)
    yield
    for stop, handler in stops.items():
        signal.signal(stop, handler)


STOP = "import os, signal, time\nos.kill(os.getpid(), signal.SIGINT)\ntime.sleep(9)\n"
RUN = "\ndef run(project, arguments):\n    "


@pytest.mark.parametrize(
    ("place", "text", "status"),
    [
        ("measured_report/__init__.py", STOP, -signal.SIGINT),
        ("report/commands/early.py", RUN + STOP.replace("\n", "\n    "), 130),
    ]
    + [
        (
            "report/commands/early.py",
            f"{STOP}\ndef run(project, arguments): ...\n",
            -signal.SIGINT,
        )
    ],
    ids=["the generator is imported", "a command runs", "a command is imported"],
)
def test_a_ctrl_c_in_the_first_second_ends_a_command_without_a_traceback(
    toy, place, text, status
):
    toy.write(place, text)
    done = program("build.py", "early")
    assert (done.returncode, done.stderr) == (
        status,
        f"{STOPPED}\n" if status == 130 else "",
    )


def test_an_output_that_is_full_is_one_line(outside):
    done = subprocess.run(
        ["bash", "-c", '"$0" build.py help >/dev/full', sys.executable],
        cwd=outside,
        capture_output=True,
    )
    assert (done.returncode, len(done.stderr.splitlines())) == (1, 1)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["rerun", "--section", ""], "toy"),
        (["rerun", "--section", "tay"], "SECTION=tay is not a section (similar: toy)"),
        (
            ["bisect", "--claim", "tay.x", "--a", "1.4.0", "--b", "1.8.0"],
            "no section has tay.x: use SECTION.NAME with an existing section (similar: toy)",
        ),
        (["rerun", "--section", "toy"], "DEVICE=cpu"),
        (["check", "--section", "nothing"], "--section nothing"),
        (["nothing"], "report"),
        (["report", "--device", "tpu"], "tpu"),
        (["report", "--device", "cuda"], "no CUDA device"),
        (["report", "--cluster", "local"], "CLUSTER=local"),
        (
            ["rerun", "--section", "toy", "--device", "cpu", "--cluster", "tcp://h:1"],
            "CLUSTER=tcp://h:1 needs the package distributed: install it",
        ),
        (["status", "--newton", "new"], "NEWTON=new"),
        (["report", "--newton", "99.0"], "NEWTON=99.0"),
        (["diff"], "required: --a, --b"),
        (["diff", "--a", "1.4.0", "--b", "new"], "B=new"),
        (["diff", "--a", "1.4.0", "--b", "99.0"], "99.0 has no results"),
        (["publish", "--target", "ftp:x"], "TARGET="),
        (["serve", "--port", "65536"], "PORT=65536"),
    ],
)
def test_bad_input_gets_one_line_and_status_2(
    arguments, message, command, monkeypatch, capfd
):
    monkeypatch.delenv("MAKELEVEL", raising=False)  # make test may start these tests
    monkeypatch.setattr(sys, "argv", ["build.py", *arguments])
    assert main() == 2
    said = capfd.readouterr()
    assert message in said.err
    assert len(said.err.splitlines()) == 1
    assert said.out == ""


def test_the_program_ends_with_the_status_of_its_command():
    done = program("build.py", "nothing", **NO_GPU)
    assert (done.returncode, done.stdout, len(done.stderr.splitlines())) == (2, "", 1)


def test_status_does_not_import_the_simulator():
    code = (
        "import sys, build; sys.argv = ['build.py', 'status']; build.main();"
        "sys.exit(bool({'warp', 'newton', 'mujoco', 'matplotlib', 'pandas'} & set(sys.modules)))"
    )
    done = program("-c", code, **NO_GPU)
    assert done.returncode == 0, done.stderr
    assert "toy" in done.stdout


def test_a_report_s_own_commands_are_found_and_every_one_says_what_it_does(
    toy, command, monkeypatch, capsys
):
    monkeypatch.setattr(sys, "argv", ["build.py", "help"])
    toy.write(
        "report/commands/greet.py",
        '"""Say something to somebody."""\n\n\ndef run(project, arguments):\n    pass\n',
    )
    assert main() == 0
    lines = {
        line.split()[1]: line
        for line in capsys.readouterr().out.splitlines()
        if line.startswith("make ")
    }
    assert {"report", "rerun", "help", "greet"} <= set(lines)
    assert all(len(line.split()) > 2 for line in lines.values())
    assert lines["rerun"].endswith(
        "[SECTION NEWTON WITH DEVICE CLUSTER PROFILE ADDRESS]"
    )


@pytest.mark.parametrize(
    ("typed", "arguments", "status"),
    [
        ({"SECTION": "tay"}, ["rerun"], "similar: toy"),
        ({"SECTION": "frction"}, ["rerun", "--section", "tay"], "similar: toy"),
        (
            {"SECTON": "toy"},
            ["rerun"],
            "SECTON= is not a variable of make here (similar: SECTION",
        ),
        (
            {"A": "1.4.0"},
            ["diff"],
            "make diff: the following arguments are required: B= (see make help)",
        ),
        (
            {"STRICT": "yes"},
            ["check"],
            "STRICT=yes is not a valid switch: use STRICT=1 or leave it out",
        ),
    ],
)
def test_what_was_typed_behind_make_is_an_option(
    typed, arguments, status, command, monkeypatch, capsys
):
    monkeypatch.setenv("MAKELEVEL", "1")
    monkeypatch.setenv(
        "TYPED", " ".join(f"{name}={value}" for name, value in typed.items())
    )
    monkeypatch.setattr(sys, "argv", ["build.py", *arguments])
    assert main() == 2
    assert status in capsys.readouterr().err
