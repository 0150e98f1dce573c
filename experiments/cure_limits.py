"""Does the cure hold up where the grasp is at its limits? Runs of section stability that it could break, with it."""

from dataclasses import replace

from experiments.cure import BEST, FIRM, TERMS
from experiments.facts import metrics
from experiments.facts.case import Case
from experiments.facts.classes import STABLE, classify, creep_mm_s
from experiments.facts.trace import Trace
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.stability import families as stability_families
from experiments.stability.families import DAMPING, GRID_KE, HOLD_FRAME_COUNT, SHAKE_FRAME_COUNT, Probe, grid_cell

FIRM_WAYS = {"firm": FIRM, "firm-euler": FIRM | {"integrator": "euler"}}
WAYS = {"plain": {}, "term": TERMS["term"], "best": BEST, **FIRM_WAYS}
"""What is done about the slip."""
GRID_SUBSTEPS = {"full": (4, 16), "quick": (4,)}


def probes(profile: str) -> list[Probe]:
    """Long steps, soft and stiff pads at two steps, masses, and starts too deep in what the cube touches."""
    grid = [
        grid_cell(family, float(ke), count)
        for family in DAMPING
        for ke in GRID_KE[profile]
        for count in GRID_SUBSTEPS[profile]
    ]
    return [
        *stability_families.steps(profile),
        *grid,
        *stability_families.masses(profile),
        *stability_families.overlaps(profile),
    ]


def measure(conditions: Conditions) -> Measurement:
    """A row for each run and way: how it ends, and how it creeps where it keeps the cube."""
    frame_count = HOLD_FRAME_COUNT + SHAKE_FRAME_COUNT[conditions.profile]
    runs = [(probe, way) for probe in probes(conditions.profile) for way in ways_of(probe)]
    cases = [case_of(probe, way, frame_count) for probe, way in runs]
    traces = conditions.simulate(cases, title="cure_limits")
    return Measurement([row_of(*run, case, trace) for run, case, trace in zip(runs, cases, traces, strict=True)])


def ways_of(probe: Probe) -> list[str]:
    """What is tried in a run: ways that set the pads are not where a run is about other pads than theirs."""
    stiff = probe.case.pad_ke == FIRM["pad_ke"] and probe.case.pad_kd == FIRM["pad_kd"]
    return [way for way in WAYS if stiff or way not in FIRM_WAYS]


def case_of(probe: Probe, way: str, frame_count: int) -> Case:
    return replace(probe.case, name=f"{probe.case.name}-{way}", frame_count=frame_count, **WAYS[way])


def row_of(probe: Probe, way: str, case: Case, trace: Trace) -> dict[str, object]:
    kind = classify(case, trace, creep_floor_mm_s=0.0)
    row = {"case": case.name, "of": probe.case.name, "family": probe.family, "way": way, **probe.parameters}
    row |= {"contact_bias": case.contact_bias, "class": kind, "kept": kind in STABLE}
    reason = "" if kind in STABLE else f"the run ended as {kind}"
    if reason:
        return row | absent(("creep_mm_s", "slip_mm"), reason)
    return row | {"creep_mm_s": creep_mm_s(case, trace), "slip_mm": metrics.slip_mm(metrics.displacement(trace))}
