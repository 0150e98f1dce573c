"""Test whether the contact gap changes the slip."""

import pytest
from deriving import NOISE, assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "cube-gap-0.005": {"slip_mm": 6.2},
    "all-gaps-zero": {"slip_mm": 5.92},
    "*": {"mean_loaded_row_count": 8, "mean_row_count": 30},
    "cube-gap-default": {"slip_mm": 6, "mean_row_count": 31},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "slip_difference": 0.28,
                "slip_difference_share": 4.666667,
                "not_the_cause": "holds",
                "same_contacts_carry": "holds",
            },
        ),
        (
            {
                "all-gaps-zero": {"slip_mm": 5.895},
                "cube-gap-default": {"mean_row_count": 30.4},
                (NOISE, "slip_mm"): 0.007,
            },
            {"not_the_cause": "cannot tell", "same_contacts_carry": "cannot tell"},
        ),
        (
            {"all-gaps-zero": {"slip_mm": 5.88, "mean_loaded_row_count": 8.4}},
            {"not_the_cause": "the opposite", "same_contacts_carry": "holds"},
        ),
        (
            {"all-gaps-zero": {"mean_loaded_row_count": 8.6}},
            {"same_contacts_carry": "the opposite"},
        ),
        (
            {"all-gaps-zero": {"mean_loaded_row_count": 9.1}},
            {"same_contacts_carry": "the opposite"},
        ),
    ],
)
def test_gap_follows_from_its_cells(cells, expected):
    assert_found("gap", GIVEN, cells, expected=expected)
