"""Remove the causes of the slip one by one and together, and test other scenes.

With the robot, the section measures ``combinations`` and their predicted ``budget``, a
minute without motion, the limits of the grasp, and an envelope of harder shakes.
Without the robot, it measures the box on a turntable, its controls, and other bodies.
"""

from dataclasses import replace
from itertools import chain

from experiments.cure import bodies, combinations, controls, limits, turntable
from experiments.envelope import MAP_SIZE, measure_map
from experiments.facts.case import AS_SHIPPED, BEST, HOLD, POSITIONS
from experiments.hold import LONG_FRAME_COUNT, creep
from experiments.simulation.measurement import Conditions, Measurement, summarize
from measured_report.measuring.batch import Batch, Plan

MINUTE = replace(HOLD, frame_count=LONG_FRAME_COUNT)
HELD = (
    replace(MINUTE, name="rounded"),
    replace(MINUTE, name="kept", **POSITIONS["kept"]),
    replace(MINUTE, name="best", **BEST),
)
# This is the case of the map in section envelope, with the whole cure.
SIDES = {"best": replace(AS_SHIPPED, **BEST)}
PARTS = {
    "limits": limits.measure,
    "turntable": turntable.measure,
    "controls": controls.measure,
    "jacobians": controls.measure_jacobians,
    "bodies": bodies.measure,
}


def measure(conditions: Conditions) -> Plan:
    """Measure the combinations by their source of contacts, and the other parts."""
    groups = {
        kind: combinations.cases(kind, conditions.quick)
        for kind in combinations.CONTACTS
    }
    held, cells, *measured = yield [
        Batch("hold", measure_held, (conditions,)),
        Batch("envelope", measure_map, (conditions, SIDES)),
        *(
            Batch(kind, combinations.measure, (conditions, cases))
            for kind, cases in groups.items()
            if cases
        ),
        *(Batch(name, function, (conditions,)) for name, function in PARTS.items()),
    ]
    best = {
        "case": "map-best",
        "contact_bias": True,
        "cell_count": MAP_SIZE[conditions.profile] ** 2,
    }
    return Measurement([*held, best, *chain(*measured)], {"map": cells})


def measure_held(conditions: Conditions) -> list[dict]:
    """Return a row for each minute with the arm held still, with the final creep.

    The creep is measured in the last second.
    """
    runs = zip(HELD, conditions.simulate(HELD, title="cure, held"), strict=True)
    return [
        summarize(case, trace) | {"contact_bias": case.contact_bias} | creep(trace)
        for case, trace in runs
    ]
