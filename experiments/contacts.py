"""Measure the solver's contact rows in the middle of the shake.

The rows are measured in the scene as shipped and with stiff pads. The section also
predicts the slide from the acceleration that the rows ignore, and measures the slide
when this acceleration is restored.
"""

from collections.abc import Sequence
from dataclasses import replace

import mujoco
import numpy as np
import warp as wp

from contact_bias_c import velocity_product
from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, STIFF_PADS, Case
from experiments.facts.trace import ContactRows, Trace
from experiments.simulation.budget import contact_timeconst_s
from experiments.simulation.measurement import (
    SETUP_FRAME_COUNT,
    Conditions,
    grasp_columns,
    summarize,
)
from experiments.simulation.simulation import Simulation
from measured_report.measuring.measurement import Measurement, absent
from measured_report.measuring.pool import gather, processes, start

ROW_NAMES = ("normal", "friction 1", "friction 2")
DOUBLE_STEP = replace(AS_SHIPPED, name="double-step", substeps=AS_SHIPPED.substeps // 2)
MOTION = ("slide_mm", "along_mm", "slip_mm", "drift_mm_s")
TWO_PERIODS_FRAME_COUNT = SETUP_FRAME_COUNT + 241
"""Frames of the set-up and of 4 s of the shake.

The shake has parts at f, 2f and 1.5f, so that it repeats every two cycles.
"""


def measure(conditions: Conditions) -> Measurement:
    """Return rows of five kinds.

    They describe the contacts of a frame, the rows of a contact, the slide of a run,
    the predicted slide, and the slide with the term restored.
    """
    cases = (AS_SHIPPED, STIFF_PADS)
    # MuJoCo's C engine runs on the CPU. Each run has its own process, in parallel with
    # the GPU and the other runs.
    restored = (*cases, DOUBLE_STEP)
    with processes(len(cases) + len(restored)) as pool:
        waiting = start(pool, predicted_row, [(case,) for case in cases])
        waiting += start(pool, restored_row, [(case,) for case in restored])
        measurement = measure_live(conditions, cases)
        in_c = gather(waiting, "contacts, in C")
    return replace(measurement, rows=[*measurement.rows, *in_c])


def measure_live(conditions: Conditions, cases: Sequence[Case]) -> Measurement:
    """Return the live contacts of each case and the sum of their velocities."""
    traces = conditions.simulate(
        cases, contact_frames=conditions.contact_frames(), title="contacts"
    )
    rows = []
    tables = {}
    for case, trace in zip(cases, traces, strict=True):
        for contacts in trace.contact_rows:
            rows.append(
                {
                    "case": case.name,
                    "kind": "frame",
                    "frame": contacts.frame,
                    **grasp_columns(contacts),
                }
            )
        middle = trace.contact_rows[len(trace.contact_rows) // 2]
        rows += constraint_rows(case.name, middle)
        tables[case.name] = contact_table(middle)
        rows.append(
            {
                "kind": "run",
                **summarize(case, trace),
                "slide_mm": metrics.slide_mm(trace),
                "along_mm": 1e3 * float(metrics.displacement(trace).along_m[-1]),
                "cone_use_max": float(
                    trace.column("cone_use")[trace.phase == metrics.SHAKE].max()
                ),
            }
        )
    return Measurement(rows, tables)


def constraint_rows(case: str, contacts: ContactRows) -> list[dict[str, object]]:
    """Return the three rows of the contact with the largest force."""
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
    """Return a table with a row for each live contact in a frame."""
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


def predicted_row(case: Case) -> dict[str, object]:
    """Return the slide predicted from the ignored term, and the actual slide.

    A contact row sets the acceleration J q̈ to -b v, where v is the sliding velocity
    and b = 2 / (dmax timeconst) (MuJoCo documentation, "Computation", constraint
    model). The real acceleration of the contact is J q̈ + J̇ q̇. It is near zero while
    the cube stays with the pads, so that v = J̇ q̇ / b. J̇ is computed by MuJoCo's
    ``mj_jacDot`` in a run with the C engine.
    """
    simulation = _in_c(case)
    bias = np.zeros(TWO_PERIODS_FRAME_COUNT)
    for frame in range(TWO_PERIODS_FRAME_COUNT):
        simulation.step()
        bias[frame] = mean_along_shake_m_s2(simulation)
    trace = _trace(simulation)
    slide_m_s = (
        bias[trace.phase == metrics.SHAKE]
        * 0.5
        * case.pad_dmax
        * contact_timeconst_s(case)
    )
    row = {
        "case": f"{case.name}-missing-term",
        "kind": "missing-term",
        **_motion(trace),
    }
    return row | {"predicted_slide_mm": 1e3 * float(slide_m_s.sum() * trace.frame_dt)}


def restored_row(case: Case) -> dict[str, object]:
    """Return the same run with the term restored, so that the rows set -b v - J̇ q̇."""
    simulation = _in_c(replace(case, contact_bias=True))
    for _ in range(TWO_PERIODS_FRAME_COUNT):
        simulation.step()
    return {
        "case": f"{case.name}-term-restored",
        "kind": "term-restored",
        "contact_bias": True,
    } | _motion(_trace(simulation))


def _in_c(case: Case) -> Simulation:
    return Simulation(
        [replace(case, backend="mujoco", frame_count=TWO_PERIODS_FRAME_COUNT)],
        wp.get_device("cpu"),
    )


def _trace(simulation: Simulation) -> Trace:
    return simulation.recorder.traces()[0]


def _motion(trace: Trace) -> dict[str, object]:
    if trace.failure or trace.phase[-1] != metrics.SHAKE:
        return absent(MOTION, str(trace.failure or "the shake was never reached"))
    moved = metrics.displacement(trace)
    return {
        "slide_mm": metrics.slide_mm(trace),
        "along_mm": 1e3 * float(moved.along_m[-1]),
        "slip_mm": metrics.slip_mm(moved),
        "drift_mm_s": metrics.drift_mm_s(moved),
    }


def mean_along_shake_m_s2(simulation: Simulation) -> float:
    """Return J̇ q̇ of the cube relative to the pads along the main axis of the shake
    [m/s²]. This is the mean over the loaded contacts.
    """
    engine, data = simulation.solver.mj_model, simulation.solver.mj_data
    cube, now = simulation.recorder.cube_geom, _at_end_of_step(engine, data)
    found = []
    for contact in data.contact:
        if (
            contact.efc_address >= 0
            and data.efc_force[contact.efc_address] > 0.0
            and cube in contact.geom
        ):
            sign = 1.0 if contact.geom[1] == cube else -1.0
            found.append(
                sign * metrics.MAIN_AXIS @ velocity_product(engine, now, contact)[0]
            )
    return float(np.mean(found)) if found else 0.0


def _at_end_of_step(engine: mujoco.MjModel, data: mujoco.MjData) -> mujoco.MjData:
    """Return the same state with updated kinematics.

    After a step, ``data`` still contains the kinematics at the start of the step.
    """
    now = mujoco.MjData(engine)
    now.qpos[:], now.qvel[:] = data.qpos, data.qvel
    mujoco.mj_kinematics(engine, now)
    mujoco.mj_comPos(engine, now)
    mujoco.mj_comVel(engine, now)
    return now
