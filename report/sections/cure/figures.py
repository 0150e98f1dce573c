"""The figure of section cure."""

from collections.abc import Mapping
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, SERIES, new_figure
from measured_report.values.quantities import Value
from measured_report.values.results import Results
from report.sections.cure.budget import PARTS
from report.sections.cure.ways import WAYS
from report.shared.drawing import mark_cells, name_lines

HATCHES = ("", "///", "...", "xxx", "\\\\\\")


def draw_budget(results: Results, parts: Mapping[str, Mapping[str, Value]]) -> Drawing:
    """All ways on the left, and those with a remedy once more on a scale of their own on the right."""
    drawing, (whole, close) = new_figure(7.2, 4.6, ncols=2, sharey=True)
    for axes in (whole, close):
        _stack(axes, parts)
        axes.axvline(0.0, color=INK, linewidth=0.8, marker="")
        axes.grid(visible=False, axis="y")
        axes.set_xlabel("along the way of the cube [mm]")
    values = [abs(value.value) for way in WAYS[1:] for value in parts[way.name].values() if value.value is not None]
    reach = 1.1 * max(values, default=1.0)
    close.set_xlim(-reach, reach)
    name_lines(whole, [way.name for way in WAYS])
    whole.set_title("whole")
    close.set_title("close")
    drawing.legend(*whole.get_legend_handles_labels(), loc="outside upper center", ncols=4)
    return drawing


def _stack(axes: Axes, parts: Mapping[str, Mapping[str, Value]]) -> None:
    """What goes along the cube's way is stacked to the right of zero, what goes against it to the left."""
    ends = {(way.name, sign): 0.0 for way in WAYS for sign in (True, False)}
    for number, (name, label) in enumerate(PARTS.items()):
        sizes, starts = [], []
        for way in WAYS:
            size = parts[way.name][name].value or 0.0
            sizes.append(size)
            starts.append(ends[way.name, size > 0.0])
            ends[way.name, size > 0.0] += size
        fill: dict[str, Any] = {"color": SERIES[number], "hatch": HATCHES[number], "linewidth": 0}
        axes.barh(range(len(WAYS)), sizes, 0.6, left=starts, label=label, **fill)
    for name, label, marker, size in (("sum", "sum of the parts", "|", 15), ("slip", "measured", "o", 5)):
        mark_cells(axes, [parts[way.name][name] for way in WAYS], INK, label, marker=marker, markersize=size)
