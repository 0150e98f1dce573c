"""Kernels: compiled beside one another, since Warp compiles a module only when its first kernel is launched."""

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from typing import Any

import warp as wp

Launch = Callable[..., Any]


@contextmanager
def launching(instead: Launch) -> Iterator[None]:
    """Call ``instead`` with each kernel, its size and its options, in place of launching it."""
    names = ("launch", "launch_tiled", "capture_while", "capture_if")
    kept = {name: getattr(wp, name) for name in names}

    def looped(_: wp.array, while_body: Callable[..., object], graph: object = None, **given: object) -> None:
        while_body(**given)

    def chosen(_: wp.array, on_true: Any = None, on_false: Any = None, graph: object = None, **given: object) -> None:
        for branch in filter(callable, (on_true, on_false)):
            branch(**given)

    for name, stand_in in zip(names, (instead, instead, looped, chosen), strict=True):
        setattr(wp, name, stand_in)
    try:
        yield
    finally:
        for name, function in kept.items():
            setattr(wp, name, function)


def compile_beside(device: wp.Device, run: Callable[[], object]) -> None:
    """Compile what ``run`` launches, which is run without launching anything; what it does not reach is left."""
    modules: dict[tuple[Any, int], None] = {}

    def note(kernel: wp.Kernel, dim: object, *_: object, block_dim: int = 256, **__: object) -> None:
        modules[kernel.module, block_dim if device.is_cuda else 1] = None

    with launching(note), suppress(Exception):  # it may read what no kernel has written
        run()
    with ThreadPoolExecutor() as pool:
        for module, block_dim in modules:
            pool.submit(module.load, device, block_dim=block_dim)
