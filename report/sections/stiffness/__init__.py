"""The cause, named; what ke and kd become in the contact that the solver has; and which of them holds the cube."""

from collections.abc import Iterable, Mapping, Sequence

from experiments.facts.case import AS_SHIPPED
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.sections.stiffness.cause import cause, drift_follows_timeconst, not_creep_under_load
from report.sections.stiffness.figures import draw_law, draw_sweep
from report.sections.stiffness.knobs import knob_claims
from report.sections.stiffness.runs import FIX, SHIPPED, Runs, drift_without_slide, is_held
from report.shared.arithmetic import by_case

order = 90
page = "cause"
label = "pads' ke and kd"


def derive(results: Results) -> Section:
    plain = [row for row in results.rows if "pad_dmax" not in row]
    runs = Runs(
        named=[row for row in results.rows if not row.case.startswith("sweep-")],
        ke_alone=_by_ke(row for row in plain if row.pad_kd.value == AS_SHIPPED.pad_kd),
        together=_by_ke(row for row in plain if row.pad_kd.value != AS_SHIPPED.pad_kd or row.case == SHIPPED),
    )
    substep = results.value(
        "substep", "given by the scene: frame time over substeps", lambda: 1 / 60 / AS_SHIPPED.substeps, unit="s"
    )
    least = results.value("least_timeconst", "two substeps", lambda step: 2 * step, substep, unit="s")
    clamp = results.value("clamp_kd", "kd at which 2 / kd is two substeps", lambda shortest: 2 / shortest, least)
    proportional = drift_follows_timeconst(results, runs, least)
    give = {
        row.case: results.value(f"give_{row.case}", "1 - dmax", lambda dmax: 1 - dmax, row.dmax) for row in runs.named
    }
    sweep = Figure(
        draw=lambda: draw_sweep(runs, clamp.value),
        sources=[row.slip_mm for row in runs.held],
        numbers={"shipped": results.row[SHIPPED].slip_mm, "fix": results.row[FIX].slip_mm, "clamp": clamp},
    )
    law = Figure(
        draw=lambda: draw_law(runs, results),
        sources=[row.drift_mm_s for row in runs.held],
        numbers={"has_rest": drift_without_slide(results).value is not None},
    )
    return Section(
        tables={"cases": _table(runs.named, give)},
        figures={"sweep": sweep, "law": law},
        claims=[
            cause(results, proportional),
            proportional,
            not_creep_under_load(results),
            *knob_claims(results, runs, clamp),
        ],
    )


def _by_ke(rows: Iterable[Row]) -> list[Row]:
    return sorted(rows, key=lambda row: row.pad_ke.value)


def _table(rows: Sequence[Row], give: Mapping[str, Value]) -> Table:
    columns = {
        "ke": [row.pad_ke for row in rows],
        "kd": [row.pad_kd for row in rows],
        "1 − dmax": [give[row.case] for row in rows],
        "cube": ["held" if is_held(row) else "lost" for row in rows],
        "slip": [row.slip_mm for row in rows],
        "drift": [row.drift_mm_s for row in rows],
        "timeconst": [row.timeconst_s for row in rows],
        "dampratio": [row.dampratio for row in rows],
        "depth": [row.penetration_mm for row in rows],
        "force": [row.normal_force_n for row in rows],
        "stiffness": [row.stiffness_n_m for row in rows],
    }
    for name in list(columns)[4:]:  # the contacts of a cube that was lost are with the ground
        columns[name] = [cell if is_held(row) else "" for row, cell in zip(rows, columns[name], strict=True)]
    return by_case(rows, columns)
