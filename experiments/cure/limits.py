"""Measure whether the cure breaks the extreme cases of section stability."""

from dataclasses import replace

from experiments.facts.case import BEST, FIRM, TERMS, Case
from experiments.facts.classes import STABLE, classify
from experiments.facts.trace import Trace
from experiments.simulation.measurement import Conditions
from experiments.stability import families
from experiments.stability.families import (
    DAMPING,
    GRID_KE,
    HOLD_FRAME_COUNT,
    SHAKE_FRAME_COUNT,
    Probe,
)

ON_STIFF_PADS = {"firm": FIRM, "firm-euler": FIRM | {"integrator": "euler"}}
VARIANTS = {"plain": {}, "term": TERMS["term"], "best": BEST, **ON_STIFF_PADS}  # type: dict[str, dict]
"""Settings of each variant of the cure."""
GRID_SUBSTEPS = {"full": (4, 16), "quick": (4,)}


def probes(profile: str) -> list[Probe]:
    """Return the probes: long steps, soft and stiff pads, masses and overlaps."""
    grid = [
        families.grid_cell(family, float(ke), count)
        for family in DAMPING
        for ke in GRID_KE[profile]
        for count in GRID_SUBSTEPS[profile]
    ]
    return [
        *families.steps(profile),
        *grid,
        *families.masses(profile),
        *families.overlaps(profile),
    ]


def measure(conditions: Conditions) -> list[dict]:
    """Return a row for each run and variant with the class in which it ends."""
    frame_count = HOLD_FRAME_COUNT + SHAKE_FRAME_COUNT[conditions.profile]
    runs = [
        (probe, variant)
        for probe in probes(conditions.profile)
        for variant in variants_of(probe)
    ]
    cases = [case_of(*run, frame_count) for run in runs]
    traces = conditions.simulate(cases, title="cure, limits")
    return [
        row_of(*run, case, trace)
        for run, case, trace in zip(runs, cases, traces, strict=True)
    ]


def variants_of(probe: Probe) -> list[str]:
    """Return the variants for a probe.

    Variants that set the pads are left out if the probe varies the pads itself.
    """
    stiff = probe.case.pad_ke == FIRM["pad_ke"] and probe.case.pad_kd == FIRM["pad_kd"]
    return [variant for variant in VARIANTS if stiff or variant not in ON_STIFF_PADS]


def case_of(probe: Probe, variant: str, frame_count: int) -> Case:
    return replace(
        probe.case,
        name=f"{probe.case.name}-{variant}",
        frame_count=frame_count,
        **VARIANTS[variant],
    )


def row_of(probe: Probe, variant: str, case: Case, trace: Trace) -> dict[str, object]:
    kind = classify(case, trace, creep_floor_mm_s=0.0)
    row = {
        "case": case.name,
        "of": probe.case.name,
        "family": probe.family,
        "variant": variant,
        **probe.parameters,
    }
    return row | {
        "contact_bias": case.contact_bias,
        "class": kind,
        "kept": kind in STABLE,
    }
