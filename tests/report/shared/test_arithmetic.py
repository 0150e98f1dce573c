"""Test cells and rows that are missing."""

from dataclasses import replace

import pytest

from experiments.simulation.task import FRAME_RATE
from measured_report.editions.project import Project
from measured_report.records.record import load_record
from measured_report.values.quantities import absent
from measured_report.values.results import Results
from report.sections import reproduction
from report.shared import arithmetic, tables


@pytest.fixture
def results(toy) -> Results:
    return Results(toy.record(), toy.record_path)


def test_a_cell_that_is_not_there_says_why(results):
    soft = results.row["soft"]
    assert arithmetic.cell_or_absent(soft, "slip_mm") == soft.slip_mm
    lost = absent("mm", "it fell")
    assert arithmetic.cell_or_absent(soft, "drift_mm", "it fell") == lost
    found = arithmetic.Sections({"toy": results})
    assert found.cell("noise", "soft", "slip_mm").unit == "mm"
    assert found.cell("toy", "soft", "slip_mm") == soft.slip_mm
    for section, case, reason in (
        ("toy", "firm", "has no such number"),
        ("noise", "soft", "was not measured: make rerun SECTION=noise"),
    ):
        assert (
            found.cell(section, case, "slip_mm").reason == f"section {section} {reason}"
        )


def test_what_gets_through_no_cycle_of_its_shake_keeps_no_cube():
    path = Project("1.4.0").record_path("stiffness")
    record = load_record(path)
    index = next(
        index for index, row in enumerate(record.rows) if row["case"] == "pad-ke-2.5e5"
    )

    def is_held_with(**changed) -> bool:
        rows = [
            *record.rows[:index],
            record.rows[index] | changed,
            *record.rows[index + 1 :],
        ]
        return arithmetic.is_held(
            Results(replace(record, rows=rows), path).row["pad-ke-2.5e5"]
        )

    assert is_held_with()
    assert not is_held_with(
        cycle_count=None, cycle_count_reason="the shake is shorter than one cycle"
    )
    assert not is_held_with(dropped=True)


def test_a_cube_that_was_lost_has_not_slipped():
    path = Project("1.4.0").record_path("poses")
    poses = Results(load_record(path), path)
    lost, kept = poses.row["as-shipped-10cm"], poses.row["stiff-pads-10cm"]
    assert lost.plain["slip_mm"] > 100.0 and lost.slip_mm.value is None
    assert tables.cell_or_lost(lost, "slip_mm") == "lost"
    assert tables.cell_or_lost(lost, "cube_height_m") == lost.cube_height_m
    assert tables.cell_or_lost(kept, "slip_mm") == kept.slip_mm
    path = Project("1.4.0").record_path("reproduction")
    record = load_record(path)
    rows = [
        row | ({"dropped": True} if row["case"] == "as-shipped" else {})
        for row in record.rows
    ]
    claims = {
        claim.name: claim
        for claim in reproduction.derive(
            Results(replace(record, rows=rows), path)
        ).claims
    }
    assert {claims[name].outcome.reason for name in ("slips", "stiff_pads_hold")} == {
        "as shipped: lost"
    }


def test_true_flags_stand_together_or_not():
    flags = {
        (0, 1, 1, 0): "holds",
        (1,): "holds",
        (1, 0, 1): "fails",
        (0,): "fails",
        (): "fails",
    }
    assert {each: arithmetic.contiguous(each).name for each in flags} == flags


def test_the_frame_rate_is_that_of_the_measured_task():
    """Test the frame rate, which the report repeats because it cannot import the
    simulator.
    """
    assert arithmetic.FRAME_RATE == FRAME_RATE
