"""Test whether a light box creeps faster than it should on a heavy turntable."""

import pytest
from deriving import NOISE, assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {"growth_per_s": 0.030},
    "3.1[147].0-implicitfast": {"growth_per_s": 0.033},
    "4.0.0-implicitfast": {"growth_per_s": 0.036},
    (NOISE, "growth_per_s"): 1e-6,
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "least_off": 10,
                "most_off": 20,
                "cured_off": 0,
                "fast_in_newer": "holds",
            },
        ),
        (
            {"4.0.0-implicitfast": {"growth_per_s": 0.027}},
            {"least_off": -10, "most_off": 10, "fast_in_newer": "fails"},
        ),
        (
            {"4.0.0-strict": {"growth_per_s": 0.027}},
            {"cured_off": 10, "fast_in_newer": "fails"},
        ),
        (
            {"3.10.0-cold": {"growth_per_s": None}},
            {"cured_off": 0, "fast_in_newer": "holds"},
        ),
    ],
)
def test_light_on_heavy_follows_from_its_cells(cells, expected):
    assert_found("light_on_heavy", GIVEN, cells, expected=expected)
