"""Test the cause, and the effect of ke and kd."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

CAUSE = {
    "pad-ke-2.5e3": {"slip_mm": 6},
    "pad-ke-2.5e5": {"slip_mm": 0.59},
    ("contacts", "missing_term_departure"): 4.9,
    ("contacts", "restored_share"): 4.9,
    ("contacts", "friction_residual"): 0,
    ("contacts", "slide_departure_as-shipped"): 14.9,
    ("hold", "hold_share"): 9.9,
    ("contacts", "restored_as-shipped_small_size"): 0.1,
    ("contacts", "restored_as-shipped_large_size"): 2,
    ("contacts", "restored_stiff-pads_small_size"): 0.1,
    ("contacts", "restored_stiff-pads_large_size"): 2,
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "cause": "holds",
                "cause/has_slip": True,
                "improvement": 10.169492,
                "together_they_hold": "holds",
                "substep": 0.001041667,
                "least_timeconst": 0.002083333,
                "clamp_kd": 960,
            },
        ),
        (
            {
                ("contacts", "missing_term_departure"): 5.1,
                "pad-ke-2.5e5": {"slip_mm": 0.61},
            },
            {
                "cause": "fails",
                "cause/lacking": "that the missing acceleration predicts the slide",
                "together_they_hold": "fails",
            },
        ),
        (
            {("contacts", "restored_share"): 5.1},
            {
                "cause": "fails",
                "cause/lacking": "that the contacts stop sliding when it is restored",
            },
        ),
        (
            {("contacts", "restored_stiff-pads_small_size"): 2},
            {"cause": "cannot tell"},
        ),
        (
            {("contacts", "restored_as-shipped_large_size"): 0.08},
            {"cause": "the opposite"},
        ),
        ({("contacts", "friction_residual"): 0.001}, {"cause": "fails"}),
        ({("contacts", "slide_departure_as-shipped"): 15.1}, {"cause": "fails"}),
        (
            {("hold", "hold_share"): 10.1},
            {"cause": "fails", "cause/lacking": "that the shake causes the drift"},
        ),
        (
            {"pad-ke-2.5e3": {"slip_mm": 0.9}},
            {
                "cause": "fails",
                "cause/has_slip": False,
                "ke_alone_does_not_help": "cannot tell",
            },
        ),
    ],
)
def test_the_cause(cells, expected):
    assert_found("stiffness", CAUSE, cells, expected=expected)


STIFFNESS = {
    "pad-ke-2.5e3": {"stiffness_n_m": 100, "drift_mm_s": -1},
    "solimp-dmax-0.9999": {"stiffness_n_m": 210, "drift_mm_s": -2},
    "pad-ke-2.5e6": {"stiffness_n_m": 49000},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "dmax_stiffness_ratio": 2.1,
                "not_creep_under_load": "holds",
                "ke_ratio": 1000,
                "stiffness_ratio": 490,
                "stiffness_follows": 49,
                "ke_is_no_spring": "holds",
            },
        ),
        (
            {
                "solimp-dmax-0.9999": {"stiffness_n_m": 190},
                "pad-ke-2.5e6": {"stiffness_n_m": 51000},
            },
            {"not_creep_under_load": "fails", "ke_is_no_spring": "fails"},
        ),
        (
            {
                "solimp-dmax-0.9999": {"drift_mm_s": -0.5},
                "*-kd-100": {"slip_mm": 5},
                "sweep-ke-1*-kd-100": {"slip_mm": 4},
            },
            {
                "not_creep_under_load": "the opposite",
                "ke_alone_low": 4,
                "ke_alone_share": 66.66667,
            },
        ),
        ({"sweep-*": None}, {"ke_alone_first": 2500, "ke_alone_last": 2500000}),
    ],
)
def test_whether_stiffness_follows_ke(cells, expected):
    assert_found("stiffness", CAUSE, STIFFNESS, cells, expected=expected)


READINGS = {
    "pad-ke-2.5e4": {"slip_mm": 6.7},
    "pad-ke-2.5e6": {"slip_mm": 6.5},
    "pad-ke-2.5e4-kd-100": {"slip_mm": 5.3},
    "pad-ke-2.5e5-kd-100": {"slip_mm": 5.5},
    "pad-ke-2.5e6-kd-100": {"slip_mm": 1.1},
    "solimp-dmax-0.9999": {"slip_mm": 0.9},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "contacts/result/0": "slips as far",
                "contacts/result/1": "slips farther",
                "contacts/result/2": "holds",
                "contacts/result/3": "slips as far",
                "contacts/result/4": "slips less",
                "contacts/result/5": "slips as far",
                "contacts/result/6": "slips less",
                "contacts/result/7": "holds",
            },
        )
    ],
)
def test_how_runs_are_read(cells, expected):
    assert_found("stiffness", CAUSE, STIFFNESS, READINGS, cells, expected=expected)


KE_ALONE = {
    "sweep-*": None,
    "pad-ke-2.5e4-kd-100": {"slip_mm": 5},
    "pad-ke-2.5e5-kd-100": {"slip_mm": 5.5},
    "pad-ke-2.5e6-kd-100": {"slip_mm": 7},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "ke_alone_low": 5,
                "ke_alone_share": 83.33333,
                "ke_alone_does_not_help": "holds",
            },
        ),
        (
            {"sweep-*": None, "pad-ke-2.5e4-kd-100": {"slip_mm": 4.7}},
            {"ke_alone_does_not_help": "fails", "sweep/is_so": False},
        ),
    ],
)
def test_whether_ke_alone_helps(cells, expected):
    assert_found(
        "stiffness", CAUSE, STIFFNESS, READINGS, KE_ALONE, cells, expected=expected
    )
