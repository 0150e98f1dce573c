"""Measure the references for the engine that runs in a page, with MuJoCo's C engine.

The references are the scene as MJCF and its cases. Newton builds the model, and
``mj_step`` runs it without Newton in double precision. The engine's midphase is off. It
uses bounding boxes that Newton does not update when it rotates the inertial frames of
the bodies, and therefore loses contacts between the pads and a cube that has sunk. One
row has the midphase on, to show this.
"""

from dataclasses import replace

import numpy as np
import warp as wp
from tqdm import tqdm

from experiments.facts import metrics
from experiments.facts.case import FIXED, LEAN, Case
from experiments.facts.classes import classify, creep_mm_s
from experiments.facts.trace import Trace
from experiments.lab.mjcf import mjcf_of
from experiments.simulation.measurement import (
    Conditions,
    Measurement,
    displacement_table,
    summarize,
)
from experiments.simulation.reference import DoubleShake
from experiments.simulation.simulation import Simulation

NEEDS_GPU = False
"""Tells ``measured_report.measuring.machine`` that a GPU is not needed.

The C engine runs on the CPU and is deterministic.
"""
TEXT_LENGTH = 4000
FAR_SHAKE_M = 0.1
WHOLE_CURE = {
    "contact_bias": True,
    "bias_centred": True,
    "integrator": "euler",
    "impratio": 1e3,
}  # type: dict
AS_SHIPPED, STIFF = replace(LEAN, name="as-shipped"), replace(FIXED, name="stiff-pads")
SHOWN = [
    AS_SHIPPED,
    STIFF,
    replace(LEAN, name="term", contact_bias=True),
    replace(LEAN, name="whole-cure", **WHOLE_CURE),
    *(
        replace(case, name=f"{case.name}-10cm", shake_amplitude_m=FAR_SHAKE_M)
        for case in (AS_SHIPPED, STIFF)
    ),
    replace(LEAN, name="cone-pyramidal", cone="pyramidal"),
    replace(LEAN, name="impratio-1", impratio=1.0),
    replace(LEAN, name="substeps-4", substeps=4),
    replace(LEAN, name="hold", shake_amplitude_m=0.0),
]
NEARBY = replace(LEAN, name="as-shipped-nearby", cube_offset_m=1e-6)
"""A case whose creep differs from the scene as shipped only by noise.

A creep below this difference cannot be distinguished from none.
"""
WITH_MIDPHASE = replace(LEAN, name="impratio-1-midphase", impratio=1.0)
CASES = [*SHOWN, NEARBY, WITH_MIDPHASE]


def measure(conditions: Conditions) -> Measurement:
    """Return the scene and a row for each case."""
    cases = [
        replace(case, frame_count=conditions.frame_count(case.frame_count))
        for case in CASES
    ]
    traces = {}
    for case in tqdm(cases, "lab", unit="run", delay=3.0):
        traces[case.name] = DoubleShake(
            case, has_midphase=case.name == WITH_MIDPHASE.name
        ).run()
    nearby, shipped = (
        creep_mm_s(case, traces[case.name]) for case in (NEARBY, AS_SHIPPED)
    )
    rows = [row_of(case, traces[case.name], abs(nearby - shipped)) for case in cases]
    tables = {case.name: displacement_table(traces[case.name]) for case in SHOWN}
    return Measurement([*scene_rows(), *rows], tables)


def row_of(case: Case, trace: Trace, floor_mm_s: float) -> dict[str, object]:
    """Return the metrics of a run and the class of its end."""
    row = summarize(case, trace) | {
        "backend": "mujoco-c",
        "class": classify(case, trace, floor_mm_s),
    }
    use = float(trace.column("cone_use")[trace.phase == metrics.SHAKE].max())
    return row | {
        "cone_use": use,
        "creep_floor_mm_s": floor_mm_s,
        "has_midphase": case.name == WITH_MIDPHASE.name,
    }


def scene_rows() -> list[dict[str, str]]:
    """Return the MJCF of the scene in consecutive parts.

    No part exceeds the length limit for a text in a record.
    """
    text = scene_mjcf()
    parts = [
        text[start : start + TEXT_LENGTH] for start in range(0, len(text), TEXT_LENGTH)
    ]
    return [
        {"case": f"scene-{number}", "mjcf": chunk}
        for number, chunk in enumerate(parts, start=1)
    ]


def scene_mjcf() -> str:
    """Return the scene as shipped with the TCP as a site.

    Parts that do not change the slip are left out.
    """
    simulation = Simulation([replace(LEAN, backend="mujoco")], wp.get_device("cpu"))
    link = simulation.scene.links["fr3_hand_tcp"]
    body = simulation.solver.mjc_body_to_newton.numpy()[0].tolist().index(link.body)
    pose = np.array(link.pose, dtype=float)
    sites = {"tcp": (body, np.concatenate([pose[:3], np.roll(pose[3:], 1)]))}
    return mjcf_of(simulation.solver.mj_model, sites)
