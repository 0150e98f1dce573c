"""Test the pendulum of the first section."""

import math

import pytest

from experiments.pendulum import START_RAD, swing


def test_the_energy_at_the_start_is_that_of_the_height_and_is_kept():
    """Compute the initial energy: m g l/2 (1 - cos θ) above the lowest point, with a
    mass of 1 kg and a length of 0.5 m.
    """
    times, energies = swing("RK4", START_RAD, 0.1)
    assert energies[0] == pytest.approx(
        9.81 * 0.25 * (1 - math.cos(START_RAD)), rel=1e-6
    )
    assert energies[-1] == pytest.approx(energies[0], rel=1e-9) and times[
        -1
    ] == pytest.approx(0.099)
