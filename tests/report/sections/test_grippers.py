"""Test how many grasps hold, creep and drop."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {"moved_mm": 0.5, "creep_mm_s": 0.1, "dropped": False},
    "*-published-c": {"moved_mm": 2.0, "creep_mm_s": 0.2},
    "*-published-warp": {"moved_mm": 3.0},
    "*-cube-rule-c": {"moved_mm": 1.5},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "moves/moving": 30,
                "moves": "holds",
                "rule_cures/cured": 20,
                "same": 0,
                "firm_cures/cured": 30,
                "agreed": 30,
                "agreed_firm": 30,
                "engines_agree": "holds",
            },
        ),
        # Objects that drop have the same recorded motion, whatever the pads are.
        (
            {
                "umi-cup-published-c": {"moved_mm": 20.0, "dropped": True},
                "umi-cup-rule-c": {"moved_mm": 20.0, "dropped": True},
            },
            {"same": 0, "moves/lost": 1},
        ),
        (
            {
                "xarm-can-published-c": {"moved_mm": 20.0, "creep_mm_s": 5.0},
                "xarm-can-rule-c": {"moved_mm": 20.0, "creep_mm_s": 5.0},
            },
            {"same": 1},
        ),
        (
            {"*-can-published-warp": {"moved_mm": 0.5}},
            {"agreed": 20, "engines_agree": "fails"},
        ),
        (
            {"leap-*-firm-warp": {"moved_mm": 5.0}},
            {"agreed_firm": 27, "engines_agree": "holds"},
        ),
    ],
)
def test_grippers_follow_from_their_cells(cells, expected):
    assert_found("grippers", GIVEN, cells, expected=expected)
