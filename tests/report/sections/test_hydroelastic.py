"""Test which stiffnesses of hydroelastic pads lose the cube."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

HELD = {"slip_mm": 1.0, "dropped": False}
LOST = {"slip_mm": 90.0, "dropped": True}
GIVEN = {"area": HELD, "area/kh-*": HELD}


@pytest.mark.parametrize(
    ("lost", "largest"),
    [
        ((), ""),
        (("1e+07",), 1e7),
        (("1e+07", "1e+08", "1e+09"), 1e9),
        # With this kh alone, the cube is not lost with each smaller one.
        (("1e+09",), ""),
        (("1e+07", "1e+12"), 1e7),
    ],
)
def test_the_page_names_a_kh_only_if_every_softer_pad_loses_the_cube(lost, largest):
    cells = {f"area/kh-{kh}": LOST for kh in lost}
    expected = {"depends_on_kh/lost": largest}
    assert_found("hydroelastic", GIVEN, cells, expected=expected)


@pytest.mark.parametrize(
    ("lost", "outcome", "count"),
    [((), "holds", 0), (("kh-1e+11", "substeps-64", "plate"), "fails", 3)],
)
def test_runs_that_lose_the_cube_are_counted(lost, outcome, count):
    cells = {f"area/{name}": LOST for name in lost}
    given = {"area": HELD, "area/*": HELD}
    expected = {"holds_in_all_runs": outcome, "lost_runs": count}
    assert_found("hydroelastic", given, cells, expected=expected)
