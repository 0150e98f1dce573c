"""The acceleration that contact rows leave out: how much slide it predicts, and what happens once it is put back."""

from dataclasses import replace

import mujoco
import numpy as np
import warp as wp

from experiments.facts import metrics
from experiments.facts.case import Case
from experiments.facts.trace import Trace
from experiments.simulation.budget import contact_timeconst_s
from experiments.simulation.contact_bias_c import velocity_product
from experiments.simulation.measurement import SETUP_FRAME_COUNT, absent
from experiments.simulation.simulation import Simulation

MOTION = ("slide_mm", "along_mm", "slip_mm", "drift_mm_s")
TWO_PERIODS_FRAME_COUNT = SETUP_FRAME_COUNT + 241
"""The set-up and 4 s of shake: with its parts at f, 2f and 1.5f the shake repeats every two cycles."""


def predicted_row(case: Case) -> dict[str, object]:
    """Say how much slide the term would give that the engine's contact rows leave out, next to the slide that they
    show.

    A contact row sets the acceleration J q̈ to -b v, where v is the sliding velocity and b = 2 / (dmax timeconst)
    (MuJoCo documentation, "Computation", constraint model). The contact's real acceleration is J q̈ + J̇ q̇. Where the
    cube stays with the pads that is near zero, which leaves v = J̇ q̇ / b. J̇ comes from MuJoCo's ``mj_jacDot`` in a run
    through MuJoCo C.
    """
    simulation = _in_c(case)
    bias = np.zeros(TWO_PERIODS_FRAME_COUNT)
    for frame in range(TWO_PERIODS_FRAME_COUNT):
        simulation.step()
        bias[frame] = mean_along_shake_m_s2(simulation)
    trace = _trace(simulation)
    slide_m_s = bias[trace.phase == metrics.SHAKE] * 0.5 * case.pad_dmax * contact_timeconst_s(case)
    row = {"case": f"{case.name}-missing-term", "kind": "missing-term", **_motion(trace)}
    return row | {"predicted_slide_mm": 1e3 * float(slide_m_s.sum() * trace.frame_dt)}


def restored_row(case: Case) -> dict[str, object]:
    """Return the same run with the term put back: every contact row asks for -b v - J̇ q̇."""
    simulation = _in_c(replace(case, contact_bias=True))
    for _ in range(TWO_PERIODS_FRAME_COUNT):
        simulation.step()
    return {"case": f"{case.name}-term-restored", "kind": "term-restored", "contact_bias": True} | _motion(
        _trace(simulation)
    )


def _in_c(case: Case) -> Simulation:
    return Simulation([replace(case, backend="mujoco", frame_count=TWO_PERIODS_FRAME_COUNT)], wp.get_device("cpu"))


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
    """Return J̇ q̇ of the cube against the pads along the shake's main axis, mean over the loaded contacts [m/s²]."""
    engine, data = simulation.solver.mj_model, simulation.solver.mj_data
    cube, now = simulation.recorder.cube_geom, _at_end_of_step(engine, data)
    found = []
    for contact in data.contact:
        if contact.efc_address >= 0 and data.efc_force[contact.efc_address] > 0.0 and cube in contact.geom:
            sign = 1.0 if contact.geom[1] == cube else -1.0
            found.append(sign * metrics.MAIN_AXIS @ velocity_product(engine, now, contact)[0])
    return float(np.mean(found)) if found else 0.0


def _at_end_of_step(engine: mujoco.MjModel, data: mujoco.MjData) -> mujoco.MjData:
    """Return the same state with the kinematics that belong to it: after a step ``data`` still has those of its
    beginning."""
    now = mujoco.MjData(engine)
    now.qpos[:], now.qvel[:] = data.qpos, data.qvel
    mujoco.mj_kinematics(engine, now)
    mujoco.mj_comPos(engine, now)
    mujoco.mj_comVel(engine, now)
    return now
