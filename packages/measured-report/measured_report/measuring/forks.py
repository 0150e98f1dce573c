"""Processes of this host that measure side by side: forks of the one that has compiled and loaded the kernels."""

from collections.abc import Iterable, Mapping
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from typing import Any

from measured_report.measuring.course import Task
from measured_report.measuring.machine import kind_of
from measured_report.measuring.outcome import Done, Failed, run_batch
from measured_report.measuring.scheduler import Host, Place

POLL_S = 0.5


class Forks:
    """See ``study.Crew``."""

    def __init__(self, pool: ProcessPoolExecutor, count: int, machine: Mapping[str, Any]):
        self.hosts = [Host("", kind_of(machine), [str(number) for number in range(count)])]
        self._pool, self._alone, self._together = pool, machine, {**machine, "sections_at_once": count}
        self._running: dict[Future, Task] = {}

    def start(self, task: Task, place: Place) -> None:
        machine = self._alone if task.batch.alone else self._together
        self._running[self._pool.submit(run_batch, task.batch.function, task.batch.arguments, machine)] = task

    def wait(self) -> Iterable[tuple[Task, Done | Failed]]:
        """What has ended within a moment; a process that was killed takes the others with it."""
        for future in wait(self._running, timeout=POLL_S, return_when=FIRST_COMPLETED).done:
            yield self._running.pop(future), future.result()
