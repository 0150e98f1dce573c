"""The cause, named; what ke and kd become in the contact that the solver has; and which of them holds the cube."""

from typing import Any

from experiments.facts.case import AS_SHIPPED
from measured_report.parts.claim import HOLDS, all_of
from measured_report.parts.section import Figure, Section
from measured_report.values.results import Results
from report.sections.stiffness import knobs
from report.sections.stiffness.cause import cause, drift_follows_timeconst, not_creep_under_load
from report.sections.stiffness.figures import draw_sweep
from report.sections.stiffness.runs import FIX, SHIPPED, Runs

order = 90
page = "cause"
reads = ("contacts", "hold", "noise", "reproduction")
leads = True
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
    alone, together = knobs.ke_alone_does_not_help(results, runs), knobs.together_they_hold(results)
    numbers: dict[str, Any]
    numbers = {"shipped": results.row[SHIPPED].slip_mm, "fix": results.row[FIX].slip_mm, "clamp": clamp}
    numbers["is_so"] = all_of(alone.outcome, together.outcome) == HOLDS
    sweep = Figure(lambda: draw_sweep(runs, clamp.value), [row.slip_mm for row in runs.held], numbers)
    return Section(
        figures={"sweep": sweep},
        claims=[
            cause(results, proportional),
            proportional,
            not_creep_under_load(results),
            knobs.ke_is_no_spring(results),
            alone,
            together,
            knobs.flat_below_clamp(results, runs, clamp),
        ],
    )
