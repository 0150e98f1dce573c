"""Test the speed of one world and of many worlds."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {"frame_ratio": 1, "ratio_resolution": 0.01},
    "stiff-pads-only": {"frame_ratio": 0.99},
    "fixed": {"ratio_resolution": 0.02},
    "as-shipped-16384": {"ratio_resolution": 0},
    "stiff-pads-16384": {"frame_ratio": 1.02},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "stiff_pads_only_change": -1,
                "stiff_pads_only_same_time": "holds",
                "resolution": 2,
                "many_worlds": "holds",
            },
        ),
        (
            {
                "stiff-pads-only": {"frame_ratio": 1.05},
                "stiff-pads-16384": {"frame_ratio": 0.98},
            },
            {
                "stiff_pads_only_change": 5,
                "stiff_pads_only_same_time": "the opposite",
                "many_worlds": "the opposite",
            },
        ),
        (
            {
                "stiff-pads-only": {"frame_ratio": 0.981},
                "stiff-pads-16384": {"frame_ratio": 0.991},
            },
            {
                "stiff_pads_only_change": -1.9,
                "stiff_pads_only_same_time": "holds",
                "many_worlds": "cannot tell",
            },
        ),
    ],
)
def test_speed_follows_from_its_cells(cells, expected):
    assert_found("speed", GIVEN, cells, expected=expected)
