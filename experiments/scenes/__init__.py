"""Other scenes, one law: a box on a slope, and grasps that others have published, written anew in MJCF."""

from experiments.scenes import capsule, pick, slope
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.measurement import Conditions, Measurement

NEEDS_GPU = False  # read by ``measured_report.measuring.machine``: small scenes, which a CPU measures in minutes
SCENES = {"slope": slope, "capsule": capsule, "pick": pick}


def measure(conditions: Conditions) -> Plan:
    """Measure each scene; a row says of which it is."""
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
