"""Executors: who measures batches. One is this process, or forks of it; the other is the workers of a cluster."""

from collections.abc import Iterable, Mapping, Sequence
from concurrent import futures
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

from measured_report.measuring.batch import Batch
from measured_report.measuring.machine import kind_of
from measured_report.measuring.outcome import BatchOutcome, run_batch

POLL_S = 0.5
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
    """A host that measures, all of it one kind of machine."""

    name: str
    kind: tuple
    processes: Sequence[str]
    """Names of its worker processes, each of which measures one batch at once."""
    shared: Sequence[str] = ()
    """Those that share its GPUs: where there are any, the others are left to what must be alone."""

    def processes_for(self, batch: Batch) -> Sequence[str]:
        return self.processes if batch.alone else self.shared or self.processes


WorkerProcess: TypeAlias = tuple[str, str]
"""The name of a host, and of a worker process there."""


class Executor(Protocol):
    """Whoever measures."""

    @property
    def hosts(self) -> Sequence[Host]:
        """The hosts that are there now."""

    def start(self, task: Task, process: WorkerProcess) -> None:
        """Start a batch on a worker process that is free."""

    def wait(self) -> Iterable[tuple[Task, BatchOutcome]]:
        """Yield what has ended since the last call, after a moment if nothing has."""


class LocalExecutor:
    """This process, one batch after the other, or the ``count`` processes of a pool."""

    def __init__(self, machine: Mapping[str, Any], pool: futures.Executor | None = None, count: int = 1):
        self.hosts = [Host("", kind_of(machine), [str(number) for number in range(count)])]
        self._alone, self._pool = machine, pool or _InTurn()
        self._together = {**machine, "sections_at_once": count} if pool else machine
        self._running: dict[Future, Task] = {}

    def start(self, task: Task, process: WorkerProcess) -> None:
        machine = self._alone if task.batch.alone else self._together
        self._running[self._pool.submit(run_batch, task.batch.function, task.batch.arguments, machine)] = task

    def wait(self) -> Iterable[tuple[Task, BatchOutcome]]:
        """Yield what has ended; a process that was killed takes the others with it."""
        for future in futures.wait(self._running, timeout=POLL_S, return_when=futures.FIRST_COMPLETED).done:
            yield self._running.pop(future), future.result()


class _InTurn(futures.Executor):
    """This process, which makes a call when it is asked to."""

    def submit(self, function, /, *args, **kwargs) -> Future:
        future: Future = Future()
        future.set_result(function(*args, **kwargs))
        return future
