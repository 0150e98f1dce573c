"""Test which settings are Pareto-optimal, and when Warp is faster."""

from dataclasses import replace

import pytest
from current_columns import units_of
from deriving import NOISE, assert_found

from measured_report.files.root import ROOT
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.sections.error_runtime.runs import ERROR, TIME, front

PATH = ROOT / "results/newton-1.4.0/error_runtime.json"


def test_a_front_has_the_settings_that_no_other_of_their_kind_beats():
    cells = [
        (1.0, 9.0, "c"),
        (2.0, 5.0, "c"),
        (3.0, 5.0, "c"),
        (2.0, 5.0, "c"),
        (4.0, 1.0, "c"),
        (1.0, 10.0, "c"),
    ]
    cells += [(4.0, 4.0, "warp")]
    rows = [
        {"case": str(n), ERROR: e, TIME: t, "backend": backend}
        for n, (e, t, backend) in enumerate(cells)
    ]
    results = Results(replace(load_record(PATH), rows=rows, units=units_of(rows)), PATH)
    assert front(results.rows) == {"0", "1", "3", "4"}
    assert front(results.rows, "backend") == {"0", "1", "3", "4", "6"}
    assert front([]) == frozenset()


GIVEN = {
    "*": {"numerical_error_mm": 0.08, "c_difference_mm": 0.01},
    "as-shipped/newton/substeps-8": {"c_difference_mm": 9},
    "*/reference/*": {"numerical_error_mm": 0.007},
    "as-shipped/reference/elliptic-impratio-50-substeps-1024": {
        "grasp_error_mm_per_cycle": 0.45
    },
    "stiff/reference/elliptic-impratio-50-substeps-1024": {
        "grasp_error_mm_per_cycle": 0.08
    },
    "as-shipped/newton-rk4/substeps-2": {
        "numerical_error_mm": 0.03,
        "time_ratio": 0.9,
        "ratio_resolution": 0.03,
    },
    "as-shipped/newton/substeps-16": {
        "grasp_error_mm_per_cycle": 0.5,
        "time_ratio": 1,
        "ratio_resolution": 0.04,
    },
    "stiff/c-rk4/substeps-4": {"numerical_error_mm": 0.3},
    "stiff/c/substeps-16": {"numerical_error_mm": 0.05},
    "as-shipped/newton/iterations-200": {
        "c_difference_mm": 9,
        "numerical_error_mm": 0.087,
    },
    "worlds-*": {"time_ratio": 20, "ms_per_s": 400},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "floor_as-shipped": 0.01,
                "pads_stays": 90,
                "pads_gain": 5.625,
                "pads_seen": 0.01,
                "pads_decide": "holds",
                "rk4_warp_doubled": 0.06,
                "rk4_warp_cost": 0.9,
                "rk4_warp_cost_seen": 5,
                "rk4_warp": "holds",
                "rk4_warp/is_as_long": False,
                "numerical/rk4_warp": True,
                "rk4_with_stiff_pads": "holds",
                "low_error": 0.08,
                "reference_margin": 11.428571,
                "reference_converged": "holds",
                "effort_change": 0.007,
                "effort_share": 8.75,
                "solver_effort": "holds",
                "one_core_rate": 50,
                "rate_worlds-1": 2.5,
                "crossover_worlds": 20,
                "one_core_advantage": 20,
                "crossover/engine": "MuJoCo Warp on the GPU",
                "crossover": "holds",
            },
        ),
        (
            {
                "as-shipped/reference/elliptic-impratio-50-substeps-1024": {
                    "grasp_error_mm_per_cycle": 0.395
                },
                "as-shipped/newton-rk4/substeps-2": {"time_ratio": 0.97},
            },
            {"pads_decide": "fails", "rk4_warp/is_as_long": True},
        ),
        (
            {
                "stiff/reference/elliptic-impratio-50-substeps-1024": {
                    "grasp_error_mm_per_cycle": 0.095
                },
                "as-shipped/newton-rk4/substeps-2": {"time_ratio": 1.4},
            },
            {"pads_decide": "fails", "rk4_warp": "holds"},
        ),
        (
            {
                "as-shipped/newton/substeps-64": {"c_difference_mm": 0.38},
                "as-shipped/newton-rk4/substeps-2": {"time_ratio": 1.65},
            },
            {
                "floor_as-shipped": 0.38,
                "pads_decide": "cannot tell",
                "rk4_warp": "fails",
                "numerical/rk4_warp": False,
            },
        ),
        (
            {
                "as-shipped/newton-rk4/substeps-2": {"numerical_error_mm": 0.036},
                "stiff/c-rk4/substeps-4": {"numerical_error_mm": 0.03},
            },
            {
                "rk4_warp": "cannot tell",
                "numerical/rk4_warp": False,
                "rk4_with_stiff_pads": "the opposite",
            },
        ),
        (
            {
                "as-shipped/newton-rk4/substeps-2": {"numerical_error_mm": 0.05},
                "*/reference/*": {"numerical_error_mm": 0.009},
            },
            {
                "rk4_warp": "the opposite",
                "reference_margin": 8.888889,
                "reference_converged": "fails",
            },
        ),
        (
            {
                "*/c/*": {"numerical_error_mm": 0.04},
                (NOISE, "numerical_error_mm"): 0.002,
                "worlds-1": {"time_ratio": 0.5},
            },
            {"low_error": 0.04, "solver_effort": "cannot tell", "one_core_rate": 50},
        ),
        (
            {
                "as-shipped/c/substeps-*": {"numerical_error_mm": 0.04},
                "as-shipped/newton-each-substep/substeps-16": {
                    "numerical_error_mm": 0.11
                },
            },
            {"low_error": 0.08, "solver_effort": "the opposite"},
        ),
        (
            {"worlds-*": {"time_ratio": 0.5}},
            {"one_core_rate": 1.25, "crossover": "the opposite"},
        ),
        (
            {"as-shipped/newton/iterations-200": {"numerical_error_mm": 41}},
            {"effort_change": 0, "solver_effort": "holds"},
        ),
    ],
)
def test_error_runtime_follows_from_its_cells(cells, expected):
    assert_found("error_runtime", GIVEN, cells, expected=expected)
