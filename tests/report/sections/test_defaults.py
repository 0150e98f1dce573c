"""Test the section on the defaults of a release."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {
                "solver-run_collision_detection": {"value": 1},
                "solver-cone": {"value": 0},
            },
            {"as_the_scene": "holds", "leaves_it_to_mujoco": "holds"},
        ),
        (
            {"own-defaults": {"pad_mu": 2}, "solver-cone": {"value": 1}},
            {
                "as_the_scene": "fails",
                "as_the_scene/changed": "pad_mu",
                "leaves_it_to_mujoco": "fails",
            },
        ),
        (
            {"solver-run_collision_detection": {"value": 0}},
            {"leaves_it_to_mujoco": "fails"},
        ),
    ],
)
def test_defaults_follows_from_its_cells(cells, expected):
    assert_found("defaults", cells, expected=expected)
