"""Test the rule that ends comparisons of times, on synthetic times with a known ratio."""

from collections.abc import Callable, Iterator

import numpy as np
import pytest
from scipy import stats

from experiments.simulation import paired_timing
from experiments.simulation.paired_timing import (
    BATCH_COUNT,
    LOOK_COUNT,
    PairedTimes,
    pool_builds,
    time_in_turn,
)

RUN_COUNT = 200
RATIO = 1.02


def noises(
    correlation: float, share: float, drift: float, seed: int
) -> Iterator[float]:
    """Return logarithms of synthetic times: each block shares noise with the previous
    one, and the mean drifts steadily.
    """
    generator = np.random.default_rng(seed)
    state, count = generator.normal(), 0
    while True:
        yield share * state + drift * count
        state = correlation * state + np.sqrt(1.0 - correlation**2) * generator.normal()
        count += 1


def compared(
    case_count: int, correlation: float, share: float, drift: float, seed: int
) -> list[PairedTimes]:
    noise = noises(correlation, share, drift, seed)

    def block(ratio: float) -> Callable[[int], float]:
        return lambda _: 10.0 * ratio * float(np.exp(next(noise)))

    return time_in_turn(
        [block(1.0), *(block(RATIO) for _ in range(case_count - 1))], cap_s=float("inf")
    )


@pytest.mark.parametrize(
    ("case_count", "correlation", "share", "drift"),
    [
        (2, 0.0, 0.02, 0.0),
        (4, 0.5, 0.005, 1e-4),
        (2, 0.9, 0.02, 1e-4),
        (4, 0.9, 0.005, 0.0),
        (4, 0.9, 0.02, 1e-4),
    ],
)
def test_the_interval_has_the_ratio_in_it(case_count, correlation, share, drift):
    found = [
        each
        for seed in range(RUN_COUNT)
        for each in compared(case_count, correlation, share, drift, seed)[1:]
    ]
    covered = [
        abs(np.log(each.ratio / RATIO)) <= np.log1p(each.resolution) for each in found
    ]
    assert np.mean(covered) >= 0.95
    most = BATCH_COUNT << (LOOK_COUNT - 1)
    assert all(each.resolution <= 0.01 or len(each.times) == most for each in found)


def test_the_quantiles_are_students():
    of_99, of_95 = paired_timing.T_99, paired_timing.T_95
    assert of_99 == pytest.approx(
        {freedom: stats.t.ppf(0.995, freedom) for freedom in (4, 6, 7)}, abs=6e-5
    )
    assert of_95 == pytest.approx(stats.t.ppf(0.975, np.arange(1, 11)), abs=6e-5)


def replayed(
    ratios, cap_s: float, seconds_a_round: float = 1.0
) -> tuple[list[PairedTimes], list[tuple[int, int]]]:
    """Return the comparison of synthetic times, and the order in which cases ran.

    The reference takes 10 ms, and the other case takes these ratios of it.
    """
    ran: list[tuple[int, int]] = []

    def block(index: int, times) -> Callable[[int], float]:
        return lambda number: ran.append((number, index)) or float(times[number])

    blocks = [block(0, np.full(128, 10.0)), block(1, 10.0 * np.asarray(ratios))]
    found = time_in_turn(
        blocks, cap_s=cap_s, clock=lambda: 500.0 + seconds_a_round * len(ran) / 2.0
    )
    return found, ran


@pytest.mark.parametrize(("look", "states"), [(0, 1), (1, 4), (2, 2), (3, 1), (4, 1)])
def test_the_interval_is_students_about_the_mean_of_each_state(look, states):
    """Test that the cap determines the number of rounds in 8 batches, and that only
    blocks with the same start states are compared.
    """
    count = 8 << look
    ratios = np.exp(np.random.default_rng(look).normal(0.3, 1.0, 128))
    found, _ = replayed(ratios, cap_s=2.0 * count - 1.0 if look < 4 else 1e9)
    batches = np.log(ratios[:count]).reshape(8, -1).mean(axis=1)
    residuals = np.concatenate(
        [
            batches[state::states] - batches[state::states].mean()
            for state in range(states)
        ]
    )
    freedom = 8 - states
    half = stats.t.ppf(0.995, freedom) * np.sqrt(np.sum(residuals**2) / freedom / 8.0)
    assert len(found[1].times) == count and found[1].ratios == pytest.approx(
        ratios[:count]
    )
    assert found[1].ratio == pytest.approx(stats.gmean(ratios[:count]))
    assert found[1].resolution == pytest.approx(np.expm1(half), rel=1e-4)
    assert (found[0].ratio, found[0].resolution) == (1.0, 0.0)


def test_rounds_turn_about_and_end_with_what_is_known():
    alternating = 1.0 + 0.008 * np.where(
        np.arange(128) % 2, 1.0, -1.0
    )  # s = 0.0085, 3.4995 s / √8 = 1.06 %
    found, ran = replayed(alternating, cap_s=1e9)
    assert [index for _, index in ran[:6]] == [0, 1, 1, 0, 0, 1] and [
        number for number, _ in ran[:4]
    ] == [0, 0, 1, 1]
    assert len(found[1].times) == 16
    found, _ = replayed(1.0 + 0.9 * (alternating - 1.0), cap_s=1e9)
    assert len(found[1].times) == 8 and found[1].resolution == pytest.approx(
        0.0095, abs=1e-4
    )
    assert len(replayed(np.ones(128), cap_s=0.0)[0][1].times) == 8


@pytest.mark.parametrize("counts", [(2, 2), (2, 3), (4, 12)])
def test_builds_are_pooled_as_in_students_test_of_two_samples(counts):
    random = np.random.default_rng(5)
    logarithms = [
        random.normal(mean, 0.1, count)
        for mean, count in zip((0.0, 0.2), counts, strict=True)
    ]
    cases = [
        [
            PairedTimes(np.full(3, r), np.full(3, np.exp(r)), np.exp(r), 0.5)
            for r in each
        ]
        for each in logarithms
    ]
    found = pool_builds(cases)
    low, high = stats.ttest_ind(logarithms[1], logarithms[0]).confidence_interval(0.95)
    if counts[1] == 12:  # at 14 degrees of freedom, for which the value for ten is used
        low, high = 0.5 * (low + high) + np.array([-0.5, 0.5]) * (
            high - low
        ) * stats.t.ppf(0.975, 10) / stats.t.ppf(0.975, 14)
    assert np.log(found[1].ratio) == pytest.approx(0.5 * (low + high))
    assert np.log1p(found[1].resolution) == pytest.approx(0.5 * (high - low), rel=1e-4)
    assert (found[0].ratio, found[0].resolution) == pytest.approx((1.0, 0.0))
    assert found[1].ratios == pytest.approx(
        np.repeat(np.exp(logarithms[1] - logarithms[0].mean()), 3)
    )
    assert len(found[1].times) == 3 * counts[1]
    assert pool_builds([cases[0][:1], cases[1][:1]]) == [cases[0][0], cases[1][0]]
