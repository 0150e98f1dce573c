"""Test the law of the drift."""

import pytest
from deriving import NOISE, assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

BY_HAND = {
    ("stiffness", "pad-ke-2.5e3"): {"dmax": 0.9},
    ("stiffness", "substep"): 0.001,
    "pad-ke-2.5e3": {
        "response_s": 0.018,
        "left_out_mm_s": 1.8,
        "step_mm_s": -0.1,
        "drift_mm_s": 1.7,
    },
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "step_ms": 1,
                "timeconst_ms": 20,
                "g": 200,
                "by_hand/trailing": 1.8,
                "back": 0.1,
                "by_hand/rough": 1.7,
                "rough_off": 0,
                "by_hand": "holds",
            },
        ),
        (
            {"pad-ke-2.5e3": {"drift_mm_s": 1.63}},
            {"rough_off": 4.294479, "by_hand": "holds"},
        ),
        ({"pad-ke-2.5e3": {"drift_mm_s": 1.6}}, {"by_hand": "fails"}),
    ],
)
def test_the_law_of_shipped_pads(cells, expected):
    assert_found("drift_law", BY_HAND, cells, expected=expected)


RUNS = {
    "sweep-*": None,
    "*": {
        "slip_mm": 1,
        "cycle_count": 11,
        "left_out_mm_s": 1,
        "step_mm_s": 0,
        "drift_mm_s": 1.01,
        "response_s": 0.01,
    },
    "sweep-a": {
        "pad_ke": 1,
        "slip_mm": 1,
        "cycle_count": 11,
        "step_mm_s": 0,
        "left_out_mm_s": 1,
        "drift_mm_s": 1.5,
        "response_s": 0.031,
    },
    "sweep-b": {
        "pad_ke": 1,
        "slip_mm": 1,
        "cycle_count": 11,
        "step_mm_s": 0,
        "drift_mm_s": 1.01,
        "left_out_mm_s": 0.9999,
        "response_s": 0.013,
    },
    "pad-ke-2.5e5": {"response_s": 0.011},
    "pad-ke-2.5e4": {"response_s": 0.012, "drift_mm_s": 1.014},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "half_kept": 1,
                "most_kept": 1.4,
                "response_range": 3.1,
                "response_count": 5,
                "follows": "holds",
                "count_kept": 10,
                "tried_count": 11,
                "law/follows": True,
            },
        ),
        (
            {"pad-ke-2.5e4": {"drift_mm_s": 1.016}},
            {"most_kept": 1.6, "follows": "fails", "law/follows": False},
        ),
        (
            {"pad-ke-2.5e4": {"drift_mm_s": 1.016}, (NOISE, "drift_mm_s"): 0.002},
            {"follows": "cannot tell"},
        ),
        ({(NOISE, "drift_mm_s"): 0.0005}, {"follows": "holds"}),
        ({(NOISE, "drift_mm_s"): 0.002}, {"follows": "cannot tell"}),
        (
            {"sweep-a": {"response_s": 0.029}},
            {"follows": "cannot tell", "follows/is_wide": False},
        ),
        (
            {"pad-ke-2.5e5": {"response_s": 0.012}},
            {"response_count": 4, "follows": "cannot tell"},
        ),
    ],
)
def test_whether_runs_follow_the_law(cells, expected):
    assert_found("drift_law", BY_HAND, RUNS, cells, expected=expected)
