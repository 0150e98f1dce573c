"""What a shake takes of the grasp, from the trace of any engine."""

import numpy as np

from experiments.facts import metrics
from experiments.facts.case import Case
from experiments.facts.trace import Trace
from measured_report.measuring.measurement import absent

FORCES = (
    "normal_force_n",
    "tangential_force_n",
    "penetration_m",
)  # in a trace's columns
GRASP = ("creep_mm_per_cycle", "normal_force_n", "friction_share", "penetration_mm")


def grasp_columns(
    case: Case, trace: Trace, more: dict[str, float], untold: str
) -> dict[str, object]:
    """Return the creep and means over the shake, with ``more``; ``untold`` is why one is NaN."""
    creep_mm = metrics.cycle_drift_mm(
        metrics.displacement(trace), case.shake_frequency_hz
    )
    is_shaken = trace.phase == metrics.SHAKE
    normal_n, tangential_n, depth_m = (
        float(trace.column(name)[is_shaken].mean()) for name in FORCES
    )
    share = tangential_n / (case.pad_mu * normal_n) if normal_n > 0.0 else np.nan
    means = (creep_mm, normal_n, share, 1e3 * depth_m)
    columns = dict(zip(GRASP, map(float, means), strict=True)) | more
    nan_names = [name for name, value in columns.items() if not np.isfinite(value)]
    return columns | absent(nan_names, untold)
