"""Ratios, differences and cells that are not there, and what a section does without its row."""

from dataclasses import replace

import pytest

from measured_report.editions.project import Project
from measured_report.records.record import load_record
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results
from report.shared import arithmetic


def quantity(value, reason="") -> Quantity:
    return Quantity(value, "mm", "newton-1.4.0/toy.json#/rows/0/slip_mm", reason, noise=0.01)


@pytest.fixture
def results(toy) -> Results:
    return Results(toy.record(), toy.record_path)


def test_ratios_shares_and_differences(results):
    cells = [quantity(value) for value in (2.0, 8.0, 5.0)]
    quarter = arithmetic.ratio(results, "a", "", *cells[:2])
    assert (quarter.value, quarter.unit) == (0.25, "1")
    assert str(arithmetic.share(results, "c", "", *cells[:2])) == "25.0 %"
    assert str(arithmetic.spread(results, "d", "", cells, unit="mm")) == "6.00 mm"
    assert arithmetic.spread(results, "e", "", cells[:1]).value == 0.0
    assert arithmetic.spread(results, "none", "", []).value is None
    assert arithmetic.size_share(results, "g", "", quantity(-1.0), quantity(4.0)).value == 25.0
    assert arithmetic.departure(results, "h", "", quantity(3.0), quantity(4.0)).value == 25.0
    assert arithmetic.difference(results, "i", "", quantity(3.0), quantity(4.0)).value == -1.0
    assert arithmetic.ratio(results, "f", "", cells[0], quantity(0.0)).value is None


def test_a_cell_that_is_not_there_says_why(results):
    soft = results.row["soft"]
    assert arithmetic.cell_or_absent(soft, "slip_mm", "mm") == soft.slip_mm
    for row, column in ((soft, "drift_mm"), (None, "slip_mm")):
        assert arithmetic.cell_or_absent(row, column, "mm", "it fell") == absent("mm", "it fell")
    later = replace(results, others={"toy": results})
    assert arithmetic.other_cell(later, "toy", "soft", "slip_mm", unit="mm") == soft.slip_mm
    for section, case, reason in (("toy", "firm", "does not say"), ("noise", "soft", "has no results here")):
        assert arithmetic.other_cell(later, section, case, "slip_mm", unit="mm").reason == f"section {section} {reason}"


def test_what_gets_through_no_cycle_of_its_shake_keeps_no_cube():
    path = Project("1.4.0").record_path("stiffness")
    record = load_record(path)
    index = next(index for index, row in enumerate(record.rows) if row["case"] == "pad-ke-2.5e5")

    def is_held_with(**changed) -> bool:
        rows = [*record.rows[:index], record.rows[index] | changed, *record.rows[index + 1 :]]
        return arithmetic.is_held(Results(replace(record, rows=rows), path).row["pad-ke-2.5e5"])

    assert is_held_with()
    assert not is_held_with(cycle_count=None, cycle_count_reason="the shake is shorter than one cycle")
    assert not is_held_with(dropped=True)
