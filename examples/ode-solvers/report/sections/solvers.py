"""Derive whether a method of higher order is faster."""

from measured_report.parts.claim import Claim, all_of, greater
from measured_report.parts.figures import new_figure
from measured_report.parts.section import Figure, Section
from measured_report.values.results import Results


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "of" not in row]
    high, low = (results.row[f"{name}-1e-9"] for name in ("DOP853", "RK45"))
    outcome = all_of(
        greater(low.error_m, high.error_m), greater(low.run_ms, high.run_ms)
    )
    times = {"high": high.run_ms, "low": low.run_ms, "error": high.error_m}

    def draw():
        drawing, axes = new_figure()
        for solver in dict.fromkeys(row.solver for row in rows):
            points = [
                (row.run_ms.number, row.error_m.number)
                for row in rows
                if row.solver == solver
            ]
            axes.loglog(*zip(*points, strict=True), label=solver)
        axes.set(xlabel="run time [ms]", ylabel="error [m]")
        axes.legend()
        return drawing

    drawn = [cell for row in rows for cell in (row.run_ms, row.error_m)]
    figures = {"work": Figure(draw, drawn, {"error": high.error_m})}
    return Section(figures=figures, claims=[Claim("high_order_wins", outcome, times)])
