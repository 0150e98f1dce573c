"""When a run of section stability passes: judged from what was measured of it, and of the others of its family.

A stable run that lacks a number by which it is judged is not judged.
"""

from collections.abc import Callable, Sequence

import numpy as np

from measured_report.values.quantities import Quantity
from measured_report.values.results import Row
from report.sections.stability.classes import is_stable

Passing = list[bool | None]
"""True, False or, where nothing is asked of a row, None for each."""

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


def passing(rows: Sequence[Row]) -> Passing:
    """Which rows of one family pass; rows that are judged by each other must all be among them."""
    whole = [row for row in rows if all(cell.value is not None for cell in judged_by(row))]
    verdicts = dict(zip(whole, FAMILIES[rows[0].family](whole), strict=True)) if rows else {}
    return [verdicts.get(row) for row in rows]


def judged_by(row: Row) -> list[Quantity]:
    """The numbers that decide whether a run passes; one that is not stable is judged by how it ended."""
    return [row[column] for column in JUDGED_BY.get(row.family, ()) if is_stable(row)]


def passed(rows: Sequence[Row]) -> list[Row]:
    return [row for row, passes in zip(rows, passing(rows), strict=True) if passes]


def _steps(rows: Sequence[Row]) -> Passing:
    """Stable, and the drift near to that with the smallest step."""
    by_step = sorted(rows, key=lambda row: row.substeps.value)
    converged = {row.pads: row.drift_mm_s.value for row in by_step}

    def passes(row: Row) -> bool:
        last = converged[row.pads]
        return is_stable(row) and last is not None and _is_near(row.drift_mm_s.value, last)

    return [passes(row) for row in rows]


def _critical(rows: Sequence[Row]) -> Passing:
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

    return [passes(row) for row in rows]


def _kd_100(rows: Sequence[Row]) -> Passing:
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

    return [passes(row) for row in rows]


def explicit_margin(ke: float, kd: float, step_s: float) -> float:
    """(dt² ke + 2 dt kd) / 4: below 1 the semi-implicit Euler step of x'' = -ke x - kd x' is stable.

    The step's matrix has determinant 1 - dt kd and trace 2 - dt kd - dt² ke; both roots lie in the unit circle when
    dt² ke + 2 dt kd < 4 (Jury's criterion).
    """
    return (step_s**2 * ke + 2.0 * step_s * kd) / 4.0


def _clamp(rows: Sequence[Row]) -> Passing:
    """All runs of one way pass when some of them fail and some do not: the failure has been found."""
    found: dict[str, set[bool]] = {}
    for row in rows:
        found.setdefault(row.clamp, set()).add(is_stable(row))
    return [len(found[row.clamp]) == 2 for row in rows]


def _load(rows: Sequence[Row]) -> Passing:
    """Held well below what friction can carry, dropped well above."""
    low, high = near_limit()

    def passes(row: Row) -> bool | None:
        load = row.load.value
        if load is None:
            return False
        if load < low:
            return is_stable(row)
        return row["class"] == "dropped" if load > high else None

    return [passes(row) for row in rows]


def near_limit() -> tuple[float, float]:
    """Between these shares of what friction can carry nothing is asked."""
    return 1.0 - 0.01 * LIMIT_MARGIN, 1.0 + 0.01 * LIMIT_MARGIN


def _friction(rows: Sequence[Row]) -> Passing:
    """Finite, and dropped where there is no friction."""
    return [row.finite and (row.pad_mu.value > 0.0 or row["class"] == "dropped") for row in rows]


def _mass(rows: Sequence[Row]) -> Passing:
    return [row.finite for row in rows]


def _size(rows: Sequence[Row]) -> Passing:
    """Stable, and not deep in the pads."""
    return [is_stable(row) and row.penetration_mm.value < 0.01 * DEPTH_LARGEST * row.cube_edge_mm.value for row in rows]


def _overlap(rows: Sequence[Row]) -> Passing:
    """Stable, and thrown out no faster than by an undamped spring."""
    return [is_stable(row) and row.exit_speed_mm_s.value <= row.exit_bound_mm_s.value for row in rows]


def _gravity(rows: Sequence[Row]) -> Passing:
    """Finite, and a cube that is let go gains no energy."""
    return [row.finite and not _gains_energy(row) for row in rows]


def _gains_energy(row: Row) -> bool:
    if not row.freed:
        return False
    first, last = row.freed_speed_first_mm_s.value, row.freed_speed_last_mm_s.value
    return last**2 > ENERGY_LARGEST * first**2


def _buffers(rows: Sequence[Row]) -> Passing:
    """The failure names the buffer that was too small; with ample room there is none."""

    def passes(row: Row) -> bool:
        if row.case == "buffers-ample":
            return is_stable(row)
        name = row.case.split("-")[1]
        return row.failure is not None and f"the {name} buffer" in row.failure

    return [passes(row) for row in rows]


def _long(rows: Sequence[Row]) -> Passing:
    """Stable, and creeping no faster in the end than in the beginning."""

    def passes(row: Row) -> bool:
        first, last = row.increment_first_mm_per_cycle.value, row.increment_last_mm_per_cycle.value
        return is_stable(row) and last <= GROWTH_LARGEST * first

    return [passes(row) for row in rows]


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
FAMILIES: dict[str, Callable[[Sequence[Row]], Passing]] = {
    "steps": _steps,
    "ke-critical": _critical,
    "ke-kd-100": _kd_100,
    "clamp": _clamp,
    "shake": _load,
    "grip": _load,
    "friction": _friction,
    "mass": _mass,
    "size": _size,
    "overlap": _overlap,
    "gravity": _gravity,
    "buffers": _buffers,
    "long": _long,
}
