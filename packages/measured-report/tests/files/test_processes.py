"""Test that forked processes share a piece of work."""

import os
import re
import signal

import pytest

from measured_report.files.errors import ReportError
from measured_report.files.processes import KILLED, forked


@pytest.fixture(autouse=True)
def on_two_processors(monkeypatch):
    monkeypatch.setattr("os.sched_getaffinity", lambda _: {0, 1})
    signal.alarm(60)  # without a signal the process would wait for ever
    yield
    signal.alarm(0)


def test_figures_are_drawn_in_their_order_by_other_processes():
    found = forked(lambda number: (number, os.getpid()), 8)
    assert [number for number, _ in found] == list(range(8))
    assert os.getpid() not in {process for _, process in found}


def test_a_process_that_is_killed_is_noticed():
    with pytest.raises(ReportError, match=re.escape(KILLED)):
        forked(lambda _: os.kill(os.getpid(), signal.SIGKILL), 8)


def test_what_stops_a_drawing_is_raised():
    def fail(_: int) -> None:
        raise ReportError("a figure reads what it must not")

    with pytest.raises(ReportError, match="reads what it must not"):
        forked(fail, 8)
