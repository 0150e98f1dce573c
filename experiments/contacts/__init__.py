"""The solver's live contact rows in the middle of the shake, as shipped and with stiff pads."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from experiments.contacts.missing_term import predicted_row, restored_row
from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, STIFF_PADS, Case
from experiments.facts.trace import ContactRows
from experiments.simulation.measurement import Conditions, Measurement, grasp_columns, summarize
from measured_report.measuring.pool import gather, processes, start

ROW_NAMES = ("normal", "friction 1", "friction 2")
DOUBLE_STEP = replace(AS_SHIPPED, name="double-step", substeps=AS_SHIPPED.substeps // 2)


def measure(conditions: Conditions) -> Measurement:
    """Return rows of five kinds: contacts of a frame, rows of one contact, slide over the run, what explains it, the
    proof."""
    cases = (AS_SHIPPED, STIFF_PADS)
    # MuJoCo's C engine runs on the CPU: each run has a process of its own, beside the GPU and the others.
    restored = (*cases, DOUBLE_STEP)
    with processes(len(cases) + len(restored)) as pool:
        waiting = start(pool, predicted_row, [(case,) for case in cases])
        waiting += start(pool, restored_row, [(case,) for case in restored])
        measurement = measure_live(conditions, cases)
        in_c = gather(waiting, "contacts, in C")
    return replace(measurement, rows=[*measurement.rows, *in_c])


def measure_live(conditions: Conditions, cases: Sequence[Case]) -> Measurement:
    """Return the live contacts of each case, and what their velocities add up to."""
    traces = conditions.simulate(cases, contact_frames=conditions.contact_frames(), title="contacts")
    rows = []
    tables = {}
    for case, trace in zip(cases, traces, strict=True):
        for contacts in trace.contact_rows:
            rows.append({"case": case.name, "kind": "frame", "frame": contacts.frame, **grasp_columns(contacts)})
        middle = trace.contact_rows[len(trace.contact_rows) // 2]
        rows += constraint_rows(case.name, middle)
        tables[case.name] = contact_table(middle)
        rows.append(
            {
                "kind": "run",
                **summarize(case, trace),
                "slide_mm": metrics.slide_mm(trace),
                "along_mm": 1e3 * float(metrics.displacement(trace).along_m[-1]),
                "cone_use_max": float(trace.column("cone_use")[trace.phase == metrics.SHAKE].max()),
            }
        )
    return Measurement(rows, tables)


def constraint_rows(case: str, contacts: ContactRows) -> list[dict[str, object]]:
    """Return the three rows of the contact that carries most force."""
    strongest = int(contacts.force_n[:, 0].argmax())
    if contacts.force_n[strongest, 0] <= 0.0:
        return []
    return [
        {
            "case": case,
            "kind": "row",
            "frame": contacts.frame,
            "row": name,
            "pair": " / ".join(contacts.geom[strongest]),
            "residual_mm": 1e3 * float(contacts.residual_m[strongest, index]),
            "velocity_mm_s": 1e3 * float(contacts.velocity_m_s[strongest, index]),
            "force_n": float(contacts.force_n[strongest, index]),
        }
        for index, name in enumerate(ROW_NAMES)
    ]


def contact_table(contacts: ContactRows) -> dict[str, np.ndarray]:
    """Return every live contact of a frame, a row each."""
    return {
        "geom_1": contacts.geom[:, 0],
        "geom_2": contacts.geom[:, 1],
        "distance_mm": 1e3 * contacts.distance_m,
        "normal_force_n": contacts.force_n[:, 0],
        "tangential_force_n": np.linalg.norm(contacts.force_n[:, 1:], axis=1),
        "timeconst_s": contacts.solref[:, 0],
        "dampratio": contacts.solref[:, 1],
        "friction": contacts.friction,
        "slide_mm_s": 1e3 * contacts.slide_m_s,
    }
