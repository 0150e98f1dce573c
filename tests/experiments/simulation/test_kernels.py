"""Kernels that are compiled before they are launched."""

import warp as wp

from experiments.simulation.kernels import compile_share


@wp.kernel(module="unique")
def doubled(values: wp.array(dtype=float)):
    i = wp.tid()
    values[i] = 2.0 * values[i]


def test_what_would_be_launched_is_compiled_and_not_launched():
    """What fails on the way, since nothing was computed, costs what comes after it alone."""
    values = wp.array([1.0], dtype=float, device="cpu")

    def run():
        wp.launch(doubled, 1, [values], device="cpu")
        raise IndexError

    assert not doubled.module.execs
    compile_share(wp.get_device("cpu"), run, 1, 2)
    assert not doubled.module.execs, "it is the first, and of the other share"
    compile_share(wp.get_device("cpu"), run, 0, 2)
    assert doubled.module.execs and values.numpy()[0] == 1.0
    wp.launch(doubled, 1, [values], device="cpu")
    assert values.numpy()[0] == 2.0
