"""Test between which bodies the cube moves."""

import pytest
from deriving import NOISE, assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {"displacement_mm": 0.1, "total_drift_mm": 0.1},
    "cube-in-TCP": {"displacement_mm": 10},
    "cube-in-hand": {"displacement_mm": 9.4},
    "cube-in-left-finger": {"displacement_mm": 9.6},
    "cube-in-right-finger": {"displacement_mm": 10.4},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "finger_share": 96,
                "finger_share_most": 104,
                "cube_moves_in_fingers": "holds",
                "robot_drift": 0.1,
                "robot_share": 1,
                "robot_is_still": "holds",
            },
        ),
        (
            {
                "cube-in-left-finger": {"displacement_mm": 9.4},
                "hand-in-link7": {"displacement_mm": 0.4},
            },
            {
                "cube_moves_in_fingers": "fails",
                "robot_share": 4,
                "robot_is_still": "holds",
            },
        ),
        (
            {
                "cube-in-right-finger": {"displacement_mm": 10.6},
                "hand-in-link7": {"total_drift_mm": 0.6},
                "TCP-in-hand": {"displacement_mm": 0.6},
            },
            {
                "cube_moves_in_fingers": "fails",
                "robot_share": 6,
                "robot_is_still": "fails",
            },
        ),
        (
            {"TCP-in-hand": {"displacement_mm": 0.49}, (NOISE, "displacement_mm"): 11},
            {"cube_moves_in_fingers": "cannot tell"},
        ),
    ],
)
def test_frames_follows_from_its_cells(cells, expected):
    assert_found("frames", GIVEN, cells, expected=expected)
