"""Compute how a shake affects the grasp, from the trace of any engine."""

import numpy as np

from experiments.facts import metrics
from experiments.facts.case import Case
from experiments.facts.trace import Trace
from measured_report.measuring.measurement import absent

# Columns of a trace.
FORCES = (
    "normal_force_n",
    "tangential_force_n",
    "penetration_m",
)
GRASP = ("creep_mm_per_cycle", "normal_force_n", "friction_share", "penetration_mm")


def mean_if_told(trace: Trace, name: str) -> float:
    """Return the mean of a column over the shake, or NaN if a frame has no value."""
    return trace.column(name)[trace.phase == metrics.SHAKE].mean()


def grasp_columns(
    case: Case, trace: Trace, more: dict[str, float], untold: str, mean=mean_if_told
) -> dict[str, object]:
    """Return the creep, the means over the shake, and the columns in ``more``.

    ``untold`` is the reason for columns that are NaN.
    """
    moved = metrics.displacement(trace)
    creep_mm = metrics.cycle_drift_mm(moved, case.shake_frequency_hz)
    normal_n, tangential_n, depth_m = (mean(trace, name) for name in FORCES)
    share = tangential_n / (case.pad_mu * normal_n) if normal_n > 0.0 else np.nan
    means = map(float, (creep_mm, normal_n, share, 1e3 * depth_m))
    columns = dict(zip(GRASP, means, strict=True)) | more
    nan_names = [name for name, value in columns.items() if not np.isfinite(value)]
    return columns | absent(nan_names, untold)
