"""Kernels: compiled beside one another, since Warp compiles a module only when its first kernel is launched."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import warp as wp

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.simulation import Simulation

Launch = Callable[..., Any]
KEPT_COUNT = 12  # chosen: a frame of the scene takes some 55 modules


@contextmanager
def launching(instead: Launch) -> Iterator[None]:
    """Call ``instead`` with each kernel, its size and its options, in place of launching it; arrays are zero then."""
    names = ("launch", "launch_tiled", "capture_while", "capture_if", "empty", "empty_like")
    functions = {name: getattr(wp, name) for name in names}

    def looped(_: wp.array, while_body: Callable[..., object], graph: object = None, **args: object) -> None:
        while_body(**args)

    def chosen(_: wp.array, on_true: Any = None, on_false: Any = None, graph: object = None, **args: object) -> None:
        for branch in filter(callable, (on_true, on_false)):
            branch(**args)

    for name, stand_in in zip(names, (instead, instead, looped, chosen, wp.zeros, wp.zeros_like), strict=True):
        setattr(wp, name, stand_in)
    try:
        yield
    finally:
        for name, function in functions.items():
            setattr(wp, name, function)


def is_bare() -> bool:
    """Tell whether Warp's cache on this machine has hardly any compiled modules yet."""
    wp.init()
    return len(list(Path(wp.config.kernel_cache_dir).glob("wp_*"))) < KEPT_COUNT


def launched_kernels(device: wp.Device, run: Callable[[], object]) -> dict[tuple[Any, int], list[wp.Kernel]]:
    """Return what ``run`` launches, by module and block size; nothing is launched for that.

    Warp drops a kernel from its module once nobody holds it, so that who compiles the module is to hold its kernels.
    """
    kernels: dict[tuple[Any, int], list[wp.Kernel]] = {}

    def note(kernel: wp.Kernel, dim: Any, inputs: Any = (), outputs: Any = (), *_: Any, **options: Any) -> None:
        if kernel.is_generic:  # a launch makes of it what its arguments take, and only that is compiled
            kernel.add_overload(kernel.infer_argument_types([*inputs, *outputs]))
        block_dim = options.get("block_dim", 256) if device.is_cuda else 1
        kernels.setdefault((kernel.module, block_dim), []).append(kernel)

    with launching(note), suppress(Exception):  # it may read what no kernel has written
        run()
    return kernels


@cache
def scene_kernels(alias: str) -> dict[tuple[Any, int], list[wp.Kernel]]:
    """Return what building the scene and its frame launch on a device; see ``launched_kernels``."""
    device = wp.get_device(alias)
    return launched_kernels(device, lambda: Simulation([replace(AS_SHIPPED, frame_count=1)], device).frame())
