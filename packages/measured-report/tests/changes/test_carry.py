"""Records over a change of code: carried where quick runs prove that it changes nothing, refused else."""

import os
import subprocess
import sys
from dataclasses import replace
from types import SimpleNamespace

import msgspec
import pytest
from toys import BY_HAND, GENERATOR, git, put

from measured_report.changes.carry import Run, _reasons, carried, first_difference
from measured_report.editions.project import Project, own_release
from measured_report.editions.release import release_of
from measured_report.editions.status import states_of
from measured_report.measuring.measure import MODULE
from measured_report.records.code import unchanged_files
from measured_report.records.columns import units_of
from measured_report.records.identity import identity_of
from measured_report.records.record import Carried, Record, load_record, write_record
from measured_report.records.replicas import mismatch

SETTINGS = """title = "A report"
name = "a-report"
edition = "numpy"
pages = [{ name = "index", label = "Overview", texts = [] }, { name = "results", label = "Results" }]

[[columns]]
kind = "cost"
names = ["frame_ms"]
"""
SECTION = "order = 100\n\n\ndef derive(results):\n    pass\n"
START = """import numpy as np

from experiments.parts import tools
from measured_report.measuring.measurement import Measurement


def rows(conditions, value):
    return Measurement([{"case": "a", "value_mm": float(value)}])

"""
TOOLS = '''import inspect
import textwrap


def kernel(function):
    """Compile what a function says, as a language for GPUs does: its own code is never run."""
    lines = textwrap.dedent(inspect.getsource(function)).splitlines()
    names = {}
    exec("\\n".join(lines[1:]), names)
    return names[function.__name__]


def summed(values):
    total = 0.0
    for value in values:
        total += value
    return total


def near(x):
    return 2.0 * x


def far(x):
    return 2.5 * x


FRAME_COUNT = 40
'''
KERNELS = "from experiments.parts import tools\n\n\n@tools.kernel\ndef moved(x):\n    return 3.0 * x\n"
SHARED = "def scaled(x):\n    y = {}\n    return y\n"
MEASURE = "def measure(conditions):\n"
BODY = MEASURE + "    x = 0.3\n    return rows(conditions, {})\n"
QUICK = MEASURE + "    {}\n    return rows(conditions, x)\n"

CHANGES_A_BIT = {  # what is measured, before and after
    "factor": (BODY.format("x"), BODY.format("x * (1 + 1e-7)")),
    "seed": (BODY.format("np.random.default_rng(7).random()"), BODY.format("np.random.default_rng(8).random()")),
    "frame_less": (BODY.format("sum([x] * len('abcd'))"), BODY.format("sum([x] * (len('abcd') - 1))")),
    "sum_order": (BODY.format("x + 1e9 - 1e9"), BODY.format("x + (1e9 - 1e9)")),
    "kernel": (
        "@tools.kernel\ndef k(x):\n    return 3.0 * x\n\n\n" + BODY.format("k(x)"),
        "@tools.kernel\ndef k(x):\n    return 3.0 * x if x < 1 else 4.0 * x\n\n\n" + BODY.format("k(x)"),
    ),
    "branch": (
        QUICK.format("x = 1.0\n    if not conditions.quick:\n        x = 2.0"),
        QUICK.format("x = 1.0\n    if not conditions.quick:\n        x = 2.0 + 2.0 - 2.0"),
    ),
    "new_branch": (QUICK.format("x = 1.0"), QUICK.format("x = 1.0\n    if not conditions.quick:\n        x = x + x")),
    "gone_branch": (QUICK.format("x = 1.0\n    if not conditions.quick:\n        x = x + x"), QUICK.format("x = 1.0")),
    "guard": (
        QUICK.format("x = 1.0\n    if not conditions.quick:\n        x = 2.0"),
        QUICK.format("x = 1.0\n    if conditions.is_cuda:\n        x = 2.0"),
    ),
    "early_return": (
        MEASURE + "    if conditions.quick:\n        return rows(conditions, 1.0)\n    return rows(conditions, 2.0)\n",
        MEASURE
        + "    if not conditions.is_cuda:\n        return rows(conditions, 1.0)\n    return rows(conditions, 2.0)\n",
    ),
    "table": (
        'COUNTS = {"full": 40, "quick": 4}\n\n\n' + QUICK.format("x = COUNTS[conditions.profile]"),
        'COUNTS = {"full": 41, "quick": 4}\n\n\n' + QUICK.format("x = COUNTS[conditions.profile]"),
    ),
    "tables_swapped": (
        'A = {"full": 5, "quick": 4}\nB = {"full": 6, "quick": 4}\n\n\n'
        + QUICK.format("x = A[conditions.profile] - B[conditions.profile]"),
        'A = {"full": 6, "quick": 4}\nB = {"full": 5, "quick": 4}\n\n\n'
        + QUICK.format("x = A[conditions.profile] - B[conditions.profile]"),
    ),
    "default": (
        "def scaled(x, n=40):\n    return n * x\n\n\n" + BODY.format("scaled(x, 4) if conditions.quick else scaled(x)"),
        "def scaled(x, n=41):\n    return n * x\n\n\n" + BODY.format("scaled(x, 4) if conditions.quick else scaled(x)"),
    ),
    "arm": (BODY.format("x if conditions.quick else 2 * x"), BODY.format("x if conditions.quick else x + x + x - x")),
    "condition": (
        BODY.format("tools.near(x) if conditions.quick else tools.far(x)"),
        BODY.format("tools.near(x) if not conditions.is_cuda else tools.far(x)"),
    ),
    "filter": (
        BODY.format("x + sum(tools.far(n) for n in [x] if not conditions.quick)"),
        BODY.format("x + sum(tools.far(n) for n in [x] if conditions.is_cuda)"),
    ),
    "locals_swapped": (
        QUICK.format("x = 1.0\n    if not conditions.quick:\n        y = tools.far(x)\n        x = y - x"),
        QUICK.format("x = 1.0\n    if not conditions.quick:\n        y = tools.far(x)\n        x = x - y"),
    ),
    "values_swapped": (
        "def f(x, a, b):\n    return x\n\n\n" + BODY.format("f(x, tools.near, tools.far)"),
        "def f(x, a, b):\n    return x\n\n\n" + BODY.format("f(x, tools.far, tools.near)"),
    ),
    "operand": (
        QUICK.format("x = conditions.quick or len('ab') > len('a')"),
        QUICK.format("x = conditions.quick or len('ab') < len('a')"),
    ),
    "handler": (
        QUICK.format("try:\n        x = 1.0\n    except ValueError:\n        x = 2.0"),
        QUICK.format("try:\n        x = 1.0\n    except ValueError:\n        x = 1.0 - 2.0 + 1.0"),
    ),
    "lambda": (
        BODY.format("(lambda: x if conditions.quick else near(x))()").replace("near", "tools.near"),
        BODY.format("(lambda: x if conditions.quick else far(x))()").replace("far", "tools.far"),
    ),
    "comprehension": (
        BODY.format("sum(each for each in [x] if conditions.quick or tools.near(each))"),
        BODY.format("sum(each for each in [x] if conditions.quick or tools.far(each))"),
    ),
    "other_import": (
        "from experiments.parts.tools import near as g\n\n\n" + BODY.format("x if conditions.quick else g(x)"),
        "from experiments.parts.tools import far as g\n\n\n" + BODY.format("x if conditions.quick else g(x)"),
    ),
    "field": (
        "class Case:\n    frames = 400\n    fast = 4\n\n\n"
        + BODY.format("Case.fast if conditions.quick else Case.frames"),
        "class Case:\n    frames = 401\n    fast = 4\n\n\n"
        + BODY.format("Case.fast if conditions.quick else Case.frames"),
    ),
    "method": (
        "class Case:\n    def full(self):\n        return 1.0\n\n    def fast(self):\n        return 2.0\n\n\n"
        + BODY.format("Case().fast() if conditions.quick else Case().full()"),
        "class Case:\n    def full(self):\n        return 2.0\n\n    def fast(self):\n        return 1.0 + 1.0\n\n\n"
        + BODY.format("Case().fast() if conditions.quick else Case().full()"),
    ),
    "other_head": (
        QUICK.format("x = 1.0\n    if tools.near(conditions.quick) < 2:\n        x = 2.0"),
        QUICK.format("x = 1.0\n    if tools.far(conditions.quick) < 2:\n        x = 2.0"),
    ),
    "only_another_section": (
        "from experiments.parts.shared import scaled\n\n\n" + BODY.format("x if conditions.quick else scaled(x)"),
        "from experiments.parts.shared import scaled  # of which the section `shared` runs what this one does not\n\n\n"
        + BODY.format("x if conditions.quick else scaled(x)"),
    ),
    "word": (
        QUICK.format("x = {'full': len, 'quick': sum}[conditions.profile]([1])"),
        QUICK.format("x = {'fully': len, 'quick': sum}[conditions.profile]([1])"),
    ),
}
COUNTED = MEASURE + "    n = 4 if conditions.quick else 40\n    {}\n    return rows(conditions, x)\n"
CHANGES_A_BIT |= {
    "bound": (COUNTED.format("x = min(n, 7)"), COUNTED.format("x = n")),
    "swapped_defaults": (
        "def f(a, b=1, c=2):\n    return a - b\n\n\n" + BODY.format("f(2, 1) if conditions.quick else f(2)"),
        "def f(a, b=2, c=1):\n    return a - b\n\n\n" + BODY.format("f(2, 1) if conditions.quick else f(2)"),
    ),
}
POOLED = "from measured_report.measuring.pool import gather, processes, start\n\n\ndef f(x):\n{}\n\n\n" + MEASURE
POOLED += "    with processes(1) as pool:\n        [x] = gather(start(pool, f, [(0.3,)]), 'f')\n"
POOLED += "    return rows(conditions, x)\n"
CHANGES_A_BIT["pool"] = (
    POOLED.format("    return x if x < 5 else x + x"),
    POOLED.format("    return x if x < 5 else x + x + x"),
)
CHANGES_NOTHING = {
    "in_a_pool": (POOLED.format("    return 2.0 * x"), POOLED.format("    x = 2.0 * x\n    return x")),
    "inlined": (
        "def f(value):\n    return value * 1.5\n\n\n" + COUNTED.format("x = f(n)"),
        COUNTED.format("x = n * 1.5"),
    ),
    "a_class": (
        "def walk(x: float, count: int):\n    for i in range(count):\n        x = x * 1.5 - i\n    return x\n\n\n"
        + COUNTED.format("x = walk(2.0, n)"),
        "class Walk:\n    def __init__(self, count: int):\n        self.count = count\n\n"
        + "    def walk(self, x: float):\n"
        + "        for i in range(self.count):\n            x = x * 1.5 - i\n        return x\n\n\n"
        + COUNTED.format("x = Walk(n).walk(2.0)"),
    ),
    "constant_moved": (
        "FRAME_COUNT = 40\n\n\n" + BODY.format("4 if conditions.quick else FRAME_COUNT"),
        "from experiments.parts.tools import FRAME_COUNT\n\n\n" + BODY.format("4 if conditions.quick else FRAME_COUNT"),
    ),
    "assertion_gone": (QUICK.format("x = 1.0\n    assert x == 1.0, f'it is {x}'"), QUICK.format("x = 1.0")),
    "uses_shared": (
        "from experiments.parts.shared import scaled\n\n\n" + BODY.format("scaled(x)"),
        "from experiments.parts.shared import scaled\n\n\n" + BODY.format("scaled(x)"),
    ),
    "comment": (BODY.format("x"), "# What it is.\n" + BODY.format("x")),
    "renamed": (
        "def f(x):\n    return x if x < 5 else -x\n\n\n" + BODY.format("f(x)"),
        "def g(x):\n    return x if x < 5 else -x\n\n\n" + BODY.format("g(x)"),
    ),
    "moved_elsewhere": (
        "def summed(values):\n    total = 0.0\n    for value in values:\n        total += value\n    return total\n\n\n"
        + BODY.format("summed([x, x])"),
        BODY.format("tools.summed([x, x])"),
    ),
    "extracted": (
        QUICK.format("x = 2.0\n    for step in range(5):\n        x = x * 1.5 - step"),
        "def walked(x):\n    for step in range(5):\n        x = x * 1.5 - step\n    return x\n\n\n"
        + QUICK.format("x = walked(2.0)"),
    ),
    "moved_kernel": (
        "@tools.kernel\ndef k(x):\n    return 3.0 * x\n\n\n" + BODY.format("k(x)"),
        "from experiments.parts.kernels import moved as k\n\n\n" + BODY.format("k(x)"),
    ),
    "seam": (
        MEASURE
        + "    if conditions.is_cuda:\n        x = tools.far(1.0)\n    else:\n        x = tools.near(1.0)\n"
        + "    return rows(conditions, x)\n",
        "class Near:\n    def step(self, x):\n        return tools.near(x)\n\n\n"
        + "def stepper(conditions):\n    if conditions.is_cuda:\n        x = tools.far(1.0)\n    else:\n"
        + "        x = Near().step(1.0)\n    return x\n\n\n"
        + MEASURE
        + "    x = stepper(conditions)\n    return rows(conditions, x)\n",
    ),
    "same_unexecuted": (
        QUICK.format("x = 1.0\n    if not conditions.quick:\n        x = tools.far(x)"),
        QUICK.format("y = 1.0\n    x = y\n    if not conditions.quick:\n        x = tools.far(x)"),
    ),
    "local_renamed_where_unexecuted": (
        QUICK.format("x = 1.0\n    if not conditions.quick:\n        step = tools.far(x)\n        x = step - x"),
        QUICK.format("x = 1.0\n    if not conditions.quick:\n        y = tools.far(x)\n        x = y - x"),
    ),
    "returns_another_type": (
        "def f(x) -> object:\n    return x > 5\n\n\n" + BODY.format("x if conditions.quick else f(x)"),
        "def f(x) -> bool:\n    return x > 5\n\n\n" + BODY.format("x if conditions.quick else f(x)"),
    ),
    "renamed_beside_a_value": (
        COUNTED.format("x = sum(map(tools.near, [n]))"),
        COUNTED.format("m = n\n    x = sum(map(tools.near, [m]))"),
    ),
    "renamed_where_unexecuted": (
        "def f(x):\n    return x > 5\n\n\n" + BODY.format("x if conditions.quick else -x if f(x) else x"),
        "def g(x):\n    return x > 5\n\n\n" + BODY.format("x if conditions.quick else -x if g(x) else x"),
    ),
    "column_gone": (
        BODY.replace("rows(conditions, {})", "Measurement([{'case': 'a', 'value_mm': x, 'other_mm': 2 * x}])"),
        BODY.replace("rows(conditions, {})", "Measurement([{'case': 'a', 'value_mm': x}])"),
    ),
}
TIMED = "from measured_report.measuring.batch import Batch\n\n\ndef step(x):\n    return {}\n\n\n"
TIMED += "def timed(x):\n    step(x)\n    return 5.0\n\n\n" + MEASURE
TIMED += "    [ms] = yield [Batch('times', timed, (1.0,), exclusive=True)]\n"
TIMED += "    return Measurement([{{'case': 'a', 'frame_ms': ms, 'value_mm': {}}}])\n"
TIMES = {
    "what_is_timed": (TIMED.format("x * 1.0", "1.0"), TIMED.format("1.0 * x", "1.0")),
    "beside_times": (TIMED.format("x * 1.0", "1.0 + ms - ms"), TIMED.format("x * 1.0", "ms - ms + 1.0")),
}
PLANTED = CHANGES_A_BIT | CHANGES_NOTHING | TIMES
KEPT = {*CHANGES_NOTHING, "beside_times"}


@pytest.fixture(scope="module")
def answers(tmp_path_factory):
    """Measure all sections by the old code, change it, and carry what can be."""
    root = tmp_path_factory.mktemp("carry") / "project"
    for name, (before, _) in PLANTED.items():
        put(root, f"experiments/{name}.py", START + "\n" + before)
        put(root, f"report/sections/{name}.py", SECTION)
    for name, text in {
        "report.toml": SETTINGS,
        "pyproject.toml": f'dependencies = ["numpy=={__import__("numpy").__version__}"]\n',
        "experiments/__init__.py": "",
        "experiments/parts/__init__.py": "",
        "experiments/parts/tools.py": TOOLS,
        "experiments/parts/kernels.py": KERNELS,
        "experiments/parts/shared.py": SHARED.format("x * 2.0"),
        "report/__init__.py": "",
        "report/sections/__init__.py": "",
        ".gitignore": "results/carry\nresults/quick\n",
    }.items():
        put(root, name, text)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", str(GENERATOR))
        git(root, "init", "--quiet")
        git(root, "add", ".")
        git(root, "commit", "--quiet", "-m", "measured")
        measured = [sys.executable, "-m", MODULE, "--device", "cpu", *PLANTED]
        subprocess.run(measured, cwd=root, check=True, env={**os.environ, "TQDM_DISABLE": "1"})
        for name, (_, after) in PLANTED.items():
            put(root, f"experiments/{name}.py", START + "\n" + after)
        put(root, "experiments/parts/shared.py", SHARED.format("2.0 * x"))
        project = Project("", root=root)
        with project.report:
            own = own_release(root)
            project = Project(own, root=root, own_release=own)
            before = {name: load_record(project.record_path(name)) for name in PLANTED}
            with unchanged_files():
                reasons = dict(carried(project, release_of(own), [*PLANTED], "cpu"))
                kinds = {state.section: state.kind for state in states_of(project)}
            after = {name: load_record(project.record_path(name)) for name in PLANTED}
            old, path = before["new_branch"], project.of("0.1").record_path("new_branch")
            change = Carried(old.identity.code, "1", "2", old.measured["date"], 1, 2)
            identity = identity_of("new_branch", "full", root, old.identity.packages)
            for code, key in ((old.identity.code, "proven"), ("0" * 64, "from_another_code")):
                twin = replace(old, identity=identity, carried=(msgspec.structs.replace(change, code=code),))
                path.parent.mkdir(exist_ok=True)
                write_record(path, twin)
                [(_, reasons[key])] = carried(project, release_of(own), ["new_branch"], "cpu")
                after[key] = load_record(project.record_path("new_branch"))
                write_record(project.record_path("new_branch"), old)
    return reasons, kinds, before, after


@pytest.mark.parametrize(("before", "after", "reasons"), [("a", "a", []), ("a", "b", ["timed"]), ("", "", ["timed"])])
def test_times_are_carried_where_a_device_is_given_the_same_work(before, after, reasons):
    code = SimpleNamespace(unexecuted=lambda *_: [], unread=lambda *_, **__: [], timed=lambda _: ["timed"])
    record = record_of([{"case": "a", "frame_ms": 1.0}])
    works = [{"times": digest} if digest else {} for digest in (before, after)]
    runs = [Run(code, [record], {}, {}, work) for work in works]
    assert _reasons(runs, record) == reasons


def record_of(rows) -> Record:
    return Record(**{**BY_HAND, "section": "a", "identity": None, "units": units_of(rows), "rows": rows})


@pytest.mark.slow
@pytest.mark.parametrize("name", [*PLANTED])
def test_a_record_is_carried_where_nothing_changed_and_else_it_is_not(answers, name):
    reasons, kinds, before, after = answers
    print(name, reasons.get(name))
    assert (kinds[name] == "fresh") == (name in KEPT), reasons[name]
    assert bool(reasons.get(name)) == (name not in KEPT)
    if name not in KEPT:
        assert after[name] == before[name]


@pytest.mark.slow
def test_a_carried_record_says_so_and_keeps_its_replicas(answers):
    """Those of the old code count as before; of two columns the one that is gone is left out."""
    _, _, before, after = answers
    [told], old = after["column_gone"].carried, before["column_gone"]
    assert (told.code, told.row_count, told.cell_count) == (old.identity.code, 1, 2)
    assert str(told).endswith("quick runs of both gave the same 1 rows, 2 cells")
    assert after["column_gone"].measured == old.measured and "other_mm" not in after["column_gone"].units
    assert mismatch(after["extracted"], before["extracted"]) == ""
    assert mismatch(before["extracted"], after["extracted"]) == "" and mismatch(after["seam"], before["kernel"])


@pytest.mark.slow
def test_what_another_release_alone_executes_is_proven_by_its_runs_over_the_same_change(answers):
    reasons, _, before, after = answers
    assert not reasons["proven"] and after["proven"].carried[-1].executed_in == "0.1"
    assert str(after["proven"].carried[-1]).endswith("; what is executed in 0.1 alone was proven there")
    assert reasons["from_another_code"] and after["from_another_code"] == before["new_branch"]


def test_runs_that_do_not_repeat_are_compared_by_their_noise():
    """Five of each: means 0.1 apart are told where runs scatter by 0.01, and not where they do by 0.2."""
    fine, coarse = [0.0, 0.01, -0.01, 0.02, -0.02], [0.0, 0.2, -0.2, 0.3, -0.3]

    def records(middle: float, scatters) -> list:
        return [record_of([{"case": "a", "value_mm": middle + each}]) for each in scatters]

    assert first_difference(records(1.0, fine), records(1.1, fine)).startswith("a.value_mm: ")
    assert not first_difference(records(1.0, coarse), records(1.1, coarse))
    assert not first_difference(records(1.0, fine), records(1.0, reversed(fine)))
