"""Measure the slip with friction coefficients from far below to far above the defaults.

The coefficients of the pads and of the cube are varied separately.
"""

from dataclasses import replace

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.measurement import Conditions, Measurement

CASES = (
    *(
        replace(AS_SHIPPED, name=f"pad-mu-{mu:g}", pad_mu=mu)
        for mu in (0.2, 0.5, 1.0, 3.0, 10.0)
    ),
    *(replace(AS_SHIPPED, name=f"cube-mu-{mu:g}", cube_mu=mu) for mu in (0.3, 20.0)),
)


def measure(conditions: Conditions) -> Measurement:
    return conditions.measure(CASES, "friction")
