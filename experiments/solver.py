"""Is it the solver? More iterations, a tighter tolerance, another cone, more impratio, smaller steps."""

from dataclasses import replace

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.measurement import Conditions, Measurement

CASES = (
    replace(AS_SHIPPED, name="iterations-15"),
    replace(AS_SHIPPED, name="iterations-200", iterations=200),
    replace(AS_SHIPPED, name="tolerance-1e-10", tolerance=1e-10, ls_tolerance=1e-10),
    replace(AS_SHIPPED, name="impratio-1000", impratio=1000.0),
    replace(AS_SHIPPED, name="cone-pyramidal", cone="pyramidal"),
    replace(AS_SHIPPED, name="substeps-32", substeps=32),
    replace(AS_SHIPPED, name="substeps-64", substeps=64),
)


def measure(conditions: Conditions) -> Measurement:
    return conditions.measure(CASES, "solver")
