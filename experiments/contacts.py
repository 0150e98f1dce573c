"""The solver's live contact rows in the middle of the shake, as shipped and with stiff pads."""

from dataclasses import replace

import mujoco
import numpy as np
import warp as wp
from tqdm import tqdm

from experiments import metrics
from experiments.case import AS_SHIPPED, STIFF_PADS, Case
from experiments.measurement import SETUP_FRAME_COUNT, Conditions, Measurement, grasp_columns, summarize
from experiments.simulation import Simulation
from experiments.trace import ContactRows

ROW_NAMES = ("normal", "friction 1", "friction 2")
MISSING_TERM = ("predicted_slide_mm", "slide_mm", "along_mm")
MISSING_TERM_FRAME_COUNT = SETUP_FRAME_COUNT + 241
"""The set-up and 4 s of shake: with its parts at f, 2f and 1.5f the shake repeats every two cycles."""


def measure(conditions: Conditions) -> Measurement:
    """Rows of four kinds: contacts of a frame, rows of one contact, slide over the run, and what explains it."""
    cases = (AS_SHIPPED, STIFF_PADS)
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
    rows += [missing_term_row(case) for case in cases]
    return Measurement(rows, tables)


def missing_term_row(case: Case) -> dict[str, object]:
    """How much slide the term would give that the engine's contact rows leave out, next to the slide that they show.

    A contact row sets the acceleration J q̈ to -b v, where v is the sliding velocity and b = 2 / (dmax timeconst)
    (MuJoCo documentation, "Computation", constraint model). The contact's real acceleration is J q̈ + J̇ q̇. Where the
    cube stays with the pads that is near zero, which leaves v = J̇ q̇ / b. J̇ comes from MuJoCo's ``mj_jacDot`` in a run
    through MuJoCo C over two full periods of the shake.
    """
    case = replace(case, name=f"{case.name}-missing-term", backend="mujoco", frame_count=MISSING_TERM_FRAME_COUNT)
    simulation = Simulation([case], wp.get_device("cpu"))
    bias = np.zeros(case.frame_count)
    for frame in tqdm(range(case.frame_count), desc=case.name, unit="frame", delay=3.0):
        simulation.step()
        bias[frame] = velocity_product_m_s2(simulation)
    [trace] = simulation.recorder.traces(simulation.frame_dt, case.frame_count, wall_s=0.0)
    row = {"case": case.name, "kind": "missing-term"}
    if trace.failure or trace.phase[-1] != metrics.SHAKE:
        reason = str(trace.failure or "the shake was never reached")
        return row | dict.fromkeys(MISSING_TERM) | {f"{name}_reason": reason for name in MISSING_TERM}
    timeconst_s = max(2.0 / case.pad_kd, 2.0 * simulation.substep_dt)
    slide_m_s = bias[trace.phase == metrics.SHAKE] * 0.5 * case.pad_dmax * timeconst_s
    along_m = metrics.displacement(trace).along_m[-1]
    numbers = 1e3 * float(slide_m_s.sum() * trace.frame_dt), metrics.slide_mm(trace), 1e3 * float(along_m)
    return row | dict(zip(MISSING_TERM, numbers, strict=True))


def velocity_product_m_s2(simulation: Simulation) -> float:
    """J̇ q̇ of the cube against the pads along the shake's main axis, mean over the loaded contacts [m/s²]."""
    engine, data = simulation.solver.mj_model, simulation.solver.mj_data
    cube = simulation.recorder.cube_geom
    found = []
    for contact in data.contact:
        if contact.efc_address < 0 or data.efc_force[contact.efc_address] <= 0.0 or cube not in contact.geom:
            continue
        other = contact.geom[0] if contact.geom[1] == cube else contact.geom[1]
        of_cube, of_pad = np.zeros((2, 3, engine.nv))
        mujoco.mj_jacDot(engine, data, of_cube, None, contact.pos, engine.geom_bodyid[cube])
        mujoco.mj_jacDot(engine, data, of_pad, None, contact.pos, engine.geom_bodyid[other])
        found.append(metrics.MAIN_AXIS @ (of_cube - of_pad) @ data.qvel)
    return float(np.mean(found)) if found else 0.0


def constraint_rows(case: str, contacts: ContactRows) -> list[dict[str, object]]:
    """The three rows of the contact that carries most force."""
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
    """Every live contact of a frame, a row each."""
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
