"""Test the maps of harder shakes."""

import pandas as pd
import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

MAP = {
    "side": ["as-shipped"] * 4 + ["stiff"] * 4,
    "shake_amplitude_m": 2 * [0.01, 0.02, 0.01, 0.02],
    "shake_frequency_hz": 2 * [1.0, 1.0, 3.0, 3.0],
    "slip_mm": [2.0, 6.0, 4.0, 500.0, 1.0, 1.5, 1.0, 5.0],
    "dropped": [False, False, False, True] + 4 * [False],
    "cube_height_m": [0.2, 0.16, 0.2, 0.01] + 4 * [0.2],
}
"""Test four cells on each side; shipped pads drop the cube in one of them."""


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        (
            {},
            {
                "map_gain_median": 4,
                "map_gain_least": 2,
                "lost_as_shipped": 1,
                "lost_stiff": 0,
                "cells": 4,
                "map_gain": "holds",
                "as_shipped_drops": "holds",
                "stiff_pads_never_drop": "holds",
                "maps/keeps": True,
                "maps/shipped": 1,
                "maps/stiff": 0,
            },
        ),
        ({("cube_height_m", 1): 0.14}, {"lost_as_shipped": 2, "lost_stiff": 0}),
        (
            {("cube_height_m", 6): 0.14},
            {
                "lost_stiff": 1,
                "stiff_pads_never_drop": "fails",
                "maps/keeps": False,
                "maps/drops": True,
            },
        ),
        (
            {("cube_height_m", 3): 0.2},
            {"as_shipped_drops": "fails", "maps/drops": False, "maps/keeps": True},
        ),
        (
            {("slip_mm", 4): 2.5},
            {"map_gain_least": 0.8, "map_gain": "fails"},
        ),
        (
            {("slip_mm", 4): 1.995},
            {"map_gain_least": 1.002506, "map_gain": "cannot tell"},
        ),
        ({("dropped", 1): True}, {"map_gain_median": 3}),
    ],
)
def test_a_map_gives_drops_and_gains(changes, expected):
    frame = pd.DataFrame(MAP)
    for (column, index), value in changes.items():
        frame.loc[index, column] = value
    cells = {"as-shipped-3cm-1hz": {"shake_frequency_hz": 1}}
    assert_found("envelope", cells, frame=frame, expected=expected)
