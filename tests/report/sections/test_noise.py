"""The noise floor of slip and drift."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": None,
    "a": {"of": "as-shipped", "slip_mm": 6, "drift_mm_s": 0.5},
    "b": {"of": "as-shipped", "slip_mm": 6.02, "drift_mm_s": 0.504},
    "c": {"of": "stiff-pads", "slip_mm": 0.3, "drift_mm_s": 0.02},
    "d": {"of": "stiff-pads", "slip_mm": 0.33, "drift_mm_s": 0.021},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "slip_floor": 0.03,
                "drift_floor": 0.004,
                "as_shipped_slip_tolerance": 0.02,
                "stiff_pads_drift_tolerance": 0.001,
                "slip_floor_share": 0.499168,
                "drift_floor_share": 0.796813,
                "noise_is_small": "holds",
                "pairs": 99.9,
                "confidence": 95,
                "near_noise": 2,
            },
        ),
        (
            {"d": {"slip_mm": 0.37}},
            {"slip_floor_share": 1.164725, "noise_is_small": "fails"},
        ),
        ({"b": {"drift_mm_s": 0.507}}, {"noise_is_small": "fails"}),
        (
            {
                "b": {"slip_mm": 6, "drift_mm_s": 0.5},
                "d": {"slip_mm": 0.3, "drift_mm_s": 0.02},
            },
            {"slip_floor": 0.001, "drift_floor": 0.0001},
        ),
    ],
)
def test_noise_follows_from_its_cells(cells, expected):
    assert_found("noise", GIVEN, cells, expected=expected)
