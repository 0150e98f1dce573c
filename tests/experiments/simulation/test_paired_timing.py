"""The rule by which comparisons of times stop: on made-up times whose ratio is known."""

from collections.abc import Callable, Iterator

import numpy as np
import pytest

from experiments.simulation.paired_timing import BATCH_COUNT, LOOK_COUNT, PairedTimes, pool_builds, time_in_turn

RUN_COUNT = 300
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


def test_what_differs_from_state_to_state_is_no_noise():
    found = []
    for seed in range(RUN_COUNT):
        generator = np.random.default_rng(seed)
        states = np.exp(generator.permutation(np.linspace(-0.1, 0.1, BATCH_COUNT)))

        def block(ratio, states, generator=generator):
            return lambda number: ratio * states[number % BATCH_COUNT] * float(np.exp(5e-3 * generator.normal()))

        found += time_in_turn([block(1.0, np.ones(BATCH_COUNT)), block(RATIO, states)], cap_s=float("inf"))[1:]
    assert np.mean([abs(np.log(each.ratio / RATIO)) <= np.log1p(each.resolution) for each in found]) >= 0.95
    assert all(each.resolution <= 0.01 for each in found)
    assert np.median([len(each.times) for each in found]) <= 4 * BATCH_COUNT


@pytest.mark.parametrize("drift", [0.0, 1e-4])
@pytest.mark.parametrize("share", [0.005, 0.02])
@pytest.mark.parametrize("correlation", [0.0, 0.5, 0.9])
@pytest.mark.parametrize("case_count", [2, 4])
def test_the_interval_has_the_ratio_in_it(case_count, correlation, share, drift):
    found = [each for seed in range(RUN_COUNT) for each in compared(case_count, correlation, share, drift, seed)[1:]]
    covered = [abs(np.log(each.ratio / RATIO)) <= np.log1p(each.resolution) for each in found]
    assert np.mean(covered) >= 0.95
    most = BATCH_COUNT << (LOOK_COUNT - 1)
    assert all(each.resolution <= 0.01 or len(each.times) == most for each in found)


def test_quiet_times_are_looked_at_once_and_a_known_case_no_more():
    quiet, loud = iter(np.exp(1e-4 * np.random.default_rng(1).normal(size=999))), noises(0.0, 0.05, 0.0, 2)
    blocks = [lambda _: next(quiet), lambda _: next(quiet), lambda _: float(np.exp(next(loud)))]
    reference, known, unknown = time_in_turn(blocks, cap_s=float("inf"))
    assert (len(known.times), len(unknown.times)) == (BATCH_COUNT, BATCH_COUNT << (LOOK_COUNT - 1))
    assert len(reference.times) == len(unknown.times) and reference.resolution == 0.0


def test_the_cap_leaves_the_resolution_that_was_reached():
    seconds = iter(range(99))
    noise = noises(0.0, 0.1, 0.0, 3)
    block = lambda _: float(np.exp(next(noise)))  # noqa: E731
    _, found = time_in_turn([block, block], cap_s=1.0, clock=lambda: float(next(seconds)))
    assert len(found.times) == BATCH_COUNT and found.resolution > 0.01


@pytest.mark.parametrize("build_count", [1, 2, 3])
def test_what_builds_differ_by_is_in_the_interval(build_count):
    """The reference has two builds, each of three cases so many, and a build takes 1 % more or less than another."""
    covered, narrow = [], []
    for seed in range(RUN_COUNT):
        generator = np.random.default_rng(seed)

        def block(ratio, generator=generator):
            own = ratio * np.exp(0.01 * generator.normal())
            return lambda _: own * float(np.exp(1e-3 * generator.normal()))

        counts = [2, *[build_count] * 3]
        found = iter(
            time_in_turn([block(RATIO if case else 1.0) for case, count in enumerate(counts) for _ in range(count)])
        )
        cases = [[next(found) for _ in range(count)] for count in counts]
        for case, each in zip(cases[1:], pool_builds(cases)[1:], strict=True):
            covered.append(abs(np.log(each.ratio / RATIO)) <= np.log1p(each.resolution))
            narrow.append(abs(np.log(case[0].ratio / RATIO)) <= np.log1p(case[0].resolution))
    assert np.mean(covered) >= 0.93 and np.mean(narrow) < 0.5
