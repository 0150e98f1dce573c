"""What is typed behind make: it arrives as it was typed, and a misspelt variable is refused."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from measured_report.files.root import ROOT

SHARED = (ROOT / "packages/measured-report/measured_report/skeleton/report.mk").read_text()
GIVEN = re.search(r"^override GIVEN := ((?:.*\\\n)*.*)", SHARED, re.MULTILINE)[1]
NAMES = GIVEN.replace("\\\n", " ").replace("$(EDITION)", "NEWTON").replace("$(OWN)", "FAST LAB").split()
WORDS = ["$(shell touch {})", "$$(touch {})", "`touch {}`", "'; touch {}; '"]


def make(*arguments: str | Path, level: str = "0") -> subprocess.CompletedProcess:
    # These tests may run below a make themselves.
    environment = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MAKEOVERRIDES")}
    command = ["make", "--silent", *arguments]
    return subprocess.run(
        command, cwd=ROOT, env={**environment, "MAKELEVEL": level}, capture_output=True, text=True, check=False
    )


def said(done: subprocess.CompletedProcess) -> list[str]:
    return [line for line in done.stderr.splitlines() if not line.startswith("make: ")]


def test_the_makefile_itself_names_what_can_be_asked_for():
    """Programs outside read that file and follow no include."""
    [phony] = re.findall(r"^\.PHONY: (.*)", SHARED, re.MULTILINE)
    assert set(phony.split()) <= set(re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))


@pytest.fixture
def python(tmp_path) -> str:
    """What stands in for Python: it prints what make passes on."""
    path = tmp_path / "python"
    path.write_text("#!/bin/sh\nenv | grep '^MAKE_'\n")
    path.chmod(0o755)
    return f"PYTHON={path}"


@pytest.mark.parametrize("word", ["friction", *WORDS])
@pytest.mark.parametrize(
    ("name", "near"),
    [("SECTON", "near it: SECTION"), ("section", "near it: SECTION"), ("READY", ""), ("MAKE_UNKNOWN", "")],
)
def test_a_misspelt_variable_is_refused_and_not_executed(name, near, word, tmp_path):
    canary = tmp_path / "canary"
    done = make("rerun", f"PYTHON={sys.executable}", f"{name}={word.format(canary)}")
    assert done.returncode == 2 and done.stdout == ""
    [line] = said(done)
    assert line.startswith(f"{name}= is no variable of make here") and near in line
    assert not canary.exists()


@pytest.mark.parametrize("name", ["name", "GIVEN", *NAMES])
@pytest.mark.parametrize("word", WORDS)
def test_no_value_is_executed(name, word, python, tmp_path):
    canary = tmp_path / "canary"
    make("status", python, *([] if name == "PYTHON" else [f"{name}={word.format(canary)}"]))
    assert not canary.exists()


@pytest.mark.parametrize("target", ["rerun", "test", "torture", "lint"])
def test_every_variable_arrives_as_it_was_typed(target, python):
    given = {name: f"a '$(b)' ${name} \\" for name in NAMES if name != "PYTHON"}
    done = make(target, python, *(f"{name}={value}" for name, value in given.items()))
    passed = done.stdout.splitlines()
    assert done.returncode == 0, done.stderr
    assert {f"MAKE_{name}={value}" for name, value in given.items()} <= set(passed)
    assert "MAKE_UNKNOWN=" in passed


def test_what_is_for_make_itself_or_of_a_make_above_is_no_variable_of_the_project(python):
    for options in ("-j8", "-k -B", "-e", "SHELL=/bin/sh", "MAKEFLAGS=-s"):
        assert "MAKE_UNKNOWN=" in make("status", python, *options.split()).stdout.splitlines(), options
    assert "MAKE_UNKNOWN=" in make("status", python, "CC=gcc", level="1").stdout.splitlines()
