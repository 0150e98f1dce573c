"""What is judged from kept numbers, by hand: when a run passes, what is on a front, and what goes one way only."""

from collections.abc import Callable, Sequence

import pytest

from measured_report.values.results import Results, Row
from report.sections.stability.passing import explicit_margin, passed, passing

Made = Callable[[Sequence[dict]], list[Row]]


@pytest.fixture
def made(toy) -> Made:
    """Rows as a section sees them, of cells; None is for a number that does not exist."""

    def rows(cells: Sequence[dict]) -> list[Row]:
        whole = []
        for index, row in enumerate(cells):
            lost = [name for name, value in row.items() if value is None and name != "failure"]
            reasons = {f"{name}_reason": "it does not exist" for name in lost}
            whole.append({"case": str(index), "failure": None} | row | reasons)
        return Results(toy.record(whole), toy.record_path).rows

    return rows


STEPS = "class pads substeps drift_mm_s"
CLAMPED = "class clamped substeps penetration_mm"
FREED = "class freed freed_speed_first_mm_s freed_speed_last_mm_s"
GROWTH = "class increment_first_mm_per_cycle increment_last_mm_per_cycle"
SAID = "the contact buffer overflowed in frame 0"
JUDGED = {
    "steps pass near the drift of the smallest": (
        *("steps", STEPS, [("creeping", "stiff", n, d) for n, d in ((1, 2.1), (2, 2.0), (4, 0.5))]),
        [("creeping", "stiff", 8, 0.49), ("creeping", "stiff", 128, 1.0), ("dropped", "stiff", 16, None)],
        [False, True, True, False, True, False],
    ),
    "and of the same pads": (
        *("steps", STEPS, [("creeping", "stiff", 16, 1.0), ("creeping", "stiff", 32, 1.0)]),
        [("creeping", "as-shipped", 16, 9.0), ("dropped", "as-shipped", 32, None)],
        [True, True, False, False],
    ),
    "those of opposite drift or none do not pass": (
        *("steps", STEPS, [("creeping", "stiff", 1, -1.0), ("creeping", "stiff", 2, 0.0)]),
        *([("creeping", "stiff", 4, 0.0)], [False, False, False]),
    ),
    "clamped cells pass near the plateau of their step": (
        *("ke-critical", CLAMPED, [("creeping", True, 16, depth) for depth in (1.0, 1.0, 2.1, 0.4)]),
        [("dropped", False, 16, 1.0), ("non-finite", False, 16, 1.0)]
        + [("creeping", True, 32, 9.0), ("dropped", True, 32, None)],
        [True, True, False, False, True, False, True, False],
    ),
    "the default kd passes as the explicit bound says": (
        *("ke-kd-100", "class pad_ke pad_kd step_ms"),
        [(kind, ke, 100.0, 1e3 / 960) for ke, kind in ((1e6, "creeping"), (1.1e6, "dropped"), (3e6, "dropped"))],
        [(kind, ke, 100.0, 1e3 / 960) for ke, kind in ((9e6, "exploded"), (8e6, "creeping"), (1e1, "dropped"))]
        + [("creeping", 1.1e6, 100.0, 1e3 / 7680)],
        [True, False, None, True, False, None, True],
    ),
    "without the clamp failure has to be found": (
        *("clamp", "class clamp", [("creeping", "off"), ("exploded", "off"), ("creeping", "direct")]),
        *([("holding", "direct")], [True, True, False, False]),
    ),
    **{
        f"loads pass as friction says ({family})": (
            *(family, "class load", [("creeping", 0.89), ("dropped", 0.89), ("dropped", 1.0), ("dropped", 1.11)]),
            *([("creeping", 1.11), ("exploded", None)], [True, False, None, True, False, False]),
        )
        for family in ("shake", "grip")
    },
    "without friction the cube has to fall": (
        *("friction", "class pad_mu", [("dropped", 0.0), ("holding", 0.0), ("dropped", 1.0), ("non-finite", 1.0)]),
        *([], [True, False, True, False]),
    ),
    "any mass passes that stays finite": ("mass", "class", [("dropped",), ("non-finite",)], [], [True, False]),
    "sizes pass up to a hundredth of the edge": (
        *("size", "class cube_edge_mm penetration_mm", [("creeping", 40.0, 0.39), ("creeping", 40.0, 0.4)]),
        *([("dropped", 40.0, None)], [True, False, False]),
    ),
    "a stable run that lacks its number is not judged": (
        *("size", "class cube_edge_mm penetration_mm", [("creeping", 400.0, None), ("creeping", 400.0, 1.0)]),
        *([("creeping", 400.0, 2.0)], [None, True, True]),
    ),
    "what starts too deep passes up to the speed of a spring": (
        *("overlap", "class exit_speed_mm_s exit_bound_mm_s", [("creeping", 5.0, 5.0), ("creeping", 5.1, 5.0)]),
        *([("dropped", 1.0, 5.0)], [True, False, False]),
    ),
    "a freed cube must not gain energy": (  # 10² grows by a hundredth at 10.0499
        *("gravity", FREED, [("creeping", False, 1.0, 1.0), ("non-finite", True, 1.0, 1.0)]),
        [("dropped", True, 10.0, 10.04), ("dropped", True, 10.0, 10.06), ("dropped", True, 0.0, 0.0)]
        + [("dropped", True, 0.0, 0.1)],
        [True, False, True, False, True, False],
    ),
    "an overflow must name its buffer": (
        *("buffers", "class case failure", [("creeping", "buffers-ample", None)]),
        [("overflow", "buffers-contact-8", SAID), ("overflow", "buffers-constraint-12", SAID)]
        + [("creeping", "buffers-contact-4", None)],
        [True, True, False, False],
    ),
    "a long run must not speed up": ("long", GROWTH, [("creeping", 1.0, 1.1)], [], [True]),
    "this one does": ("long", GROWTH, [("creeping", 1.0, 1.2)], [], [False]),
    "nor must it drop the cube": ("long", GROWTH, [("dropped", None, None)], [], [False]),
}
"""Family, columns, cells, further cells, and which of them pass."""


@pytest.mark.parametrize("name", JUDGED)
def test_what_passes(made, name):
    family, columns, first, further, expected = JUDGED[name]
    rows = [dict(zip(columns.split(), cells, strict=True)) for cells in [*first, *further]]
    rows = [{"family": family, "finite": row["class"] != "non-finite"} | row for row in rows]
    assert passing(made(rows)) == expected


def test_the_explicit_bound():
    # dt = 0.01: 1e-4 * 1e4 + 0.02 * 100 = 3.
    assert explicit_margin(1e4, 100.0, 0.01) == pytest.approx(0.75)
    # kd = 0: dt² ke = 4 at ke = 4 * 960². With kd = 100: at ke = 4 * 960² - 2 * 960 * 100.
    assert explicit_margin(4 * 960.0**2, 0.0, 1 / 960) == pytest.approx(1.0)
    assert explicit_margin(4 * 960.0**2 - 2 * 960.0 * 100.0, 100.0, 1 / 960) == pytest.approx(1.0)


def test_what_was_not_measured_is_not_judged_and_those_that_pass_are_listed(made):
    assert passing([]) == passed([]) == []
    rows = made([{"family": "mass", "class": "", "finite": finite} for finite in (True, False, True)])
    assert passed(rows) == [rows[0], rows[2]]
