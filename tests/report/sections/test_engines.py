"""Other engines: what a cell says in words follows the numbers beside it."""

from dataclasses import replace

import pytest

from experiments.drivers.newton_solver import EXCUSED
from measured_report.editions.project import Project
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.sections.engines import published


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


def test_a_number_agrees_within_half_its_last_digit_its_noise_or_below_its_bound_and_one_that_is_missing_does_not():
    digits = published.Published("", "", "0.0902", "1", "", "")
    assert (digits.agrees(0.09024), digits.agrees(0.0898)) == (True, False)
    noisy, bound = replace(digits, theirs="150.5", noise=3.0), replace(digits, theirs="100", is_bound=True)
    assert (noisy.agrees(153.4), noisy.agrees(153.6)) == (True, False)
    assert (bound.agrees(5.0), bound.agrees(100.5)) == (True, False)
    path = Project("1.4.0").record_path("engines")
    record = load_record(path)
    only = replace(record, rows=[{"case": "orbit", "creep_mm": 5.0}])
    [claim] = published.derive(Results(only, path)).claims
    assert claim.outcome.name == "unknown"
