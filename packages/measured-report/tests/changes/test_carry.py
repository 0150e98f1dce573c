"""Test that records are carried over a change of code if quick runs of both codes cover
it, and refused otherwise.
"""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import pytest
from toys import GENERATOR, git, put

from measured_report.changes import carry
from measured_report.changes.carry import carried
from measured_report.editions.project import Project, own_release
from measured_report.editions.release import release_of
from measured_report.editions.status import states_of
from measured_report.measuring.measure import MODULE
from measured_report.records.record import load_record, write_record

SETTINGS = """title = "A report"
name = "a-report"
edition = "numpy"
pages = [{ name = "index", label = "Overview", texts = [] }, { name = "results", label = "Results" }]

[[columns]]
kind = "cost"
names = ["frame_ms"]
"""
SECTION = "def derive(results):\n    pass\n"
START = """import numpy as np

from experiments.parts import tools
from measured_report.measuring.measurement import Measurement


def rows(value):
    return Measurement([{"case": "a", "value_mm": float(value)}])

"""
TOOLS = '''import inspect
import textwrap


def kernel(function):
    """Compile the source of a function, as a language for GPUs does. Python never runs it."""
    lines = textwrap.dedent(inspect.getsource(function)).splitlines()
    names = {}
    exec("\\n".join(lines[1:]), names)
    return names[function.__name__]


def near(x):
    return 2.0 * x


def far(x):
    return 2.5 * x


class Car:
    def advance(self):
        return 1.0
'''
MEASURE = "def measure(conditions):\n"
BODY = (
    MEASURE
    + "    x = 2.0\n    n = 4 if conditions.quick else 40\n    {}\n    return rows(x)\n"
)
KERNEL = "@tools.kernel\ndef k(x):\n    {}\n\n\n" + BODY.format("x = k(x)")
ROWS = BODY.format("").replace("rows(x)", "Measurement((3 * [*rows(x).rows]){})")
CAR = "class Car:\n    def advance(self):\n        return {}\n\n\n"
CAR += BODY.format("x = x if conditions.quick else Car().advance()")
POOL = (
    "from measured_report.measuring.pool import gather, processes, start\n\n\ndef f(x):\n{}\n\n\n"
    + MEASURE
)
POOL += "    with processes(1) as pool:\n        [x] = gather(start(pool, f, [(0.3,)]), 'f')\n    return rows(x)\n"

REFUSED = {  # the code before, the code after, and the reason
    "number": (
        BODY.format("x = x * 1.5 - n"),
        BODY.format("x = x - n * 1.5"),
        "value_mm of a changes from -1.0 to -4.0",
    ),
    "last_bit": (
        BODY.format("x = 0.1 + 1e8 - 1e8"),
        BODY.format("x = 0.1 + (1e8 - 1e8)"),
        "value_mm of a changes from 0.099999994 to 0.1",
    ),
    "full_constant": (
        BODY.format("n = min(n, 7)"),
        BODY.format("n = min(n, 8)"),
        "constant",
    ),
    "square": (BODY.format("x = x * 2"), BODY.format("x = x ** 2"), "operator"),
    "kernel": (
        KERNEL.format("return x * x + x"),
        KERNEL.format("return x + x * x"),
        "the quick run does not call",
    ),
    "default": (
        "def f(x, n=40):\n    return n * x\n\n\n"
        + BODY.format("x = f(x, 4) if conditions.quick else f(x)"),
        "def f(x, n=41):\n    return n * x\n\n\n"
        + BODY.format("x = f(x, 4) if conditions.quick else f(x)"),
        "a default or a decorator",
    ),
    "seed": (
        BODY.format("x = np.random.default_rng(7).random()"),
        BODY.format("x = np.random.default_rng(8).random()"),
        "constant",
    ),
    "full_seed": (
        BODY.format("x = x if conditions.quick else np.random.default_rng(7).random()"),
        BODY.format("x = x if conditions.quick else np.random.default_rng(8).random()"),
        "constant",
    ),
    "table": (
        'COUNTS = {"full": 40, "quick": 4}\n\n\n'
        + BODY.format("x = COUNTS[conditions.profile]"),
        'COUNTS = {"full": 41, "quick": 4}\n\n\n'
        + BODY.format("x = COUNTS[conditions.profile]"),
        "a statement that runs at the import of experiments/table.py has changed",
    ),
    "field": (
        "class Case:\n    frames = 400\n\n\n"
        + BODY.format("x = 4.0 if conditions.quick else Case.frames"),
        "class Case:\n    frames = 401\n\n\n"
        + BODY.format("x = 4.0 if conditions.quick else Case.frames"),
        "a statement that runs",
    ),
    "advance": (
        CAR.format("0.1 + 0.2"),
        CAR.format("0.2 + 0.1"),
        "does not call all of experiments/advance.py:Car.advance",
    ),
    "int16": (
        BODY.format("x = float(np.int32(n))"),
        BODY.format("x = float(np.int16(n))"),
        "name int",
    ),
    "alias": (
        "from numpy import int32 as whole\n\n\n" + BODY.format("x = float(whole(n))"),
        "from numpy import int16 as whole\n\n\n" + BODY.format("x = float(whole(n))"),
        "name int",
    ),
    "other_function": (
        BODY.format("x = x if conditions.quick else tools.near(x)"),
        BODY.format("x = x if conditions.quick else tools.far(x)"),
        "name ",
    ),
    "swapped_methods": (
        CAR.format("1.0").replace(
            "class Car:\n", "class Car:\n    def stop(self):\n        return 2.0\n\n"
        ),
        CAR.format("2.0").replace(
            "class Car:\n", "class Car:\n    def stop(self):\n        return 1.0\n\n"
        ),
        "the quick run does not call",
    ),
    "in_a_pool": (
        POOL.format("    return x if x < 5 else x + x"),
        POOL.format("    return x if x < 5 else x * x"),
        "operator",
    ),
    "unread_lambda": (
        BODY.format(
            "x = (lambda: x)() if conditions.quick else (lambda y: y + x - y)(x)"
        ),
        BODY.format(
            "x = (lambda: x)() if conditions.quick else (lambda y: y - y + x)(x)"
        ),
        "the quick run does not call",
    ),
    "import_time": (
        BODY.format(""),
        "np.seterr(all='raise')\n\n\n" + BODY.format(""),
        "a statement that runs",
    ),
    "row": (
        ROWS.format("[1:][:2]"),
        ROWS.format("[2:][:1]"),
        "the number of rows changes from 2 to 1",
    ),
    "broken": (
        BODY.format(""),
        BODY.format("raise ValueError('as a test')"),
        "the old or the new code could not be measured",
    ),
    "times": (
        BODY.format("").replace(
            "rows(x)", 'Measurement([{"case": "a", "frame_ms": x}])'
        ),
        BODY.format("y = x").replace(
            "rows(x)", 'Measurement([{"case": "a", "frame_ms": y}])'
        ),
        "it measures times, which cannot be carried: use make rerun SECTION=times",
    ),
}
CARRIED = {
    "rewritten": (  # a renamed function and variable, an extracted function, a new check
        "def f(x):\n    return x if x < 5 else -x\n\n\n"
        + BODY.format(
            "if x < 0:\n        raise ValueError('it is negative')\n"
            "    for step in range(5):\n        x = x * 1.5 - step\n"
            "    y = 3.0 * x\n    x = f(y if conditions.quick else y - x)"
        ),
        "def g(x):\n    return x if x < 5 else -x\n\n\n"
        "def walked(x):\n    for step in range(5):\n        x = x * 1.5 - step\n    return x\n\n\n"
        + BODY.format(
            "for y in [x, n]:\n        if y < 0:\n            raise ValueError(f'{y} is negative')\n"
            "    x = walked(x)\n"
            "    near = 3.0 * x\n    x = g(near if conditions.quick else near - x)"
        ),
    ),
    "moved_function": (
        "def summed(values):\n    total = 0.0\n    for value in values:\n        total += value\n    return total\n\n\n"
        + BODY.format("x = summed([x, x])"),
        "from experiments.parts import moved\n\n\n"
        + BODY.format("x = moved.summed([x, x])"),
    ),
    "in_a_worker": (
        POOL.format("    return 2.0 * x"),
        POOL.format("    x = 2.0 * x\n    return x"),
    ),
}
MOVED = "def summed(values):\n    total = 0.0\n    for value in values:\n        total += value\n    return total\n"
PLANTED = {**{name: pair[:2] for name, pair in REFUSED.items()}, **CARRIED}


@contextmanager
def measured(root: Path, sections: dict[str, str]) -> Iterator[Project]:
    """Return a report whose sections were measured by the code of its first commit."""
    for name, text in sections.items():
        put(root, f"experiments/{name}.py", START + "\n" + text)
        put(root, f"report/sections/{name}.py", SECTION)
    for name, text in {
        "report.toml": SETTINGS,
        "pyproject.toml": f'dependencies = ["numpy=={__import__("numpy").__version__}"]\n',
        "experiments/__init__.py": "",
        "experiments/parts/__init__.py": "",
        "experiments/parts/tools.py": TOOLS,
        "report/__init__.py": "",
        "report/sections/__init__.py": "",
        ".gitignore": "results/quick\n__pycache__\n",
    }.items():
        put(root, name, text)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", str(GENERATOR))
        git(root, "init", "--quiet")
        git(root, "add", ".")
        git(root, "commit", "--quiet", "-m", "to be measured")
        command = [sys.executable, "-m", MODULE, "--device", "cpu", *sections]
        subprocess.run(
            command, cwd=root, check=True, env={**os.environ, "TQDM_DISABLE": "1"}
        )
        git(root, "add", ".")
        git(root, "commit", "--quiet", "-m", "measured")
        project = Project("", root=root)
        with project.report:
            own = own_release(root)
            yield replace(project, release=own, own_release=own)


def change(
    project: Project, sections: dict[str, str], is_committed: bool = True
) -> None:
    for name, text in sections.items():
        put(project.root, f"experiments/{name}.py", START + "\n" + text)
    if is_committed:
        git(project.root, "add", ".")
        git(project.root, "commit", "--quiet", "--allow-empty", "-m", "changed")


def carry_all(project: Project, *names: str) -> dict[str, str]:
    return dict(carried(project, release_of(project.release), names))


@pytest.fixture(scope="module")
def answers(tmp_path_factory):
    """Return the reason for refusing each planted change, and both records."""
    with measured(
        tmp_path_factory.mktemp("carry") / "project",
        {name: old for name, (old, _) in PLANTED.items()},
    ) as it:
        before = {name: load_record(it.record_path(name)) for name in PLANTED}
        put(it.root, "experiments/parts/moved.py", MOVED)
        change(it, {name: new for name, (_, new) in PLANTED.items()})
        reasons = carry_all(it, *PLANTED)
        after = {name: load_record(it.record_path(name)) for name in PLANTED}
        kinds = {state.section: state.kind for state in states_of(it)}
        assert (
            "worktree" not in git(it.root, "status")
            and len(git(it.root, "worktree", "list").splitlines()) == 1
        )
    return {
        name: (reasons[name], before[name], after[name], kinds[name])
        for name in PLANTED
    }


@pytest.mark.parametrize("name", REFUSED)
def test_a_change_that_may_change_a_number_is_refused_and_nothing_is_written(
    answers, name
):
    reason, before, after, kind = answers[name]
    assert REFUSED[name][2] in reason
    assert (before, kind) == (after, "stale")


@pytest.mark.parametrize("name", CARRIED)
def test_a_change_that_quick_runs_cover_is_carried_with_the_rows(answers, name):
    reason, before, after, kind = answers[name]
    assert (reason, kind) == ("", "fresh")
    assert (
        after.rows == before.rows
        and after.measured == before.measured
        and not before.carried
    )
    [carried] = after.carried
    assert carried.code == before.identity.code and carried.cells == 2
    assert str(carried).endswith(
        "cells are bit-identical; the full profile was not run again."
    )


SIMPLE = {"one": BODY.format("x = x + 1.0"), "two": BODY.format("x = x + 1.0")}
COVERED = {"one": BODY.format("y = x + 1.0\n    x = y")}


@pytest.fixture
def simple(tmp_path) -> Iterator[Project]:
    with measured(tmp_path / "project", SIMPLE) as project:
        yield project


def test_comments_and_formatting_need_no_carrying_and_changes_without_a_commit_are_refused(
    simple,
):
    change(
        simple,
        {"one": "# A remark.\n" + BODY.format("x = (\n        x + 1.0\n    )")},
        is_committed=False,
    )
    assert [state.kind for state in states_of(simple)] == ["fresh", "fresh"]
    change(simple, COVERED, is_committed=False)
    assert "uncommitted changes" in carry_all(simple, "one")["one"]
    change(simple, {})
    assert carry_all(simple, "one", "two") == {
        "one": "",
        "two": "its code has not changed: it does not need to be carried",
    }


def while_it_runs(monkeypatch, event) -> None:
    """Call a function after both codes have run."""
    compare = carry.first_difference

    def happened(*runs) -> str:
        event()
        return compare(*runs)

    monkeypatch.setattr(carry, "first_difference", happened)


def test_code_that_changes_while_it_runs_is_not_certified(simple, monkeypatch):
    before = simple.record_path("one").read_bytes()
    change(simple, COVERED)
    while_it_runs(
        monkeypatch,
        lambda: change(simple, {"one": BODY.format("x = x + 8.0")}, is_committed=False),
    )
    assert "the code of one changed in the meantime" in carry_all(simple, "one")["one"]
    assert simple.record_path("one").read_bytes() == before


def test_a_newer_record_is_not_replaced(simple, monkeypatch):
    change(simple, COVERED)
    path = simple.record_path("one")
    newer = replace(load_record(path), rows=[{"case": "a", "value_mm": 5.0}])
    while_it_runs(monkeypatch, lambda: write_record(path, newer))
    assert "was changed by another command" in carry_all(simple, "one")["one"]
    assert load_record(path).rows == newer.rows


HOOK = """#!/bin/sh
exec {python} -c '
from pathlib import Path
from measured_report.changes.carry import carried
from measured_report.editions.project import Project, own_release
from measured_report.editions.release import release_of
own = own_release()
print(dict(carried(Project(own, own_release=own), release_of(own), ["one"])))
' > said 2>&1
"""


def test_in_a_hook_of_git_the_index_stays_as_it_is(simple):
    change(simple, COVERED)
    hook = simple.root / ".git/hooks/pre-commit"
    hook.parent.mkdir(exist_ok=True)
    hook.write_text(HOOK.format(python=sys.executable))
    hook.chmod(0o700)
    put(simple.root, "notes.txt", "new")
    git(simple.root, "add", "notes.txt")
    git(simple.root, "commit", "--quiet", "-m", "with a note")
    assert (simple.root / "said").read_text() == "{'one': ''}\n"
    assert (
        git(simple.root, "show", "--format=", "--name-status", "HEAD") == "A\tnotes.txt"
    )
