"""Test how many batches run at once, which of them run by themselves, and how a record
describes their times.
"""

import os
import pickle
from concurrent.futures import Future
from types import SimpleNamespace

import numpy as np
import pytest
from batches import all_of, section_of

from measured_report.files.config import report
from measured_report.files.errors import ReportError, UsageError
from measured_report.measuring import batch
from measured_report.measuring.batch import Batch, Result
from measured_report.measuring.host import Accelerator
from measured_report.measuring.machine import measuring_device
from measured_report.measuring.pool import environments, host_pools
from measured_report.measuring.run import Loop, plausible_row
from measured_report.records.record import load_record

MACHINE = {
    "device": "cpu",
    "gpu": None,
    "driver": None,
    "cpu": "A processor",
    "cores": "8",
    "python": "3.12",
}


class Pool:
    """Stands for a pool that does not start batches by itself."""

    killed = BrokenPipeError

    def __init__(self, limit: int):
        self.limit = limit

    def submit(self, *_) -> Future:
        return Future()


def begin(toy, names: str, count: int, exclusive: str = "") -> Loop:
    section = section_of(
        toy, all_of([Batch(name, print, exclusive=name in exclusive) for name in names])
    )
    section.advance()
    return Loop([section], Pool(count), Pool(1))


def running(loop: Loop) -> str:
    """Submit every batch that can run, and return the names of those that run."""
    loop._submit()
    return "".join(each.name for _, each in loop.running.values())


def end(loop: Loop, name: str, start: int = 0, seconds: float = 1.0, **other) -> None:
    """End a running batch."""
    future = next(
        future for future, (_, each) in loop.running.items() if each.name == name
    )
    times = [
        f"2026-01-02T03:04:{second:02}+00:00"
        for second in (start, start + int(seconds))
    ]
    future.set_result(
        Result(
            pickle.dumps({"case": name, "slip_mm": 1.0}),
            {**MACHINE, **other},
            *times,
            seconds,
        )
    )
    loop._take(future, *loop.running.pop(future))


def test_no_more_run_at_once_than_fit_and_what_is_exclusive_waits_for_all_others(toy):
    loop = begin(toy, "axbycd", 2, exclusive="xy")
    for names, ended in (
        ("ab", "b"),
        ("ac", "a"),
        ("cd", "c"),
        ("d", "d"),
        ("x", "x"),
        ("y", "y"),
    ):
        assert running(loop) == running(loop) == names
        end(loop, ended)
    assert (
        running(loop) == ""
        and loop.sections[0].is_over
        and not loop.sections[0].has_failed
    )


def test_a_record_tells_from_the_first_beginning_to_the_last_end_and_adds_what_all_took(
    toy,
):
    loop = begin(toy, "abc", 3)
    assert running(loop) == "abc"
    for name, start, seconds, host in (
        ("b", 20, 30.26, "one"),
        ("a", 10, 5.0, "two"),
        ("c", 15, 10.0, None),
    ):
        end(loop, name, start, seconds, host=host)
    record = load_record(toy.record_path)
    times = [
        record.measured[name].partition("T")[2][:8]
        for name in ("started", "ended", "date")
    ]
    assert (
        times == ["03:04:10", "03:04:50", "03:04:50"]
        and record.measured["seconds"] == 45.3
    )
    assert record.machine["host"] == "one, two" and record.machine["gpu"] is None


def test_a_batch_ends_as_long_after_its_beginning_as_it_took(monkeypatch):
    ticks = iter((100.0, 161.26))
    monkeypatch.setattr(
        batch, "time", SimpleNamespace(perf_counter=lambda: next(ticks))
    )
    found = batch.measure_batch(pickle.dumps(Batch("a", int)), "cpu")
    start, stop = (
        batch.datetime.fromisoformat(each) for each in (found.started, found.ended)
    )
    assert (
        found.seconds == 61.3
        and 61 <= (stop - start).total_seconds() <= 62
        and pickle.loads(found.value) == 0
    )


def test_a_number_that_no_record_may_hold_is_none_and_says_what_it_was():
    row = {
        "way_mm": 1e11,
        "pause_s": -1.0,
        "far_mm": np.float32("nan"),
        "pull_n": None,
        "ratio": None,
        "load_kg": 0.0,
    }
    lost = ("way_mm", "pause_s", "far_mm", "pull_n")
    reasons = {f"{name}_reason": f"the measurement gave {row[name]}" for name in lost}
    assert plausible_row(row, report().columns) == {
        **row,
        **dict.fromkeys(lost),
        **reasons,
    }
    with pytest.raises(ReportError, match=r"column 'Way \[mm\]' has an invalid name"):
        plausible_row({"Way [mm]": 1.0}, report().columns)


def test_a_cpu_measures_where_there_is_nothing_else(toy, monkeypatch):
    monkeypatch.setattr("os.cpu_count", lambda: 6)
    kinds = (("cpu", "quick"), ("cpu", "full"), ("cuda", "quick"))
    counts = [len(environments(*each, toy.project.report)) for each in kinds]
    assert counts == [6, 1, 1]
    assert measuring_device(None, "full") is None
    assert measuring_device(None, "quick") == measuring_device("cpu", "full") == "cpu"
    with pytest.raises(
        UsageError,
        match="DEVICE=cuda: this machine has no CUDA device: use DEVICE=cpu to measure on its CPU",
    ):
        measuring_device("cuda", "full")


def test_processes_are_spread_over_all_accelerators(toy, monkeypatch):
    cards = [Accelerator(name, 1024, {"VISIBLE": name}) for name in "ab"]
    module = toy.project.report.accelerator
    monkeypatch.setattr(module, "accelerators", lambda: cards)
    counts = {"a": 2, "b": 1}
    monkeypatch.setattr(module, "share_count", lambda card, _: counts[card.name])
    found = environments("cuda", "full", toy.project.report)
    assert [each["VISIBLE"] for each in found] == ["a", "b", "a"]
    with host_pools(found, {"VISIBLE": "alone"}) as (shared, exclusive):
        running = [shared.submit(os.getenv, "VISIBLE") for _ in range(20)]
        assert {future.result() for future in running} <= {"a", "b"}
        assert exclusive.submit(os.getenv, "VISIBLE").result() == "alone"
