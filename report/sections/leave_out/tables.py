"""The tables and the figure of what each thing left out costs and changes."""

from collections.abc import Mapping, Sequence

from markupsafe import Markup
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, SERIES, new_figure, say_value, write
from measured_report.parts.section import Figure, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import case_html, name_of, worlds_name
from report.sections.leave_out.variants import ALL, REFERENCE, Runs, Timed, is_identical, reference_of
from report.shared.arithmetic import DEVICES, Column, cells_of, table_of
from report.shared.drawing import name_lines

LEFT_OUT = {
    REFERENCE: "nothing: exactly as shipped",
    "without-buffers": "room for contacts and constraints beyond the peak",
    "without-ik-iterations": "most iterations of the inverse kinematics",
    "without-ik-in-turn": "waiting for the inverse kinematics",
    "without-state-sync": "Newton's state and targets written before every substep",
    "without-cube-gap": "the cube's default contact gap",
    "without-hand-box": "collision of the hand",
    "without-visuals": "shapes for looking at",
    "without-fixed-joints": "bodies fixed to one another",
    "without-broad-phase": "testing all pairs of shapes",
    "without-sensors": "the engine's stage of sensors",
    "without-limits": "the engine's stage of joint limits",
    ALL: "all of these",
    "as-shipped": "buffers, IK iterations, waiting for IK, state writes: this report's baseline",
}


def case_table(runs: Runs) -> Table:
    names = list(dict.fromkeys(case for _, case in runs))
    return table_of("case", map(case_html, names), {"left out": [LEFT_OUT.get(name, "") for name in names]})


def audit_table(results: Results) -> Table:
    rows = [row for row in results.rows if "item" in row]
    items = [row.item.split(", against ") for row in rows]
    columns: dict[str, Column] = {
        "there": lambda row: _whole(results, row, "present"),
        "used": lambda row: _whole(results, row, "used"),
        **{"counted as used": [", ".join(item[1:]) for item in items], "note": "note"},
    }
    columns = {name: cells for name, cells in cells_of(rows, columns).items() if any(cells)}
    return table_of("", [item[0] for item in items], columns)


def _whole(results: Results, row: Row, column: str) -> Quantity:
    """A count as the whole number that it is; a mean stays as it was measured."""
    measured = row[column]
    if measured.value is None or measured.value % 1:
        return measured
    return results.value(f"{row.case}_{column}".replace("-", "_"), "the count, as a whole number", round, measured)


def cost_table(timed: Timed, runs: Runs) -> Table:
    times = {
        worlds_name(count): [timed[(*run, count)].frame_ms if (*run, count) in timed else "" for run in runs]
        for count in sorted({worlds for *_, worlds in timed})
    }
    return _table(runs, {**times, "memory": "buffer_bytes_per_world"})


def same_table(runs: Runs, differences: Mapping[tuple[str, str], Value]) -> Table:
    references = [reference_of(runs, device) for device in DEVICES]

    def bits(row: Row) -> bool | str:
        if row in references:
            return "reference"
        return is_identical(row) if "differing_frame_count" in row else "not run"

    columns = {"slip": "slip_mm", "change": list(differences.values()), "drift": "drift_mm_s"}
    return _table(runs, {**columns, "same bits": bits, "apart": "pose_difference_mm"})


def _table(runs: Runs, columns: Mapping[str, Column]) -> Table:
    """Make a table with a line for each run, after the device that it was run on."""
    columns = {"on": lambda row: DEVICES[row.device], **columns}
    return table_of("case", [case_html(case) for _, case in runs], columns, runs.values())


def cost_figure(timed: Timed, panels: Sequence[tuple[str, int]]) -> Figure:
    times = Markup("; ").join(
        Markup("{} on the {}, {}: {}").format(name_of(case), DEVICES[device], worlds_name(worlds), row.frame_ms)
        for panel in dict.fromkeys((*panels[:1], *panels[-1:]))
        for (device, case, worlds), row in timed.items()
        if (device, worlds) == panel and case in (REFERENCE, ALL)
    )
    sources = [row.frame_ms for (device, _, worlds), row in timed.items() if (device, worlds) in panels]
    return Figure(lambda: _draw_cost(timed, panels), sources, {"times": times})


def _draw_cost(timed: Timed, panels: Sequence[tuple[str, int]]) -> Drawing:
    names = list(dict.fromkeys(case for _, case, _ in timed))
    drawing, grid = new_figure(7.2, 1.3 + 0.28 * len(names), ncols=len(panels), sharey=True, squeeze=False)
    for axes, (device, worlds) in zip(grid[0], panels, strict=True):
        whole = timed[device, REFERENCE, worlds].frame_ms.value
        for place, case in enumerate(names):
            row = timed.get((device, case, worlds))
            if row and row.frame_ms.value is not None:
                _draw_time(axes, place, row, whole)
        axes.axvline(100, color=INK, linewidth=1, linestyle="--")
        axes.set_xlim(left=0)
        axes.set_title(f"{DEVICES[device]}\n{worlds_name(worlds)}")
        axes.grid(axis="y", visible=False)
    name_lines(grid[0][0], map(name_of, names))
    drawing.supxlabel("time of a frame as a share of that exactly as shipped [%]", fontsize=10)
    return drawing


def _draw_time(axes: Axes, place: int, row: Row, whole: float) -> None:
    """Draw the time of a frame as a share of ``whole``, with the range of its frames and the time in words."""
    middle, low, high = (100 * row[name].value / whole for name in ("frame_ms", "frame_ms_p5", "frame_ms_p95"))
    axes.barh(place, middle, height=0.62, color=SERIES[0], edgecolor=INK, linewidth=0.6)
    if middle > 40:
        axes.annotate(write(row.frame_ms), (4, place), fontsize=8, va="center", color="white")
    else:
        say_value(axes, high, place, write(row.frame_ms))
    axes.plot([low, high], [place, place], color=INK, linestyle="-", marker="|", markevery=1, linewidth=1.2)
