"""Test the section on contact rows."""

import pytest
from deriving import NOISE, assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {"friction_residual_mm": 0, "normal_residual_mm": 5},
    "as-shipped": {
        "cone_use_max": 0.09,
        "tangential_force_n": 1.57,
        "normal_residual_mm": 0.02,
        "slide_mm": 4.4,
        "along_mm": 4,
    },
    ("reproduction", "cube_weight"): 0.5,
    "as-shipped-missing-term": {"slide_mm": 2, "predicted_slide_mm": 2.04},
    "stiff-pads-missing-term": {"predicted_slide_mm": 0.97, "slide_mm": 1},
    "as-shipped-term-restored": {"slide_mm": -0.08},
    "stiff-pads-term-restored": {"slide_mm": 0.049},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "grip_used_shipped": 9,
                "far_inside_cone": "holds",
                "load_along": 1.57,
                "load_by_weight": 3.14,
                "friction_residual": 0,
                "normal_residual": 0.02,
                "no_friction_residual": "holds",
                "slide_gap_as-shipped": 0.4,
                "slide_departure_as-shipped": 10,
                "slide_accounts": "holds",
                "slide_accounts/is_more": "holds",
                "missing_term_departure": 3,
                "missing_term/predicted": 2.04,
                "missing_term/slide": 2,
                "term_restored/restored": -0.08,
                "missing_term": "holds",
                "missing_term/effect": "holds",
                "restored_share_as-shipped": 4,
                "restored_share": 4.9,
                "restored_as-shipped_small_size": 0.08,
                "restored_as-shipped_large_size": 2,
                "term_restored": "holds",
            },
        ),
        (
            {
                "stiff-pads": {"friction_residual_mm": 0.01},
                "as-shipped": {"cone_use_max": 0.11, "friction_timeconst_s": 0},
            },
            {
                "far_inside_cone": "fails",
                "no_friction_residual": "fails",
                "own_friction_timeconst": "the opposite",
            },
        ),
        (
            {
                "as-shipped": {
                    "normal_residual_mm": 0.005,
                    "friction_timeconst_s": 0.01,
                    "slide_mm": 4.7,
                },
                (NOISE, "normal_residual_mm"): 0.006,
            },
            {
                "no_friction_residual": "cannot tell",
                "own_friction_timeconst": "holds",
                "slide_accounts": "fails",
            },
        ),
        (
            {
                "as-shipped": {"slide_mm": 3.5},
                "stiff-pads-missing-term": {"predicted_slide_mm": 0.94},
            },
            {
                "slide_accounts": "holds",
                "slide_accounts/is_more": "the opposite",
                "missing_term_departure": 6,
                "missing_term": "fails",
            },
        ),
        (
            {"stiff-pads-term-restored": {"slide_mm": 0.051}},
            {"term_restored": "fails", "missing_term/effect": "fails"},
        ),
        ({(NOISE, "slide_mm"): 1.5}, {"term_restored": "cannot tell"}),
    ],
)
def test_contacts_follows_from_its_cells(cells, expected):
    assert_found("contacts", GIVEN, cells, expected=expected)
