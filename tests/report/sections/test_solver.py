"""Test whether the settings of the solver change the slip."""

import pytest
from deriving import NOISE, assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

SLIPS = {
    "*": {"slip_mm": 6},
    "iterations-200": {"slip_mm": 6.009},
    "tolerance-1e-10": {"slip_mm": 5.992},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "convergence_difference": 0.009,
                "solver_has_converged": "holds",
                "impratio_does_not_help": "holds",
                "smaller_steps_do_not_help": "holds",
                "solver_has_converged/effect": "holds",
            },
        ),
        (
            {"tolerance-1e-10": {"slip_mm": 6.03}},
            {"convergence_share": 0.5, "solver_has_converged": "holds"},
        ),
        (
            {"tolerance-1e-10": {"slip_mm": 6.06}, "impratio-1000": {"slip_mm": 5.9}},
            {
                "convergence_share": 1,
                "solver_has_converged": "cannot tell",
                "impratio-1000_reduction": 0.1,
                "impratio-1000_reduction_share": 1.666667,
                "impratio_does_not_help": "the opposite",
            },
        ),
        (
            {"iterations-200": {"slip_mm": 5.9}, "impratio-1000": {"slip_mm": 6.5}},
            {"solver_has_converged": "the opposite", "impratio_does_not_help": "holds"},
        ),
        (
            {"substeps-64": {"slip_mm": 5.9}},
            {
                "smaller_steps_do_not_help": "the opposite",
                "impratio_does_not_help": "holds",
            },
        ),
        ({(NOISE, "slip_mm"): 0.02}, {"solver_has_converged": "holds"}),
        (
            {(NOISE, "slip_mm"): 0.31, "*": {"slip_mm": 0.5}},
            {
                "solver_has_converged": "cannot tell",
                "impratio_does_not_help": "cannot tell",
                "solver_has_converged/effect": "fails",
            },
        ),
    ],
)
def test_whether_settings_change_the_slip(cells, expected):
    assert_found("solver", SLIPS, cells, expected=expected)


NOSLIP = {
    "as-shipped-mujoco-c": {"drift_mm_s": 1},
    "as-shipped-mujoco-c-noslip": {"drift_mm_s": 0.92},
    "stiff-pads-mujoco-c": {"drift_mm_s": 0.1},
    "stiff-pads-mujoco-c-noslip": {"drift_mm_s": 0.109},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "as-shipped-mujoco-c_change": -8,
                "stiff-pads-mujoco-c_change": 9,
                "mujoco-c_change": 9,
                "noslip_does_not_help_in_mujoco_c": "holds",
                "noslip_does_not_help_in_mujoco_c/treated_stiff": 0.109,
            },
        ),
        (
            {"as-shipped-mujoco-c-noslip": {"drift_mm_s": 0.88}},
            {"noslip_does_not_help_in_mujoco_c": "fails"},
        ),
    ],
)
def test_whether_noslip_helps(cells, expected):
    assert_found("solver", SLIPS, NOSLIP, cells, expected=expected)
