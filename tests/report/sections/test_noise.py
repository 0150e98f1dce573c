"""Test the scatter between runs of one case."""

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
                "as_shipped_slip_count": 2,
                "as_shipped_slip_mean": 6.01,
                "as_shipped_slip_deviation": 0.01414214,
                "stiff_pads_drift_deviation": 0.000707107,
                "slip_scatter_share": 0.2353101,
                "drift_scatter_share": 0.5634317,
                "noise_is_small": "holds",
                "relevance": 1,
                "confidence": 95,
                "scatter/slip: runs/1": 2,
            },
        ),
        ({"d": {"slip_mm": 0.37}}, {"noise_is_small": "holds"}),
        (
            {"b": {"drift_mm_s": 0.51}},
            {"drift_scatter_share": 1.400211, "noise_is_small": "the opposite"},
        ),
        (
            {"b": {"slip_mm": 6, "drift_mm_s": 0.5}},
            {"as_shipped_slip_deviation": 0, "noise_is_small": "holds"},
        ),
        (
            {"e": {"of": "as-shipped", "slip_mm": None, "drift_mm_s": None}},
            {"as_shipped_slip_count": 2, "noise_is_small": "holds"},
        ),
        (
            {"e": {"of": "nobody", "slip_mm": 9, "drift_mm_s": 9}},
            {"nobody_slip_deviation": None, "noise_is_small": "holds"},
        ),
        ({"b": None}, {"noise_is_small": "cannot tell"}),
    ],
)
def test_noise_follows_from_its_cells(cells, expected):
    assert_found("noise", GIVEN, cells, expected=expected)
