"""What slides in the contact rows, and the motion that it adds up to."""

from collections.abc import Mapping

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, SERIES, new_figure
from measured_report.values.results import Row, Series
from report.names import name_of
from report.shared.drawing import mark_points

FINGERS = {"leftfinger": "left finger", "rightfinger": "right finger"}
"""By what the names of their shapes have."""


def draw_contacts(tables: Mapping[str, Series], runs: Mapping[str, Row]) -> Drawing:
    drawing, (left, right) = new_figure(7.2, 3.2, ncols=2, width_ratios=(3, 2))
    _draw_sliding(left, tables)
    for number, run in enumerate(runs.values()):
        label = "" if number else "from the rows", "" if number else "measured"
        right.bar(number - 0.2, run.slide_mm.value, 0.36, color=SERIES[4], hatch="///", label=label[0])
        right.bar(number + 0.2, run.along_mm.value, 0.36, color=SERIES[0], label=label[1])
    right.set_xticks(range(len(runs)), map(name_of, runs))
    right.grid(visible=False, axis="x")
    right.set_ylabel("motion along the main axis [mm]")
    right.legend(loc="upper right")
    right.margins(y=0.35)
    return drawing


def _draw_sliding(axes: Axes, tables: Mapping[str, Series]) -> None:
    """Draw the loaded contacts of each finger side by side, by their speed."""
    for number, (case, trace) in enumerate(tables.items()):
        if trace.value is not None:
            loaded = trace.value.query("normal_force_n > 0")
            found = [sorted(loaded["slide_mm_s"][loaded["geom_1"].str.contains(finger)]) for finger in FINGERS]
            points = [
                (finger + 0.7 * ((rank + 0.5) / len(speeds) - 0.5), speed)
                for finger, speeds in enumerate(found)
                for rank, speed in enumerate(speeds)
            ]
            mark_points(axes, points, marker="os"[number], markersize=6, label=name_of(case))
    axes.axhline(0.0, color=INK, linewidth=0.8, linestyle="-", marker="")
    axes.set_xticks(range(len(FINGERS)), FINGERS.values())
    axes.set(xlim=(-0.5, len(FINGERS) - 0.5), ylabel="sliding velocity [mm/s]")
    axes.grid(visible=False, axis="x")
    axes.legend(loc="best")
