"""The law of the drift: what each run of section stiffness is predicted to drift, from the arm's motion alone.

The parts are those of ``budget``, each as the slope of its sum over the shake, which is what the drift is of the cube's
displacement. They are taken from one run of the shake through MuJoCo's C engine with the term put back, so that no
slide of any pads is in them; nothing is fitted. Rounding of positions is no part of it: it is taken out of the runs.
"""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import warp as wp

from experiments import metrics, stiffness
from experiments.beside import gather, processes, start
from experiments.budget import Watch, friction_timeconst_s
from experiments.case import AS_SHIPPED, Case
from experiments.cure import POSITIONS
from experiments.measurement import Conditions, Measurement, summarize
from experiments.simulation import Simulation
from experiments.task import FRAME_RATE

SUMS = ("left_out", "damping", "load")
"""∫ g dt, ∫ e dt and ∫ R f dt, as ``budget`` has them."""


def measure(conditions: Conditions) -> Measurement:
    """A row for each case of section stiffness: its parts, their sum, and how far it drifts once rounding takes nothing
    from its positions."""
    shaken = replace(AS_SHIPPED, frame_count=conditions.frame_count(AS_SHIPPED.frame_count))
    cases = [replace(case, **POSITIONS["kept"]) for case in stiffness.cases(conditions.profile)]
    with processes(1) as pool:
        waiting = start(pool, measure_slopes, [(shaken,)])
        traces = conditions.simulate(cases, title="drift_law")
        [(slopes, inverse_mass_1_kg)] = gather(waiting, "drift_law, in C")
    return Measurement(
        [
            summarize(case, trace) | predicted_columns(case, slopes, inverse_mass_1_kg)
            for case, trace in zip(cases, traces, strict=True)
        ]
    )


def measure_slopes(case: Case) -> tuple[dict[str, float], float]:
    """Slope of each of SUMS along the shake's main axis [m/s²], and the inverse mass of ``budget.Motion`` [1/kg]."""
    case = replace(case, backend="mujoco", contact_bias=True, bias_centred=True)
    simulation = Simulation([case], wp.get_device("cpu"))
    watch = Watch(simulation)
    step = simulation.solver._mujoco.mj_step
    simulation.solver._mujoco = SimpleNamespace(mj_step=lambda engine, data: watch.step(step, engine, data))
    frames = np.zeros((case.frame_count, len(SUMS), 3))
    for frame in range(case.frame_count):
        watch.sums[:] = 0.0
        simulation.step()
        frames[frame] = watch.sums[: len(SUMS)]
    [trace] = simulation.recorder.traces(simulation.frame_dt, case.frame_count, wall_s=0.0)
    shaking = np.flatnonzero(trace.phase == metrics.SHAKE)
    frames[: shaking[0] + 1] = 0.0  # the displacement counts from the end of the first
    poses = trace.poses[shaking[0]].astype(float)
    along = frames.cumsum(axis=0)[shaking] @ metrics.rotate_inverse(poses[metrics.TCP, 3:], metrics.MAIN_AXIS)
    slopes = np.polyfit(trace.frame_dt * np.arange(len(shaking)), along, 1)[0]
    return dict(zip(SUMS, map(float, slopes), strict=True)), watch.inverse_mass_1_kg


def predicted_columns(case: Case, slopes: dict[str, float], inverse_mass_1_kg: float) -> dict[str, object]:
    """What a case of section stiffness is predicted to drift, and what time its friction rows take to respond."""
    h = 1.0 / FRAME_RATE / case.substeps
    response_s = case.pad_dmax * friction_timeconst_s(case, h, inverse_mass_1_kg)
    parts = {
        "left_out": 0.5 * response_s * slopes["left_out"],
        "step": -0.5 * h * slopes["left_out"],
        "damping": 0.5 * response_s * slopes["damping"],
        "creep": -0.5 * response_s * slopes["load"],
    }
    columns: dict[str, object] = {"pad_ke": case.pad_ke, "pad_kd": case.pad_kd, "response_s": response_s}
    columns |= {f"{name}_mm_s": 1e3 * part for name, part in parts.items()}
    return columns | {"predicted_drift_mm_s": 1e3 * sum(parts.values())}
