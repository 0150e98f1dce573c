"""Warp's compilers in processes of their own: within one process they wait for each other."""

import os
import queue
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import ExitStack, contextmanager, suppress
from functools import partial
from typing import Any
from unittest import mock

import warp as wp
from tqdm import tqdm
from warp._src import build

from report.records.processes import workers

Call = tuple[str, tuple, Mapping[str, Any]]
COMPILERS = ("build_cuda", "build_cpu")
"""Warp's functions that write what a source compiles to."""


def load_all(loads: Sequence[Callable[[], Any]]) -> None:
    """Call all ``loads``, which load modules of kernels; those that must be compiled are, on all cores.

    What does not compile here is compiled when it is met, and fails there with a message of its own.
    """
    count = min(len(loads), os.cpu_count() or 1)
    calls: queue.SimpleQueue[tuple[Call, Future]] = queue.SimpleQueue()
    # A process ends with the thread that started it, so this thread starts them: the others come and go.
    with (
        workers(count, "spawn", _begin) as processes,
        ThreadPoolExecutor(count) as threads,
        _compilers_elsewhere(calls),
    ):
        waiting = {threads.submit(load) for load in loads}
        with tqdm(desc="compiling kernels", total=len(waiting), unit="module", delay=3.0) as bar:
            while waiting:
                with suppress(queue.Empty):
                    call, future = calls.get(timeout=0.05)
                    processes.submit(_compile, *call).add_done_callback(partial(_hand_over, future))
                ended, waiting = wait(waiting, timeout=0.0)
                bar.update(len(ended))


@contextmanager
def _compilers_elsewhere(calls: queue.SimpleQueue) -> Iterator[None]:
    """Within it a call of one of Warp's compilers is put into ``calls``, and waits for what comes of it."""

    def ask(name: str, *arguments, **options) -> None:
        future: Future = Future()
        calls.put(((name, arguments, options), future))
        future.result()

    with ExitStack() as stack:
        for name in COMPILERS:
            stack.enter_context(mock.patch.object(build, name, partial(ask, name)))
        yield


def _begin() -> None:
    wp.config.log_level = wp.LOG_ERROR  # whoever started it has said what there is to say
    wp.init()


def _compile(name: str, arguments: tuple, options: Mapping[str, Any]) -> None:
    """Compile in this process; the source, and the folder to write to, are there."""
    getattr(build, name)(*arguments, **options)


def _hand_over(future: Future, done: Future) -> None:
    if error := done.exception():
        future.set_exception(error)
    else:
        future.set_result(None)
