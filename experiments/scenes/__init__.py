"""Measure a box on a slope and published grasps, which follow the same law."""

from experiments.scenes import capsule, pick, slope
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.measurement import Conditions, Measurement

# ``measured_report.measuring.machine`` reads this. A CPU measures these scenes in
# minutes.
NEEDS_GPU = False
SCENES = {"slope": slope, "capsule": capsule, "pick": pick}


def measure(conditions: Conditions) -> Plan:
    """Return the rows of all scenes, with the name of the scene."""
    found = yield [
        Batch(name, scene.rows, (conditions,)) for name, scene in SCENES.items()
    ]
    return Measurement(
        [
            row | {"scene": name}
            for name, rows in zip(SCENES, found, strict=True)
            for row in rows
        ]
    )
