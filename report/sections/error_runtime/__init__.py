"""Error against run time: the cheapest setting for an error, and what the expensive knobs buy."""

from markupsafe import Markup

from measured_report.parts.claim import HOLDS
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.results import Results, Row
from report.sections.error_runtime import claims
from report.sections.error_runtime.figures import LEAST_ERROR_MM, draw_numerical
from report.sections.error_runtime.runs import ERROR, GRASP, PADS, TIME, Points, is_clamped, points_of
from report.shared.tables import Column, table_of

order = 155
page = "error"
leads = True
label = "error and run time"
labels = {
    "as-shipped/newton/iterations-1": "shipped pads, Newton's contacts, 1 iteration",
    "as-shipped/newton/iterations-#": "shipped pads, Newton's contacts, {} iterations",
    "stiff/newton/iterations-#": "stiff pads, Newton's contacts, {} iterations",
    "as-shipped/newton/solver-cg": "shipped pads, Newton's contacts, conjugate gradients",
    "stiff/newton/solver-cg": "stiff pads, Newton's contacts, conjugate gradients",
}

PARAMETERS = ("iterations", "ls_iterations", "solver", "cone", "impratio", "integrator", "contacts", "collide_count")
"""Parameters that a setting may change beside its pads and substeps, as they are called in the scene."""


def derive(results: Results) -> Section:
    points = points_of(results)
    rk4 = claims.rk4_in_warp(points)
    tests = [claims.pads_decide(points), rk4, claims.rk4_with_stiff_pads(points)]
    tests += [claims.reference_converged(points), claims.solver_effort(points), claims.crossover(points)]
    errors = [row[ERROR] for row in points.settings]
    numerical = Figure(lambda: draw_numerical(points), errors, {"rk4_warp": rk4.outcome == HOLDS})
    return Section(tables={"front": _front_table(points)}, figures={"numerical": numerical}, claims=tests)


def _front_table(points: Points) -> Table:
    best = (row for backend in points.engines for row in points.best(backend))
    rows = [row for row in best if row[ERROR].value > LEAST_ERROR_MM]
    engines = [{"mujoco-c": "C", "warp-cpu": "Warp, CPU"}.get(row.backend, "Warp") for row in rows]
    columns: dict[str, Column] = {"engine": engines, "settings": _settings, "numerical error": ERROR}
    columns |= {"grasp error": GRASP, "clamped": is_clamped, "time": TIME}
    return table_of("pads", [PADS[row["pads"]].removesuffix(" pads") for row in rows], columns, rows)


def _settings(row: Row) -> Markup:
    """Write the parameters as one sets them in the scene."""
    values = {name: row[name] for name in ("substeps", *PARAMETERS) if name in row}
    parts = (Markup("{}={}").format(name, getattr(value, "code", value)) for name, value in values.items())
    return Markup("<code>{}</code>").format(Markup(", ").join(parts))
