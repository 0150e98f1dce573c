"""What moves against what: the drift as shipped, taken apart into relative poses."""

from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import Claim, all_of, at_least, at_most
from measured_report.parts.figures import SERIES, new_figure, say_value, write
from measured_report.parts.section import Figure, Section
from measured_report.values.results import Results, Row
from report.shared.arithmetic import share, table_of

order = 60
label = "what moves"

FINGERS = ("cube-in-left-finger", "cube-in-right-finger")
ROBOT = ("TCP-in-hand", "left-finger-in-hand", "hand-in-link7")
"""Pairs in which both bodies belong to the robot."""
COLUMNS = {
    "drift over the shake": "total_drift_mm",
    "displacement at the end": "displacement_mm",
    "oscillation": "oscillation_mm",
}


def derive(results: Results) -> Section:
    drift = Figure(
        draw=lambda: _draw_drift(results.rows),
        sources=[row.total_drift_mm for row in results.rows],
        numbers={"pairs": [(row.pair, row.total_drift_mm) for row in results.rows]},
    )
    return Section(
        tables={"pairs": table_of("body in the frame of", [row.pair for row in results.rows], COLUMNS, results.rows)},
        figures={"drift": drift},
        claims=[_cube_moves_in_fingers(results), _robot_is_still(results)],
    )


def _cube_moves_in_fingers(results: Results) -> Claim:
    whole = results.row["cube-in-TCP"].total_drift_mm
    left, right = cells = [results.row[case].total_drift_mm for case in FINGERS]
    formula = "{} of the cube's drifts against the two fingers, of its drift against the TCP"
    least, most = (
        results.value(name, formula.format(which), lambda a, b, c, f=f: 100 * f(a, b) / c, *cells, whole, unit="%")
        for name, which, f in (("finger_share", "smaller", min), ("finger_share_most", "larger", max))
    )
    all_of_it = at_least(least, 95.0, why="as good as all of it"), at_most(most, 105.0, why="no more than all of it")
    return Claim("cube_moves_in_fingers", all_of(*all_of_it), {"whole": whole, "left": left, "right": right})


def _robot_is_still(results: Results) -> Claim:
    formula, drifts = "largest drift between two bodies of the robot", (results.row[it].total_drift_mm for it in ROBOT)
    largest = results.value("robot_drift", formula, max, *drifts, unit="mm")
    whole = results.row["cube-in-TCP"].total_drift_mm
    of_cube = share(results, "robot_share", f"{formula}, of the cube's drift against the TCP", largest, whole)
    outcome = at_most(of_cube, 1.0, why="too little to matter")
    return Claim("robot_is_still", outcome, {"largest": largest, "share": of_cube})


def _draw_drift(rows: list[Row]) -> Drawing:
    there = [row for row in reversed(rows) if row.total_drift_mm.value]
    drawing, axes = new_figure(7.2, 2.8)
    for place, row in enumerate(there):
        drift, is_robot = row.total_drift_mm, row.case in ROBOT
        axes.plot(drift.value, place, "os"[is_robot], color=SERIES[is_robot], markersize=7, markevery=1)
        say_value(axes, drift.value, place, write(drift), gap=8.0)
    axes.set_yticks(range(len(there)), [row.pair for row in there])
    right = 50.0 * max(row.total_drift_mm.value for row in there)
    axes.set(xscale="log", xlim=(None, right), xlabel="drift over the shake [mm]")
    return drawing
