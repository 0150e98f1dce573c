"""Test the additional time of a frame with the root cure."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {"frame_ratio": 1.0, "ratio_resolution": 0.01},
    "best 16384": {"frame_ratio": 1.008},
    "firm-euler 4096": {"frame_ratio": 1.2},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "best_extra_16384": 0.8,
                "best_worst": 0.8,
                "best_costs_nothing": "holds",
                "firm-euler_extra_4096": 20,
                "ways/4 096 worlds/3": 20,
                "ways/16 384 worlds/1": 0.8,
                "resolution": 1,
            },
        ),
        (
            {"best 4096": {"frame_ratio": 1.015}},
            {
                "best_worst": 1.5,
                "best_costs_nothing": "holds",
                "firm_costs_nothing": "holds",
            },
        ),
        (
            {"firm 1": {"frame_ratio": 1.05}},
            {
                "firm_worst": 5,
                "best_costs_nothing": "holds",
                "firm_costs_nothing": "the opposite",
            },
        ),
        (
            {"best 1": {"ratio_resolution": 0.031}},
            {"best_costs_nothing": "cannot tell"},
        ),
        (
            {"best 1": {"ratio_resolution": 0.012}},
            {"best_costs_nothing": "holds", "resolution": 1.2},
        ),
        (
            {"term 1": {"ratio_resolution": 0.031}},
            {"best_costs_nothing": "holds", "resolution": 3.1},
        ),
    ],
)
def test_cure_cost_follows_from_its_cells(cells, expected):
    assert_found("cure_cost", GIVEN, cells, expected=expected)
