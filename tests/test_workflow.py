"""Test the workflow of the alarm without GitHub: its scripts are run as a runner runs
them.
"""

import os
import re
import subprocess
import sys
import textwrap
from itertools import chain
from pathlib import Path

import pytest
from toys import ROWS, Toy, git, lay_out

from measured_report.commands.new import SKELETON
from measured_report.editions.project import Project
from measured_report.files.config import report_in
from measured_report.files.root import ROOT

WORKFLOWS = ROOT / ".github/workflows", SKELETON / "dot.github/workflows"
SCRIPT = re.compile(r"^      [ -] run: \|\n((?:          .*\n)+)", re.MULTILINE)
PROGRAM = """#!/bin/bash
printf '%s|' "${0##*/}" "$@" >> "$FOLDER/log"; echo >> "$FOLDER/log"
case "$1 $2" in
  "label create") exit 1;;
  "run list") echo "$RUNS";;
  "run download") [ "$3" != 3 ] || exit 1;;
  "issue list") printf %s "$OPEN_ISSUE";;
  "build.py newest") printf 'newton=1.9.0\\nwith=\\n';;
  "build.py upgrade") printf %s "$ANSWER"; echo "it took a while" >&2; exit "$STATUS";;
esac
"""
"""Replaces ``gh`` and Python."""


def run_script(
    folder: Path,
    number: int,
    workflow: Path = WORKFLOWS[0] / "upgrade.yml",
    **settings: str,
) -> subprocess.CompletedProcess:
    """Run a script of the workflow as a runner does, in a folder with programs that
    record their arguments.
    """
    for path in (
        folder / name
        for name in ("gh", ".venv/bin/python", "nvidia-smi")
        if not (folder / name).exists()
    ):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(
            "#!/bin/bash\nexit 1\n" if path.name == "nvidia-smi" else PROGRAM
        )
        path.chmod(0o755)
    script = textwrap.dedent(SCRIPT.findall(workflow.read_text())[number])
    given = {
        "FOLDER": folder,
        "GITHUB_OUTPUT": folder / "output",
        "PATH": f"{folder}:{os.environ['PATH']}",
        **settings,
    }
    command = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script]
    return subprocess.run(
        command, cwd=folder, env=given, capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize(
    ("answer", "status", "comment"),
    [
        ("all is well", "0", "all is well"),
        ("it flips", "1", "it flips"),
        ("", "1", "It could not be"),
    ]
    + [("", "2", "It could")],
)
def test_the_workflow_comments_with_the_answer_or_with_why_there_is_none(
    tmp_path, answer, status, comment
):
    done = run_script(
        tmp_path, 3, NEWTON="1.9.0", WITH="", ANSWER=answer, STATUS=status
    )
    assert done.returncode == 0 and (tmp_path / "output").read_text().startswith(
        f"status={status}\ncomment<<"
    )
    said = (tmp_path / "comment.md").read_text()
    assert said.startswith(comment) and ("it took a while" in said) == (not answer)
    called = (tmp_path / "log").read_text()
    assert (
        called
        == "python|build.py|upgrade|--newton|1.9.0|--with||--profile|quick|--format|markdown|\n"
    )


def test_the_newest_release_is_measured_again_on_a_gpu_and_compared_anew(tmp_path):
    given = {"NEWTON": "1.8.0", "WITH": "", "ANSWER": "as before", "STATUS": "0"}
    run_script(tmp_path, 3, AGAIN="true", **given)
    assert not (tmp_path / "log").exists(), "quick runs on a CPU are bit-identical"
    (tmp_path / "nvidia-smi").write_text("#!/bin/bash\nexit 0\n")
    run_script(tmp_path, 3, AGAIN="true", **given)
    calls = (tmp_path / "log").read_text().splitlines()
    assert calls[0] == "python|build.py|replicate|--newton|1.8.0|--with||"
    assert calls[1].startswith(
        "python|build.py|upgrade|--newton|1.8.0|--with||--profile|full|"
    )


def test_measurements_of_a_tracked_release_join_its_replicas(tmp_path):
    for folder in (
        "before/results-1.8.0/newton-1.8.0/replicas",
        "results/newton-1.8.0",
    ):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "before/results-1.8.0/newton-1.8.0/replicas/a.tgz").write_text("a")
    assert run_script(tmp_path, 1).returncode == 0
    assert (tmp_path / "results/newton-1.8.0/replicas/a.tgz").read_text() == "a"


def test_finding_8_workflows_name_what_they_run_by_its_content_and_keep_no_credentials():
    shown = [ROOT / "packages/newton-lint/README.md", ROOT / "docs/audit.md"]
    for workflow in (*shown, *chain(*(folder.glob("*.yml") for folder in WORKFLOWS))):
        text = textwrap.dedent(
            workflow.read_text().partition("scenes.yml\n")[2] or workflow.read_text()
        )
        used = re.findall(r"uses: (\S+)", text)
        assert used and all(
            re.fullmatch(r"[\w/-]+@[0-9a-f]{40}", action) for action in used
        ), workflow
        kept_nothing = re.findall(
            r"actions/checkout@.*\n        with:\n          persist-credentials: false\n",
            text,
        )
        assert len(kept_nothing) == text.count("actions/checkout@"), workflow
        assert workflow in shown or not re.search(
            r"pip install|astral\.sh|setup-uv", text
        ), "the lock says which uv"


@pytest.mark.parametrize(
    ("open_issue", "call"),
    [("", "gh|issue|create|--label|upgrade"), ("7", "gh|issue|edit|7")],
)
def test_the_workflow_keeps_one_issue(tmp_path, open_issue, call):
    title = 'Upgrade: newton 1.9.0 "$(touch evil)"'
    assert (
        run_script(
            tmp_path, 4, OPEN_ISSUE=open_issue, TITLE=title, COMMENT="$(touch evil)"
        ).returncode
        == 0
    )
    assert (tmp_path / "log").read_text().splitlines()[
        -1
    ] == f"{call}|--title|{title}|--body-file|comment.md|"
    assert not (tmp_path / "evil").exists()


@pytest.mark.parametrize("folder", WORKFLOWS, ids=["here", "new"])
def test_the_job_that_may_write_runs_nothing_that_was_measured(folder):
    before, rest = (folder / "upgrade.yml").read_text().split("\n  upgrade:\n")
    measuring, writing = rest.split("\n  issue:\n")
    assert (
        ": write" not in before + measuring
        and "github.token" not in measuring
        and "issues: write" in writing
    )
    assert not any(
        re.search("build.py|make ", job)
        for job in (before.partition("jobs:")[2], writing)
    )
    assert "uses:" not in writing


@pytest.mark.parametrize("folder", WORKFLOWS, ids=["here", "new"])
def test_what_was_measured_is_kept_and_used_the_next_time(folder, tmp_path):
    run_script(tmp_path, 0, workflow=folder / "upgrade.yml", RUNS="3 2 1")
    calls = (tmp_path / "log").read_text().splitlines()[1:]
    assert calls == [
        f"gh|run|download|{run}|--pattern|results-*|--dir|measured|" for run in (3, 2)
    ], "3 has none"
    kept = ("newton-1.9.0", "quick/newton-1.9.0", "newton-1.9.0@cpu")
    for name in (
        *kept,
        "newton-1.9.0.1",
        "newton-1.4.0",
        "quick/newton-1.4.0",
        "newton-99.0.0",
        "timed/newton-1.9.0",
    ):
        (tmp_path / "before/results-1.9.0" / name).mkdir(parents=True)
    (tmp_path / "results/newton-1.9.0").mkdir(parents=True)  # tracked
    assert run_script(tmp_path, 1, workflow=folder / "upgrade.yml").returncode == 0
    assert {
        str(path.parent.relative_to(tmp_path / "results") / path.name)
        for path in (tmp_path / "results").rglob("*-*")
    } == {*kept}
    assert not (tmp_path / "results/newton-1.9.0/newton-1.9.0").exists()


def test_a_pull_request_that_moves_to_another_release_is_compared_with_that_of_its_base(
    tmp_path,
):
    lay_out(folder := tmp_path / "project")
    for release in ("1.4.0", "1.9.0"):
        with report_in(folder):
            toy = Toy(Project(release, root=folder))
            toy.write(
                "pyproject.toml",
                f'[project]\ndependencies = ["newton[sim]=={release}"]\n',
            )
            toy.measure(
                ({**ROWS[0], "slip_mm": 9.0}, ROWS[1]) if release == "1.9.0" else ROWS
            )
        git(folder, "init", "--quiet")
        git(folder, "add", "--all")
        git(folder, "commit", "--quiet", "--message", release)
    toy.write(".venv/bin/python", f'#!/bin/bash\nexec {sys.executable} "$@"\n')
    (folder / ".venv/bin/python").chmod(0o755)
    paths = f"{folder}{os.pathsep}{ROOT / 'packages/measured-report'}"
    base = git(folder, "rev-parse", "HEAD~1")
    done = run_script(
        folder,
        0,
        SKELETON / "dot.github/workflows/changes.yml",
        BASE=base,
        PYTHONPATH=paths,
    )
    comment = (folder / "comment.md").read_text()
    assert done.returncode == 0 and "newton 1.4.0@base → newton 1.9.0: " in comment, (
        comment + done.stderr
    )
    assert "+41 % worse (toy soft)" in comment and "faults: 0" in comment, comment


def test_a_new_report_takes_the_uv_of_the_lock_by_its_bytes():
    version, *hashes = re.findall(
        r"uv==(\S+)|hash=(\S+)", (SKELETON / "uv.txt").read_text()
    )
    lock = (
        (ROOT / "uv.lock")
        .read_text()
        .partition('name = "uv"\nversion = "' + version[0])[2]
        .partition("\n\n")[0]
    )
    assert len(hashes) == 4 and all(digest in lock for _, digest in hashes)
    assert "--require-hashes" in (SKELETON / "Makefile").read_text()


def test_what_the_suite_samples_is_tested_each_week():
    text = (ROOT / ".github/workflows/mutation.yml").read_text(encoding="utf-8")
    command = text.partition("WORLDS=1000 ")[2].partition("\n      - ")[0]
    folders = (ROOT / "tests", ROOT / "packages")
    sampled = {
        path.relative_to(ROOT).as_posix()
        for path in chain(*(folder.rglob("test_*.py") for folder in folders))
        if re.search(r"\b(IS_WEEKLY|WORLDS)\b", path.read_text(encoding="utf-8"))
    }
    sampled.remove(Path(__file__).relative_to(ROOT).as_posix())
    assert len(sampled) > 5 and {*re.findall(r"\S+\.py", command)} == sampled


def test_every_room_of_the_generator_is_mutated_each_week():
    text = (ROOT / ".github/workflows/mutation.yml").read_text(encoding="utf-8")
    rooms = re.search(r"room: \[(.*)\]", text)[1].split(", ")
    generator = ROOT / "packages/measured-report/measured_report"
    folders = {path.parent.name for path in generator.glob("*/[a-z]*.py")}
    tests = ROOT / "packages/measured-report/tests"
    assert rooms == sorted(folders - {"skeleton"})
    assert all(any((tests / room).glob("test_*.py")) for room in rooms)
    modules = re.findall(r"\b[a-z]+/[a-z]+\.py\b", text.partition("steps:")[0])
    assert len(modules) == 7 and all((generator / name).is_file() for name in modules)
    # The loop of the job, for one folder and for these modules.
    script = text.partition("- run: |\n")[2].partition("          make mutate")[0]
    for names, count in (("", 7), (" ".join(modules), 7)):
        chosen = subprocess.run(
            ["bash", "-c", f'set -e\n{script}\necho "$module" "${{#modules[@]}}"'],
            env={**os.environ, "ROOM": "values", "MODULES": names},
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=True,
        )
        module, total = chosen.stdout.split()[-2:]
        assert (generator / module).is_file() and int(total) == count
