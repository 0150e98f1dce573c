"""A pool of processes of this host: forks of one that has everything loaded, or processes that start afresh."""

import os
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor, Future
from contextlib import AbstractContextManager

from tqdm import tqdm

from measured_report.files.processes import workers
from measured_report.measuring.host import host


def processes(count: int, method: str = "spawn") -> AbstractContextManager[Executor]:
    """Open a pool for ``count`` calls, or for as many at once as there are cores. Close it with ``with``.

    Where the processes start afresh, as without ``method="fork"``, what is called, and its arguments, must be found by
    name in a module. Nothing may be timed in another process meanwhile.
    """
    return workers(max(1, min(count, os.cpu_count() or 1)), method, _begin)


def start(pool: Executor, function: Callable, calls: Sequence[tuple]) -> list[Future]:
    """Start a call of ``function`` for each tuple of arguments."""
    return [pool.submit(function, *arguments) for arguments in calls]


def gather(waiting: Iterable[Future], title: str) -> list:
    """Wait for what was started, in that order."""
    return [result.result() for result in tqdm(list(waiting), desc=title, unit="run", delay=3.0)]


def _begin() -> None:
    host().be_quiet()
