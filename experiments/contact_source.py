"""Measure whether the source, rate or shape of contacts, or the engine, matters."""

from dataclasses import replace

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.measurement import Conditions, Measurement

CASES = (
    replace(AS_SHIPPED, name="contacts-60hz"),
    replace(AS_SHIPPED, name="contacts-240hz", collide_count=4),
    replace(AS_SHIPPED, name="contacts-960hz", collide_count=16),
    replace(AS_SHIPPED, name="contacts-mujoco", contacts="mujoco"),
    replace(AS_SHIPPED, name="pads-convex-mesh", pad_shape="convex-mesh"),
    replace(AS_SHIPPED, name="engine-mujoco-c", backend="mujoco"),
)


def measure(conditions: Conditions) -> Measurement:
    return conditions.measure(CASES, "contact_source")
