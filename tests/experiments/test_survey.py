"""The survey: examples of Newton's that build, and those that don't, and the rows that are kept of them."""

import newton.examples
import pytest

from experiments import survey
from experiments.survey import examples
from experiments.survey.examples import Example, Unbuilt, build

STUBBORN = """
import os
import newton
from newton.solvers import SolverMuJoCo, SolverXPBD

class Example:
    def __init__(self, viewer, args):
        {body}
"""


def shipped(name: str) -> Example:
    return Example(name, newton.examples.get_examples()[name])


def test_an_example_is_built_as_far_as_its_solver_or_says_why_not():
    built = build(shipped("basic_plotting"))
    assert (built.solver, built.model.shape_count > 100) == ("SolverMuJoCo", True)
    assert built.engine.refsafe and 0.0 < built.engine.substep_dt < 0.01
    with pytest.raises(Unbuilt, match="needs a download"):
        build(shipped("franka_cable_ik_pick_place"))
    found = examples.row_of(shipped("basic_conveyor"))["findings"]
    assert {"ke-without-kd"} <= {finding["rule"] for finding in found}


@pytest.mark.parametrize("name", ["newton_cradle", "domino_spiral", "balance_bird"])
def test_examples_of_later_releases_told_to_use_mujoco(name):
    if name not in newton.examples.get_examples():
        pytest.skip(f"Newton {newton.__version__} does not have {name}")
    [offered] = [example for example in examples.examples() if example.case == f"{name}-mujoco"]
    row = examples.row_of(offered)
    assert row["solver"] == "SolverMuJoCo"
    assert "ke-without-kd" in {finding["rule"] for finding in row["findings"]}


@pytest.mark.parametrize(
    ("body", "reason"),
    [
        ("os._exit(3)", "ends with status 3 while it is built"),
        ("os.abort()", "is killed by SIGABRT while it is built"),
        ("while True: pass", "takes over 1 s"),
        ("raise ValueError('no\\n such  thing')", "ValueError: no such thing"),
        ("import no_such_package", "needs the package no_such_package"),
        ("pass", "makes no solver"),
        ("SolverXPBD(model=newton.ModelBuilder().finalize(device='cpu'))", ""),
        ("SolverMuJoCo(newton.ModelBuilder().finalize(device='cpu'), solver='cg', cone='elliptic')", ""),
    ],
)
def test_no_example_takes_the_survey_down(body, reason, tmp_path, monkeypatch):
    name = f"stubborn_{abs(hash(body))}"
    (tmp_path / f"{name}.py").write_text(STUBBORN.format(body=body))
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(examples, "TIME_LIMIT_S", 1 if "while" in body else 120)
    monkeypatch.setattr(examples, "_place", lambda example: {"case": example.case, "folder": "tests"})
    row = examples._row_apart(Example("stubborn", name))
    assert (row["case"], row["unbuilt"]) == ("stubborn", reason)
    assert ("findings" in row) == (not reason)


def test_rows_of_what_is_found_and_of_what_is_not_linted():
    finding = {"rule": "unused", "parameter": "restitution", "value": 0.5, "used": None, "unit": "1", "count": 2}
    short = {"rule": "timeconst", "parameter": "timeconst", "value": 1e-3, "used": 4e-3, "unit": "s", "count": 3}
    found = {"case": "a", "folder": "b", "unbuilt": "", "solver": "SolverX", "shape_count": 4, "pair_count": 5}
    summary, *rest = survey._rows(found | {"findings": [finding, short, short]})
    assert (summary["finding_count"], summary["unused_count"], summary["timeconst_count"]) == (3, 1, 2)
    assert [row["scene"] for row in rest] == ["a"] * 3
    assert (rest[0]["used"], rest[0]["used_reason"], rest[1]["used_s"]) == (None, "the solver does not read it", 4e-3)
    [unbuilt] = survey._rows({"case": "c", "folder": "b", "unbuilt": "needs a download"})
    assert (unbuilt["finding_count"], "download" in unbuilt["finding_count_reason"]) == (None, True)
    assert set(summary) - {"solver"} <= set(unbuilt)
