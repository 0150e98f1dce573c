"""Times to a stated resolution: blocks of frames in turn, until the interval of a ratio is narrow enough.

A round times one block of each case, in the opposite order from the round before (ABBA), so that a drift of the machine
cancels. Compared are logarithms of a case's time over the reference's in the same round. Their mean has an interval
from batch means (Law & Carson, "A sequential procedure for determining the length of a steady-state simulation",
Operations Research 27(5), 1979): the rounds so far make BATCH_COUNT batches, which get longer at each look, so that
rounds that follow one another need not be independent. Rounds that are BATCH_COUNT apart start from the same state. So
from the second look on each batch is compared with those that start from its own states, and differences from state to
state are no noise (a stratified sample: Cochran, "Sampling Techniques", ch. 5). Each of LOOK_COUNT looks has its part
of the error (Bonferroni), so the interval covers whenever one stops.

A simulation that is built again takes a little more or less time on a GPU, always, by many times this noise. So cases
that differ in their build are built more than once, and ``pool_builds`` takes that into the interval.
"""

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

RESOLUTION = 0.01  # half of the interval of a ratio that is narrow enough, as a share of the ratio
BATCH_COUNT = 8
LOOK_COUNT = 5  # looks after 8, 16, 32, 64 and 128 rounds, each with 1 % of error
T_99 = {
    4: 4.6041,
    6: 3.7074,
    7: 3.4995,
}  # Student's t, two-sided 99 %, by degrees of freedom
T_95 = (12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060, 2.2622, 2.2281)
"""Student's t, two-sided 95 %, from one degree of freedom on; more than these have the last."""
CAP_S = 6.0  # seconds after which no comparison goes on to another look


@dataclass(frozen=True)
class PairedTimes:
    """Times of a case and of the reference in the same rounds."""

    times: np.ndarray  # time of a frame in each round [ms]
    ratios: (
        np.ndarray
    )  # ratio to the reference's time in the same round; 1 everywhere for the reference
    ratio: float  # geometric mean of the ratios
    resolution: float  # half of the 95 % interval of ``ratio``, as a share of it


def time_in_turn(
    blocks: Sequence[Callable[[int], float]],
    *,
    cap_s: float = CAP_S,
    clock: Callable[[], float] = time.perf_counter,
) -> list[PairedTimes]:
    """Time the blocks against the first of them until each ratio is known to RESOLUTION, in LOOK_COUNT looks at most.

    A case that is known takes no further part; the reference does to the end. Alone it is timed for the first look.

    Args:
        blocks: Each times a frame of its case [ms] in the round of that number.
        cap_s: Where another look would end after this time [s], the resolution stays as it is.
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
    state_count = (
        1 if pass_count == 1 else max(1, BATCH_COUNT // pass_count)
    )  # states that batches start from
    by_state = batches.reshape(-1, state_count)
    freedom = BATCH_COUNT - state_count
    deviation = math.sqrt(np.square(by_state - by_state.mean(axis=0)).sum() / freedom)
    half = T_99[freedom] * deviation / math.sqrt(BATCH_COUNT)
    return PairedTimes(times_ms, ratios, math.exp(batches.mean()), math.expm1(half))


def pool_builds(cases: Sequence[Sequence[PairedTimes]]) -> list[PairedTimes]:
    """Pool the builds of each case, all timed in one comparison; the first case is the reference.

    The spread of builds is taken as the same for all cases. Where no case has two, each is as it was.
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
