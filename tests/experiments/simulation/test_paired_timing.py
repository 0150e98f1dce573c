"""The rule by which comparisons of times stop: on made-up times whose ratio is known."""

from collections.abc import Callable, Iterator

import numpy as np
import pytest

from experiments.simulation.paired_timing import BATCH_COUNT, LOOK_COUNT, PairedTimes, time_in_turn

RUN_COUNT = 200
RATIO = 1.02


def noises(correlation: float, share: float, drift: float, seed: int) -> Iterator[float]:
    """Logarithms of made-up times: noise that each block has in part from the one before, on a steady drift."""
    generator = np.random.default_rng(seed)
    state, count = generator.normal(), 0
    while True:
        yield share * state + drift * count
        state = correlation * state + np.sqrt(1.0 - correlation**2) * generator.normal()
        count += 1


def compared(case_count: int, correlation: float, share: float, drift: float, seed: int) -> list[PairedTimes]:
    noise = noises(correlation, share, drift, seed)

    def block(ratio: float) -> Callable[[int], float]:
        return lambda _: 10.0 * ratio * float(np.exp(next(noise)))

    return time_in_turn([block(1.0), *(block(RATIO) for _ in range(case_count - 1))], cap_s=float("inf"))


@pytest.mark.parametrize(
    ("case_count", "correlation", "share", "drift"),
    [(2, 0.0, 0.02, 0.0), (4, 0.5, 0.005, 1e-4), (2, 0.9, 0.02, 1e-4), (4, 0.9, 0.005, 0.0), (4, 0.9, 0.02, 1e-4)],
)
def test_the_interval_has_the_ratio_in_it(case_count, correlation, share, drift):
    found = [each for seed in range(RUN_COUNT) for each in compared(case_count, correlation, share, drift, seed)[1:]]
    covered = [abs(np.log(each.ratio / RATIO)) <= np.log1p(each.resolution) for each in found]
    assert np.mean(covered) >= 0.95
    most = BATCH_COUNT << (LOOK_COUNT - 1)
    assert all(each.resolution <= 0.01 or len(each.times) == most for each in found)
