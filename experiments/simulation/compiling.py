"""Warp's compiler for CUDA, and the driver's, in processes of their own: within one process calls wait for each other.

That for the CPU is called from threads, which do not. Where Warp's compiler makes PTX, the driver makes machine code of
it when a module is loaded, and keeps that on disk: so each process loads what it has compiled, and whoever wants the
module finds it there.
"""

import os
import queue
import sys
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from functools import cache, partial
from typing import Any
from unittest import mock

import warp as wp
from tqdm import tqdm
from warp._src import build, context

from measured_report.files.processes import workers

Call = tuple[str, tuple, Mapping[str, Any]]
BUILD, SOLVER = "build_cuda", "wp_cuda_compile_solver"
"""Warp's functions that write what a source compiles to, and what a tile's factorization does, which is linked in."""
GPU_MEMORY_BYTES = 1 << 30
"""What a process may take of a GPU that loads modules there, generously."""


def load_all(loads: Sequence[Callable[[], Any]], meanwhile: Callable[[], Any] = lambda: None) -> None:
    """Call all ``loads``, which load modules of kernels; those that must be compiled are, on all cores.

    Where one for a GPU must be, ``meanwhile`` is called, once. What does not compile here is compiled when it is met,
    and fails there with a message of its own.
    """
    count = min(len(loads), _process_count())
    meanwhile = cache(meanwhile)
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
                meanwhile()
                request, future = call
                processes.submit(_compile, *request).add_done_callback(partial(_hand_over, future))


def _process_count() -> int:
    """How many processes there are cores for, of those that this one may use, and memory on its GPU."""
    cores = len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1
    return max(1, min([cores, *(device.free_memory // GPU_MEMORY_BYTES for device in wp.get_cuda_devices()[:1])]))


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

    def ask(name: str, *arguments, **options) -> Any:
        future: Future = Future()
        calls.put(((name, arguments, options), future))
        return future.result()

    with (
        mock.patch.object(build, BUILD, partial(ask, BUILD)),
        mock.patch.object(context.runtime.core, SOLVER, partial(ask, SOLVER)),
    ):
        yield


def _begin() -> None:
    wp.config.log_level = wp.LOG_ERROR  # whoever started it has said what there is to say
    wp.init()


def _compile(name: str, arguments: tuple, options: Mapping[str, Any]) -> Any:
    """Compile in this process; the source, and the folder to write to, are there."""
    if name == SOLVER:
        return context.runtime.core.wp_cuda_compile_solver(*arguments, **options)
    build.build_cuda(*arguments, **options)
    _, _, written, *_ = arguments
    with suppress(Exception):  # whoever wants the module loads it in any case
        _translate(written)


def _translate(path: str) -> None:
    """Let the driver make machine code of a module of PTX, and keep it."""
    for device in wp.get_cuda_devices()[:1]:
        if path.endswith(".ptx") and (module := build.load_cuda(path, device)):
            context.runtime.core.wp_cuda_unload_module(device.context, module)


def _hand_over(future: Future, done: Future) -> None:
    if error := done.exception():
        future.set_exception(error)
    else:
        future.set_result(done.result())
