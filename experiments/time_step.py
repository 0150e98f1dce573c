"""Measure how far the cube slips at each time step, with the pads that suit the step."""

from collections.abc import Sequence
from dataclasses import replace

from experiments.facts.case import AS_SHIPPED, BEST, FIRM, STIFF_PADS, Case
from experiments.simulation.limits import step_s
from experiments.simulation.measurement import (
    Conditions,
    Measurement,
    absent,
    grasp_columns,
    summarize,
)
from measured_report.measuring.batch import Batch, Plan

SUBSTEPS = {"full": (1, 2, 4, 8, 16, 32, 64, 128), "quick": (4, 16)}
LONGEST = {"newton-elliptic": 128, "rk4": 16}
"""Largest number of substeps for the most and least expensive settings; others have 64."""
CONTACTS = {
    "newton-elliptic": {},
    "newton-pyramidal": {"cone": "pyramidal"},
    "mujoco-elliptic": {"contacts": "mujoco"},
    "mujoco-pyramidal": {"contacts": "mujoco", "cone": "pyramidal"},
}  # type: dict[str, dict]
KD_FACTORS = (0.125, 0.25, 0.5, 1.0, 2.0)
"""kd times the step, with a damping ratio of 1; the rule is 1."""
KE_FACTORS = (1 / 16, 1 / 4, 2.0, 4.0, 16.0)
"""ke relative to the ke of the rule, with the kd of the rule."""
RULE = "kd-1"
REMEDY_PADS = ("shipped", "stiff", RULE)


def pads_at(substeps: int) -> dict[str, dict[str, float]]:
    """Return ke and kd of the pads by name, for one number of substeps.

    ``kd-1`` is the rule: kd is 1/step, the largest damping that the engine uses, and ke
    is kd²/4, which makes the damping ratio 1.
    """
    kd = 1.0 / step_s(replace(AS_SHIPPED, substeps=substeps))
    ke = kd**2 / 4.0
    pads = {
        "shipped": {"pad_ke": AS_SHIPPED.pad_ke, "pad_kd": AS_SHIPPED.pad_kd},
        "stiff": {"pad_ke": STIFF_PADS.pad_ke, "pad_kd": STIFF_PADS.pad_kd},
    }
    pads |= {
        f"kd-{factor:g}": {"pad_ke": factor**2 * ke, "pad_kd": factor * kd}
        for factor in KD_FACTORS
    }
    return pads | {
        f"ke-{factor:g}": {"pad_ke": factor * ke, "pad_kd": kd} for factor in KE_FACTORS
    }


def measure(conditions: Conditions) -> Plan:
    warp, c = yield [
        Batch("warp", measure_in_warp, (conditions,)),
        Batch("c", measure_in_c, (conditions,)),
    ]
    return Measurement([*warp, *c])


def measure_in_warp(conditions: Conditions) -> list[dict]:
    """Return a row for each setting, step and pads in MuJoCo Warp."""
    cases = warp_cases(conditions.profile)
    middle = conditions.contact_frames()[1]
    traces = conditions.simulate(cases, contact_frames=(middle,), title="time_step")
    return [
        columns_of(case)
        | summarize(case, trace)
        | (
            grasp_columns(trace.contact_rows[0])
            if trace.contact_rows
            else absent(("penetration_mm",), "the run ended before contacts were kept")
        )
        for case, trace in zip(cases, traces, strict=True)
    ]


def measure_in_c(conditions: Conditions) -> list[dict]:
    """Return a row for each step and pads in MuJoCo's C engine."""
    cases = ladder("c", {"backend": "mujoco"}, conditions.profile, REMEDY_PADS)
    traces = conditions.simulate(cases, title="time_step, in C")
    return [
        columns_of(case) | summarize(case, trace)
        for case, trace in zip(cases, traces, strict=True)
    ]


def columns_of(case: Case) -> dict[str, object]:
    """Return the values that every row states, even if they equal the scene as shipped."""
    setting, pads, _ = case.name.split("/")
    return {
        "setting": setting,
        "pads": pads,
        "pad_ke": case.pad_ke,
        "pad_kd": case.pad_kd,
        "substeps": case.substeps,
        "substep_ms": 1e3 * step_s(case),
    }


def warp_cases(profile: str) -> list[Case]:
    every = list(pads_at(1))
    cases = [
        case
        for setting, changes in CONTACTS.items()
        for case in ladder(setting, changes, profile, every)
    ]
    cases += ladder("rk4", {"integrator": "rk4"}, profile, REMEDY_PADS)
    cases += ladder("cure", BEST, profile, ["shipped"])
    # The cure with stiff pads, whose ke and kd follow the step.
    remedy = {
        name: value for name, value in FIRM.items() if name not in pads_at(1)["stiff"]
    }
    return cases + ladder("cure", remedy, profile, ["stiff", RULE])


def ladder(
    setting: str, changes: dict, profile: str, pads: Sequence[str]
) -> list[Case]:
    """Return a case of a setting for each number of substeps and these pads."""
    return [
        replace(
            AS_SHIPPED,
            name=f"{setting}/{name}/substeps-{substeps}",
            substeps=substeps,
            **changes,
            **pads_at(substeps)[name],  # type: ignore[arg-type]  # of ke and kd
        )
        for substeps in SUBSTEPS[profile]
        if substeps <= LONGEST.get(setting, 64)
        for name in pads
    ]
