"""Test the slip, the gain of stiff pads, and the agreement of the engines."""

import numpy as np
import pandas as pd
import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "as-shipped": {"slip_mm": 6},
    "as-shipped-*": {"slip_mm": 6},
    "stiff-pads": {"slip_mm": 0.3},
    "stiff-pads-*": {"slip_mm": 0.3},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "stiff_gain": 20,
                "slips": "holds",
                "stiff_pads_hold": "holds",
                "same_on_both_engines/effect": "holds",
            },
        ),
        (
            {
                "stiff-pads": {"slip_mm": 0.6},
                "as-shipped": {
                    "slip_mm": 1.01,
                    "shake_amplitude_m": 0.0304,
                    "shake_frequency_hz": 1.6,
                },
            },
            {
                "slips": "holds",
                "stiff_pads_hold": "fails",
                "amplitude": 30,
                "frequency": 2,
            },
        ),
        (
            {"as-shipped": {"slip_mm": 0.99}, "hold": {"slip_mm": 1}},
            {
                "slips": "fails",
                "same_on_both_engines/effect": "fails",
                "frame_rate": 60,
                "cube_edge": 40,
                "cube_mass": 32,
                "cube_friction": 1.2,
                "pad_friction": 1,
                "pad_ke": 2500,
                "pad_kd": 100,
            },
        ),
        (
            {
                "stiff-pads": {"slip_mm": 1.1},
                "as-shipped-mujoco-c": {"slip_mm": 6.01},
                "as-shipped-warp-cpu": {"slip_mm": 5.995},
            },
            {"stiff_pads_hold": "fails", "engine_difference_shipped": 0.015},
        ),
        (
            {
                "as-shipped-mujoco-c": {"slip_mm": 6.005},
                "as-shipped-warp-cpu": {"slip_mm": 5.999},
            },
            {"same_on_both_engines": "holds"},
        ),
        (
            {"as-shipped-mujoco-c": {"slip_mm": 6.04}},
            {"engine_difference": 0.04, "same_on_both_engines": "fails"},
        ),
        (
            {"stiff-pads-warp-cpu": {"slip_mm": 0.323}},
            {"engine_difference": 0.023, "same_on_both_engines": "fails"},
        ),
    ],
)
def test_reproduction_follows_from_its_cells(cells, expected):
    assert_found("reproduction", GIVEN, cells, expected=expected)


@pytest.mark.parametrize(
    ("late", "change", "outcome"),
    [(1.09, 9, "holds"), (0.91, 9, "holds"), (1.12, 12, "fails")],
)
def test_a_steady_drift_moves_as_far_early_as_late(late, change, outcome):
    along_mm = np.cumsum([0.0, 9.0, *4 * [1.0], 5.0, 5.0, *4 * [late]])
    time_s = np.arange(len(along_mm), dtype=float)
    mean = (7 + 2 * late) / 5  # in the even cycles, and in the odd ones
    assert_found(
        "reproduction",
        {"as-shipped": {"shake_frequency_hz": 1}},
        frame=pd.DataFrame({"time_s": time_s, "along_mm": along_mm}),
        expected={
            "increment_earlier": 1,
            "increment_later": late,
            "steady_cycle_count": 4,
            "increment_change": change,
            "increment_even": mean,
            "increment_odd": mean,
            "every_second_adds_more": "fails",
            "drift_is_steady": outcome,
        },
    )


def test_the_drift_along_each_axis_is_the_slope_of_the_displacement():
    """Test a cube that moves 5 mm along x and −2 mm along z in ten seconds."""
    time_s = np.linspace(0.0, 10.0, 601)
    names = ("x_mm", "y_mm", "z_mm", "along_mm")
    speeds = (0.5, 0.0, -0.2, 0.5)
    moved = dict(zip(names, np.outer(speeds, time_s), strict=True))
    assert_found(
        "reproduction",
        GIVEN,
        expected={
            "drift_x_as_shipped": 0.5,
            "drift_y_as_shipped": 0.0,
            "drift_z_stiff_pads": -0.2,
        },
        frame=pd.DataFrame({"time_s": time_s, **moved}),
    )
