"""The scenes as data, which every engine can read: a body on balls, the supports that it touches, and MJCF."""

from typing import Any

from experiments.cure.turntable import MASS_KG, MJCF, RADIUS_M, SAMPLE_S, TURN_RAD_S
from experiments.scenes import capsule
from experiments.simulation.mjcf_engines import GRAVITY_M_S2

TABLE_INERTIA = 1000.0  # of the table [kg m²], which keeps turning whatever the box does
HALF_EDGE_M, FOOT_M = 0.05, 0.01
FEET = [(x, y, -0.04) for x in (0.04, -0.04) for y in (0.04, -0.04)]
PRESS_N = 12.0  # what each pad presses with, as in the report that the pinched capsule is after
CAPSULE = capsule.Pinch("within-pads", half_length_m=0.02)


def turntable(seconds: float) -> dict[str, Any]:
    """Describe the box on four feet on the turning table, in rest on it."""
    inertia = [MASS_KG / 3.0 * (HALF_EDGE_M**2 + 0.04**2)] * 2 + [MASS_KG / 3.0 * 2.0 * HALF_EDGE_M**2]
    body = {"mass_kg": MASS_KG, "inertia_kg_m2": inertia, "feet": FEET, "foot_m": FOOT_M, "place": [RADIUS_M, 0.0, 0.1]}
    body |= {"velocity": [0.0, TURN_RAD_S * RADIUS_M, 0.0], "spin": [0.0, 0.0, TURN_RAD_S]}
    table: dict = {"joint": "hinge", "axis": [0.0, 0.0, 1.0], "half_size": [0.5, 0.5, 0.05], "place": [0.0, 0.0, 0.0]}
    table |= {"mass_kg": TABLE_INERTIA, "inertia_kg_m2": TABLE_INERTIA, "speed": TURN_RAD_S, "force_n": 0.0}
    start = [TURN_RAD_S, *body["velocity"], *body["spin"]]  # type: ignore[misc]  # both are lists
    return _scene(seconds, 1.0, body, [table]) | {"mjcf": MJCF, "qvel": start, "ctrl": []}


def pinch(seconds: float) -> dict[str, object]:
    """Describe two pads that press on a capsule's ends, which touch them."""
    mass, radius, half = capsule.MASS_KG, capsule.RADIUS_M, CAPSULE.half_length_m
    across, along = mass * (radius**2 / 4.0 + half**2 / 3.0), mass * radius**2 / 2.0
    body = {"mass_kg": mass, "inertia_kg_m2": [across, along, across], "foot_m": radius, "place": [0.0, 0.0, 0.0]}
    body |= {"feet": [[0.0, -half, 0.0], [0.0, half, 0.0]], "velocity": [0.0, 0.0, 0.0], "spin": [0.0, 0.0, 0.0]}
    size = capsule.PAD_HALF_SIZE_M
    pad = {"joint": "slide", "axis": [1.0, 0.0, 0.0], "half_size": size, "mass_kg": capsule.PAD_MASS_KG, "speed": 0.0}
    pads = [
        pad | {"inertia_kg_m2": 1e-3, "place": [side * (radius + size[0]), 0.0, 0.0], "force_n": -side * PRESS_N}
        for side in (-1.0, 1.0)
    ]
    travel = capsule.GAP_M + capsule.SQUEEZE_M
    start = {"mjcf": CAPSULE.mjcf(), "qvel": [0.0] * 8, "ctrl": [travel, -travel]}
    return _scene(seconds, capsule.FRICTION[0], body, pads) | start


def _scene(seconds: float, friction: float, body: dict, supports: list[dict]) -> dict[str, object]:
    scene = {"seconds": seconds, "sample_s": SAMPLE_S, "gravity_m_s2": GRAVITY_M_S2, "friction": friction}
    return scene | {"body": body, "supports": supports}
