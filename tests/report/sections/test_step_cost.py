"""Test the run time of a frame at each time step."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {"ratio_resolution": 0.01},
    "stiff/substeps-4 1": {"frame_ratio": 0.3},
    "stiff/substeps-16 1": {"frame_ratio": 1.0},
    "stiff/substeps-32 1": {"frame_ratio": 1.95},
    "stiff/substeps-4 16384": {"frame_ratio": 0.5},
    "stiff/substeps-16 16384": {"frame_ratio": 1.25},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "doubled": 1.95,
                "proportional": "holds",
                "resolution": 1,
            },
        ),
        (
            {"stiff/substeps-32 1": {"frame_ratio": 1.5}},
            {"doubled": 1.5, "proportional": "fails"},
        ),
    ],
)
def test_step_cost_follows_from_its_cells(cells, expected):
    assert_found("step_cost", GIVEN, cells, expected=expected)
