"""Tables and figure of what each thing left out costs and changes."""

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from markupsafe import Markup
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, new_figure, say_value, write
from measured_report.parts.section import Figure, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import DEVICES, Column, case_html, table_of
from report.shared.drawing import SHIPPED, name_lines
from report.shared.timing import worlds_name

REFERENCE, ALL = "untrimmed", "without-all"
Timed = Mapping[tuple[str, str, int], Row]
"""Rows by device, case and number of worlds; a row without anything where nothing was measured."""


def audit_table(results: Results) -> Table:
    rows = [row for row in results.rows if "item" in row]
    items = [row.item.split(", against ") for row in rows]
    columns: dict[str, Column] = {
        "there": lambda row: _whole(results, row, "present"),
        "used": lambda row: _whole(results, row, "used"),
        "counted as used": [", ".join(item[1:]) for item in items],
    }
    return table_of("part", [item[0] for item in items], columns, rows)


def _whole(results: Results, row: Row, column: str) -> Quantity:
    """Write a count as the whole number that it is; a mean stays as it was measured."""
    measured = row[column]
    if measured.value is None or measured.value % 1:
        return measured
    return results.value(f"{row.case}_{column}".replace("-", "_"), "the count, as a whole number", round, measured)


def by_case(timed: Timed) -> dict[str, Row]:
    """Return a row of each case."""
    return {case: row for (_, case, _), row in timed.items()}


def cost_table(
    timed: Timed,
    differences: Mapping[tuple[str, str], Value],
    resolutions: Mapping[str, Value],
    apart: Mapping[str, Value],
    cpu_reference: Row,
) -> Table:
    """Make a line for each case, with its times and changes by device, on the CPU from those of ``cpu_reference``."""
    names = list(dict.fromkeys(case for _, case, _ in timed))
    places = sorted({(device, worlds) for device, _, worlds in timed}, key=lambda place: (place[0] == "cpu", place))
    columns: dict[str, Column] = {}
    for device, worlds in places:
        rows = [timed.get((device, name, worlds)) for name in names]
        columns[f"{DEVICES[device]}, {worlds_name(worlds)}"] = [row.frame_ms if row else "" for row in rows]
    runs = {name: row for (device, name, _), row in reversed(list(timed.items())) if device == places[0][0]}
    columns["memory"] = [runs[name].buffer_bytes_per_world if name in runs else "" for name in names]
    for device in dict.fromkeys(device for device, _ in places):
        columns[f"slip, {DEVICES[device]}"] = [differences.get((device, name), "") for name in names]
    other = case_html(cpu_reference) if cpu_reference.case != REFERENCE else ""
    said: dict[str, Any] = {f"on_{device}": within for device, within in resolutions.items()}
    said |= {f"apart_{device}": most for device, most in apart.items()}
    return table_of("case", map(case_html, by_case(timed).values()), columns, cpu_reference=other, **said)


def cost_figure(timed: Timed, panels: Sequence[tuple[str, int]]) -> Figure:
    """Show each device with the number of worlds that most cases were timed with, the largest of such."""
    count = Counter((device, worlds) for (device, _, worlds), row in timed.items() if row.frame_ms.value is not None)
    most = dict(sorted(panels, key=lambda panel: (count[panel], panel[1])))
    shown = [(device, most[device]) for device in DEVICES if device in most]
    ends = {
        (device, worlds, case): timed[device, case, worlds].frame_ms
        for device, worlds in shown
        for case in (REFERENCE, ALL)
    }
    times = Markup("; ").join(
        Markup("{} on the {}, {}: {}").format(by_case(timed)[case].label, DEVICES[device], worlds_name(worlds), time)
        for (device, worlds, case), time in ends.items()
    )
    device, worlds = max(shown, key=lambda panel: panel[1])
    numbers: dict[str, Any] = {"times": times, "device": DEVICES[device], "worlds": worlds_name(worlds)}
    numbers |= {"before": ends[device, worlds, REFERENCE], "after": ends[device, worlds, ALL]}
    sources = [row.frame_ms for (device, _, worlds), row in timed.items() if (device, worlds) in shown]
    return Figure(lambda: _draw_cost(timed, shown), sources, numbers)


def _draw_cost(timed: Timed, panels: Sequence[tuple[str, int]]) -> Drawing:
    names = list(dict.fromkeys(case for _, case, _ in timed))
    drawing, grid = new_figure(7.2, 1.3 + 0.28 * len(names), ncols=len(panels), sharey=True, squeeze=False)
    for axes, (device, worlds) in zip(grid[0], panels, strict=True):
        whole = timed[device, REFERENCE, worlds].frame_ms.value
        for place, case in enumerate(names):
            row = timed[device, case, worlds]
            if whole and row.frame_ms.value is not None:
                _draw_time(axes, place, row, whole)
            else:
                say_value(axes, 0.0, place, "not timed")
        axes.axvline(100, color=INK, linewidth=1, linestyle="--")
        axes.set_xlim(0, 1.15 * axes.get_xlim()[1])
        axes.set_title(f"{DEVICES[device]}\n{worlds_name(worlds)}")
        axes.grid(axis="y", visible=False)
    name_lines(grid[0][0], [row.label for row in by_case(timed).values()])
    drawing.supxlabel("time of a frame as a share of that exactly as shipped [%]", fontsize=10)
    return drawing


def _draw_time(axes: Axes, place: int, row: Row, whole: float) -> None:
    """Draw the time of a frame as a share of ``whole``, with the range of its frames and the time in words."""
    middle, low, high = (100 * row[name].value / whole for name in ("frame_ms", "frame_ms_p5", "frame_ms_p95"))
    axes.barh(place, middle, height=0.62, color=SHIPPED, edgecolor=INK, linewidth=0.6)
    # Beside the line, and not on it.
    say_value(axes, max(high, 100) if high > 80 else high, place, write(row.frame_ms))
    axes.plot([low, high], [place, place], color=INK, linestyle="-", marker="|", markevery=1, linewidth=1.2)
