"""The box on the turning table, on a slope and on a table that stands still, with each of Newton's solvers.

A solver that has the velocity at the contact vanish at the end of each step of h, and moves by one end's velocity, has
the box walk by h/2 of the acceleration ω² r that a step bends its path by: dr/dt = ± r ω² h / 2, less the shorter the
step. What does not go with the step is something else.
"""

import numpy as np

from experiments.cure.turntable import SAMPLE_S, SETTLE_S, growth_per_s
from experiments.drivers.newton_solver import EXCUSED, Variant, name_of, run, solver_classes
from experiments.scenes.turntable import FOOT_M, TABLE, slope, still, turntable
from measured_report.measuring.measurement import Conditions, absent

STEPS_S = {"full": (0.002, 0.001), "quick": (0.002,)}
SECONDS = {"full": 4.0, "quick": 2.0}  # on the turning table
STANDING = {"slope": slope, "still": still}  # the table does not turn in these
STANDING_S = 2.0


def excused_rows() -> list[dict[str, object]]:
    """Make a row for each solver that is not measured, with the reason."""
    return [
        {"case": name_of(solver), "of": solver, "stays": None}
        | absent(["growth_per_s"], EXCUSED[solver])
        for solver in solver_classes()
        if solver in EXCUSED
    ]


def rows_of(conditions: Conditions, variant: Variant) -> list[dict[str, object]]:
    """Make a row for each scene and step, with the reason where a solver cannot run it."""
    steps_s = STEPS_S[conditions.profile]
    seconds = SECONDS[conditions.profile]
    scenes = {f"{1e3 * step_s:g}ms": turntable(step_s, seconds) for step_s in steps_s}
    scenes |= {end: stand(steps_s[0], STANDING_S) for end, stand in STANDING.items()}
    rows = []
    for end, scene in scenes.items():
        row = {
            "case": f"{variant.name}-{end}",
            "solver": variant.name,
            "of": variant.solver,
            "step_ms": 1e3 * scene.step_s,
        }
        number = "creep_mm_s" if end in STANDING else "growth_per_s"
        try:
            path_m = run(scene, variant, conditions.device).path_m
            rows.append(row | columns(number, path_m))
        except Exception as error:  # solvers need not know all that the scene has
            rows.append(row | {"stays": None} | absent([number], reason_of(error)))
    return rows


def reason_of(error: Exception) -> str:
    """Say in a line why a solver shows nothing."""
    return " ".join(str(error).split())[:120] or type(error).__name__


def columns(number: str, path_m: np.ndarray) -> dict[str, object]:
    """Tell whether the box stays on the table and how fast it walks outward or creeps."""
    if not np.isfinite(path_m).all():
        return {"stays": False} | absent([number], "a position is not finite")
    radius_m = np.hypot(*path_m[:, :2].T)
    is_up = abs(path_m[-1, 2] - path_m[0, 2]) < FOOT_M
    row: dict = {"stays": bool(is_up and radius_m[-1] < TABLE.half_size_m[0])}
    if number == "growth_per_s":
        return row | {number: growth_per_s(radius_m, SETTLE_S)}
    settled_m = path_m[round(SETTLE_S / SAMPLE_S) :, :2]
    time_s = SAMPLE_S * np.arange(len(settled_m))
    velocity_m_s = np.polyfit(time_s, settled_m, 1)[0]
    return row | {number: 1e3 * float(np.hypot(*velocity_m_s))}
