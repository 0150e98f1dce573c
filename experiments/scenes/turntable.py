"""Define the box on four feet on a rotating table, for engines without MJCF."""

from dataclasses import replace

import numpy as np

from experiments.cure.turntable import MASS_KG, MJCF, RADIUS_M, SAMPLE_S, TURN_RAD_S
from experiments.drivers.scene import GRAVITY_M_S2, ORIGIN, Body, Scene, Support

BOX_M = (0.05, 0.05, 0.04)
FOOT_M = 0.01
TURNING = Body(
    mass_kg=MASS_KG,
    inertia_kg_m2=[
        MASS_KG / 3.0 * (BOX_M[1] ** 2 + BOX_M[2] ** 2),
        MASS_KG / 3.0 * (BOX_M[0] ** 2 + BOX_M[2] ** 2),
        MASS_KG / 3.0 * 2.0 * BOX_M[0] ** 2,
    ],
    position_m=(RADIUS_M, 0.0, 0.1),
    foot_m=FOOT_M,
    feet=[(x, y, -0.04) for x in (0.04, -0.04) for y in (0.04, -0.04)],
    velocity_m_s=(0.0, TURN_RAD_S * RADIUS_M, 0.0),
    spin_rad_s=(0.0, 0.0, TURN_RAD_S),
)
TABLE = Support(
    joint="hinge",
    axis=(0.0, 0.0, 1.0),
    half_size_m=(0.5, 0.5, 0.05),
    position_m=ORIGIN,
    mass_kg=1000.0,  # so heavy that the box cannot slow the table down
    inertia_kg_m2=1000.0,
    speed=TURN_RAD_S,
)


def turntable(step_s: float, seconds: float) -> Scene:
    """Return a box on four feet, at rest on the rotating table."""
    return Scene(
        step_s,
        SAMPLE_S,
        [[]] * round(seconds / SAMPLE_S),
        mjcf=MJCF,
        qvel=[TURN_RAD_S, *TURNING.velocity_m_s, *TURNING.spin_rad_s],
        body=TURNING,
        supports=[TABLE],
    )


def still(step_s: float, seconds: float) -> Scene:
    """Return the same box on a table that stands still."""
    return replace(turntable(step_s, seconds), qvel=(0.0,) * 7)


def slope(step_s: float, seconds: float) -> Scene:
    """Return the same box on a slope of 0.35. Friction holds it up to a slope of 1."""
    gravity = GRAVITY_M_S2 * np.array([0.35, 0.0, -1.0]) / np.hypot(1.0, 0.35)
    return replace(still(step_s, seconds), gravity_m_s2=gravity)
