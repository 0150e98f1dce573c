"""The cause, named; what ke and kd become in the contact that the solver has; and which of them holds the cube."""

from collections.abc import Callable

from experiments.facts.case import AS_SHIPPED
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.sections.stiffness import knobs
from report.sections.stiffness.cause import cause, drift_follows_timeconst, not_creep_under_load
from report.sections.stiffness.figures import draw_law, draw_sweep
from report.sections.stiffness.runs import FIX, SHIPPED, Runs, drift_without_slide, is_held
from report.shared.arithmetic import Column, by_case

order = 90
page = "cause"
label = "pads' ke and kd"


def derive(results: Results) -> Section:
    plain = sorted((row for row in results.rows if "pad_dmax" not in row), key=lambda row: row.pad_ke.value)
    runs = Runs(
        named=[row for row in results.rows if not row.case.startswith("sweep-")],
        ke_alone=[row for row in plain if row.pad_kd.value == AS_SHIPPED.pad_kd],
        together=[row for row in plain if row.pad_kd.value != AS_SHIPPED.pad_kd or row.case == SHIPPED],
    )
    formula = "given by the scene: frame time over substeps"
    substep = results.value("substep", formula, lambda: 1 / 60 / AS_SHIPPED.substeps, unit="s")
    least = results.value("least_timeconst", "two substeps", lambda step: 2 * step, substep, unit="s")
    clamp = results.value("clamp_kd", "kd at which 2 / kd is two substeps", lambda shortest: 2 / shortest, least)
    proportional = drift_follows_timeconst(results, runs, least)
    columns = COLUMNS | {
        "1 − dmax": [results.value(f"give_{row.case}", "1 - dmax", lambda a: 1 - a, row.dmax) for row in runs.named]
    }
    numbers = {"shipped": results.row[SHIPPED].slip_mm, "fix": results.row[FIX].slip_mm, "clamp": clamp}
    sweep = Figure(lambda: draw_sweep(runs, clamp.value), [row.slip_mm for row in runs.held], numbers)
    has_rest = drift_without_slide(results).value is not None
    law = Figure(lambda: draw_law(runs, results), [row.drift_mm_s for row in runs.held], {"has_rest": has_rest})
    return Section(
        tables={"cases": by_case(runs.named, columns)},
        figures={"sweep": sweep, "law": law},
        claims=[
            cause(results, proportional),
            proportional,
            not_creep_under_load(results),
            knobs.ke_is_no_spring(results),
            knobs.ke_alone_does_not_help(results, runs),
            knobs.stiff_contact_still_slips(results),
            knobs.ke_alone_fails(results, runs),
            knobs.together_they_hold(results),
            knobs.flat_below_clamp(results, runs, clamp),
        ],
    )


def _of_held(column: str) -> Callable[[Row], Quantity | str]:
    """The contacts of a cube that was lost are with the ground."""
    return lambda row: row[column] if is_held(row) else ""


COLUMNS: dict[str, Column] = {
    **{"ke": "pad_ke", "kd": "pad_kd", "1 − dmax": (), "cube": lambda row: "held" if is_held(row) else "lost"},
    **{"slip": _of_held("slip_mm"), "drift": _of_held("drift_mm_s"), "timeconst": _of_held("timeconst_s")},
    **{"dampratio": _of_held("dampratio"), "depth": _of_held("penetration_mm")},
    **{"force": _of_held("normal_force_n"), "stiffness": _of_held("stiffness_n_m")},
}
