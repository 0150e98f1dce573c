"""Noise: how far apart runs of one case are, and what it makes of numbers derived from them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from measured_report.values.noise import Floor, binomial_noise, cell_noise, derived_noise, is_beyond, tolerance

SIZES = st.floats(1e-12, 1e12)


def test_the_noise_is_what_nearly_all_pairs_stay_within_and_what_is_beyond_it_moved():
    """χ² at 39 degrees of freedom and 0.05 is 25.695, and the normal distribution has 0.9995 of it below 3.2905."""
    runs = [6.36 + 0.001 * (-1) ** index for index in range(40)]
    deviation = 0.001 * (40 / 39) ** 0.5
    assert tolerance(runs) == pytest.approx(2**0.5 * 3.2905 * deviation * (39 / 25.695) ** 0.5, rel=1e-3)
    assert tolerance([*runs, 7.36]) == pytest.approx(1.001), "never less than what was seen"
    assert tolerance([6.36] * 40) == 0.0 and tolerance([1.0, 1.5]) == 0.5
    assert not is_beyond(0.01, 1.0, 1.009) and is_beyond(0.01, 1.0, 1.02)
    assert not is_beyond(0.0, 6.0, 6.005), "rounding"
    assert Floor(spread=0.01, magnitude=5.0).at(1.0) == 0.01
    assert Floor(spread=0.01, magnitude=5.0).at(10.0, -20.0) == pytest.approx(0.04)


@pytest.mark.parametrize(
    ("successes", "trials", "end"),
    [(81, 263, 0.3662), (15, 148, 0.1605), (0, 20, 0.1611), (1, 29, 0.1718), (20, 20, 1 - 0.1611)],
)
def test_the_noise_of_a_share_is_of_wilson_s_interval(successes, trials, end):
    """Ends from Newcombe (1998), Statistics in Medicine 17, 857-872, table I, method 3; the last by symmetry."""
    share = successes / trials
    assert binomial_noise(share, trials) / 2**0.5 == pytest.approx(abs(end - share), abs=5e-5)


@given(SIZES, SIZES, st.floats(1e-6, 0.5), st.floats(1e-6, 0.5))
def test_a_ratio_carries_the_noise_of_both_parts(above, below, share, other):
    noise = derived_noise(lambda a, b: a / b, [above, below], [share * above, other * below])
    assert noise >= 0.999 * max(share, other) * above / below


def test_the_noise_of_a_cell_a_time_and_of_what_is_computed_from_an_unknown_one():
    floors = {"slip_mm": Floor(0.005, 6.4), "drift_mm_s": Floor(0.0, 0.5), "wall_s": Floor(0.0, 2.0)}
    row = {"slip_mm": 6.36, "drift_mm_s": 0.5, "wall_s": 2.0, "pad_ke": 2.5e5, "creep_mm_s": 0.1, "row_count": 8}
    found = {column: cell_noise(column, row, floors) for column in row}
    assert found == {
        "slip_mm": 0.005,
        "drift_mm_s": 1e-4,  # what rounding does, however well a machine repeats itself
        "wall_s": None,
        "pad_ke": 0.0,
        "creep_mm_s": None,
        "row_count": 0.0,
    }
    assert cell_noise("slip_mm", {"slip_mm": 64.0}, floors) == pytest.approx(0.05), "larger values are noisier"
    floors["slip_mm"] = Floor(0.005, 6.4, length=12.0)
    long = {"slip_mm": 3.58, "shake_duration_s": 60.0}
    assert cell_noise("slip_mm", long, floors) == pytest.approx(0.025), "runs part as they go on"
    assert cell_noise("slip_mm", {**long, "shake_duration_s": None}, floors) == 0.005
    in_c = row | {"backend": "c", "build_s": 2.0}
    assert cell_noise("creep_mm_s", in_c, floors) == pytest.approx(1e-4), "it repeats to the last bit"
    assert cell_noise("slip_mm", in_c, floors) == 0.005
    assert cell_noise("build_s", in_c, floors) is None, "a time does not"
    row = {"frame_ms": 8.0, "frame_ms_p5": 7.8, "frame_ms_p95": 8.3, "repeat_count": 25, "frames_per_s": 125.0}
    assert cell_noise("frame_ms", row, {}) == pytest.approx(1.25 * 0.5 / 5)
    ratio = {"frame_ratio": 0.5, "frame_ratio_p5": 0.4, "frame_ratio_p95": 0.6, "repeat_count": 16}
    assert cell_noise("frame_ratio", ratio | {"ratio_resolution": 0.01}, {}) == pytest.approx(0.005), "timed in turn"
    assert cell_noise("frame_ratio", ratio | {"ratio_resolution": 0.0}, {}) == pytest.approx(1.25 * 0.2 / 4)
    assert cell_noise("frames_per_s", row, {}) == pytest.approx(125.0 * 1.25 * 0.5 / 5 / 8.0)
    assert derived_noise(lambda a, b: a / b, [1.0, 2.0], [0.1, None]) is None
    assert derived_noise(lambda a, b: a / b, [1.0, 2.0], [0.0, 0.0]) == 0.0
