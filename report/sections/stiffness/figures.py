"""The figures of section stiffness."""

from statistics import median
from typing import Any

import numpy as np
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, SERIES, new_figure, tick_125
from measured_report.values.results import Results, Row
from report.sections.stiffness.runs import Runs, drift_without_slide, is_held
from report.shared.drawing import mark_points

ENDS = {"dropped": "v", "not finite": "x", "overflow": "P", "hardly shaken": "s"}
"""How a run can end with no slip to show, and its mark."""


def draw_sweep(runs: Runs, clamp_kd: float) -> Drawing:
    drawing, axes = new_figure(7.2, 4.2)
    fine = [row for row in runs.together if row.case.startswith("sweep-")]
    series = (("kd at its default", runs.ke_alone), ("kd = 2√ke, damping ratio 1", fine))
    held = [row.slip_mm.value for _, rows in series for row in rows if is_held(row)]
    top = 3.0 * max(held)
    for label, rows in series:
        kept = [row for row in rows if is_held(row)]
        axes.plot([r.pad_ke.value for r in kept], [r.slip_mm.value for r in kept], label=label, markevery=1)
    for end, mark in ENDS.items():
        for number, (_, rows) in enumerate(series):
            found = [(row.pad_ke.value, top) for row in rows if _end(row) == end]
            mark_points(axes, found, marker=mark, color=SERIES[number], clip_on=False, markersize=7)
        if any(_end(row) == end for _, rows in series for row in rows):
            axes.plot([], [], mark, color=INK, markersize=7, markevery=1, label=end)
    axes.set(xscale="log", yscale="log", xlabel="pad ke", ylabel="slip [mm]", ylim=(0.6 * min(held), top))
    clamp_ke = (clamp_kd / 2) ** 2
    axes.axvline(clamp_ke, color=INK, linewidth=1.0, linestyle=":")
    place: dict[str, Any] = {"xycoords": ("data", "axes fraction"), "xytext": (6, 0), "textcoords": "offset points"}
    axes.annotate("2/kd = 2·dt\n(kd = 2√ke)", (clamp_ke, 0.42), **place)
    tick_125(axes.yaxis)
    drawing.legend(loc="outside upper left", ncols=3)
    return drawing


def _end(row: Row) -> str:
    """Why a run has no slip to show, in a word or two; empty where it has."""
    if is_held(row):
        return ""
    if row.slip_mm.value is not None:
        return "dropped" if row.dropped else "hardly shaken"
    return "overflow" if "overflow" in (row.failure or "") else "not finite"


def draw_law(runs: Runs, results: Results) -> Drawing:
    drawing, axes = new_figure(7.2, 3.6)
    rest = drift_without_slide(results).value
    groups = {
        "kd at its default": [row for row in runs.ke_alone if is_held(row)],
        "ke and kd raised together": [row for row in runs.together if is_held(row)],
        "dmax raised": [row for row in runs.named if "pad_dmax" in row and is_held(row)],
    }
    times = {row.case: results.derived[f"response_{row.case}"].value for rows in groups.values() for row in rows}
    rates = [results.derived[f"rate_{case}"].value for case in times]
    for number, (label, rows) in enumerate(groups.items()):
        points = [(1e3 * times[row.case], row.drift_mm_s.value - (rest or 0.0)) for row in rows]
        mark_points(axes, points, label=label, zorder=3 - number)
    ends = np.array([min(times.values()), max(times.values())])
    if None not in rates:
        axes.plot(1e3 * ends, median(rates) * ends, color=INK, linestyle="-", linewidth=1.0, marker="")
    axes.set(xscale="log", yscale="log", xlabel="dmax · timeconst [ms]")
    axes.set_ylabel("drift [mm/s]" if rest is None else "drift less that without slide [mm/s]")
    tick_125(axes.xaxis)
    tick_125(axes.yaxis)
    axes.legend()
    return drawing
