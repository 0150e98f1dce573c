"""Error against run time: the cheapest setting for an error, and what the expensive knobs buy."""

from measured_report.parts.claim import HOLDS
from measured_report.parts.section import Figure, Section
from measured_report.values.results import Results
from report.sections.error_runtime import claims
from report.sections.error_runtime.figures import draw_numerical
from report.sections.error_runtime.runs import ERROR, points_of

order = 155
page = "error"
first = True
label = "error and run time"
labels = {
    "as-shipped/newton/iterations-1": "shipped pads, Newton's contacts, 1 iteration",
    "as-shipped/newton/iterations-#": "shipped pads, Newton's contacts, {} iterations",
    "stiff/newton/iterations-#": "stiff pads, Newton's contacts, {} iterations",
    "as-shipped/newton/solver-cg": "shipped pads, Newton's contacts, conjugate gradients",
    "stiff/newton/solver-cg": "stiff pads, Newton's contacts, conjugate gradients",
}


def derive(results: Results) -> Section:
    points = points_of(results)
    rk4 = claims.rk4_in_warp(points)
    tests = [claims.pads_decide(points), rk4, claims.rk4_with_stiff_pads(points)]
    tests += [claims.reference_converged(points), claims.solver_effort(points), claims.crossover(points)]
    errors = [row[ERROR] for row in points.settings]
    numerical = Figure(lambda: draw_numerical(points), errors, {"rk4_warp": rk4.outcome == HOLDS})
    return Section(figures={"numerical": numerical}, claims=tests)
