"""Test the reduction of a frame's time without the unneeded parts."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

GIVEN = {
    "*": {"frame_ratio": 1, "ratio_resolution": 0.001},
    "without-all cuda *": {"frame_ratio": 0.8},
    "without-all cpu 1": {"frame_ratio": 0.5, "ratio_resolution": 0.25},
    "untrimmed cuda *": {"slip_mm": 6},
    "* cuda *": {"slip_mm": 6},
    "without-visuals cuda *": {"frame_ratio": 0.9, "slip_mm": 6.009},
    "untrimmed cuda 1": {"buffer_bytes_per_world": 2100},
    "without-all cuda 1": {"buffer_bytes_per_world": 100},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "cuda_gain_1": 1.25,
                "cuda_gain_16384": 1.25,
                "cuda_without_all_1_less": 20,
                "faster_on_gpu": "holds",
                "cpu_gain_least": 1.6,
                "faster_on_cpu": "holds",
                "memory_saving": 21,
                "less_memory": "holds",
                "cuda_largest_difference": 0.009,
                "cuda_without_visuals_difference": 0.009,
                "cuda_largest_share": 0.15,
                "same_slip_on_gpu": "holds",
                "cuda_resolution": 0.1,
                "cpu_resolution": 25,
            },
        ),
        (
            {
                "without-all cuda 1": {"frame_ratio": 0.985},
                "without-all cpu 1": {"frame_ratio": 1.5},
                "untrimmed cuda 1": {"buffer_bytes_per_world": 1900},
            },
            {
                "faster_on_gpu": "holds",
                "faster_on_gpu/one": 1.015228,
                "faster_on_gpu/many": 1.25,
                "faster_on_cpu": "the opposite",
                "less_memory": "fails",
            },
        ),
        (
            {
                "without-all cuda 16384": {"frame_ratio": 0.995},
                "without-all cuda *": {"slip_mm": 5.9},
            },
            {"faster_on_gpu": "the opposite", "same_slip_on_gpu": "the opposite"},
        ),
    ],
)
def test_leave_out_follows_from_its_cells(cells, expected):
    assert_found("leave_out", GIVEN, cells, expected=expected)
