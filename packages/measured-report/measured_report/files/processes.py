"""Processes that share a piece of work: one that is killed is noticed, and none outlives the one that started it."""

import ctypes
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import active_children, get_context

from measured_report.files.errors import ReportError

KILLED = "a process was killed, perhaps for want of memory; nothing was changed"
PR_SET_PDEATHSIG = 1  # from linux/prctl.h: which signal a process gets when the one that started it ends


@contextmanager
def workers(count: int, method: str, then: Callable[[], None] | None = None) -> Iterator[ProcessPoolExecutor]:
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
