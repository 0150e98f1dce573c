"""Executors: who measures batches. One is this process, or forks of it; the other is the workers of a cluster."""

from collections.abc import Iterable, Mapping, Sequence
from concurrent import futures
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any, Protocol

from measured_report.measuring.batch import Batch
from measured_report.measuring.machine import kind_of
from measured_report.measuring.outcome import BatchOutcome, run_batch

WHOLE = "whole"
"""The one batch of a section that has declared none."""


@dataclass(frozen=True)
class Task:
    """A batch of a section."""

    section: str
    batch: Batch
    seconds: float = 0.0
    """How long it is expected to take; 0 where nobody knows."""

    @property
    def name(self) -> str:
        return self.section if self.batch.name == WHOLE else f"{self.section}/{self.batch.name}"


@dataclass(frozen=True)
class Host:
    """A host that measures, all of it one kind of machine; of one with several GPUs, the part that is about one."""

    name: str
    """Of the host."""
    kind: tuple
    processes: Sequence[str]
    """Names of its worker processes, each of which measures one batch at once; no other part has the same."""
    alone: Sequence[str]
    """Those for what must be alone there, of which one at a time is while others prepare."""

    def those_of(self, busy: Mapping[tuple[str, str], Task]) -> list[Task]:
        """What runs there of all that does, by the names of a host and a process."""
        mine = {(self.name, process) for process in (*self.processes, *self.alone)}
        return [task for process, task in busy.items() if process in mine]


class Executor(Protocol):
    """Whoever measures."""

    @property
    def hosts(self) -> Sequence[Host]:
        """The hosts that are there now, one with several GPUs once for each."""

    def start(self, task: Task, process: tuple[str, str]) -> None:
        """Start a batch on a worker process that is free: the names of its host and its own."""

    def wait(self) -> Iterable[tuple[Task, BatchOutcome]]:
        """Yield what has ended since the last call, after a moment if nothing has."""


class LocalExecutor:
    """This process, one batch after the other, or the ``count`` processes of a pool."""

    def __init__(self, machine: Mapping[str, Any], pool: futures.Executor | None = None, count: int = 1):
        names = [str(number) for number in range(count)]
        self.hosts = [Host("", kind_of(machine), names, names)]
        self._alone, self._pool = machine, pool
        self._together = {**machine, "sections_at_once": count} if pool else machine
        self._running: dict[Future, Task] = {}

    def start(self, task: Task, process: tuple[str, str]) -> None:
        call = task.batch, self._alone if task.batch.exclusive else self._together
        if self._pool:
            future = self._pool.submit(run_batch, *call)
        else:
            future = Future()
            future.set_result(run_batch(*call))
        self._running[future] = task

    def wait(self) -> Iterable[tuple[Task, BatchOutcome]]:
        """Yield what has ended; a process that was killed takes the others with it."""
        for future in futures.wait(self._running, timeout=0.5, return_when=futures.FIRST_COMPLETED).done:
            yield self._running.pop(future), future.result()
