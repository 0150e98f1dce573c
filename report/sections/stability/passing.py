"""When a run of section stability passes: judged from what was measured of it, and of the others of its family.

A stable run that lacks a number by which it is judged is not judged.
"""

from collections.abc import Callable, Sequence

import numpy as np

from measured_report.values.quantities import Quantity
from measured_report.values.results import Row
from report.sections.stability.classes import is_stable

Judge = Callable[[Row], bool | None]
"""Tells whether a row passes; None where nothing is asked of it."""

DEPTH_LARGEST = 1.0
"""Depth in stiff pads, at most, in percent of the edge."""
GROWTH_LARGEST = 1.1
"""Creep per cycle at the end of the long run over that at its beginning, at most."""
ENERGY_LARGEST = 1.01
"""Energy of a freed cube at the end over that when the fingers had opened, at most."""
LIMIT_MARGIN = 10.0
"""So near to what friction can carry, in percent of it, nothing is asked."""
NEAR_FACTOR = 2.0
"""Numbers that are alike are no more than this factor apart."""


def passing(rows: Sequence[Row]) -> list[bool | None]:
    """Judge the rows of one family; rows that are judged by each other must all be among them."""
    whole = [row for row in rows if all(cell.value is not None for cell in judged_by(row))]
    if not whole:
        return [None] * len(rows)
    judge = ALONE.get(whole[0].family) or TOGETHER[whole[0].family](whole)
    verdicts = {row: judge(row) for row in whole}
    return [verdicts.get(row) for row in rows]


def judged_by(row: Row) -> list[Quantity]:
    """The numbers that decide whether a run passes; one that is not stable is judged by how it ended."""
    return [row[column] for column in JUDGED_BY.get(row.family, ()) if is_stable(row)]


def passed(rows: Sequence[Row]) -> list[Row]:
    return [row for row, passes in zip(rows, passing(rows), strict=True) if passes]


def _steps(rows: Sequence[Row]) -> Judge:
    """Stable, and the drift near to that with the smallest step."""
    converged = {row.pads: row.drift_mm_s.value for row in sorted(rows, key=lambda row: row.substeps.value)}

    def passes(row: Row) -> bool:
        last = converged[row.pads]
        return is_stable(row) and last is not None and _is_near(row.drift_mm_s.value, last)

    return passes


def _critical(rows: Sequence[Row]) -> Judge:
    """Finite, and where the clamp is at work nearly as deep in the pads as the other clamped cells of the same step:
    the clamp predicts the same stiffness for them all."""
    depths: dict[int, list[float]] = {}
    for row in rows:
        if row.clamped and is_stable(row):
            depths.setdefault(row.substeps.value, []).append(row.penetration_mm.value)
    plateau = {substeps: float(np.median(found)) for substeps, found in depths.items()}

    def passes(row: Row) -> bool:
        if not row.clamped:
            return row.finite
        return is_stable(row) and _is_near(row.penetration_mm.value, plateau[row.substeps.value])

    return passes


def _kd_100(rows: Sequence[Row]) -> Judge:
    """Stable where the explicit bound says so with the factor to spare, and not stable where it is exceeded as much. A
    contact too soft to hold the cube at any step says nothing of the step."""
    held = {row.pad_ke.value for row in rows if is_stable(row)}

    def passes(row: Row) -> bool | None:
        margin = explicit_margin(row.pad_ke.value, row.pad_kd.value, 1e-3 * row.step_ms.value)
        if margin > NEAR_FACTOR:
            return not is_stable(row)
        if margin >= 1.0 / NEAR_FACTOR or row.pad_ke.value not in held:
            return None
        return is_stable(row)

    return passes


def explicit_margin(ke: float, kd: float, step_s: float) -> float:
    """(dt² ke + 2 dt kd) / 4: below 1 the semi-implicit Euler step of x'' = -ke x - kd x' is stable.

    The step's matrix has determinant 1 - dt kd and trace 2 - dt kd - dt² ke; both roots lie in the unit circle when
    dt² ke + 2 dt kd < 4 (Jury's criterion).
    """
    return (step_s**2 * ke + 2.0 * step_s * kd) / 4.0


def _clamp(rows: Sequence[Row]) -> Judge:
    """All runs of one way pass when some of them fail and some do not: the failure has been found."""
    found = {(row.clamp, is_stable(row)) for row in rows}
    return lambda row: {(row.clamp, True), (row.clamp, False)} <= found


def _load(row: Row) -> bool | None:
    """Held well below what friction can carry, dropped well above."""
    low, high = near_limit()
    load = row.load.value
    if load is None:
        return False
    if load < low:
        return is_stable(row)
    return row["class"] == "dropped" if load > high else None


def near_limit() -> tuple[float, float]:
    """Between these shares of what friction can carry nothing is asked."""
    return 1.0 - 0.01 * LIMIT_MARGIN, 1.0 + 0.01 * LIMIT_MARGIN


def _friction(row: Row) -> bool:
    """Finite, and dropped where there is no friction."""
    return row.finite and (row.pad_mu.value > 0.0 or row["class"] == "dropped")


def _size(row: Row) -> bool:
    """Stable, and not deep in the pads."""
    return is_stable(row) and row.penetration_mm.value < 0.01 * DEPTH_LARGEST * row.cube_edge_mm.value


def _overlap(row: Row) -> bool:
    """Stable, and thrown out no faster than by an undamped spring."""
    return is_stable(row) and row.exit_speed_mm_s.value <= row.exit_bound_mm_s.value


def _gravity(row: Row) -> bool:
    """Finite, and a cube that is let go gains no energy."""
    if not (row.finite and row.freed):
        return row.finite
    return row.freed_speed_last_mm_s.value**2 <= ENERGY_LARGEST * row.freed_speed_first_mm_s.value**2


def _buffers(row: Row) -> bool:
    """The failure names the buffer that was too small; with ample room there is none."""
    if row.case == "buffers-ample":
        return is_stable(row)
    return row.failure is not None and f"the {row.case.split('-')[1]} buffer" in row.failure


def _long(row: Row) -> bool:
    """Stable, and creeping no faster in the end than in the beginning."""
    first, last = row.increment_first_mm_per_cycle.value, row.increment_last_mm_per_cycle.value
    return is_stable(row) and last <= GROWTH_LARGEST * first


def _is_near(value: float, other: float) -> bool:
    """Whether one is within the factor of the other, and on the same side of zero."""
    return value * other > 0.0 and abs(other) / NEAR_FACTOR <= abs(value) <= NEAR_FACTOR * abs(other)


JUDGED_BY = {
    "steps": ("drift_mm_s",),
    "ke-critical": ("penetration_mm",),
    "shake": ("load",),
    "grip": ("load",),
    "size": ("penetration_mm",),
    "overlap": ("exit_speed_mm_s", "exit_bound_mm_s"),
    "long": ("increment_first_mm_per_cycle", "increment_last_mm_per_cycle"),
}
TOGETHER: dict[str, Callable[[Sequence[Row]], Judge]] = {
    "steps": _steps,
    "ke-critical": _critical,
    "ke-kd-100": _kd_100,
    "clamp": _clamp,
}
"""Families whose rows are judged by each other."""
ALONE: dict[str, Judge] = {
    **{"shake": _load, "grip": _load, "friction": _friction, "mass": lambda row: row.finite, "size": _size},
    **{"overlap": _overlap, "gravity": _gravity, "buffers": _buffers, "long": _long},
}
