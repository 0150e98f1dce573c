"""What moves against what: the drift as shipped, taken apart into relative poses."""

import pandas as pd
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, all_of, at_least, at_most
from measured_report.parts.figures import SERIES, new_figure, say_value, write
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.results import Results, Row
from report.shared.arithmetic import share

order = 60
label = "what moves"

FINGERS = ("cube-in-left-finger", "cube-in-right-finger")
ROBOT = ("TCP-in-hand", "left-finger-in-hand", "hand-in-link7")
"""Pairs in which both bodies belong to the robot."""


def derive(results: Results) -> Section:
    drift = Figure(
        draw=lambda: _draw_drift(results.rows),
        sources=[row.total_drift_mm for row in results.rows],
        numbers={"pairs": [(row.pair, row.total_drift_mm) for row in results.rows]},
    )
    return Section(
        tables={"pairs": _table(results.rows)},
        figures={"drift": drift},
        claims=[_cube_moves_in_fingers(results), _robot_is_still(results)],
    )


def _cube_moves_in_fingers(results: Results) -> Claim:
    whole = results.row["cube-in-TCP"].total_drift_mm
    left, right = (results.row[case].total_drift_mm for case in FINGERS)
    share = results.value(
        "finger_share",
        "smaller of the cube's drifts against the two fingers, of its drift against the TCP",
        lambda a, b, all_of_it: 100 * min(a, b) / all_of_it,
        left,
        right,
        whole,
        unit="%",
    )
    most = results.value(
        "finger_share_most",
        "larger of the cube's drifts against the two fingers, of its drift against the TCP",
        lambda a, b, all_of_it: 100 * max(a, b) / all_of_it,
        left,
        right,
        whole,
        unit="%",
    )
    bound = results.chosen("finger_share_bound", "as good as all of it", 95.0, unit="%")
    upper = results.chosen("finger_share_upper_bound", "no more than all of it", 105.0, unit="%")
    return Claim(
        "cube_moves_in_fingers",
        all_of(at_least(share, bound), at_most(most, upper)),
        numbers={"whole": whole, "left": left, "right": right},
    )


def _robot_is_still(results: Results) -> Claim:
    largest = results.value(
        "robot_drift",
        "largest drift between two bodies of the robot",
        max,
        *(results.row[case].total_drift_mm for case in ROBOT),
        unit="mm",
    )
    formula = "largest drift between two bodies of the robot, of the cube's drift against the TCP"
    of_cube = share(results, "robot_share", formula, largest, results.row["cube-in-TCP"].total_drift_mm)
    bound = results.chosen("robot_share_bound", "too little to matter", 1.0, unit="%")
    return Claim("robot_is_still", at_most(of_cube, bound), numbers={"largest": largest, "share": of_cube})


def _table(rows: list[Row]) -> Table:
    columns = {
        "drift over the shake": [row.total_drift_mm for row in rows],
        "displacement at the end": [row.displacement_mm for row in rows],
        "oscillation": [row.oscillation_mm for row in rows],
    }
    index = pd.Index([row.pair for row in rows], name="body in the frame of")
    return Table(pd.DataFrame(columns, index=index))


def _draw_drift(rows: list[Row]) -> Drawing:
    there = [row for row in reversed(rows) if row.total_drift_mm.value]
    drawing, axes = new_figure(7.2, 2.8)
    for place, row in enumerate(there):
        robot = row.case in ROBOT
        axes.plot(
            row.total_drift_mm.value, place, "s" if robot else "o", color=SERIES[robot], markersize=7, markevery=1
        )
        say_value(axes, row.total_drift_mm.value, place, write(row.total_drift_mm), gap=8.0)
    axes.set_yticks(range(len(there)), [row.pair for row in there])
    axes.set_xscale("log")
    axes.set_xlim(None, 50.0 * max(row.total_drift_mm.value for row in there))
    axes.set_xlabel("drift over the shake [mm]")
    return drawing
