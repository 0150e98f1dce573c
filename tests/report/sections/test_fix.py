"""Test whether the files of the fix hold the cube."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "as-shipped": {"slip_mm": 6, "exit_status": 1},
    "fixed": {"slip_mm": 0.59, "exit_status": 0},
    ("stiffness", "substep"): 0.001,
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "gain": 10.169492,
                "recommended": "holds",
                "test_tells": "holds",
                "test_tells/before": "fails",
                "test_tells/after": "passes",
                "step_ms": 1,
                "step_kd": 1000,
                "step_ke": 250000,
                "patch_kd_off": 0,
                "patch_ke_off": 0,
                "patch_rounds_up": "holds",
            },
        ),
        (
            {"fixed": {"slip_mm": 0.61}, ("stiffness", "substep"): 0.00104},
            {
                "recommended": "fails",
                "patch_kd_off": 4,
                "patch_ke_off": 8.16,
                "patch_rounds_up": "holds",
            },
        ),
        (
            {"fixed": {"exit_status": 1}, ("stiffness", "substep"): 0.00105},
            {
                "recommended": "fails",
                "test_tells": "fails",
                "patch_kd_off": 5,
                "patch_ke_off": 10.25,
                "patch_rounds_up": "fails",
            },
        ),
        (
            {"as-shipped": {"exit_status": 0}, ("stiffness", "substep"): 0.00099},
            {"recommended": "holds", "test_tells": "fails", "patch_rounds_up": "fails"},
        ),
    ],
)
def test_fix_follows_from_its_cells(cells, expected):
    assert_found("fix", GIVEN, cells, expected=expected)
