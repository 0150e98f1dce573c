"""The workflow of the alarm, as far as that goes without GitHub: its scripts, run as a runner runs them."""

import os
import re
import subprocess
import textwrap
from itertools import chain
from pathlib import Path

import pytest

from measured_report.commands.new import SKELETON
from measured_report.files.root import ROOT

WORKFLOWS = ROOT / ".github/workflows", SKELETON / "dot.github/workflows"
SCRIPT = re.compile(r"^        run: \|\n((?:          .*\n)+)", re.MULTILINE)
PROGRAM = """#!/bin/bash
printf '%s|' "${0##*/}" "$@" >> "$FOLDER/log"; echo >> "$FOLDER/log"
case "$1 $2" in
  "label create") exit 1;;
  "issue list") printf %s "$OPEN_ISSUE";;
  "build.py newest") printf 'newton=1.9.0\\nwith=\\n';;
  "build.py upgrade") printf %s "$ANSWER"; echo "it took a while" >&2; exit "$STATUS";;
esac
"""
"""In place of ``gh`` and of Python."""


def run_script(folder: Path, number: int, **settings: str) -> subprocess.CompletedProcess:
    """A script of the workflow as a runner runs it, in a folder with programs that note what they are called with."""
    for name in ("gh", ".venv/bin/python", "nvidia-smi"):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("#!/bin/bash\nexit 1\n" if name == "nvidia-smi" else PROGRAM)
        path.chmod(0o755)
    script = textwrap.dedent(SCRIPT.findall((ROOT / ".github/workflows/upgrade.yml").read_text())[number + 1])
    given = {"FOLDER": folder, "GITHUB_OUTPUT": folder / "output", "PATH": f"{folder}:{os.environ['PATH']}", **settings}
    command = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script]
    return subprocess.run(command, cwd=folder, env=given, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(
    ("answer", "status", "comment"),
    [("all is well", "0", "all is well"), ("it flips", "1", "it flips"), ("", "1", "It could not be")]
    + [("", "2", "It could")],
)
def test_the_workflow_comments_with_the_answer_or_with_why_there_is_none(tmp_path, answer, status, comment):
    done = run_script(tmp_path, 1, NEWTON="1.9.0", WITH="", ANSWER=answer, STATUS=status)
    assert done.returncode == 0 and (tmp_path / "output").read_text().startswith(f"status={status}\ncomment<<")
    said = (tmp_path / "comment.md").read_text()
    assert said.startswith(comment) and ("it took a while" in said) == (not answer)
    called = (tmp_path / "log").read_text()
    assert called == "python|build.py|upgrade|--newton|1.9.0|--with||--profile|quick|--format|markdown|\n"


def test_finding_8_workflows_name_what_they_run_by_its_content_and_keep_no_credentials():
    shown = [ROOT / "packages/newton-lint/README.md"]
    for workflow in (*shown, *chain(*(folder.glob("*.yml") for folder in WORKFLOWS))):
        text = textwrap.dedent(workflow.read_text().partition("scenes.yml\n")[2] or workflow.read_text())
        used = re.findall(r"uses: (\S+)", text)
        assert used and all(re.fullmatch(r"[\w/-]+@[0-9a-f]{40}", action) for action in used), workflow
        kept_nothing = re.findall(r"actions/checkout@.*\n        with:\n          persist-credentials: false\n", text)
        assert len(kept_nothing) == text.count("actions/checkout@"), workflow
        assert workflow in shown or not re.search(r"pip install|astral\.sh|setup-uv", text), "the lock says which uv"


@pytest.mark.parametrize(("open_issue", "call"), [("", "gh|issue|create|--label|upgrade"), ("7", "gh|issue|edit|7")])
def test_the_workflow_keeps_one_issue(tmp_path, open_issue, call):
    title = 'Upgrade: newton 1.9.0 "$(touch evil)"'
    assert run_script(tmp_path, 2, OPEN_ISSUE=open_issue, TITLE=title, COMMENT="$(touch evil)").returncode == 0
    assert (tmp_path / "log").read_text().splitlines()[-1] == f"{call}|--title|{title}|--body-file|comment.md|"
    assert not (tmp_path / "evil").exists()


@pytest.mark.parametrize("folder", WORKFLOWS, ids=["here", "new"])
def test_the_job_that_may_write_runs_nothing_that_was_measured(folder):
    before, rest = (folder / "upgrade.yml").read_text().split("\n  upgrade:\n")
    measuring, writing = rest.split("\n  issue:\n")
    assert ": write" not in before + measuring and "github.token" not in measuring and "issues: write" in writing
    assert not any(re.search("build.py|make ", job) for job in (before.partition("jobs:")[2], writing))
    assert "uses:" not in writing


@pytest.mark.parametrize("folder", WORKFLOWS, ids=["here", "new"])
def test_what_was_measured_is_kept_and_used_the_next_time(folder):
    text = (folder / "upgrade.yml").read_text()
    kept = re.search(r"name: measured\n +path: (\S+)\n", text)[1]
    assert f"name: before\n          path: {kept}\n" in text and "--name measured" in text


def test_a_new_report_takes_the_uv_of_the_lock_by_its_bytes():
    version, *hashes = re.findall(r"uv==(\S+)|hash=(\S+)", (SKELETON / "uv.txt").read_text())
    lock = (ROOT / "uv.lock").read_text().partition('name = "uv"\nversion = "' + version[0])[2].partition("\n\n")[0]
    assert len(hashes) == 4 and all(digest in lock for _, digest in hashes)
    assert "--require-hashes" in (SKELETON / "Makefile").read_text()
