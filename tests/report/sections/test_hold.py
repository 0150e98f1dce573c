"""Test the drift and the creep with the arm held still."""

import pytest
from deriving import NOISE, assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "hold": {"drift_mm_s": 0.05},
    "as-shipped": {"drift_mm_s": -1},
    "hold-60s": {"slip_mm": 6, "shake_duration_s": 60, "increment_final_mm": 0.06},
    "hold-60s-stiff": {"slip_mm": 3.1},
    "precision-c-double": {"creep_mm_s": 0.04},
    "precision-c-single": {"creep_mm_s": 0.1},
    "precision-warp": {"creep_mm_s": 0.105},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "hold_share": 5,
                "drift_needs_cycle": "holds",
                "drift_needs_cycle/is_opposed": True,
                "creep_final_share": 60,
                "creep_goes_on": "holds",
                "stiff_creep_share": 51.66667,
                "stiff_pads_keep_creep": "holds",
                "double_share": 40,
                "rounded_departure": 4.761905,
                "creep_is_rounding": "holds",
                "motion/is_so": True,
            },
        ),
        (
            {"hold": {"drift_mm_s": -0.11}, "hold-60s": {"increment_final_mm": 0.04}},
            {
                "drift_needs_cycle": "fails",
                "drift_needs_cycle/is_opposed": False,
                "creep_goes_on": "fails",
                "stiff_pads_keep_creep": "fails",
                "motion/is_so": False,
            },
        ),
        (
            {
                (NOISE, "increment_final_mm"): 0.07,
                "precision-c-double": {"creep_mm_s": 0.051},
            },
            {
                "creep_goes_on": "cannot tell",
                "motion/is_so": False,
                "creep_is_rounding": "fails",
            },
        ),
        (
            {
                "hold-60s-stiff": {"slip_mm": 2.9},
                "precision-c-single": {"creep_mm_s": 0.117},
            },
            {
                "stiff_pads_keep_creep": "fails",
                "motion/is_so": False,
                "creep_is_rounding": "fails",
            },
        ),
        ({(NOISE, "creep_mm_s"): 0.002}, {"creep_is_rounding": "holds"}),
        ({(NOISE, "creep_mm_s"): 0.006}, {"creep_is_rounding": "cannot tell"}),
        ({"precision-*": {"creep_mm_s": -0.1}}, {"creep_is_rounding": "fails"}),
    ],
)
def test_hold_follows_from_its_cells(cells, expected):
    assert_found("hold", GIVEN, cells, expected=expected)
