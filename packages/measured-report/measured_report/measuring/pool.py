"""Pools of processes of this host: those that measure batches, and those that a batch has for itself."""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager, contextmanager
from functools import partial
from multiprocessing import active_children, get_context
from typing import Any

from tqdm import tqdm

from measured_report.files.config import report as current
from measured_report.files.processes import begin, workers


class HostPool:
    """Submit to forks of this process, which has loaded the simulator but no device, and to new ones after a kill."""

    lost: type[Exception] = BrokenProcessPool

    def __init__(self, limit: int, settings: Mapping[str, str]):
        self.limit = limit
        self._begin = partial(_begin, settings)
        self.pool = self._opened()

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        try:
            return self.pool.submit(function, *arguments)
        except BrokenProcessPool:
            self.pool = self._opened()
            return self.pool.submit(function, *arguments)

    def _opened(self) -> Executor:
        return ProcessPoolExecutor(
            self.limit, get_context("fork"), begin, (self._begin,)
        )


@contextmanager
def host_pools(
    count: int, alone: Mapping[str, str]
) -> Iterator[tuple[HostPool, HostPool]]:
    """Open a pool for ``count`` batches that share this host, and one for exclusive ones, with ``alone`` set."""
    shared, exclusive = HostPool(count, {}), HostPool(1, alone)
    try:
        yield shared, exclusive
    finally:
        for process in active_children():
            process.kill()
        for opened in (
            shared,
            exclusive,
        ):  # the thread that leads the processes must not meet the end of the program
            opened.pool.shutdown(cancel_futures=True)


def processes(count: int) -> AbstractContextManager[Executor]:
    """Open a pool for ``count`` calls, of functions of modules, as many at once as there are cores; time nothing."""
    return workers(
        max(1, min(count, os.cpu_count() or 1)), "spawn", partial(_begin, {})
    )


def start(
    pool: Executor, function: Callable[..., Any], calls: Sequence[tuple[Any, ...]]
) -> list[Future[Any]]:
    return [pool.submit(function, *arguments) for arguments in calls]


def gather(waiting: Iterable[Future[Any]], title: str) -> list[Any]:
    """Wait for what was started, in that order."""
    return [
        result.result()
        for result in tqdm(list(waiting), desc=title, unit="run", delay=3.0)
    ]


def _begin(settings: Mapping[str, str]) -> None:
    os.environ.update(settings)
    current().host.be_quiet()
