"""Measure combinations of the cure's parts, pads, contacts and shakes.

Each run is compared with the displacement that is predicted for each cause.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from experiments.facts import metrics
from experiments.facts.case import (
    AS_SHIPPED,
    IMPRATIO,
    POSITIONS,
    STIFF_PADS,
    TERMS,
    Case,
)
from experiments.facts.trace import Trace
from experiments.simulation.budget import Motion, measure_motion, predicted_mm
from experiments.simulation.measurement import (
    SHAKE_COLUMNS,
    Conditions,
    absent,
    summarize,
)
from measured_report.measuring.pool import gather, processes, start
from newton_lint.newton_models.compat import kf_is_read

PADS = {"shipped": AS_SHIPPED, "stiff": STIFF_PADS}
AMPLITUDES_M = {"held": 0.0, "3cm": 0.03, "10cm": 0.1}
CONTACTS = {
    "newton": {},
    "mujoco": {"contacts": "mujoco"},
    "pyramidal": {"cone": "pyramidal"},
}  # type: dict[str, dict]
ALONG = {"x": 0, "z": 2}  # axes of the TCP frame along the pads, by index
OTHERS = [
    ("implicitfast", 50.0),
    ("implicitfast", IMPRATIO),
    ("rk4", 50.0),
    ("euler", IMPRATIO),
]
SETTINGS = {
    "newton": list(
        product(("implicitfast", "euler", "rk4"), (AS_SHIPPED.impratio, IMPRATIO))
    ),
    "mujoco": OTHERS,
    "pyramidal": OTHERS,
}
"""Integrators and values of impratio for each source of contacts.

Each pair needs a separate simulation. All other parameters vary between the worlds of a
simulation.
"""


def cases(kind: str, quick: bool) -> list[Case]:
    """Return every combination with one source of contacts.

    The quick profile has only Newton's contacts, the default pads and the default
    impratio, without the 10 cm shake and without RK4.
    """
    combinations = []
    for (integrator, impratio), pads, amplitude, term, positions in product(
        SETTINGS[kind], PADS, AMPLITUDES_M, TERMS, POSITIONS
    ):
        usual = (kind, impratio, pads) == ("newton", AS_SHIPPED.impratio, "shipped")
        if quick and (not usual or amplitude == "10cm" or integrator == "rk4"):
            continue
        if integrator == "rk4" and "bias_centred" in TERMS[term]:
            continue
        case = replace(
            PADS[pads],
            name=f"{kind}-{integrator}-{impratio:g}-{pads}-{amplitude}-{term}-{positions}",
            shake_amplitude_m=AMPLITUDES_M[amplitude],
            integrator=integrator,
            impratio=impratio,
            **CONTACTS[kind],
            **TERMS[term],
            **POSITIONS[positions],
        )
        combinations.append(case)
    # these cases join the batches of other cases
    if kind == "newton" and kf_is_read():
        stem = f"newton-{AS_SHIPPED.integrator}-{AS_SHIPPED.impratio:g}-shipped"
        for shake, amplitude_m in AMPLITUDES_M.items():
            if not (quick and shake == "10cm"):
                name = f"{stem}-{shake}-kf-off"
                combinations.append(
                    replace(
                        AS_SHIPPED,
                        name=name,
                        shake_amplitude_m=amplitude_m,
                        pad_kf=-1.0,
                    )
                )
    return combinations


def measure(conditions: Conditions, variants: Sequence[Case]) -> list[dict]:
    """Return a row for each case."""
    shakes = dict.fromkeys(shake_of(case) for case in variants)
    # MuJoCo's C engine runs on the CPU. Each run has its own process, in parallel with
    # the GPU and the other runs.
    frame_count = conditions.frame_count(AS_SHIPPED.frame_count)
    moved = [
        replace(
            PADS[pads], shake_amplitude_m=AMPLITUDES_M[shake], frame_count=frame_count
        )
        for pads, shake in shakes
    ]
    with processes(len(moved)) as pool:
        waiting = start(pool, measure_motion, [(case,) for case in moved])
        traces = conditions.simulate(variants, title="cure")
        motions = dict(zip(shakes, gather(waiting, "cure, in C"), strict=True))
    return [
        row_of(case, trace, motions[shake_of(case)])
        for case, trace in zip(variants, traces, strict=True)
    ]


def shake_of(case: Case) -> tuple[str, str]:
    """Return the pads and the amplitude of a case, as in its name."""
    _, _, _, pads, shake, *_ = case.name.split("-")
    return pads, shake


def row_of(case: Case, trace: Trace, motion: Motion) -> dict[str, object]:
    """Return the row of a run: its slip and the predicted parts in the TCP frame.

    The y axis of the TCP frame is perpendicular to the pads, so that only x and z are
    kept.
    """
    pads, shake = shake_of(case)
    row = {
        "kind": "run",
        **summarize(case, trace),
        "pads": pads,
        "shake": shake,
        "contact_bias": case.contact_bias,
    }
    parts = predicted_mm(case, motion)
    vectors = {**parts, "predicted": sum(parts.values())}
    row |= cells(
        {
            name: value
            for term, mm in vectors.items()
            for name, value in along(term, mm)
        },
        motion.failure,
    )
    reason = row.get(f"{SHAKE_COLUMNS[0]}_reason")
    slip = (
        np.full(3, np.nan) if reason else 1e3 * metrics.displacement(trace).vector_m[-1]
    )
    row |= cells(dict(along("slip", slip)), reason)
    remainder = float(
        np.linalg.norm((slip - vectors["predicted"])[list(ALONG.values())])
    )
    return row | cells({"remainder_mm": remainder}, reason or motion.failure)


def along(name: str, vector: np.ndarray) -> list[tuple[str, float]]:
    """Return the columns for a vector [mm] in the TCP frame, shape [3]."""
    return [(f"{name}_{axis}_mm", float(vector[at])) for axis, at in ALONG.items()]


def cells(columns: dict[str, object], reason: str | None) -> dict[str, object]:
    """Return the columns. They have no values if there is a ``reason``."""
    return absent(columns, reason) if reason else columns
