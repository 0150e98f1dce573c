"""Drawing: figures are drawn by processes, while this one does something else."""

import os
import signal
import time
from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import Any

import pytest

from measured_report.files.errors import ReportError
from measured_report.files.processes import KILLED
from measured_report.parts.drawing import AT_ONCE, Drawing

COUNT = 4 * AT_ONCE


@pytest.fixture(autouse=True)
def on_two_processors(monkeypatch):
    monkeypatch.setattr("measured_report.parts.drawing._processor_count", lambda: 2)
    signal.alarm(60)  # what waits for nothing would wait for ever
    yield
    signal.alarm(0)


def figure(name: Any, drawn: Callable[[], Any]) -> SimpleNamespace:
    return SimpleNamespace(anchor=str(name), draw=None, is_there=True, drawn=drawn)


def test_processes_that_have_ended_meanwhile_are_not_waited_for():
    figures = [figure(number, lambda number=number: number) for number in range(COUNT)]
    with Drawing() as drawing:

        def meanwhile() -> None:
            for share in drawing._shares:
                share.process.join()

        assert drawing.all(figures, meanwhile) == list(range(COUNT))


def test_what_a_process_has_begun_with_others_help_it_to_end(tmp_path):
    def drawn(number: int) -> int:
        (tmp_path / f"{number} {os.getpid()}").touch()
        while number == 0 and not [*tmp_path.glob(f"{2 * AT_ONCE - 1} *")]:
            time.sleep(0.01)
        return number

    figures = [figure(number, partial(drawn, number)) for number in range(COUNT)]
    with Drawing() as drawing:
        drawing.begin(figures[:1])
        assert not drawing._shares  # too few for a process
        drawing.begin(figures[1 : 2 * AT_ONCE])
        assert len(drawing._shares) == 1
        drawing.begin(figures[2 * AT_ONCE :])
        assert len(drawing._shares) == 1  # the other processor derives
        assert drawing.all(figures, lambda: None) == list(range(COUNT))
    drawn_by = [path.name.split() for path in tmp_path.iterdir()]
    assert sorted(int(number) for number, _ in drawn_by) == list(range(COUNT))  # each by one process
    assert str(os.getpid()) not in dict(drawn_by).values()


def test_a_process_that_is_killed_is_noticed():
    figures = [figure(number, lambda: os.kill(os.getpid(), signal.SIGKILL)) for number in range(COUNT)]
    with Drawing() as drawing, pytest.raises(ReportError, match=KILLED):
        drawing.all(figures, lambda: None)


def test_what_stops_a_drawing_is_raised():
    def fail() -> None:
        raise ReportError("a figure reads what it must not")

    figures = [figure(number, fail) for number in range(COUNT)]
    with Drawing() as drawing, pytest.raises(ReportError, match="reads what it must not"):
        drawing.all(figures, lambda: None)
