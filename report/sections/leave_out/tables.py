"""The tables and the figure of what each thing left out costs and changes."""

from collections.abc import Sequence
from typing import Any

import pandas as pd
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, SERIES, new_figure, say_value, write
from measured_report.parts.parts import Figure, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import case_html, name_of, worlds_name
from report.sections.leave_out.variants import ALL, REFERENCE, Variant, find, is_identical, reference_of, was_compared
from report.shared.arithmetic import DEVICES

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


def case_table(variants: Sequence[Variant]) -> Table:
    names = list(dict.fromkeys(variant.case for variant in variants))
    columns = {"left out": [LEFT_OUT.get(name, "") for name in names]}
    return Table(pd.DataFrame(columns, index=pd.Index(map(case_html, names), name="case")))


def audit_table(results: Results) -> Table:
    rows = [row for row in results.rows if "item" in row]
    items = [row.item.split(", against ") for row in rows]
    columns: dict[str, list[Any]] = {
        "there": [_whole(results, row, "present") for row in rows],
        "used": [_whole(results, row, "used") for row in rows],
        "counted as used": [", ".join(item[1:]) for item in items],
        "note": [row.note for row in rows],
    }
    columns = {name: cells for name, cells in columns.items() if any(cells)}
    return Table(pd.DataFrame(columns, index=pd.Index([item[0] for item in items], name="")))


def _whole(results: Results, row: Row, column: str) -> Quantity:
    """A count as the whole number that it is; a mean stays as it was measured."""
    measured = row[column]
    if measured.value is None or measured.value % 1:
        return measured
    return results.value(f"{row.case}_{column}".replace("-", "_"), "the count, as a whole number", round, measured)


def cost_table(variants: Sequence[Variant]) -> Table:
    counts = sorted({row.worlds.value for variant in variants for row in variant.rows})
    columns: dict[str, list] = {"on": [DEVICES[variant.device] for variant in variants]}
    for count in counts:
        rows = [variant.at(count) for variant in variants]
        columns[worlds_name(count)] = [row.frame_ms if row else "" for row in rows]
    columns["memory"] = [variant.run.buffer_bytes_per_world for variant in variants]
    index = pd.Index([case_html(variant.case) for variant in variants], name="case")
    return Table(pd.DataFrame(columns, index=index))


def same_table(variants: Sequence[Variant], differences: dict[str, Value]) -> Table:
    columns = {
        "on": [DEVICES[variant.device] for variant in variants],
        "slip": [variant.run.slip_mm for variant in variants],
        "change": [differences[variant.name] for variant in variants],
        "drift": [variant.run.drift_mm_s for variant in variants],
        "same bits": [_bits(variants, variant) for variant in variants],
        "apart": [variant.run.pose_difference_mm for variant in variants],
    }
    index = pd.Index([case_html(variant.case) for variant in variants], name="case")
    return Table(pd.DataFrame(columns, index=index))


def _bits(variants: Sequence[Variant], variant: Variant) -> bool | str:
    if variant is reference_of(variants, variant.device):
        return "reference"
    return is_identical(variant.run) if was_compared(variant.run) else "not run"


def cost_figure(variants: Sequence[Variant], panels: Sequence[tuple[str, int]]) -> Figure:
    times = Markup("; ").join(
        Markup("{} on the {}, {}: {}").format(
            name_of(variant.case), DEVICES[device], worlds_name(worlds), variant.at(worlds).frame_ms
        )
        for device, worlds in dict.fromkeys((*panels[:1], *panels[-1:]))
        for variant in variants
        if variant.device == device and variant.case in (REFERENCE, ALL) and variant.at(worlds)
    )
    return Figure(
        draw=lambda: _draw_cost(variants, panels),
        sources=[
            row.frame_ms for variant in variants for row in variant.rows if (variant.device, row.worlds.value) in panels
        ],
        numbers={"times": times},
    )


def _draw_cost(variants: Sequence[Variant], panels: Sequence[tuple[str, int]]) -> Drawing:
    names = list(dict.fromkeys(variant.case for variant in variants))
    drawing, grid = new_figure(7.2, 1.3 + 0.28 * len(names), ncols=len(panels), sharey=True, squeeze=False)
    for axes, (device, worlds) in zip(grid[0], panels, strict=True):
        whole = find(variants, device, REFERENCE).at(worlds).frame_ms.value
        for variant in variants:
            row = variant.at(worlds)
            if variant.device == device and row and row.frame_ms.value is not None:
                middle, low, high = (
                    100 * row[name].value / whole for name in ("frame_ms", "frame_ms_p5", "frame_ms_p95")
                )
                place = names.index(variant.case)
                axes.barh(place, middle, height=0.62, color=SERIES[0], edgecolor=INK, linewidth=0.6)
                if middle > 40:
                    axes.annotate(write(row.frame_ms), (4, place), fontsize=8, va="center", color="white")
                else:
                    say_value(axes, high, place, write(row.frame_ms))
                axes.plot([low, high], [place, place], color=INK, linestyle="-", marker="|", markevery=1, linewidth=1.2)
        axes.axvline(100, color=INK, linewidth=1, linestyle="--")
        axes.set_xlim(left=0)
        axes.set_title(f"{DEVICES[device]}\n{worlds_name(worlds)}")
        axes.grid(axis="y", visible=False)
    grid[0][0].set_yticks(range(len(names)), map(name_of, names))
    grid[0][0].invert_yaxis()
    drawing.supxlabel("time of a frame as a share of that exactly as shipped [%]", fontsize=10)
    return drawing
