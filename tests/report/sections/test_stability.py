"""Test by hand which runs of section stability pass."""

import pytest
from deriving import assert_found

from measured_report.editions.project import Project
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.sections import stability
from report.sections.stability.passing import passes

LOAD = [
    ("creeping", 0.89, True),
    ("dropped", 0.89, False),
    ("dropped", 1.0, None),
    ("dropped", 1.11, True),
]
LOAD += [("creeping", 1.11, False), ("exploded", None, False)]
JUDGED = {
    "shake": ("class load", LOAD),
    "grip": ("class load", LOAD),
    "friction": (
        "class pad_mu",
        [
            ("dropped", 0.0, True),
            ("holding", 0.0, False),
            ("dropped", 1.0, True),
            ("non-finite", 1.0, False),
        ],
    ),
    "mass": ("class", [("dropped", True), ("non-finite", False)]),
    "size": (  # up to a hundredth of the edge length
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
        [
            ("creeping", 5.0, 5.0, True),
            ("creeping", 5.1, 5.0, False),
            ("dropped", 1.0, 5.0, False),
        ],
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
"""Columns of each family, and whether the run passes for each set of cells."""


@pytest.mark.parametrize("family", JUDGED)
def test_what_passes(toy, family):
    columns, cells = JUDGED[family]
    rows = []
    for index, (*values, _) in enumerate(cells):
        row = dict(zip(columns.split(), values, strict=True))
        lost = [
            name for name, value in row.items() if value is None and name != "failure"
        ]
        reasons = {f"{name}_reason": "it does not exist" for name in lost}
        finite = row["class"] != "non-finite"
        rows.append(
            {"case": str(index), "failure": None, "family": family, "finite": finite}
            | row
            | reasons
        )
    found = Results(toy.record(rows), toy.record_path).rows
    assert [passes(row) for row in found] == [expected for *_, expected in cells]


def test_curves_of_the_maps_are_where_their_conditions_begin(monkeypatch):
    """Test that 2 / kd is 2 dt if kd is 2 √ke; dt² ke + 2 dt kd is then 4."""
    path, drawn = Project("1.4.0").record_path("stability"), []
    monkeypatch.setattr(stability, "draw_maps", drawn.extend)
    results = Results(load_record(path), path)
    row = next(row for row in results.rows if "pad_kd" in row)
    stability._maps(results, [], [row], False).draw()
    clamped, unstable = (curve for _, _, curve, _ in drawn)
    step_s = unstable(2500.0)
    assert (
        clamped(2500.0),
        2500.0 * step_s**2 + 2.0 * step_s * row.pad_kd.value,
    ) == pytest.approx((0.01, 4.0))


GIVEN = {
    "ke-critical-*": {"class": "creeping"},
    "ke-critical-464-1": {"class": "dropped"},
    "ke-kd-100-*": {"class": "creeping"},
    "ke-kd-100-1e+05-16": {"class": "exploded"},
    "ke-kd-100-1e+09-*": {"class": "exploded"},
    "ke-kd-100-1e+03-16": {"class": "exploded"},
    "steps-*": {"creep_floor_mm_s": 0.001},
    "steps-as-shipped-*": {"creep_mm_s": 0.6},
    "steps-stiff-16": {"creep_mm_s": 0.1},
    "steps-stiff-8": {"creep_mm_s": 0.2},
    "steps-stiff-1": {"creep_mm_s": 0.4},
    "clamp-*": {"class": "creeping"},
    "clamp-*-1": {"class": "exploded"},
    "clamp-*-0.*": {"class": "exploded"},
    "shake-*": {"load": 0.5, "class": "creeping"},
    "shake-80mm-2hz": {"load": 1.2, "class": "dropped"},
    "shake-45mm-2hz": {"load": 0.95},
    "shake-60mm-2hz": {"load": 1.05, "class": "dropped"},
    "friction-*": {"class": "creeping"},
    "friction-0": {"class": "dropped"},
    "mass-*": {"class": "creeping"},
    "size-*": {"class": "creeping", "penetration_mm": 0.01},
    "overlap-*": {"exit_speed_mm_s": 5, "exit_bound_mm_s": 10},
    "overlap-ground-1mm": {"exit_speed_mm_s": 9},
    "long-stiff": {
        "increment_first_mm_per_cycle": 0.02,
        "increment_last_mm_per_cycle": 0.0218,
    },
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "safe_ke": 1000,
                "safe_margin": 250,
                "largest_step_tried": 16.66667,
                "safe_settings": "holds",
                "kd_100_breaks": 100000,
                "kd_100_ke": 46415.89,
                "kd_100_margin": 18.56636,
                "step_gain_16": 6,
                "step_gain_8": 3,
                "step_gain_1": 1.5,
                "gain_goes": "holds",
                "gain_goes/shipped": 6,
                "gain_goes/twice": 3,
                "gain_goes/longest": 1.5,
                "clamp_fails_at": 1,
                "clamp_holds_at": 1.414214,
                "clamp_predicted": 1.207107,
                "clamp_off": "holds",
                "shake_kept_over": -5,
                "shake_lost_over": 5,
                "shake_crossover": "holds",
                "shake_crossover_count": 16,
                "shake_mu": 0.0187,
                "grip_mu": 0.1,
                "friction_kept": 0.001,
                "friction_most": 100,
                "friction_lost": 0,
                "friction_extremes": "holds",
                "masses": "holds",
                "mass_least": 0.001,
                "mass_most": 10,
                "size_shipped": 2,
                "size_scaled": 2,
                "exit_share_most": 90,
                "overlap_deepest": 5,
                "overlaps": "holds",
                "gravities": "holds",
                "long_growth": 1.09,
                "long_run": "holds",
                "limit_margin": 10,
                "depth_largest": 1,
                "maps/is_so": True,
            },
        ),
        (
            {
                "ke-critical-1e+04-1": {"class": "dropped"},
                "ke-kd-100-1e+09-4": {"class": "creeping"},
                "steps-stiff-1": {"creep_mm_s": 0.28},
            },
            {
                "safe_ke": 21544.35,
                "safe_margin": 11.60397,
                "safe_settings": "holds",
                "maps/is_so": False,
                "gain_goes": "fails",
            },
        ),
        (
            {
                "ke-critical-2.15e+04-1": {"class": "dropped"},
                "steps-stiff-16": {"creep_mm_s": 0.155},
                "friction-1": {"class": "exploded"},
            },
            {
                "safe_margin": 5.386087,
                "safe_settings": "fails",
                "maps/is_so": False,
                "gain_goes": "fails",
                "friction_extremes": "fails",
            },
        ),
        (
            {
                "steps-stiff-8": {"creep_mm_s": 0.09},
                "clamp-off-0.5": {"class": "creeping"},
                "mass-10kg": {"class": "dropped"},
            },
            {
                "gain_goes": "fails",
                "clamp_off": "fails",
                "clamp_off/first": "",
                "mass_most": 3.162278,
                "masses": "holds",
            },
        ),
        (
            {
                "clamp-off-*": {"class": "exploded"},
                "shake-10mm-2hz": {"class": "dropped"},
            },
            {
                "clamp_off": "fails",
                "clamp_off/never": "the clamp off",
                "shake_crossover": "fails",
                "shake_crossover_failed": 1,
                "shake_lost_over": -50,
            },
        ),
        (
            {
                "mass-0.1kg": {"class": "dropped"},
                "size-2mm-as-shipped": {"class": "dropped"},
                "gravity-0": {"finite": False},
            },
            {
                "masses": "fails",
                "size_shipped": 3,
                "sizes/small_ones_fail": True,
                "sizes": "fails",
                "gravities": "fails",
            },
        ),
        (
            {
                "size-3mm-scaled": {"penetration_mm": 0.03},
                "overlap-ground-1mm": {"exit_speed_mm_s": 11},
            },
            {
                "sizes/small_ones_fail": False,
                "sizes_failed": 1,
                "exit_share_most": 110,
                "overlaps": "fails",
            },
        ),
        (
            {"long-stiff": {"increment_last_mm_per_cycle": 0.0223}},
            {"long_run": "fails"},
        ),
        (
            {"long-stiff": {"class": "dropped"}},
            {"long_run": "fails", "long_run/is_lost": True, "long_run/ends": "dropped"},
        ),
        ({"steps-stiff-4": {"creep_mm_s": 0.09}}, {"gain_goes": "holds"}),
    ],
)
def test_stability_follows_from_its_cells(cells, expected):
    assert_found("stability", GIVEN, cells, expected=expected)
