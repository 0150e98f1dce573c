"""Predict the drift of each run of section stiffness only from the motion of the arm.

The parts are the same as in ``budget``. The drift is the slope of the cube's
displacement over the shake, and each part is the slope of a sum. The sums are measured
in one run of the shake in MuJoCo's C engine with the term restored, so that they do not
contain any slide. No parameter is fitted. The prediction does not include the rounding
of positions, which is avoided in the compared runs.
"""

from dataclasses import dataclass, replace

import numpy as np

from experiments import stiffness
from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, POSITIONS, Case
from experiments.simulation.budget import Watched, friction_timeconst_s, softness
from experiments.simulation.limits import step_s
from experiments.simulation.measurement import (
    Conditions,
    Measurement,
    absent,
    summarize,
)
from measured_report.measuring.pool import gather, processes, start

PREDICTED = (
    "left_out_mm_s",
    "step_mm_s",
    "damping_mm_s",
    "creep_mm_s",
    "predicted_drift_mm_s",
)


@dataclass(frozen=True)
class Slopes:
    """The slopes of the sums in ``budget.Motion`` over the shake.

    The slopes are taken along the main axis of the shake [m/s²]. The other fields are
    needed for a prediction.
    """

    left_out: float
    damping: float
    load: float
    depth_m: float
    inverse_mass_1_kg: float
    failure: str | None = None


def measure(conditions: Conditions) -> Measurement:
    """Return a row for each case of section stiffness.

    It contains the predicted parts, their sum, and the measured drift without rounded
    positions.
    """
    shaken = replace(
        AS_SHIPPED, frame_count=conditions.frame_count(AS_SHIPPED.frame_count)
    )
    cases = [
        replace(case, **POSITIONS["kept"])
        for case in stiffness.cases(conditions.profile)
    ]
    with processes(1) as pool:
        waiting = start(pool, measure_slopes, [(shaken,)])
        traces = conditions.simulate(cases, title="drift_law")
        [slopes] = gather(waiting, "drift_law, in C")
    return Measurement(
        [
            summarize(case, trace) | predicted_columns(case, slopes)
            for case, trace in zip(cases, traces, strict=True)
        ]
    )


def measure_slopes(case: Case) -> Slopes:
    """Measure the slopes in one run of a case in MuJoCo's C engine."""
    run = Watched(case)
    if run.failure:
        return Slopes(*[np.nan] * 5, failure=run.failure)  # type: ignore[misc]  # mypy counts six values, but there are five
    frames = run.frames.copy()
    # The displacement is measured from the end of the first frame.
    frames[: run.shaking[0] + 1] = 0.0
    poses = run.trace.poses[run.shaking[0]].astype(float)
    along = frames.cumsum(axis=0)[run.shaking] @ metrics.rotate_inverse(
        poses[metrics.TCP, 3:], metrics.MAIN_AXIS
    )
    slopes = np.polyfit(run.trace.frame_dt * np.arange(len(run.shaking)), along, 1)[0]
    left_out, damping, load, _ = map(float, slopes)
    return Slopes(left_out, damping, load, run.depth_m, run.inverse_mass_1_kg)


def predicted_columns(case: Case, slopes: Slopes) -> dict[str, object]:
    """Return the predicted drift of a case and the response time of friction rows."""
    columns: dict[str, object] = {"pad_ke": case.pad_ke, "pad_kd": case.pad_kd}
    if slopes.failure:
        return columns | absent(("response_s", *PREDICTED), slopes.failure)
    response_s = case.pad_dmax * friction_timeconst_s(case, slopes.inverse_mass_1_kg)
    parts = (
        0.5 * response_s * slopes.left_out,
        -0.5 * step_s(case) * slopes.left_out,
        0.5 * response_s * slopes.damping,
        -0.5 * response_s * softness(case, AS_SHIPPED, slopes.depth_m) * slopes.load,
    )
    found = dict(
        zip(PREDICTED, (1e3 * part for part in (*parts, sum(parts))), strict=True)
    )
    return columns | {"response_s": response_s} | found
