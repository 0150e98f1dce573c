"""Drawing: figures are drawn by processes."""

import os
import signal
from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import Any

import pytest

from measured_report.files.errors import ReportError
from measured_report.files.processes import KILLED
from measured_report.parts.section import draw


@pytest.fixture(autouse=True)
def on_two_processors(monkeypatch):
    monkeypatch.setattr("os.sched_getaffinity", lambda _: {0, 1})
    signal.alarm(60)  # what waits for nothing would wait for ever
    yield
    signal.alarm(0)


def figures(drawn: Callable[[int], Any]) -> list[Any]:
    return [SimpleNamespace(drawn=partial(drawn, number)) for number in range(8)]


def test_figures_are_drawn_in_their_order_by_other_processes():
    found = draw(figures(lambda number: (number, os.getpid())))
    assert [number for number, _ in found] == list(range(8))
    assert os.getpid() not in {process for _, process in found}


def test_a_process_that_is_killed_is_noticed():
    with pytest.raises(ReportError, match=KILLED):
        draw(figures(lambda _: os.kill(os.getpid(), signal.SIGKILL)))


def test_what_stops_a_drawing_is_raised():
    def fail(_: int) -> None:
        raise ReportError("a figure reads what it must not")

    with pytest.raises(ReportError, match="reads what it must not"):
        draw(figures(fail))
