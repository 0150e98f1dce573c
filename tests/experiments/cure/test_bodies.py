"""Test bodies and contacts that differ from a grasp."""

import pytest

from experiments.cure import bodies
from experiments.simulation.measurement import Conditions

GRAVITY_M_S2 = 9.81


def moved(name: str, body: str, variant: str, engine: str = "c") -> list[float]:
    """Return how far a body moves on the plane in half a second [m]: along the motion,
    sideways and up.
    """
    motion = next(
        each for each in bodies.MOTIONS if (each.name, each.body) == (name, body)
    )
    row = bodies.row_of(motion, variant, engine, Conditions(device="cpu", quick=True))
    return [1e-3 * row[column] for column in bodies.COLUMNS["plane"]]


def test_how_bodies_roll_spin_and_slide():
    plain, term = (moved("roll", "sphere", variant) for variant in ("plain", "term"))
    assert plain[0] == pytest.approx(0.5 * bodies.SPEED_M_S, rel=2e-3)
    assert term == pytest.approx(plain, abs=1e-9)
    assert (
        abs(moved("pivot", "sphere", "plain")[1]) < 1e-9
        and abs(moved("pivot", "sphere", "term")[1]) > 1e-3
    )
    plain, exact = (
        moved("pivot", "sphere", variant, "warp") for variant in ("plain", "exact")
    )
    assert abs(exact[1]) < 1e-4 and abs(plain[2] - exact[2]) < 1e-4
    far = bodies.SPEED_M_S**2 / (2.0 * bodies.FRICTION * GRAVITY_M_S2)
    for variant in ("plain", "term"):
        assert moved("slide", "mesh", variant)[0] == pytest.approx(far, rel=0.08)
