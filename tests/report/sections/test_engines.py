"""Other engines: what a cell says in words follows the numbers beside it."""

import pytest

from experiments.newton_solvers.box import EXCUSED
from measured_report.editions.project import Project
from measured_report.records.record import load_record
from measured_report.values.quantities import Value
from measured_report.values.results import Results
from report.sections.engines import Line, _as_their_laws_say


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


def test_engines_are_counted_that_have_a_number_to_hold_against_their_law():
    path = Project("1.4.0").record_path("engines")
    results = Results(load_record(path), path)
    walk, still, sink = Value(0.4, "%/s", "", noise=0.0), Value(0.0, "%/s", "", noise=0.0), Value(0.0, "µm/s", "")
    lines = [Line(f"A, {model}", "", "step", walk, walk, walk, sink, sink) for model in ("one", "another")]
    lines.append(Line("B", "", "anchored", still, still, still, sink, sink))
    numbers = _as_their_laws_say(results, lines, Value(0.002, "%/s", ""), Value(0.01, "µm/s", "")).numbers
    assert (numbers["engines"].value, numbers["count"].value) == (1, 2)
