"""Test the time of a frame by the number of worlds."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {"frame_ms_p5": None, "ratio_resolution": 0.01},
    "worlds-1": {"frame_ms": 10},
    "worlds-4": {"frame_ms": 15},
    "worlds-16": {"frame_ms": 19.9},
    "worlds-64": {"frame_ms": 20.1},
    "worlds-256": {"frame_ms": 5},
    "whole-*": {"frame_ratio": 1},
    "each-step-*": {"frame_ratio": 0.5, "world_substeps_per_s": 1000},
    "testspeed-*": {"world_substeps_per_s": 250},
    "testspeed-4096": {"world_substeps_per_s": 400},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "cheap_worlds": 16,
                "first_worlds_are_cheap": "holds",
                "gain_1": 2,
                "gain_4096": 1.25,
                "least_gain": 1.25,
                "faster": "holds",
                "ways/1 world/0": 200,
                "ways/1 world/1": 50,
                "ways/4 096 worlds/0": 125,
                "ways/16 384 worlds/5": 100,
                "table_resolution": 1,
            },
        ),
        (
            {
                "worlds-4": {"frame_ms": 20.1},
                "testspeed-16384": {"world_substeps_per_s": 550},
            },
            {
                "cheap_worlds": 1,
                "first_worlds_are_cheap": "fails",
                "least_gain": 0.909091,
                "faster": "fails",
            },
        ),
        (
            {"each-step-waited-for-4096": {"ratio_resolution": 0.3}},
            {"faster": "cannot tell"},
        ),
    ],
)
def test_scaling_follows_from_its_cells(cells, expected):
    assert_found("scaling", GIVEN, cells, expected=expected)
