"""Describe the box on a rotating table for Newton's solvers."""

from typing import Any

from experiments.cure.turntable import MASS_KG, MJCF, RADIUS_M, SAMPLE_S, TURN_RAD_S
from experiments.drivers.scene import GRAVITY_M_S2

# Inertia of the table [kg m²], which is so large that the box cannot slow it down.
TABLE_INERTIA = 1000.0
HALF_EDGE_M, FOOT_M = 0.05, 0.01
FEET = [(x, y, -0.04) for x in (0.04, -0.04) for y in (0.04, -0.04)]


def turntable(seconds: float) -> dict[str, Any]:
    """Return the box on four feet, at rest on the rotating table."""
    inertia = [MASS_KG / 3.0 * (HALF_EDGE_M**2 + 0.04**2)] * 2 + [
        MASS_KG / 3.0 * 2.0 * HALF_EDGE_M**2
    ]
    body = {
        "mass_kg": MASS_KG,
        "inertia_kg_m2": inertia,
        "feet": FEET,
        "foot_m": FOOT_M,
        "place": [RADIUS_M, 0.0, 0.1],
    }
    body |= {
        "velocity": [0.0, TURN_RAD_S * RADIUS_M, 0.0],
        "spin": [0.0, 0.0, TURN_RAD_S],
    }
    table: dict = {
        "joint": "hinge",
        "axis": [0.0, 0.0, 1.0],
        "half_size": [0.5, 0.5, 0.05],
        "place": [0.0, 0.0, 0.0],
    }
    table |= {
        "mass_kg": TABLE_INERTIA,
        "inertia_kg_m2": TABLE_INERTIA,
        "speed": TURN_RAD_S,
        "force_n": 0.0,
    }
    start = [TURN_RAD_S, *body["velocity"], *body["spin"]]  # type: ignore[misc]  # both are lists
    return _scene(seconds, 1.0, body, [table]) | {
        "mjcf": MJCF,
        "qvel": start,
        "ctrl": [],
    }


def _scene(
    seconds: float, friction: float, body: dict, supports: list[dict]
) -> dict[str, object]:
    scene = {
        "seconds": seconds,
        "sample_s": SAMPLE_S,
        "gravity_m_s2": GRAVITY_M_S2,
        "friction": friction,
    }
    return scene | {"body": body, "supports": supports}
