"""When a run of section stability passes: judged from what was measured of it, and of the others of its family.

A stable run that lacks a number by which it is judged is not judged.
"""

from collections.abc import Sequence

import numpy as np

from experiments.facts import classes
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row

CLASSES = classes.CLASSES[::-1]
"""How a run ends, from the best to the worst."""
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


def is_stable(row: Row) -> bool:
    return row["class"] in classes.STABLE


def passing(rows: Sequence[Row]) -> list[bool | None]:
    """Judge the rows of one family, all of it where they are judged by each other; None where nothing is asked."""
    whole = [row for row in rows if all(cell.value is not None for cell in judged_by(row))]
    judge = TOGETHER.get(whole[0].family) if whole else None
    verdicts = dict(zip(whole, judge(whole) if judge else map(_passes_alone, whole), strict=True))
    return [verdicts.get(row) for row in rows]


def judged_by(row: Row) -> list[Quantity]:
    """Return the numbers that decide whether a run passes; one that is not stable is judged by how it ended, and by
    what says how it should end."""
    measured = JUDGED_BY.get(row.family, ()) if is_stable(row) else ()
    return [row[column] for column in (*SET.get(row.family, ()), *measured)]


def passed(rows: Sequence[Row]) -> list[Row]:
    return [row for row, passes in zip(rows, passing(rows), strict=True) if passes]


def _steps(rows: Sequence[Row]) -> list[bool | None]:
    last = {row.pads: row.drift_mm_s.value for row in sorted(rows, key=lambda row: row.substeps.value)}
    return [
        is_stable(row) and last[row.pads] is not None and _is_near(row.drift_mm_s.value, last[row.pads]) for row in rows
    ]


def _critical(rows: Sequence[Row]) -> list[bool | None]:
    """Ask that a run is finite, and where the clamp is at work nearly as deep in the pads as the other clamped cells of
    the same step: the clamp predicts the same stiffness for them all."""
    depths: dict[int, list[float]] = {}
    for row in rows:
        if row.clamped and is_stable(row):
            depths.setdefault(row.substeps.value, []).append(row.penetration_mm.value)
    plateau = {substeps: float(np.median(found)) for substeps, found in depths.items()}
    return [
        is_stable(row) and _is_near(row.penetration_mm.value, plateau[row.substeps.value])
        if row.clamped
        else row.finite
        for row in rows
    ]


def _kd_100(rows: Sequence[Row]) -> list[bool | None]:
    """Ask that a run is stable where the explicit bound says so with the factor to spare, and not stable where it is
    exceeded as much. A contact too soft to hold the cube at any step says nothing of the step."""
    held = {row.pad_ke.value for row in rows if is_stable(row)}

    def passes(row: Row) -> bool | None:
        margin = explicit_margin(row.pad_ke.value, row.pad_kd.value, 1e-3 * row.step_ms.value)
        if margin > NEAR_FACTOR:
            return not is_stable(row)
        return is_stable(row) if margin < 1.0 / NEAR_FACTOR and row.pad_ke.value in held else None

    return list(map(passes, rows))


def explicit_margin(ke: float, kd: float, step_s: float) -> float:
    """Return (dt² ke + 2 dt kd) / 4: below 1 the semi-implicit Euler step of x'' = -ke x - kd x' is stable.

    The step's matrix has determinant 1 - dt kd and trace 2 - dt kd - dt² ke; both roots lie in the unit circle when
    dt² ke + 2 dt kd < 4 (Jury's criterion).
    """
    return (step_s**2 * ke + 2.0 * step_s * kd) / 4.0


def _clamp(rows: Sequence[Row]) -> list[bool | None]:
    """Let all runs of one way pass when some of them fail and some do not: the failure has been found."""
    found = {(row.clamp, is_stable(row)) for row in rows}
    return [{(row.clamp, True), (row.clamp, False)} <= found for row in rows]


def _passes_alone(row: Row) -> bool | None:
    match row.family:
        case "shake" | "grip":  # held well below what friction can carry, dropped well above
            (low, high), load = near_limit(), row.load.value
            if load is None or load > high:
                return load is not None and row["class"] == "dropped"
            return is_stable(row) if load < low else None
        case "friction":
            return row.finite and (row.pad_mu.value > 0.0 or row["class"] == "dropped")
        case "size":
            return is_stable(row) and row.penetration_mm.value < 0.01 * DEPTH_LARGEST * row.cube_edge_mm.value
        case "overlap":  # thrown out no faster than by an undamped spring
            return is_stable(row) and row.exit_speed_mm_s.value <= row.exit_bound_mm_s.value
        case "gravity" if row.finite and row.freed:  # a cube that is let go gains no energy
            return row.freed_speed_last_mm_s.value**2 <= ENERGY_LARGEST * row.freed_speed_first_mm_s.value**2
        case "buffers" if row.case == "buffers-ample":
            return is_stable(row)
        case "buffers":  # the failure names the buffer that was too small
            return row.failure is not None and f"the {row.case.split('-')[1]} buffer" in row.failure
        case "long":  # creeps no faster in the end than in the beginning
            first, last = row.increment_first_mm_per_cycle.value, row.increment_last_mm_per_cycle.value
            return is_stable(row) and last <= GROWTH_LARGEST * first
        case "mass" | "gravity":
            return row.finite
    raise LookupError(f"nothing says when a run of {row.family} passes")


def near_limit() -> tuple[float, float]:
    """Return the shares of what friction can carry between which nothing is asked."""
    return 1.0 - 0.01 * LIMIT_MARGIN, 1.0 + 0.01 * LIMIT_MARGIN


def _is_near(value: float, other: float) -> bool:
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
SET = {"ke-kd-100": ("pad_ke", "pad_kd", "step_ms")}
TOGETHER = {"steps": _steps, "ke-critical": _critical, "ke-kd-100": _kd_100, "clamp": _clamp}
"""Families whose rows are judged by each other."""
