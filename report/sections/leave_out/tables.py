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
from report.sections.leave_out.variants import (
    ALL,
    REFERENCE,
    Variant,
    Variants,
    is_identical,
    reference_of,
    row_of,
    was_compared,
)
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


def case_table(variants: Variants) -> Table:
    names = list(dict.fromkeys(case for _, case in variants))
    return table_of("case", map(case_html, names), {"left out": [LEFT_OUT.get(name, "") for name in names]})


def audit_table(results: Results) -> Table:
    rows = [row for row in results.rows if "item" in row]
    items = [row.item.split(", against ") for row in rows]
    columns = {
        "there": lambda row: _whole(results, row, "present"),
        "used": lambda row: _whole(results, row, "used"),
        "counted as used": [", ".join(item[1:]) for item in items],
        "note": "note",
    }
    columns = {name: cells for name, cells in cells_of(rows, columns).items() if any(cells)}
    return table_of("", [item[0] for item in items], columns)


def _whole(results: Results, row: Row, column: str) -> Quantity:
    """A count as the whole number that it is; a mean stays as it was measured."""
    measured = row[column]
    if measured.value is None or measured.value % 1:
        return measured
    return results.value(f"{row.case}_{column}".replace("-", "_"), "the count, as a whole number", round, measured)


def cost_table(variants: Variants) -> Table:
    counts = sorted({row.worlds.value for variant in variants.values() for row in variant.rows})
    times = {
        worlds_name(count): [row.frame_ms if row else "" for row in (each.at(count) for each in variants.values())]
        for count in counts
    }
    memory = [variant.run.buffer_bytes_per_world for variant in variants.values()]
    return _table(variants, {**times, "memory": memory})


def same_table(variants: Variants, differences: Mapping[str, Value]) -> Table:
    columns = {
        "slip": "slip_mm",
        "change": [differences[variant.name] for variant in variants.values()],
        "drift": "drift_mm_s",
        "same bits": [_bits(variants, variant) for variant in variants.values()],
        "apart": "pose_difference_mm",
    }
    return _table(variants, columns)


def _table(variants: Variants, columns: Mapping[str, Column]) -> Table:
    """Make a table with a line for each variant, after the device that it was run on."""
    columns = {"on": [DEVICES[device] for device, _ in variants], **columns}
    runs = [variant.run for variant in variants.values()]
    return table_of("case", [case_html(case) for _, case in variants], columns, runs)


def _bits(variants: Variants, variant: Variant) -> bool | str:
    if variant is reference_of(variants, variant.device):
        return "reference"
    return is_identical(variant.run) if was_compared(variant.run) else "not run"


def cost_figure(variants: Variants, panels: Sequence[tuple[str, int]]) -> Figure:
    timed = [(variant, row) for variant in variants.values() for row in variant.rows]
    times = Markup("; ").join(
        Markup("{} on the {}, {}: {}").format(name_of(variant.case), DEVICES[device], worlds_name(worlds), row.frame_ms)
        for device, worlds in dict.fromkeys((*panels[:1], *panels[-1:]))
        for variant, row in timed
        if (variant.device, row.worlds.value) == (device, worlds) and variant.case in (REFERENCE, ALL)
    )
    sources = [row.frame_ms for variant, row in timed if (variant.device, row.worlds.value) in panels]
    return Figure(draw=lambda: _draw_cost(variants, panels), sources=sources, numbers={"times": times})


def _draw_cost(variants: Variants, panels: Sequence[tuple[str, int]]) -> Drawing:
    names = list(dict.fromkeys(case for _, case in variants))
    drawing, grid = new_figure(7.2, 1.3 + 0.28 * len(names), ncols=len(panels), sharey=True, squeeze=False)
    for axes, (device, worlds) in zip(grid[0], panels, strict=True):
        whole = row_of(variants, device, REFERENCE, worlds).frame_ms.value
        for place, case in enumerate(names):
            row = row_of(variants, device, case, worlds)
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
