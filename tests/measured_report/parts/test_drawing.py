"""Drawing: figures are drawn by processes, while this one does something else."""

import signal
import time
from types import SimpleNamespace

from measured_report.parts.drawing import AT_ONCE, Drawing


def test_processes_that_have_ended_meanwhile_are_not_waited_for(monkeypatch):
    monkeypatch.setattr("measured_report.parts.drawing._processor_count", lambda: 2)
    figures = [
        SimpleNamespace(anchor=str(number), draw=None, is_there=True, drawn=lambda number=number: number)
        for number in range(4 * AT_ONCE)
    ]
    with Drawing() as drawing:

        def meanwhile() -> None:
            while drawing._running:
                time.sleep(0.01)

        signal.alarm(60)  # a process that waits for nothing would wait for ever
        assert drawing.all(figures, meanwhile) == list(range(4 * AT_ONCE))
        signal.alarm(0)
