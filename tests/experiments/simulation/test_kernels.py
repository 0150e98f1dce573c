"""Kernels that are compiled before they are launched."""

from dataclasses import replace

import warp as wp

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.kernels import launched_modules, launching
from experiments.simulation.simulation import Simulation


@wp.kernel(module="unique")
def doubled(values: wp.array(dtype=float)):
    i = wp.tid()
    values[i] = 2.0 * values[i]


def test_what_would_be_launched_is_known_and_not_launched():
    """What fails on the way, since nothing was computed, costs what comes after it alone."""
    values = wp.array([1.0], dtype=float, device="cpu")

    def run():
        wp.launch(doubled, 1, [values], device="cpu")
        raise IndexError

    assert launched_modules(wp.get_device("cpu"), run) == [(doubled.module, 1)]
    assert not doubled.module.execs and values.numpy()[0] == 1.0
    wp.launch(doubled, 1, [values], device="cpu")
    assert values.numpy()[0] == 2.0


def test_a_simulation_and_its_frame_can_be_gone_through_without_a_launch():
    """So all that they launch is known at once, and nothing waits for what comes before it."""
    keys: list[str] = []
    with launching(lambda kernel, *_, **__: keys.append(kernel.key)):
        Simulation([replace(AS_SHIPPED, frame_count=1)], wp.get_device("cpu")).frame()
    assert keys[-1] == "end_frame"
