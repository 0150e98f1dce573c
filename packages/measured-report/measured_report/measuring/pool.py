"""Open pools of processes on this host, for batches and for calls within a batch."""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager, contextmanager
from functools import partial
from multiprocessing import active_children, get_context
from multiprocessing.queues import SimpleQueue
from typing import Any

from tqdm import tqdm

from measured_report.files.config import Report
from measured_report.files.config import report as current
from measured_report.files.processes import begin, workers

Settings = Mapping[str, str]  # the environment of a process


class HostPool:
    """Run calls in forks of this process, and open a new pool if a fork was killed.

    This process has loaded the simulator, but has not opened a device.
    """

    killed: type[Exception] = BrokenProcessPool  # raised if a process was killed

    def __init__(self, environments: Sequence[Settings]):
        self.environments = environments  # one for each process
        self.limit = len(environments)
        self.pool = self._opened()

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        try:
            return self.pool.submit(function, *arguments)
        except BrokenProcessPool:
            self.pool = self._opened()
            return self.pool.submit(function, *arguments)

    def _opened(self) -> Executor:
        context = get_context("fork")
        waiting = context.SimpleQueue()
        for environment in self.environments:
            waiting.put(environment)
        start = partial(_begin, waiting)
        return ProcessPoolExecutor(self.limit, context, begin, (start,))


@contextmanager
def host_pools(
    shared: Sequence[Settings], alone: Settings
) -> Iterator[tuple[HostPool, HostPool]]:
    """Open a pool for batches that share this host and one for exclusive batches."""
    opened = HostPool(shared), HostPool([alone])
    try:
        yield opened
    finally:
        for process in active_children():
            process.kill()
        # The thread that manages the processes must end before the program does.
        for host_pool in opened:
            host_pool.pool.shutdown(cancel_futures=True)


def environments(device: str, profile: str, report: Report) -> list[Settings]:
    """Return the environments of the processes that share this host.

    There are as many processes as the accelerators can serve. On a CPU there is one for
    each core, but only one for a full measurement of a report that needs an
    accelerator.
    """
    accelerator = report.accelerator
    if device == "cpu":
        is_light = profile == "quick" or not report.settings.needs_device
        return [{}] * ((os.cpu_count() or 1) if is_light else 1)
    cards = accelerator.accelerators()
    counts = [accelerator.share_count(card, len(cards)) for card in cards]
    # The first processes use different cards, so that few batches share a card.
    settings = []
    for number in range(max(counts, default=0)):
        for card, count in zip(cards, counts, strict=True):
            if number < count:
                settings.append(card.settings)
    return settings or [{}]


def processes(count: int) -> AbstractContextManager[Executor]:
    """Open a pool for ``count`` calls of module-level functions.

    It has at most one process for each core. Do not measure times in it, because the
    processes disturb each other.
    """
    return workers(max(1, min(count, os.cpu_count() or 1)), "spawn", _be_quiet)


def start(
    pool: Executor, function: Callable[..., Any], calls: Sequence[tuple[Any, ...]]
) -> list[Future[Any]]:
    return [pool.submit(function, *arguments) for arguments in calls]


def gather(waiting: Iterable[Future[Any]], title: str) -> list[Any]:
    """Wait for the started calls and return their results in the same order."""
    bar = tqdm(list(waiting), desc=title, unit="run", delay=3.0)
    return [future.result() for future in bar]


def _begin(waiting: "SimpleQueue[Settings]") -> None:
    os.environ.update(waiting.get())
    _be_quiet()


def _be_quiet() -> None:
    current().host.be_quiet()
