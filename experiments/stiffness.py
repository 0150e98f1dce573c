"""Measure pad stiffness, damping and solimp, and the solver's contact parameters."""

from dataclasses import replace

import numpy as np

from experiments.facts.case import AS_SHIPPED, Case
from experiments.simulation.measurement import (
    Conditions,
    Measurement,
    grasp_columns,
    summarize,
)

# Values of ke and kd that keep the damping ratio near 1.
CRITICAL = (
    (2.5e3, 1e2),
    (2.5e4, 3e2),
    (2.5e5, 1e3),
    (2.5e6, 3e3),
)
SWEEP = {"full": np.logspace(2, 8, 40), "quick": np.logspace(2, 8, 7)}


def cases(profile: str) -> list[Case]:
    variants = [
        replace(AS_SHIPPED, name=f"pad-ke-{name(ke)}", pad_ke=ke, pad_kd=kd)
        for ke, kd in CRITICAL
    ]
    variants += [
        replace(AS_SHIPPED, name=f"pad-ke-{name(ke)}-kd-100", pad_ke=ke)
        for ke, _ in CRITICAL[1:]
    ]
    variants += [
        replace(AS_SHIPPED, name=f"solimp-dmax-{dmax}", pad_dmax=dmax)
        for dmax in (0.99, 0.9999)
    ]
    for ke in (float(value) for value in SWEEP[profile]):
        # A damping ratio of 1 means kd = 2 sqrt(ke), because dampratio = kd / (2
        # sqrt(ke)).
        variants.append(
            replace(
                AS_SHIPPED, name=f"sweep-ke-{ke:.3g}", pad_ke=ke, pad_kd=2.0 * ke**0.5
            )
        )
        variants.append(
            replace(AS_SHIPPED, name=f"sweep-ke-{ke:.3g}-kd-100", pad_ke=ke)
        )
    return variants


def name(ke: float) -> str:
    """Return a number in short form, such as ``2.5e3`` for 2500.0."""
    return f"{ke:.1e}".replace("e+0", "e")


def measure(conditions: Conditions) -> Measurement:
    variants = cases(conditions.profile)
    middle = conditions.contact_frames()[1]
    traces = conditions.simulate(variants, contact_frames=(middle,), title="stiffness")
    return Measurement(
        [
            summarize(case, trace)
            | {"pad_ke": case.pad_ke, "pad_kd": case.pad_kd}
            | grasp_columns(trace.contact_rows[0])
            for case, trace in zip(variants, traces, strict=True)
        ]
    )
