"""Share work between processes, which end when their parent process ends."""

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
KILLED = (
    "a process was killed, perhaps because memory ran out: free some memory and try "
    "again (no file was changed)"
)
# From linux/prctl.h: sets the signal that a process receives when its parent ends.
PR_SET_PDEATHSIG = 1


@contextmanager
def workers(
    count: int, method: str, prepare: Callable[[], None] | None = None
) -> Iterator[ProcessPoolExecutor]:
    """Open a pool of ``count`` processes that call ``prepare`` first.

    ``method`` is the start method of ``multiprocessing``. Raise ReportError if a
    process is killed.
    """
    pool = ProcessPoolExecutor(count, get_context(method), begin, (prepare,))
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


# The function that the forks call. They inherit it, so that it does not have to be
# pickled.
_task: list[Callable[[int], Any]] = []


def forked(make: Callable[[int], T], count: int) -> list[T]:
    """Return the results of ``make`` for 0 to ``count`` - 1, computed on all cores."""
    # Forks are safe on Linux only, and a single call needs no fork.
    process_count = 1
    if sys.platform == "linux":
        process_count = min(len(os.sched_getaffinity(0)), count)
    if process_count < 2:
        return [*map(make, range(count))]
    _task[:] = [make]
    # The processes need no garbage collection, because their results fit into memory.
    with workers(process_count, "fork", gc.disable) as pool:
        return [*pool.map(_make, range(count))]


def _make(number: int) -> Any:
    return _task[0](number)


def begin(prepare: Callable[[], None] | None) -> None:
    """Prepare a process of a pool: it ends with its parent and ignores Ctrl-C."""
    end_with_parent()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    if prepare:
        prepare()


def end_with_parent() -> None:
    """Let this process end as soon as its parent ends (only on Linux)."""
    if prctl := getattr(ctypes.CDLL(None), "prctl", None):
        prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
