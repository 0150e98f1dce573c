"""Warp's compiler for CUDA, and the driver's, in processes of their own: within one process calls wait for each other.

That for the CPU is called from threads, which do not. Where Warp's compiler makes PTX, the driver makes machine code of
it when a module is loaded, and keeps that on disk: so each process loads what it has compiled, and whoever wants the
module finds it there.
"""

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from typing import Any
from unittest import mock

import warp as wp
from tqdm import tqdm
from warp._src import build, context

from measured_report.files.processes import workers

BUILD, SOLVER = "build_cuda", "wp_cuda_compile_solver"
"""Warp's functions that write what a source compiles to, and what a tile's factorization does, which is linked in."""
GPU_MEMORY_BYTES = 1 << 30
"""Memory that a process may take of a GPU where it loads modules, generously."""


def load_all(loads: Sequence[Callable[[], Any]]) -> None:
    """Call all ``loads``, which load modules of kernels; those that must be compiled are, on all cores.

    What does not compile here is compiled when it is met, and fails there with a message of its own.
    """
    count = min(len(loads), _process_count())
    threads = ThreadPoolExecutor(count)
    with workers(count, "spawn", _begin) as processes:

        def ask(name: str, *arguments, **options) -> Any:
            return processes.submit(_compile, name, arguments, options).result()

        with (
            mock.patch.object(build, BUILD, partial(ask, BUILD)),
            mock.patch.object(context.runtime.core, SOLVER, partial(ask, SOLVER)),
        ):
            try:
                list(tqdm(threads.map(_load, loads), "compiling kernels", len(loads), unit="module", delay=3.0))
            finally:
                threads.shutdown(wait=False, cancel_futures=True)  # after a Ctrl-C nothing would answer them


def _process_count() -> int:
    """Count the processes that there are cores for, of those that this one may use, and memory on its GPU."""
    cores = len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1
    return max(1, min([cores, *(device.free_memory // GPU_MEMORY_BYTES for device in wp.get_cuda_devices()[:1])]))


def _load(load: Callable[[], Any]) -> None:
    with suppress(Exception):
        load()


def _begin() -> None:
    wp.config.log_level = wp.LOG_ERROR  # whoever started it has said what there is to say
    wp.init()


def _compile(name: str, arguments: tuple, options: Mapping[str, Any]) -> Any:
    """Compile in this process; the source, and the folder to write to, are there."""
    if name == SOLVER:
        return context.runtime.core.wp_cuda_compile_solver(*arguments, **options)
    build.build_cuda(*arguments, **options)
    _, _, path, *_ = arguments
    with suppress(Exception):  # whoever wants the module loads it in any case
        for device in wp.get_cuda_devices()[:1]:
            if path.endswith(".ptx") and (module := build.load_cuda(path, device)):
                context.runtime.core.wp_cuda_unload_module(device.context, module)
