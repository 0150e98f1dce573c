"""Test the pads, the slip and the run time at each time step."""

import pytest
from deriving import NOISE, assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

RULE = "newton-elliptic/kd-1/substeps-"
GIVEN = {
    f"{RULE}{substeps}": {"slip_mm": slip}
    for substeps, slip in zip(
        (2, 4, 8, 16, 32, 64, 128), (2.4, 1.2, 0.6, 0.3, 0.15, 0.075, 0.2), strict=True
    )
}
GIVEN |= {
    "newton-elliptic/stiff/substeps-16": {"slip_mm": 0.3},
    "newton-elliptic/stiff/substeps-64": {"slip_mm": 0.5},
    ("step_cost", "stiff/substeps-64 1"): {"frame_ratio": 3.9},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "halving_least": 2,
                "halves": "holds",
                "fixed_pads": "holds",
                "finest": "holds",
                "fine": "holds",
                "fine/slip": 0.075,
                "fine/ratio": 3.9,
                "margin": "holds",
                "margin/safe": 4,
                "margin/lost": 16,
                "ke_safe": 4,
            },
        ),
        (
            {f"{RULE}8": {"slip_mm": 1.0}},
            {"halving_least": 1.2, "halves": "fails"},
        ),
        (
            {"newton-elliptic/stiff/substeps-64": {"slip_mm": 0.2}},
            {"fixed_pads": "the opposite"},
        ),
        (
            {
                "newton-elliptic/stiff/substeps-64": {"slip_mm": 0.31},
                (NOISE, "slip_mm"): 0.1,
            },
            {"fixed_pads": "cannot tell"},
        ),
        (
            {f"{RULE}32": {"slip_mm": 0.09}},
            {"fine/slip": 0.09},
        ),
        (
            {f"{RULE}8": {"slip_mm": None, "dropped": True}},
            {"margin": "fails"},
        ),
        (
            {"newton-pyramidal/ke-0.0625/substeps-2": {"slip_mm": 9.0}},
            {"pyramid": "the opposite"},
        ),
    ],
)
def test_time_step_follows_from_its_cells(cells, expected):
    assert_found("time_step", GIVEN, cells, expected=expected)


def test_the_law_is_half_of_the_left_out_acceleration_times_response_minus_step():
    """Test a drift of 25 · (0.019 − 0.001) = 0.45 mm/s and a slip of 4.5 mm, with
    ⟨J̇q̇⟩ = 50 mm/s², dmax 0.95, a timeconst of 20 ms, a step of 1 ms and a shake of 10
    s.
    """
    case = "newton-elliptic/shipped/substeps-16"
    cells = {
        ("drift_law", "g"): 50.0,
        case: {
            "dmax": 0.95,
            "timeconst_s": 0.02,
            "friction_timeconst_s": 0.0,
            "substep_ms": 1.0,
            "shake_duration_s": 10.0,
        },
    }
    assert_found(
        "time_step", cells, {}, expected={"law_newton-elliptic_shipped_16": 4.5}
    )
