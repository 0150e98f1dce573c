"""Processes that share a piece of work: one that is killed is noticed, and none outlives the one that started it."""

import ctypes
import gc
import os
import signal
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import active_children, get_context
from typing import Any, TypeVar

from measured_report.files.errors import ReportError

T = TypeVar("T")
KILLED = "a process was killed, perhaps for want of memory; nothing was changed"
PR_SET_PDEATHSIG = 1  # from linux/prctl.h: which signal a process gets when the one that started it ends


@contextmanager
def workers(
    count: int, method: str, then: Callable[[], None] | None = None
) -> Iterator[ProcessPoolExecutor]:
    """Open a pool of ``count`` processes, started by ``method``, that call ``then``; ReportError if one is killed."""
    pool = ProcessPoolExecutor(count, get_context(method), begin, (then,))
    try:
        yield pool
    except BaseException as error:
        for process in active_children():
            process.kill()
        if isinstance(error, BrokenProcessPool):
            raise ReportError(KILLED) from None
        raise
    finally:
        pool.shutdown(cancel_futures=True)


_task: list[
    Callable[[int], Any]
] = []  # what forks of this process are asked to make: it need not be pickled


def forked(make: Callable[[int], T], count: int) -> list[T]:
    """Return what ``make`` makes of each number below ``count``, on every processor that there is."""
    # A fork is safe on Linux alone, and a single piece is made here.
    if (
        process_count := min(len(os.sched_getaffinity(0)), count)
        if sys.platform == "linux"
        else 1
    ) < 2:
        return [*map(make, range(count))]
    _task[:] = [make]
    with workers(
        process_count, "fork", gc.disable
    ) as pool:  # all that a process makes fits into memory together
        return [*pool.map(_make, range(count))]


def _make(number: int) -> Any:
    return _task[0](number)


def begin(then: Callable[[], None] | None) -> None:
    """Let this process, which is one of a pool, end with the one that started it and leave Ctrl-C to it."""
    end_with_parent()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    if then:
        then()


def end_with_parent() -> None:
    """Let this process end as soon as the one that started it has; on Linux alone."""
    if prctl := getattr(ctypes.CDLL(None), "prctl", None):
        prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
