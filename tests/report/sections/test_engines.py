"""Other engines: what a cell says in words follows the numbers beside it."""

import pytest

from experiments.newton_solvers.box import EXCUSED
from measured_report.values.quantities import Value
from report.sections.engines import Line, _helps


@pytest.mark.parametrize(
    ("law", "walk", "short", "said"),
    [
        ("mujoco", 3.5, 3.7, "the term"),
        ("step", 0.4, 0.2, "shorter step"),
        ("step", 0.4, 0.4, "not known"),
        ("tamsi", 0.42, 0.22, "shorter step, smaller vₛ"),
        ("stribeck", 0.11, None, "smaller vₛ"),
        ("anchored", 0.001, 0.001, "nothing to help"),
        ("", None, 0.7, "not known"),
    ],
)
def test_a_shorter_step_helps_where_that_was_seen(law, walk, short, said):
    seen, halved, unknown = (Value(number, "%/s", "") for number in (walk, short, None))
    line = Line("", "", "", law, seen, unknown, halved, unknown, unknown)
    assert _helps(line, Value(0.002, "%/s", "")) == said


@pytest.mark.words
def test_each_solver_of_a_release_has_numbers_or_an_excuse(editions):
    """One that a release adds and that can't run our scenes has neither."""
    for release, edition in editions.items():
        if "newton_solvers" not in edition.chapters:
            continue
        told = [row for row in edition.chapters["newton_solvers"].results.rows if "of" in row]
        named = {row["of"] for row in told}
        numbers = {row["of"] for row in told if "growth_per_s" in row and row.growth_per_s.value is not None}
        assert {"SolverMuJoCo", "SolverXPBD"} <= numbers, release
        assert named - numbers == set(EXCUSED), release
