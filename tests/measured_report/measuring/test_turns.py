"""Turns on a host: batches of several processes, one of which at a time is alone."""

import pickle
import time
from contextlib import suppress
from itertools import permutations

import pytest

from measured_report.measuring import turns
from measured_report.measuring.batch import Batch, timing
from measured_report.measuring.outcome import run_batch
from measured_report.measuring.pool import processes
from measured_report.measuring.turns import alone

PREPARE_S, TIME_S = 0.4, 0.1


@pytest.fixture(autouse=True)
def place(tmp_path, monkeypatch):
    monkeypatch.setattr(turns, "PLACE", tmp_path / "turns")


def prepared_and_timed(raises: bool = False) -> list[tuple[float, float]]:
    """Prepare and time something, twice: when each began and ended."""
    spans = []
    for _ in range(2):
        begin = time.monotonic()
        time.sleep(PREPARE_S)
        spans.append((begin, time.monotonic()))
        with suppress(MemoryError), alone(), alone():
            begin = time.monotonic()
            time.sleep(TIME_S)
            spans.append((begin, time.monotonic()))
            if raises:
                raise MemoryError
    return spans


def outcomes(batches: list[Batch]) -> list:
    """Run batches at once, each in a process of its own."""
    with processes(len(batches), "fork") as pool:
        return [call.result() for call in [pool.submit(run_batch, batch, {}) for batch in batches]]


def overlap(one, other) -> bool:
    return one[0] < other[1] and other[0] < one[1]


@pytest.mark.parametrize("raises", [False, True])
def test_those_that_prepare_do_so_together_and_one_at_a_time_is_timed(raises):
    found = outcomes([timing("times", prepared_and_timed, raises)] * 2)
    spans = [pickle.loads(done.content) for done in found]
    for mine, others in permutations(spans):
        assert not any(overlap(timed, other) for timed in mine[1::2] for other in others)
    assert all(overlap(spans[0][number], spans[1][number]) for number in (0, 2)), "they prepare together"
    for done, mine in zip(found, spans, strict=True):
        lengths = [end - begin for begin, end in mine]
        assert done.seconds == pytest.approx(sum(lengths), abs=0.2), "what it waits for does not count"
        assert done.alone_s == pytest.approx(sum(lengths[1::2]), abs=0.1)


def test_what_need_not_be_alone_is_beside_its_like_and_never_beside_what_is():
    shared, whole = (Batch(name, prepared_and_timed, alone=name == "whole") for name in ("shared", "whole"))

    def spans(*batches: Batch) -> list[tuple[float, float]]:
        found = [pickle.loads(done.content) for done in outcomes([*batches])]
        return [(mine[0][0], mine[-1][1]) for mine in found]

    assert overlap(*spans(shared, shared)) and not overlap(*spans(shared, whole)) and not overlap(*spans(whole, whole))


def test_whoever_waits_long_for_others_says_so(capfd, monkeypatch):
    monkeypatch.setattr(turns, "PATIENCE_S", 0.05)
    assert len(outcomes([Batch("times", time.sleep, (0.4,), alone=True)] * 2)) == 2
    assert capfd.readouterr().err.count(turns.WAITING) == 1
