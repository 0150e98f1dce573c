"""Derive which integrator keeps the energy of a pendulum."""

import pandas as pd

from measured_report.parts.claim import Claim, greater
from measured_report.parts.figures import new_figure
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.results import Results

order = 10  # position on the page
label = "pendulum"  # the name of the section in figures and tables
INTEGRATORS = {"euler": "Euler", "rk4": "RK4"}


def derive(results: Results) -> Section:
    errors = {case: results.row[case].energy_error_mj for case in INTEGRATORS}
    claim = Claim("rk4_keeps_more", greater(errors["euler"], errors["rk4"]), errors)
    traces = {case: results.trace(case) for case in INTEGRATORS}

    def draw():
        drawing, axes = new_figure()
        for case, name in INTEGRATORS.items():
            axes.plot(
                traces[case].value.time_s,
                traces[case].value.energy_change_mj,
                label=name,
                marker="",
            )
        axes.set(xlabel="time [s]", ylabel="change of energy [mJ]")
        axes.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
        return drawing

    frame = pd.DataFrame({"largest change of energy": errors}).rename(INTEGRATORS)
    figure = Figure(draw, list(traces.values()), errors)
    return Section(
        tables={"errors": Table(frame)}, figures={"energy": figure}, claims=[claim]
    )
