"""Measure bodies that wobble, spin, roll or tumble, with and without the exact term.

This is the benchmark of the package contact-bias.
"""

from tqdm import tqdm

import contact_tumbles
from measured_report.measuring.measurement import Conditions, Measurement


def measure(conditions: Conditions) -> Measurement:
    bodies = tqdm(contact_tumbles.BODIES, desc="tumbles", unit="body", delay=3.0)
    rows = [
        contact_tumbles.measure(body, conditions.profile, conditions.device)
        for body in bodies
    ]
    return Measurement([row for of_body in rows for row in of_body])
