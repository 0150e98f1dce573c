"""Test whose material determines a contact."""

import pytest
from deriving import NOISE, assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {
        "dampratio": 1,
        "timeconst_s": 0.02,
        "friction": 1,
        "dmin": 0.9,
        "dmax": 0.95,
    },
    "cube-ke-*": {"slip_mm": 6},
    "cube-ke-8e5": {"slip_mm": 6.1},
    "priority-0": {"slip_mm": 3, "timeconst_s": 0.01},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "cube_resolved_spread": 0,
                "cube_does_not_count": "holds",
                "cube_slip_spread": 0.1,
                "cube_slip_share": 1.666667,
                "cube_does_not_move_slip": "holds",
                "mixed_drop": 50,
                "equal_priorities_mix": "holds",
                "materials/material/0": "of the pads",
                "materials/material/4": "of both",
            },
        ),
        (
            {"cube-ke-8e5": {"dmax": 0.96, "slip_mm": 6.13}},
            {
                "cube_dmax_spread": 0.01,
                "cube_resolved_spread": 0.01,
                "cube_does_not_count": "fails",
                "cube_does_not_move_slip": "the opposite",
            },
        ),
        (
            {
                "cube-ke-8e3": {"dmin": 0.8},
                "cube-ke-8e5": {"slip_mm": 6.13},
                (NOISE, "slip_mm"): 0.07,
                "priority-0": {"timeconst_s": 0.03},
            },
            {
                "cube_does_not_count": "fails",
                "cube_does_not_move_slip": "cannot tell",
                "equal_priorities_mix": "the opposite",
            },
        ),
        (
            {
                "cube-ke-8e5": {"slip_mm": 6.13},
                (NOISE, "slip_mm"): 0.2,
                "priority-0": {"slip_mm": 5.995},
            },
            {
                "cube_does_not_move_slip": "cannot tell",
                "equal_priorities_mix": "cannot tell",
            },
        ),
        (
            {"pad-ke-2.5e5": {"timeconst_s": 0.002}},
            {"materials/material/3": "of the pads"},
        ),
    ],
)
def test_priority_follows_from_its_cells(cells, expected):
    assert_found("priority", GIVEN, cells, expected=expected)
