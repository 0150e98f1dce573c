"""Test whether the term adds energy to bodies that tumble."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {
        "plain_gain_count": 2,
        "exact_gain_count": 2,
        "plain_alone_count": 0,
        "exact_alone_count": 1,
        "higher_count": 2,
        "lower_count": 1,
        "plain_most_energy": 1,
        "exact_most_energy": 1.04,
        "pair_count": 400,
    },
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "exact_gains": 120,
                "tumble_gain_excess": 2.236068,
                "tumble_rise_excess": 1.290994,
                "tumble_more": 0,
                "tumble_surprise": 1.04,
                "tumble_count": 24000,
                "tumbling_gains_nothing": "holds",
            },
        ),
        (
            {"tumble-box-1ms": {"exact_alone_count": 20}},
            {"tumbling_gains_nothing": "fails", "tumble_gain_excess": 4.898979},
        ),
        (
            {"tumble-box-1ms": {"exact_most_energy": 1.06}},
            {"tumble_surprise": 1.06, "tumbling_gains_nothing": "fails"},
        ),
    ],
)
def test_tumbles_follow_from_their_cells(cells, expected):
    assert_found("tumbles", GIVEN, cells, expected=expected)
