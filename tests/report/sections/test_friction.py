"""Test whether the friction coefficient changes the slip."""

import pytest
from deriving import NOISE, assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {"slip_mm": 6},
    "pad-mu-0.2": {"slip_mm": 6.5},
    "cube-mu-20": {"slip_mm": 5.45},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "largest_difference": 0.55,
                "largest_share": 9.166667,
                "not_the_cause": "holds",
                "pad-mu-0.2_difference": 0.5,
                "cube-mu-20_difference": -0.55,
                "not_the_cause/most": "cube's friction 20",
            },
        ),
        ({"pad-mu-0.2": {"slip_mm": 6.65}}, {"not_the_cause": "the opposite"}),
        ({"pad-mu-0.2": {"slip_mm": 5.35}}, {"not_the_cause": "the opposite"}),
        (
            {"pad-mu-0.2": {"slip_mm": 6.605}, (NOISE, "slip_mm"): 0.007},
            {"not_the_cause": "cannot tell"},
        ),
    ],
)
def test_friction_follows_from_its_cells(cells, expected):
    assert_found("friction", GIVEN, cells, expected=expected)
