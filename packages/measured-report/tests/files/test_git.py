"""Test that only one module writes files, and that only one starts git."""

import ast
from pathlib import Path

import pytest
from toys import GENERATOR
from toys import git as git_of_tests

from measured_report.files.errors import UsageError
from measured_report.files.git import environment, git, run_git

WRITING = {"write_text", "write_bytes"}
PLACES = ("files/", "commands/audit.py", "changes/executed.py", "skeleton/")
"""Modules that write files or start git, and programs that run without the generator.
"""


def other_ways(path: Path) -> list[str]:
    """Return the lines of a module that write a file or start git directly."""
    found = []
    for node in ast.walk(ast.parse(path.read_bytes())):
        if isinstance(node, ast.Call):
            name = (
                node.func.attr
                if isinstance(node.func, ast.Attribute)
                else getattr(node.func, "id", "")
            )
            of_module = getattr(getattr(node.func, "value", None), "id", "")
            texts = [
                each.value
                for each in node.args
                if isinstance(each, ast.Constant) and isinstance(each.value, str)
            ]
            is_opened = (
                name == "open"
                and of_module != "tarfile"
                and any(text[0] in "wax" for text in texts if text)
            )
            if name in WRITING or is_opened:
                found.append(ast.unparse(node))
        elif (
            isinstance(node, ast.List | ast.Tuple)
            and node.elts
            and ast.unparse(node.elts[0]) == "'git'"
        ):
            found.append(ast.unparse(node))
    return found


def test_nothing_else_writes_files_or_starts_git():
    package = GENERATOR / "measured_report"
    paths = {
        path.relative_to(package).as_posix(): path for path in package.rglob("*.py")
    }
    others = {
        name: other_ways(path)
        for name, path in paths.items()
        if not name.startswith(PLACES)
    }
    assert {name: found for name, found in others.items() if found} == {}
    assert other_ways(package / "files/atomic.py") and other_ways(
        package / "files/git.py"
    )


def test_git_is_asked_of_its_folder_whatever_a_hook_has_set_and_runs_no_hook(
    checkout, monkeypatch, tmp_path
):
    commit = git_of_tests(checkout, "rev-parse", "HEAD")
    hook = checkout / ".git/hooks/post-checkout"
    hook.parent.mkdir(exist_ok=True)
    hook.write_text(f"#!/bin/sh\ntouch {tmp_path}/ran\n")
    hook.chmod(0o700)
    for name in ("GIT_DIR", "GIT_INDEX_FILE", "GIT_WORK_TREE"):
        monkeypatch.setenv(name, str(tmp_path / "nothing"))
    monkeypatch.setenv("GIT_SSH_COMMAND", "ssh -4")
    assert git(checkout, "rev-parse", "HEAD") == commit
    run_git(checkout, "checkout", "--quiet", "--detach")
    assert not (tmp_path / "ran").exists() and not (tmp_path / "nothing").exists()
    assert (
        environment(GIT_DIR="x")["GIT_DIR"] == "x"
        and environment()["GIT_SSH_COMMAND"] == "ssh -4"
    )


def test_where_git_fails_it_says_why_or_nothing(tmp_path):
    assert git(tmp_path, "rev-parse", "HEAD") == ""
    with pytest.raises(UsageError, match=r"^git: fatal: not a git repository[^\n]*$"):
        run_git(tmp_path, "rev-parse", "HEAD")
