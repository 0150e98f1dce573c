"""Warp's compiler for CUDA in processes of its own: within one process its calls wait for each other.

That for the CPU is called from threads, which do not.
"""

import os
import queue
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from functools import partial
from typing import Any
from unittest import mock

import warp as wp
from tqdm import tqdm
from warp._src import build

from report.records.processes import workers

Call = tuple[tuple, Mapping[str, Any]]
COMPILER = "build_cuda"
"""Warp's function that writes what a source compiles to."""


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
    with workers(count, "spawn", _begin) as processes, _compiler_elsewhere(calls):
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
def _compiler_elsewhere(calls: queue.SimpleQueue) -> Iterator[None]:
    """Within it a call of the compiler is put into ``calls``, and waits for what comes of it."""

    def ask(*arguments, **options) -> None:
        future: Future = Future()
        calls.put(((arguments, options), future))
        future.result()

    with mock.patch.object(build, COMPILER, ask):
        yield


def _begin() -> None:
    wp.config.log_level = wp.LOG_ERROR  # whoever started it has said what there is to say
    wp.init()


def _compile(arguments: tuple, options: Mapping[str, Any]) -> None:
    """Compile in this process; the source, and the folder to write to, are there."""
    getattr(build, COMPILER)(*arguments, **options)


def _hand_over(future: Future, done: Future) -> None:
    if error := done.exception():
        future.set_exception(error)
    else:
        future.set_result(None)
