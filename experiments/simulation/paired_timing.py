"""Time blocks of frames alternately until the interval of a ratio is narrow enough.

A round times one block of each case, in the reverse order of the previous round (ABBA),
so that a drift of the machine cancels. The logarithm of a case's time relative to the
reference in the same round is evaluated. The interval of its mean is computed from
batch means (Law & Carson, "A sequential procedure for determining the length of a
steady-state simulation", Operations Research 27(5), 1979). The rounds form BATCH_COUNT
batches, which become longer at each look, so that consecutive rounds need not be
independent. Rounds that are BATCH_COUNT apart start from the same state. From the
second look on, each batch is compared with batches that start from the same states, so
that differences between states do not count as noise (a stratified sample: Cochran,
"Sampling Techniques", ch. 5). Each of the LOOK_COUNT looks has its share of the error
probability (Bonferroni), so that the interval is valid at every stop.

If a simulation is built again on a GPU, its time differs permanently by many times this
noise. Therefore, cases with different builds are built more than once, and
``pool_builds`` includes this scatter in the interval.
"""

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

# Largest half-width of a ratio's interval that is narrow enough, relative to the ratio.
RESOLUTION = 0.01
BATCH_COUNT = 8
LOOK_COUNT = 5  # looks after 8, 16, 32, 64 and 128 rounds, each with an error of 1 %
# Student's t, two-sided 99 %, by degrees of freedom.
T_99 = {
    4: 4.6041,
    6: 3.7074,
    7: 3.4995,
}
T_95 = (12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060, 2.2622, 2.2281)
"""Student's t, two-sided 95 %, from one degree of freedom on.

The last value is also used for more degrees of freedom.
"""
CAP_S = 6.0  # time after which a comparison does not start another look [s]


@dataclass(frozen=True)
class PairedTimes:
    """The times of a case and its ratios to the reference in the same rounds."""

    times: np.ndarray  # time of a frame in each round [ms]
    # Ratio to the reference's time in the same round; 1 for the reference itself.
    ratios: np.ndarray
    ratio: float  # geometric mean of the ratios
    resolution: float  # half of the 95 % interval of ``ratio``, relative to it


def time_in_turn(
    blocks: Sequence[Callable[[int], float]],
    *,
    cap_s: float = CAP_S,
    clock: Callable[[], float] = time.perf_counter,
) -> list[PairedTimes]:
    """Time blocks until each ratio to the first one is as precise as RESOLUTION.

    There are at most LOOK_COUNT looks. A case whose ratio is precise enough is no
    longer timed, but the reference is timed to the end. A reference alone is timed for
    the first look only.

    Args:
        blocks: Functions that return the time of a case's frame [ms] in a given round.
        cap_s: Time [s] that another look must not exceed.
    """
    if not blocks:
        return []
    start = clock()
    rounds: list[list[float]] = [[] for _ in blocks]
    active = list(range(len(blocks)))
    for look in range(LOOK_COUNT):
        for number in range(len(rounds[0]), BATCH_COUNT << look):
            for index in active if number % 2 == 0 else reversed(active):
                rounds[index].append(blocks[index](number))
        is_open = {
            index: _compared(rounds[index], rounds[0]).resolution > RESOLUTION
            for index in active
        }
        active = [index for index in active if index == 0 or is_open[index]]
        if len(active) == 1 or 2.0 * (clock() - start) > cap_s:
            break
    return [_compared(times, rounds[0]) for times in rounds]


def _compared(times: Sequence[float], reference: Sequence[float]) -> PairedTimes:
    times_ms = np.array(times)
    ratios = times_ms / np.array(reference[: len(times)])
    batches = np.log(ratios).reshape(BATCH_COUNT, -1).mean(axis=1)
    pass_count = len(times_ms) // BATCH_COUNT
    # The number of different start states of the batches.
    state_count = 1 if pass_count == 1 else max(1, BATCH_COUNT // pass_count)
    by_state = batches.reshape(-1, state_count)
    freedom = BATCH_COUNT - state_count
    deviation = math.sqrt(np.square(by_state - by_state.mean(axis=0)).sum() / freedom)
    half = T_99[freedom] * deviation / math.sqrt(BATCH_COUNT)
    return PairedTimes(times_ms, ratios, math.exp(batches.mean()), math.expm1(half))


def pool_builds(cases: Sequence[Sequence[PairedTimes]]) -> list[PairedTimes]:
    """Return the times of each case in one comparison, pooled over its builds.

    The first case is the reference. The scatter between builds is assumed to be equal
    for all cases. If no case has two builds, the times are returned unchanged.
    """
    logarithms = [np.log([build.ratio for build in builds]) for builds in cases]
    freedom = sum(len(logs) - 1 for logs in logarithms)
    if not freedom:
        return [builds[0] for builds in cases]
    deviation = math.sqrt(
        sum(np.square(logs - logs.mean()).sum() for logs in logarithms) / freedom
    )
    t, reference, pooled = T_95[min(freedom, len(T_95)) - 1], logarithms[0], []
    for builds, logs in zip(cases, logarithms, strict=True):
        half = (
            t * deviation * math.sqrt(1 / len(logs) + 1 / len(reference))
            if logs is not reference
            else 0.0
        )
        times = np.concatenate([build.times for build in builds])
        ratios = np.concatenate([build.ratios for build in builds]) / math.exp(
            reference.mean()
        )
        pooled.append(
            PairedTimes(
                times,
                ratios,
                math.exp(logs.mean() - reference.mean()),
                math.expm1(half),
            )
        )
    return pooled
