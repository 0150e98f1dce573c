"""Test which numbers of two editions are compared, and which direction is better."""

from dataclasses import replace

import pytest
from toys import compared

from measured_report.changes.moves import direction
from measured_report.files.columns import Column
from measured_report.files.config import report


def column(better: str) -> Column:
    return Column(
        name="x_mm",
        unit="mm",
        words="x",
        least=-1.0,
        largest=1.0,
        kinds=frozenset(),
        better=better,
    )


@pytest.mark.parametrize(
    ("before", "after", "is_larger"),
    [
        (1.0, 2.0, True),
        (-1.0, -2.0, True),
        (-2.0, 1.0, False),
        (1.0, -2.0, True),
        (2.0, -1.0, False),
        (0.0, -1.0, True),
    ],
)
def test_the_size_of_a_signed_number_is_better_or_worse(before, after, is_larger):
    """Test that an error of -2 mm is worse than an error of 1 mm.

    Its sign does not count.
    """
    outcomes = {"more": is_larger, "less": not is_larger}
    for better, is_better in outcomes.items():
        said = direction(column(better), before, after)
        assert said == ("better" if is_better else "worse"), better
    assert direction(column(""), before, after) == ""
    assert direction(column("less"), None, after) == ""
    assert direction(column("less"), before, None) == ""


ROW = {
    "case": "soft",
    "slip_mm": 6.3,
    "drift_mm_s": 0.5,
    "dropped": False,
    "pad_ke": 1e4,
    "frame_count": 100,
}
ALL = {*ROW} - {"case"}


@pytest.mark.parametrize(
    ("changed", "columns"),
    [
        ({}, ALL),
        # A rate does not depend on the length of a run, but all other numbers may.
        ({"frame_count": 200}, ALL - {"slip_mm"}),
        ({"pad_ke": 2e4}, ALL - {"slip_mm", "drift_mm_s"}),
        ({"pad_ke": 2e4, "frame_count": 200}, ALL - {"slip_mm", "drift_mm_s"}),
        ({"slip_mm": 7.0}, ALL),
        ({"case": "another"}, set()),
    ],
)
def test_numbers_of_runs_with_other_parameters_are_not_compared(toy, changed, columns):
    newer = toy.of("1.8.0")
    other = {**ROW, "case": "stiff"}
    toy.measure([ROW, other])
    newer.measure([{**ROW, **changed}, other])
    cells = compared(toy.project, newer.project).cells
    rows = [cell for cell in cells if cell.place.get("case") == "soft"]
    assert {cell.column.name for cell in rows} == columns


def test_a_number_with_a_threshold_that_one_edition_lacks_is_missing(toy, monkeypatch):
    thresholds = {"toy.soft.slip_mm": 0.05, "toy.gone.slip_mm": 0.05}
    changes = replace(report().settings.changes, thresholds=thresholds)
    settings = replace(report().settings, changes=changes)
    monkeypatch.setitem(vars(report()), "settings", settings)
    newer = toy.of("1.8.0")
    toy.measure([ROW, {**ROW, "case": "gone"}])
    newer.measure([ROW, {**ROW, "case": "new"}])
    assert compared(toy.project, newer.project).missing == ["toy.gone.slip_mm"]
