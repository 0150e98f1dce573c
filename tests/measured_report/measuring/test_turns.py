"""Turns on a host: batches of several processes, one of which at a time is alone."""

import os
import pickle
import time
from contextlib import suppress
from dataclasses import replace
from itertools import chain, pairwise, permutations, zip_longest
from multiprocessing import get_context
from multiprocessing.synchronize import Barrier
from types import SimpleNamespace

import pytest

from measured_report.measuring import turns
from measured_report.measuring.batch import Batch, timing
from measured_report.measuring.outcome import Done, Failed, run_batch
from measured_report.measuring.pool import processes
from measured_report.measuring.turns import alone

PREPARE_S, TIME_S, STEP_S = 0.4, 0.1, 0.01


@pytest.fixture(autouse=True)
def place(tmp_path, monkeypatch):
    monkeypatch.setattr(turns, "PLACE", tmp_path / "turns")
    monkeypatch.setattr(turns, "POLL_S", STEP_S)
    monkeypatch.setattr(os, "cpu_count", lambda: 4)
    settling(monkeypatch, lambda: True)


def settling(monkeypatch, settle) -> None:
    monkeypatch.setattr(turns, "host", lambda: SimpleNamespace(settle=settle))


def moments(seconds: float) -> list[float]:
    """Moments in which this process runs, in all so long."""
    found = [time.monotonic()]
    for _ in range(round(seconds / STEP_S)):
        time.sleep(STEP_S)
        found.append(time.monotonic())
    return found


def prepared_and_timed(raises: bool = False, prepare_s: float = PREPARE_S) -> list[list[float]]:
    """Prepare and time something, twice: the moments of each."""
    found = []
    for _ in range(2):
        found.append(moments(prepare_s))
        with suppress(MemoryError), alone(), alone():
            found.append(moments(TIME_S))
            if raises:
                raise MemoryError
    return found


def outcomes(batches: list[Batch], gpus: str = "") -> list:
    """Run batches at once, each in a process of its own, which has the GPU of that letter."""
    together.append(get_context("fork").Barrier(len(batches)))
    with processes(len(batches), "fork") as pool:
        calls = [pool.submit(run_on, *call) for call in zip_longest(batches, gpus)]
        return [call.result() for call in calls]


together: list[Barrier] = []
"""Where the processes of the last batches wait for one another, since a fork may take as long as a batch."""


def run_on(batch: Batch, gpu: str | None) -> Done | Failed:
    os.environ["CUDA_VISIBLE_DEVICES"] = f"GPU-{gpu}" if gpu else ""
    together[-1].wait()
    return run_batch(batch, {})


def is_beside(part: list[float], other: list[float]) -> bool:
    """Whether the other runs between the first and the last moment of a part."""
    return any(part[0] < moment < part[-1] for moment in other)


@pytest.mark.parametrize("raises", [False, True])
def test_those_that_prepare_do_so_together_and_one_at_a_time_is_timed(raises):
    found = outcomes([timing("times", prepared_and_timed, raises)] * 2)
    parts = [pickle.loads(done.content) for done in found]
    for mine, others in permutations(parts):
        assert not any(is_beside(timed, other) for timed in mine[1::2] for other in others)
    assert is_beside(parts[0][0], parts[1][0]), "they prepare together"
    for done in found:
        assert done.seconds == pytest.approx(2 * (PREPARE_S + TIME_S), abs=0.3), "what it waits for does not count"
        assert done.alone_s == pytest.approx(2 * TIME_S, abs=0.1)


def test_what_prepares_gives_way_to_what_is_timed_and_goes_on_where_it_was():
    long, short = outcomes([timing("long", prepared_and_timed, False, 2.0), timing("short", prepared_and_timed)])
    mine, others = (pickle.loads(done.content) for done in (long, short))
    prepared, timed = mine[0], others[1]
    assert prepared[0] < timed[0] < timed[-1] < prepared[-1] and not is_beside(timed, prepared)
    steps = [step for step in pairwise(chain(*mine)) if not is_beside(step, [*chain(*others[1::2])])]
    assert long.seconds == pytest.approx(sum(end - start for start, end in steps), abs=0.5), "nothing is done twice"


def test_what_prepares_goes_on_while_another_waits_for_what_does_not():
    timed = [timing(name, prepared_and_timed, False, prepare_s) for name, prepare_s in (("long", 0.8), ("short", 0.4))]
    done = outcomes([Batch("shared", moments, (2.0,)), *timed])
    shared, [prepared, timed, *_], [_, waited_for, *_] = (pickle.loads(each.content) for each in done)
    assert prepared[-1] < shared[-1] < min(timed[0], waited_for[0])


def test_what_cannot_be_left_is_waited_for(monkeypatch):
    settling(monkeypatch, lambda: False)
    long, short = outcomes([timing("long", prepared_and_timed, False, 1.0), timing("short", prepared_and_timed)])
    assert pickle.loads(long.content)[0][-1] < pickle.loads(short.content)[1][0]


def test_what_need_not_be_alone_is_beside_its_like_and_never_beside_what_is():
    shared, whole = (Batch(name, prepared_and_timed, alone=name == "whole") for name in ("shared", "whole"))

    def are_together(*batches: Batch) -> bool:
        return is_beside(*([*chain(*pickle.loads(done.content))] for done in outcomes([*batches])))

    assert are_together(shared, shared) and not are_together(shared, whole) and not are_together(whole, whole)


def test_what_is_alone_on_a_gpu_leaves_others_alone_and_what_times_the_cpu_has_the_host():
    long, short = (timing(name, prepared_and_timed, False, prepare_s) for name, prepare_s in (("a", 0.8), ("b", 0.4)))
    cpu = replace(timing("cpu", prepared_and_timed, False, 0.1), on_host=True)
    done = outcomes([Batch("shared", moments, (1.0,)), long, short, cpu], "aaba")
    shared, on_a, on_b, on_host = (pickle.loads(each.content) for each in done)
    assert shared[0] < on_b[1][0] < on_b[1][-1] < shared[-1], "another GPU's are timed beside what runs"
    assert is_beside(on_b[1], on_a[0]), "and beside what prepares"
    assert shared[-1] < on_a[1][0]
    for timed in on_host[1::2]:
        assert not any(is_beside(timed, other) for other in (shared, *on_a, *on_b))


def test_whoever_waits_long_for_others_says_so(capfd, monkeypatch):
    monkeypatch.setattr(turns, "PATIENCE_S", 0.05)
    assert len(outcomes([Batch("times", time.sleep, (0.4,), alone=True)] * 2)) == 2
    assert capfd.readouterr().err.count(turns.WAITING) == 1
