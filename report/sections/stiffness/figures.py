"""The figure of section stiffness."""

from typing import Any

from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, SERIES, new_figure, tick_125
from measured_report.values.results import Row
from report.sections.stiffness.runs import FIX, SHIPPED, Runs, is_held
from report.shared import drawing as colours
from report.shared.drawing import mark_points

ENDS = {"dropped": "v", "not finite": "x", "overflow": "P", "shaken too late": "s"}
"""How a run can end with no slip to show, and its mark."""
LINES = SERIES[5], SERIES[4]
"""Of kd at its default, and raised with ke."""


def draw_sweep(runs: Runs, clamp_kd: float) -> Drawing:
    drawing, axes = new_figure(7.2, 4.2)
    fine = [row for row in runs.together if row.case.startswith("sweep-")]
    series = (("kd at its default", runs.ke_alone), ("kd = 2√ke, damping ratio 1", fine))
    held = [row.slip_mm.value for _, rows in series for row in rows if is_held(row)]
    top = 3.0 * max(held)
    for (label, rows), colour in zip(series, LINES, strict=True):
        kept = [row for row in rows if is_held(row)]
        axes.plot(
            [r.pad_ke.value for r in kept], [r.slip_mm.value for r in kept], label=label, color=colour, markevery=1
        )
    for case, colour, label in ((SHIPPED, colours.SHIPPED, "shipped pads"), (FIX, colours.STIFF, "stiff pads")):
        points = [(row.pad_ke.value, row.slip_mm.value) for row in runs.held if row.case == case]
        mark_points(axes, points, marker="D", markersize=9, color=colour, label=label, zorder=5)
    for end, mark in ENDS.items():
        for number, (_, rows) in enumerate(series):
            found = [(row.pad_ke.value, top) for row in rows if _end(row) == end]
            mark_points(axes, found, marker=mark, color=LINES[number], clip_on=False, markersize=7)
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
    if is_held(row):
        return ""
    if row.slip_mm.value is not None:
        return "dropped" if row.dropped else "shaken too late"
    return "overflow" if "overflow" in (row.failure or "") else "not finite"
