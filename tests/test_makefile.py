"""Test that the arguments of make arrive unchanged, and that a misspelt variable is
refused.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from measured_report.commands.command_line import variables_of
from measured_report.files.root import ROOT

NAMES = ["SECTION", "NEWTON", "CLAIM", "FAST"]
OF_THE_MAKEFILES = ["name", "TYPED", "READY", "GOALS", "GOAL", "OWN", "PYTHON"]
WORDS = ["$(shell touch {})", "$$(touch {})", "`touch {}`", "'; touch {}; '"]


def make(*arguments: str | Path, level: str = "0") -> subprocess.CompletedProcess:
    # A make may run these tests itself.
    environment = {
        name: value
        for name, value in os.environ.items()
        if name not in ("MAKEFLAGS", "MAKEOVERRIDES")
    }
    command = ["make", "--silent", *arguments]
    return subprocess.run(
        command,
        cwd=ROOT,
        env={**environment, "MAKELEVEL": level},
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture
def python(tmp_path) -> str:
    """Replaces Python: it prints its arguments, and writes the variables of make to a
    file next to itself.
    """
    path = tmp_path / "python"
    path.write_text('#!/bin/sh\nprintf "%s" "$TYPED" > "${0%/*}/typed"\necho "$@"\n')
    path.chmod(0o755)
    return f"PYTHON={path}"


def test_the_makefile_itself_names_what_can_be_asked_for():
    """Test the targets in the file without its includes, because programs that list
    targets do not follow these.
    """
    named = set(
        re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text(), re.MULTILINE)
    )
    assert named >= set(
        "report test status rerun check serve publish help page verify trace clips upgrade".split()
    )
    assert named >= {"bisect", "history", "diff"}


@pytest.mark.parametrize(
    ("name", "word"),
    [("SECTON", "friction"), ("section", WORDS[0]), ("SECTON", WORDS[3])],
)
def test_a_misspelt_variable_is_refused_and_not_executed(name, word, tmp_path):
    canary = tmp_path / "canary"
    done = make("rerun", f"PYTHON={sys.executable}", f"{name}={word.format(canary)}")
    [line] = [
        line for line in done.stderr.splitlines() if not line.startswith("make: ")
    ]
    assert (done.returncode, done.stdout) == (2, "")
    assert (
        line.startswith(f"{name}= is not a variable of make here")
        and "similar: SECTION" in line
    )
    assert not canary.exists()


def test_a_variable_of_another_command_is_refused():
    """Test that a variable is refused if no goal takes it.

    With several goals it may belong to only one of them.
    """
    done = make("publish", f"PYTHON={sys.executable}", "NEWTON=1.8.0")
    assert done.returncode == 2
    assert "make publish does not take NEWTON=: leave it out" in done.stderr
    done = make("help", "status", f"PYTHON={sys.executable}", "PROFILE=quick")
    assert "does not take" not in done.stderr


@pytest.mark.parametrize("word", [WORDS[0], WORDS[3]])
def test_no_value_and_no_goal_is_executed(word, python, tmp_path):
    word = word.format(canary := tmp_path / "canary")
    for name in [*OF_THE_MAKEFILES, *NAMES]:
        make("status", python, f"{name}={word}")
    make(word, python)
    assert not canary.exists()


@pytest.mark.parametrize("goal", ["rerun", "lint"])
def test_every_variable_arrives_as_it_was_typed(goal, python, tmp_path):
    given = {
        name: f"a '$(b)' $${name} \"\t\\ \n=`c` \\"
        for name in [*NAMES, *OF_THE_MAKEFILES]
        if name != "PYTHON"
    }
    done = make(goal, python, *(f"{name}={value}" for name, value in given.items()))
    assert done.returncode == 0, done.stderr
    assert variables_of((tmp_path / "typed").read_text()) == given
    assert goal == "lint" or done.stdout.splitlines() == [f"build.py {goal}"]


def test_what_is_for_make_itself_is_no_variable_of_the_project(python, tmp_path):
    for options in ("-j8", "-k -B", "-e", "SHELL=/bin/sh", "MAKEFLAGS=-s"):
        make("status", python, *options.split())
        assert variables_of((tmp_path / "typed").read_text()) == {}, options


def test_what_a_make_above_was_asked_for_is_not_refused():
    assert make("help", f"PYTHON={sys.executable}", "CC=gcc", level="1").returncode == 0
    assert make("help", f"PYTHON={sys.executable}", "CC=gcc").returncode == 2
