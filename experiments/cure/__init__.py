"""The cure: causes of the slip taken out one by one and together, and where else that holds.

With the robot: ``combinations`` beside their predicted ``budget``, a minute held still, the limits of the grasp and an
envelope of harder shakes. Without it: the box on a turntable and other bodies.
"""

from itertools import chain

from experiments.cure import bodies, combinations, envelope, hold, limits, turntable
from experiments.simulation.measurement import Conditions, Measurement
from measured_report.measuring.batch import Batch, Plan


def measure(conditions: Conditions) -> Plan:
    """Measure the combinations by their kind of contacts, and each other part."""
    groups = combinations.by_contacts(conditions.quick)
    *combined, held, (map_rows, cells), tried, turned, moved = yield [
        *(Batch(kind, combinations.measure, (conditions, cases)) for kind, cases in groups.items()),
        Batch("hold", hold.measure, (conditions,)),
        Batch("envelope", envelope.measure, (conditions,)),
        Batch("limits", limits.measure, (conditions,)),
        Batch("turntable", turntable.measure, (conditions,)),
        Batch("bodies", bodies.measure, (conditions,)),
    ]
    runs = chain.from_iterable(rows for rows, _ in combined)
    motions = {row["case"]: row for _, rows in combined for row in rows}
    held_rows, displacements = held
    rows = [*runs, *motions.values(), *held_rows, *map_rows, *tried, *turned, *moved]
    return Measurement(rows, {**displacements, "map": cells})
