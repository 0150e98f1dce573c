"""What is judged from kept numbers, by hand: when a run passes."""

import pytest

from measured_report.editions.project import Project
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.sections import stability
from report.sections.stability.passing import passes

LOAD = [("creeping", 0.89, True), ("dropped", 0.89, False), ("dropped", 1.0, None), ("dropped", 1.11, True)]
LOAD += [("creeping", 1.11, False), ("exploded", None, False)]
JUDGED = {
    "shake": ("class load", LOAD),
    "grip": ("class load", LOAD),
    "friction": (
        "class pad_mu",
        [("dropped", 0.0, True), ("holding", 0.0, False), ("dropped", 1.0, True), ("non-finite", 1.0, False)],
    ),
    "mass": ("class", [("dropped", True), ("non-finite", False)]),
    "size": (  # up to a hundredth of the edge
        "class cube_edge_mm penetration_mm",
        [
            ("creeping", 40.0, 0.39, True),
            ("creeping", 40.0, 0.4, False),
            ("dropped", 40.0, None, False),
            ("creeping", 400.0, None, None),
        ],
    ),
    "overlap": (
        "class exit_speed_mm_s exit_bound_mm_s",
        [("creeping", 5.0, 5.0, True), ("creeping", 5.1, 5.0, False), ("dropped", 1.0, 5.0, False)],
    ),
    "long": (
        "class increment_first_mm_per_cycle increment_last_mm_per_cycle",
        [
            ("creeping", 1.0, 1.1, True),
            ("creeping", 1.0, 1.2, False),
            ("creeping", -1.0, -1.1, True),
            ("dropped", None, None, False),
        ],
    ),
}
"""By family, columns, and cells with what is said of them."""


@pytest.mark.parametrize("family", JUDGED)
def test_what_passes(toy, family):
    columns, cells = JUDGED[family]
    rows = []
    for index, (*values, _) in enumerate(cells):
        row = dict(zip(columns.split(), values, strict=True))
        lost = [name for name, value in row.items() if value is None and name != "failure"]
        reasons = {f"{name}_reason": "it does not exist" for name in lost}
        finite = row["class"] != "non-finite"
        rows.append({"case": str(index), "failure": None, "family": family, "finite": finite} | row | reasons)
    found = Results(toy.record(rows), toy.record_path).rows
    assert [passes(row) for row in found] == [expected for *_, expected in cells]


def test_curves_of_the_maps_are_where_their_conditions_begin(monkeypatch):
    """2 / kd is 2 dt where kd is 2 √ke, and dt² ke + 2 dt kd is 4."""
    path, drawn = Project("1.4.0").record_path("stability"), []
    monkeypatch.setattr(stability, "draw_maps", drawn.extend)
    results = Results(load_record(path), path)
    row = next(row for row in results.rows if "pad_kd" in row)
    stability._maps(results, [], [row], False).draw()
    clamped, unstable = (curve for _, _, curve, _ in drawn)
    step_s = unstable(2500.0)
    assert (clamped(2500.0), 2500.0 * step_s**2 + 2.0 * step_s * row.pad_kd.value) == pytest.approx((0.01, 4.0))
