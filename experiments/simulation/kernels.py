"""Kernels compiled at once, in threads, before the first run: one after the other they take minutes on a new machine.

Which modules a run needs shows only when it launches their kernels, so a first frame is built and queued with nothing
launched, and what would have been compiled for it is compiled in parallel.
"""

import os
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import replace
from unittest import mock

import newton
import warp as wp
from tqdm import tqdm

from experiments.facts.case import AS_SHIPPED, Case
from experiments.simulation import recorder
from experiments.simulation import simulation as simulations
from experiments.simulation.scene import build_scene

OLDEST = (1, 4, 0)
"""The oldest release that can run the scene."""
Module = type(wp.get_module(__name__))


def compile_first(device: wp.Device) -> str:
    """Compile what all sections need; return why the scene can't be run at all, where it can't.

    What else goes wrong here is said, and left to the measurement.
    """
    start = time.perf_counter()
    try:
        wanted = modules_of(device, AS_SHIPPED)

        def load(wanted: tuple[Module, int | None]) -> None:
            with suppress(Exception):  # it fails where it is met, with a message of its own
                wanted[0].load(device, wanted[1])

        with ThreadPoolExecutor(os.cpu_count()) as threads:
            list(tqdm(threads.map(load, wanted), "compiling kernels", len(wanted), unit="module", delay=3.0))
    except Exception as error:  # a new release may build its kernels in another way
        try:
            simulations.Simulation([replace(AS_SHIPPED, frame_count=1)], device)
        except (AttributeError, ImportError, TypeError) as missing:
            return " ".join(str(missing).split())[:200]
        print(f"kernels are compiled as they are met: {' '.join(str(error).split())[:200]}", file=sys.stderr)
        return ""
    tqdm.write(f"{len(wanted)} modules of kernels are ready after {time.perf_counter() - start:.0f} s")
    return ""


def modules_of(device: wp.Device, case: Case) -> list[tuple[Module, int | None]]:
    """Return the modules, with their block sizes, whose kernels a frame of ``case`` launches; none is launched."""
    wanted: dict[tuple[Module, int | None], None] = {}

    def note(module: Module, device: wp.Device, block_dim: int | None = None) -> None:
        wanted[module, block_dim] = None

    newton.use_coord_layout_targets = True
    case = replace(case, frame_count=1)
    scene = build_scene([case], device)  # few and small kernels, without which the scene makes no sense to the engine
    with _no_launches(note), mock.patch.object(simulations, "build_scene", lambda cases, device: scene):
        simulation = simulations.Simulation([case], device)
        with wp.ScopedDevice(device), wp.ScopedStream(simulation.stream):
            simulation.frame()
        wp.synchronize_device(device)
    return list(wanted)


@contextmanager
def _no_launches(note: Callable) -> Iterator[None]:
    """Let a launch within it only note the module that it needs, and a conditional part be queued
    once."""

    def once(condition: wp.array, body: Callable | None = None, stream: wp.Stream | None = None, **arguments) -> None:
        (body or arguments.pop("while_body"))(**arguments)

    # The real names are of what a kernel finds out.
    names = mock.patch.object(recorder, "_geom_names", lambda scene, solver: ["cube"])
    # What a kernel would have filled is read on the host: the arm's pose, and with it the mass matrix.
    filled = mock.patch.object(wp, "empty", wp.zeros)
    with names, filled, mock.patch.object(Module, "load", note), mock.patch.object(wp, "capture_while", once):
        yield
