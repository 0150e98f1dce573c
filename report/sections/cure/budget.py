"""The budget of the slip: parts that are predicted from the arm's motion, beside what is measured."""

from collections.abc import Mapping, Sequence
from itertools import product
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import Claim, at_least
from measured_report.parts.figures import INK, SERIES, new_figure
from measured_report.parts.section import Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.sections.cure.ways import GRASP_MM, WAYS, Way
from report.shared.arithmetic import cell_count, extreme, ratio, table_of
from report.shared.drawing import mark_cells, name_lines

PARTS = {"left_out": "the term", "step": "step", "damping": "damping", "creep": "load", "rounding": "rounding"}
"""Columns of the parts, and what they are called."""
HATCHES = ("", "///", "...", "xxx", "\\\\\\")
PADS = {"shipped": "shipped pads", "stiff": "stiff pads"}
SHAKES = {"held": "held still", "3cm": "30 mm", "10cm": "100 mm"}


def kept_runs(results: Results) -> list[Row]:
    """Select the combinations that have a slip to show and keep the cube."""
    runs = [row for row in results.rows if row.kind == "run" and row.slip_mm.value is not None]
    return [row for row in runs if row.slip_mm.value < GRASP_MM]


def closed_count(results: Results, name: str, runs: Sequence[Row], least: Value, most: Value) -> Value:
    """Count the runs whose remainder is below ``least`` [mm], or below ``most`` of the slip [%]."""
    return results.value(
        name,
        "runs whose remainder is below either bound",
        lambda absolute, relative, *found: sum(
            remainder <= max(absolute, 0.01 * relative * slip)
            for remainder, slip in zip(found[::2], found[1::2], strict=True)
        ),
        *(least, most),
        *(cell for row in runs for cell in (row.remainder_mm, row.slip_mm)),
    )


def run_count(results: Results, name: str, runs: Sequence[Row]) -> Value:
    return cell_count(results, name, "runs that keep the cube", [row.slip_mm for row in runs])


def parts_of(results: Results, way: Way) -> dict[str, Value]:
    """Derive the parts of a way at 3 cm along the direction in which its cube went, their sum, and how far it went."""
    row, parts = way.row(results, "3cm"), {}
    for name, column in {**{name: name for name in PARTS}, "sum": "predicted", "slip": "slip"}.items():
        formula = f"{column} of {row.case} along the pads, in the direction in which the cube went there"
        cells = row[f"{column}_x_mm"], row[f"{column}_z_mm"], row.slip_x_mm, row.slip_z_mm
        parts[name] = results.value(f"{row.case}_{name}", formula, _along, *cells, unit="mm")
    return parts


def _along(x: float, z: float, slip_x: float, slip_z: float) -> float:
    """Project a vector on the slip."""
    return (x * slip_x + z * slip_z) / (slip_x**2 + slip_z**2) ** 0.5 + 0.0  # no negative zero


def budget_table(results: Results, parts: Mapping[str, Mapping[str, Value]], amplitude: Value) -> Table:
    shown = {label: name for name, label in PARTS.items()} | {"sum": "sum", "measured": "slip"}
    columns = {label: [parts[way.name][name] for way in WAYS] for label, name in shown.items()}
    columns["remainder"] = [way.row(results, "3cm").remainder_mm for way in WAYS]
    return table_of("what is done", [way.name for way in WAYS], columns, amplitude=amplitude)


def closing_table(results: Results, least: Value, most: Value) -> Table:
    """Count for each kind of run how many keep the cube, and of how many of these the budget closes."""
    kept = kept_runs(results)
    columns: dict[str, list[Value]] = {}
    for pads, shake in product(PADS, SHAKES):
        runs, name = [row for row in kept if (row.pads, row.shake) == (pads, shake)], f"{pads}_{shake}"
        remainders, slips = [row.remainder_mm for row in runs], [row.slip_mm for row in runs]
        for above, value in {
            "keep the cube": run_count(results, f"kept_{name}", runs),
            "budget closes": closed_count(results, f"closed_{name}", runs, least, most),
            "largest remainder": extreme(results, f"remainder_{name}", "largest remainder", max, remainders),
            "largest slip": extreme(results, f"slip_{name}", "largest slip", max, slips),
        }.items():
            columns.setdefault(above, []).append(value)
    return table_of("runs", [f"{pads}, {shake}" for pads, shake in product(PADS.values(), SHAKES.values())], columns)


def lacks_the_sway(results: Results, amplitude: Value) -> Claim:
    """Tell whether what the budget leaves of the widest shake is a matter of soft pads, in which the cube sways."""
    soft, stiff = (results.derived[f"remainder_{pads}_10cm"] for pads in PADS)
    formula = "largest remainder with shipped pads over that with stiff ones"
    more = ratio(results, "remainder_ratio", formula, soft, stiff)
    numbers = {"soft": soft, "stiff": stiff, "amplitude": amplitude}
    return Claim("lacks_the_sway", at_least(more, 3.0, why="clearly more"), numbers)


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
