"""Runs on the CPU in processes of their own, beside what the device does. Nothing may be timed meanwhile."""

import os
import signal
from collections.abc import Callable, Sequence
from multiprocessing import get_context
from multiprocessing.pool import AsyncResult, Pool

import warp as wp
from tqdm import tqdm


def processes(count: int) -> Pool:
    """A pool for ``count`` calls, or for as many at once as there are cores. Close it with ``with``.

    What is called, and its arguments, must be found by name in a module: the processes start afresh.
    """
    return get_context("spawn").Pool(max(1, min(count, os.cpu_count() or 1)), be_quiet)


def start(pool: Pool, function: Callable, calls: Sequence[tuple]) -> list[AsyncResult]:
    """Start a call of ``function`` for each tuple of arguments."""
    return [pool.apply_async(function, arguments) for arguments in calls]


def gather(waiting: Sequence[AsyncResult], title: str) -> list:
    """Wait for what was started, in that order."""
    return [result.get() for result in tqdm(waiting, desc=title, unit="run", delay=3.0)]


def be_quiet() -> None:
    """In a process beside others: Warp warns no second time, and whoever started it is who stops it."""
    wp.config.log_level = wp.LOG_ERROR
    signal.signal(signal.SIGINT, signal.SIG_IGN)
