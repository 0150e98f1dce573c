"""Kernels are known before a run, so that they can be compiled on all cores."""

import ctypes
from dataclasses import replace

import newton
import warp as wp

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.kernels import Module, modules_of
from experiments.simulation.simulation import Simulation
from experiments.simulation.timing import run_frames


def test_all_kernels_of_a_run_are_known_before_it(monkeypatch):
    newton.use_coord_layout_targets = True
    device = wp.get_device("cpu")
    empty = wp.empty

    def full_of_rubbish(*arguments, **options):
        array = empty(*arguments, **options)
        if array.capacity:
            ctypes.memset(array.ptr, 0x7E, array.capacity)
        return array

    with monkeypatch.context() as memory:
        memory.setattr(wp, "empty", full_of_rubbish)
        known = set(modules_of(device, AS_SHIPPED))
    assert len(known) > 20
    needed = set()
    load = Module.load

    def note(module, device, block_dim=None):
        needed.add((module, block_dim))
        return load(module, device, block_dim)

    monkeypatch.setattr(Module, "load", note)
    simulation = Simulation([replace(AS_SHIPPED, frame_count=3)], device)
    run_frames(simulation, 3)
    assert needed
    scenes = {module.name for module, _ in needed} - {module.name for module, _ in known}
    assert len(scenes) < 5, "only the scene's own kernels are compiled as they are met"
