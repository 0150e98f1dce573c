"""Kernels: compiled beside one another, since Warp compiles a module only when its first kernel is launched."""

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
KEPT_COUNT = 12  # chosen: a frame of the scene takes some 55 modules


@contextmanager
def launching(instead: Launch) -> Iterator[None]:
    """Call ``instead`` with each kernel, its size and its options, in place of launching it; arrays are zero then."""
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
    """Tell whether this process has begun to use Warp, and devices: only then has it chosen where kernels are kept."""
    return wp.config.kernel_cache_dir is not None


def is_bare() -> bool:
    """Tell whether this machine has compiled hardly anything yet: where kernels are kept there is next to nothing."""
    begun = has_begun()
    if not begun:
        init_kernel_cache()
    kept_count = len(list(Path(wp.config.kernel_cache_dir).glob("wp_*")))
    if not begun:
        wp.config.kernel_cache_dir = None  # for Warp to choose again
    return kept_count < KEPT_COUNT


def launched_kernels(
    device: wp.Device, run: Callable[[], object]
) -> dict[tuple[Any, int], list[wp.Kernel]]:
    """Return what ``run`` launches, by module and block size; nothing is launched for that.

    Warp drops a kernel from its module once nobody holds it, so that who compiles the module is to hold its kernels.
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
        if (
            kernel.is_generic
        ):  # a launch makes of it what its arguments take, and only that is compiled
            kernel.add_overload(kernel.infer_argument_types([*inputs, *outputs]))
        block_dim = options.get("block_dim", 256) if device.is_cuda else 1
        kernels.setdefault((kernel.module, block_dim), []).append(kernel)

    with launching(note), suppress(Exception):  # it may read what no kernel has written
        run()
    return kernels


class UnlaunchedRecorder(MuJoCoRecorder):
    """Looks for no cube among the engine's geoms: no kernel has said what they are of."""

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
    """A simulation whose kernels are never launched."""

    stepper_of = UnlaunchedStepper


@cache
def scene_kernels(alias: str) -> dict[tuple[Any, int], list[wp.Kernel]]:
    """Return what building the scene and its frame launch on a device; see ``launched_kernels``."""
    device = wp.get_device(alias)
    return launched_kernels(
        device, lambda: Unlaunched([replace(AS_SHIPPED, frame_count=1)], device).frame()
    )
