"""Compile kernels in parallel.

Warp itself compiles a module only when its first kernel is launched.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import warp as wp
from warp._src.build import init_kernel_cache

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.recorder import Recorder
from experiments.simulation.simulation import Simulation
from experiments.simulation.stepper import Stepper
from experiments.simulation.stepper_c import MuJoCoRecorder, MuJoCoStepper

Launch = Callable[..., Any]
KEPT_COUNT = 12  # a chosen value: a frame of the scene needs about 55 modules


@contextmanager
def launching(instead: Launch) -> Iterator[None]:
    """Call ``instead`` with each kernel, its size and its options, and do not launch
    it.

    Within the block, new arrays contain zeros.
    """
    names = (
        "launch",
        "launch_tiled",
        "capture_while",
        "capture_if",
        "empty",
        "empty_like",
    )
    functions = {name: getattr(wp, name) for name in names}

    def looped(
        _: wp.array,
        while_body: Callable[..., object],
        graph: object = None,
        **args: object,
    ) -> None:
        while_body(**args)

    def chosen(
        _: wp.array,
        on_true: Any = None,
        on_false: Any = None,
        graph: object = None,
        **args: object,
    ) -> None:
        for branch in filter(callable, (on_true, on_false)):
            branch(**args)

    for name, stand_in in zip(
        names, (instead, instead, looped, chosen, wp.zeros, wp.zeros_like), strict=True
    ):
        setattr(wp, name, stand_in)
    try:
        yield
    finally:
        for name, function in functions.items():
            setattr(wp, name, function)


def has_begun() -> bool:
    """Return whether this process has started to use Warp and devices.

    Only then has Warp chosen the folder of its kernels.
    """
    return wp.config.kernel_cache_dir is not None


def is_bare() -> bool:
    """Return whether the kernel cache of this machine is almost empty."""
    begun = has_begun()
    if not begun:
        init_kernel_cache()
    kept_count = len(list(Path(wp.config.kernel_cache_dir).glob("wp_*")))
    if not begun:
        wp.config.kernel_cache_dir = None  # so that Warp chooses it again
    return kept_count < KEPT_COUNT


def launched_kernels(
    device: wp.Device, run: Callable[[], object]
) -> dict[tuple[Any, int], list[wp.Kernel]]:
    """Return the kernels that ``run`` launches, by module and block size.

    The kernels are not launched. Warp removes a kernel from its module when it is no
    longer referenced, so the caller must keep the kernels until the module is compiled.
    """
    kernels: dict[tuple[Any, int], list[wp.Kernel]] = {}

    def note(
        kernel: wp.Kernel,
        dim: Any,
        inputs: Any = (),
        outputs: Any = (),
        *_: Any,
        **options: Any,
    ) -> None:
        # A launch creates the overload for its arguments, and only this overload is
        # compiled.
        if kernel.is_generic:
            kernel.add_overload(kernel.infer_argument_types([*inputs, *outputs]))
        block_dim = options.get("block_dim", 256) if device.is_cuda else 1
        kernels.setdefault((kernel.module, block_dim), []).append(kernel)

    # it may read results of kernels that did not run
    with launching(note), suppress(Exception):
        run()
    return kernels


class UnlaunchedRecorder(MuJoCoRecorder):
    """Skip the search for the cube, because no kernel has filled the geoms."""

    def __init__(self, stepper: Stepper, frame_count: int):
        Recorder.__init__(
            self,
            stepper.scene,
            stepper.solver,
            stepper.contacts,
            stepper.world_count,
            frame_count,
        )
        self.cube_geom = 0


class UnlaunchedStepper(MuJoCoStepper):
    def _build_recorder(self, frame_count: int) -> MuJoCoRecorder:
        return UnlaunchedRecorder(self, frame_count)


class Unlaunched(Simulation):
    """Build a simulation whose kernels are never launched."""

    stepper_of = UnlaunchedStepper


@cache
def scene_kernels(alias: str) -> dict[tuple[Any, int], list[wp.Kernel]]:
    """Return the kernels that are launched to build the scene and to run its frame on a
    device.

    See ``launched_kernels``.
    """
    device = wp.get_device(alias)
    return launched_kernels(
        device, lambda: Unlaunched([replace(AS_SHIPPED, frame_count=1)], device).frame()
    )
