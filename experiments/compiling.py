"""Warp's compilers in processes of their own: within one process they wait for each other."""

import os
import queue
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future
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
    waiting: queue.SimpleQueue[Callable[[], Any]] = queue.SimpleQueue()
    calls: queue.SimpleQueue[tuple[Call, Future] | None] = queue.SimpleQueue()
    for load in loads:
        waiting.put(load)
    # A process ends with the thread that started it, so this thread starts them. Nobody waits for the other threads:
    # after a Ctrl-C nothing would answer them.
    with workers(count, "spawn", _begin) as processes, _compilers_elsewhere(calls):
        for _ in range(count):
            threading.Thread(target=_load, args=(waiting, calls), daemon=True).start()
        for _ in tqdm(loads, desc="compiling kernels", unit="module", delay=3.0):
            while call := calls.get():
                request, future = call
                processes.submit(_compile, *request).add_done_callback(partial(_hand_over, future))


def _load(waiting: queue.SimpleQueue, calls: queue.SimpleQueue) -> None:
    """Load what waits, and say after each that it is done."""
    with suppress(queue.Empty):
        while True:
            load = waiting.get_nowait()
            with suppress(Exception):
                load()
            calls.put(None)


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
