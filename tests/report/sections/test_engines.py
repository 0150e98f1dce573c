"""Test that the words in cells about other engines follow the numbers."""

from dataclasses import replace

import pytest
from deriving import assert_found

from experiments.newton_solvers.box import EXCUSED
from measured_report.editions.project import Project
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.sections.engines import published


@pytest.mark.words
def test_each_solver_of_a_release_has_numbers_or_an_excuse(editions):
    """Test that each solver has results or a reason for their absence, also a solver
    that a release adds.
    """
    for release, edition in editions.items():
        if "newton_solvers" not in edition.chapters:
            continue
        told = [
            row
            for row in edition.chapters["newton_solvers"].results.rows
            if "of" in row
        ]
        named = {row["of"] for row in told}
        numbers = {
            row["of"]
            for row in told
            if "growth_per_s" in row and row.growth_per_s.value is not None
        }
        assert {"SolverMuJoCo", "SolverXPBD"} <= numbers, release
        assert named - numbers == set(EXCUSED), release


def test_a_number_agrees_within_half_its_last_digit_its_noise_or_below_its_bound_and_one_that_is_missing_does_not():
    digits = published.Published("", "", "0.0902", "1", "", "")
    assert (digits.agrees(0.09024), digits.agrees(0.0898)) == (True, False)
    noisy, bound = (
        replace(digits, theirs="150.5", noise=3.0),
        replace(digits, theirs="100", is_bound=True),
    )
    assert (noisy.agrees(153.4), noisy.agrees(153.6)) == (True, False)
    assert (bound.agrees(5.0), bound.agrees(100.5)) == (True, False)
    path = Project("1.4.0").record_path("engines")
    record = load_record(path)
    only = replace(record, rows=[{"case": "orbit", "creep_mm": 5.0}])
    [claim] = published.derive(Results(only, path)).claims
    assert claim.outcome.name == "unknown"


WALKS = {
    "*": {"growth_per_s": 0.004},
    "mjx-turntable-2ms": {"growth_per_s": 0.035},
    "mjx-turntable-1ms": {"growth_per_s": 0.033},
    "dart-turntable-2ms": {"growth_per_s": 0.02},
    "discrete-20ms-turntable-2ms": {"growth_per_s": 9},
    ("cure", "plain-c"): {"growth_per_s": 0.5},
    "dart-pinch-2ms": {"creep_mm_s": 2e-05},
    "physx-pinch-2ms": {"creep_mm_s": 9e-06},
    "physx-turntable-2ms": {"growth_per_s": 2e-05},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "mjx_walk": 3.5,
                "worst_other": 2,
                "times": 1.75,
                "kept": 94.28571,
                "walks_most_in_mujoco": "holds",
                "engines/sinks/10": 0.02,
                "engines/sinks/12": "not measurable",
                "engines/walk/12": "not measurable",
                "engines/walk/10": 2,
            },
        ),
        (
            {"dart-turntable-2ms": {"growth_per_s": 0.024}},
            {"walks_most_in_mujoco": "fails"},
        ),
        (
            {"mjx-turntable-1ms": {"growth_per_s": 0.031}},
            {"walks_most_in_mujoco": "fails"},
        ),
    ],
)
def test_where_the_box_walks(cells, expected):
    assert_found("engines", WALKS, cells, expected=expected)


SHAKES = {
    "*-shake-3cm": {"slip_mm": 1},
    "*-shake-held": {"slip_mm": 0.5},
    "mujoco-c-shake-3cm": {"slip_mm": 6},
    "pybullet-shake-held": {"slip_mm": 1.5},
    ("solver", "stiff-pads-mujoco-c"): {"slip_mm": 0.3},
    "*-shake-10cm": {"dropped": False},
    "mujoco-c-shake-10cm": {"dropped": True},
    "fet028-pad-kd-100": {"slip_mm": 0.6},
    "fet028-pad-kd-5": {"slip_mm": 13},
    "physx-shake-3cm": {"slip_mm": 0.0005},
    "dart-shake-3cm": {"slip_mm": 2, "creep_mm_per_cycle": 0.2},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "robot_worst": 2,
                "robots/creep/3": 0.2,
                "robots/creep/5": "not measurable",
                "robot_worst_held": 1.5,
                "robot_count": 5,
                "slips_farthest": "holds",
                "only_it_loses": "holds",
                "soft_times": 21.66667,
                "test_lets_through": "holds",
                "test_lets_through/is_more": "holds",
            },
        ),
        (
            {
                "mujoco-c-shake-3cm": {"slip_mm": 1.9},
                "dart-shake-10cm": {"dropped": True},
                "fet028-pad-kd-5": {"slip_mm": 5.8},
            },
            {
                "slips_farthest": "the opposite",
                "only_it_loses": "fails",
                "test_lets_through": "fails",
            },
        ),
        (
            {
                "mujoco-c-shake-held": {"slip_mm": 7},
                "mujoco-c-shake-10cm": {"dropped": False},
                "fet028-pad-kd-5": {"slip_mm": 31},
            },
            {
                "slips_farthest": "the opposite",
                "only_it_loses": "fails",
                "test_lets_through": "fails",
            },
        ),
        (
            {
                "pybullet-shake-held": {"slip_mm": 7},
                "fet028-pad-kd-5": {"slip_mm": 0.5},
            },
            {
                "slips_farthest": "the opposite",
                "test_lets_through/is_more": "the opposite",
            },
        ),
        (
            {("solver", "stiff-pads-mujoco-c"): {"slip_mm": 7}},
            {"slips_farthest": "fails"},
        ),
    ],
)
def test_where_the_cube_slips_farthest(cells, expected):
    assert_found("engines", WALKS, SHAKES, cells, expected=expected)


PUBLISHED = {
    "friction-motrixsim": {"critical_friction": 0.09024, "fall_mm": 0.04},
    "friction-euler": {"fall_mm": 153.4},
    "friction-implicitfast": {"fall_mm": 11.34},
    "shake-*": {"dropped_count": 0},
    "wall-*": {"creep_mm_s": 4.54},
    "orbit": {"creep_mm": 5},
    ("scenes", "impratio-1-c"): {"creep_mm_s": 1.54},
    ("scenes", "pyramidal-c"): {"creep_mm_s": 2.34},
    ("scenes", "stiff-c"): {"creep_mm_s": 0.054},
    ("scenes", "noslip-c"): {"creep_mm_s": 0.00144},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "agreeing": 12,
                "compared": 12,
                "as_others_published": "holds",
                "published/difference/0": 4e-05,
                "published/tolerance/2": 3,
            },
        ),
        (
            {"wall-c": {"creep_mm_s": 4.56}},
            {
                "agreeing": 11,
                "as_others_published": "fails",
                "as_others_published/are_most": True,
            },
        ),
        (
            {
                "friction-*": {"fall_mm": 99},
                "wall-*": {"creep_mm_s": 99},
                ("scenes", "impratio-1-c"): {"creep_mm_s": 99},
            },
            {"as_others_published/are_most": False},
        ),
        ({"orbit": {"creep_mm": 101}}, {"agreeing": 12, "published/agrees/12": False}),
    ],
)
def test_whether_numbers_are_as_published(cells, expected):
    assert_found("engines", WALKS, SHAKES, PUBLISHED, cells, expected=expected)
