"""Measure which bodies move relative to each other in the scene as shipped."""

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED
from experiments.simulation.measurement import Conditions, Measurement
from experiments.simulation.scene import TRACKED_BODIES

PAIRS = (
    ("cube", "fr3_hand_tcp"),
    ("cube", "fr3_hand"),
    ("cube", "fr3_leftfinger"),
    ("cube", "fr3_rightfinger"),
    ("fr3_hand_tcp", "fr3_hand"),
    ("fr3_leftfinger", "fr3_hand"),
    ("fr3_hand", "fr3_link7"),
)
NAMES = dict(
    zip(
        TRACKED_BODIES,
        ("cube", "TCP", "hand", "left finger", "right finger", "link7"),
        strict=True,
    )
)


def measure(conditions: Conditions) -> Measurement:
    [trace] = conditions.simulate([AS_SHIPPED], title="frames")
    rows = []
    for body, frame in PAIRS:
        moved = metrics.displacement(
            trace, *(TRACKED_BODIES.index(name) for name in (body, frame))
        )
        pair = f"{NAMES[body]} in {NAMES[frame]}"
        rows.append(
            {
                "case": pair.replace(" ", "-"),
                "pair": pair,
                "total_drift_mm": metrics.total_drift_mm(moved),
                "displacement_mm": metrics.slip_mm(moved),
                "oscillation_mm": metrics.oscillation_mm(moved),
            }
        )
    return Measurement(rows)
