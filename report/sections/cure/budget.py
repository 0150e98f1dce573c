"""The slip's causes taken out one by one and together: what is predicted, what is measured, and what to use."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import SERIES, new_figure, write
from report.shared import (
    MM_PER_M,
    PERCENT,
    Claim,
    Figure,
    Results,
    Row,
    Section,
    Table,
    Value,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    rows_with,
    table_of,
)
from report.shared.drawing import mark_points, name_lines

SHIPPED = "newton-implicitfast-50-shipped-{}-plain-rounded"
STIFF = "newton-implicitfast-50-stiff-{}-plain-rounded"
TERM = "newton-implicitfast-50-shipped-{}-term-rounded"
BEST = "newton-euler-400-shipped-{}-full-kept"
FIRM = "newton-implicitfast-400-stiff-{}-centred-kept"
KF_OFF = "newton-implicitfast-50-shipped-{}-kf-off"  # of releases that read ``kf``
NAMES = {  # names by case, which has a gap for the shake: contacts, integrator, impratio, pads; term and positions
    SHIPPED: "as shipped",
    STIFF: "stiff pads, the fix",
    "newton-implicitfast-50-stiff-{}-term-rounded": "stiff pads and the term",
    TERM: "the term",
    "newton-euler-50-shipped-{}-centred-rounded": "the term centred, Euler",
    "newton-euler-400-shipped-{}-centred-rounded": "the same, high impratio",
    "newton-euler-400-shipped-{}-centred-kept": "the same, positions compensated",
    BEST: "the root cure, in normal rows too",
    FIRM: "stiff pads and the root cure",
    "newton-euler-400-stiff-{}-centred-kept": "the same, Euler",
    KF_OFF: "as shipped, kf off",
}
PARTS = {
    "left_out": "the term",
    "step": "step",
    "damping": "damping",
    "creep": "load",
    "rounding": "rounding",
}
"""Columns of the parts of the slip that are predicted from the arm's motion, and what they are called."""
SHOWN = (SHIPPED, STIFF, TERM, BEST)  # variants whose parts are shown
SHAKES = {  # label, colour and mark of each shake
    "3cm": ("the shake", SERIES[0], "o"),
    "10cm": ("a wider shake", SERIES[1], "s"),
    "held": ("held still", SERIES[5], "^"),
}
OTHER_CONTACTS = {  # the root cure with other contacts than Newton's and with another cone
    "mujoco": "mujoco-euler-400-shipped-3cm-full-kept",
    "pyramid": "pyramidal-euler-400-shipped-3cm-full-kept",
}


def derive(results: Results) -> Section:
    others, why = [], "as good as with Newton's contacts, or nearly"
    for name, case in OTHER_CONTACTS.items():
        slip = results.row[case].slip_mm
        others.append(
            Claim(f"with_{name}", at_most(slip, 0.1, why=why), {"slip": slip})
        )
    claims = [_what_to_use(results), _budget_closes(results), *others]
    cases = [
        case for case in NAMES if case != KF_OFF or results.row[case.format("3cm")]
    ]
    rows = {
        shake: [results.row[case.format(shake)] for case in cases] for shake in SHAKES
    }
    cells = [row.slip_mm for column in rows.values() for row in column if row]
    use = Figure(lambda: _draw_use([NAMES[case] for case in cases], rows), cells)
    return Section(
        tables={"budget": _budget_table(results)}, figures={"use": use}, claims=claims
    )


def _draw_use(names: Sequence[str], rows: Mapping[str, Sequence[Row]]) -> Drawing:
    """Draw the slips of each way, a mark for each shake; a cube that is lost is a cross on the edge."""
    drawing, axes = new_figure(7.2, 1.2 + 0.34 * len(names))
    slips = [
        row.slip_mm.value
        for column in rows.values()
        for row in column
        if row and row.slip_mm.value
    ]
    edge = 4 * max(slips, default=1.0)
    for shake, (label, colour, marker) in SHAKES.items():
        points = [
            (row.slip_mm.value, place) for place, row in enumerate(rows[shake]) if row
        ]
        mark_points(
            axes, points, label=label, color=colour, marker=marker, markersize=7
        )
        lost = [
            (edge, place)
            for place, row in enumerate(rows[shake])
            if row and row.plain.get("dropped")
        ]
        mark_points(axes, lost, color=colour, marker="X", markersize=8)
    for place, row in enumerate(rows["3cm"]):
        if row and row.slip_mm.value is not None:
            above = {"xytext": (0, 5), "textcoords": "offset points", "ha": "center"}
            axes.annotate(
                write(row.slip_mm), (row.slip_mm.number, place), fontsize=8, **above
            )
    name_lines(axes, names)
    axes.set(xscale="log", xlabel="slip [mm]")
    axes.margins(y=0.1)
    drawing.legend(loc="outside upper left", ncols=3)
    return drawing


def _what_to_use(results: Results) -> Claim:
    """Tell whether the cure on stiff pads loses no cube that they keep, shaken 10 cm as well, and slips less."""
    narrow, wide = (results.row[FIRM.format(shake)] for shake in ("3cm", "10cm"))
    slip, shipped, far = (
        narrow.slip_mm,
        results.row[SHIPPED.format("3cm")].slip_mm,
        wide.slip_mm,
    )
    amplitude = results.value(
        "amplitude_10cm",
        "in whole mm",
        combined(round, MM_PER_M * wide.shake_amplitude_m),
    )
    lost, kept = results.derived["limit_lost_firm"], results.derived["kept_firm"]
    part = results.value(
        "held_share", "of the slip as shipped, that", PERCENT * slip / shipped
    )
    keeps, near = (
        at_most(lost, 0, why="none of them is lost"),
        at_most(part, 50.0, why="less by half"),
    )
    outcome = all_of(
        keeps, at_most(far, 0.05, why="hardly more, shaken three times as wide"), near
    )
    numbers = {
        "slip": slip,
        "shipped": shipped,
        "far": far,
        "amplitude": amplitude,
        "lost": lost,
        "kept": kept,
    }
    return Claim("what_to_use", outcome, numbers)


def _budget_closes(results: Results) -> Claim:
    least = results.chosen(
        "remainder_least", "what a grasp of this kind does not show", 0.02, "mm"
    )
    most = results.chosen("remainder_share", "as good as the law", 5.0, "%")
    runs = [
        row for row in rows_with(results, "kind", "pads", "shake") if row.kind == "run"
    ]
    holding = [row for row in runs if row.slip_mm.value is not None]

    def count_closed(least: float, most: float, *found: float) -> int:
        cells = np.array(
            found
        )  # of a thousand runs, each moved in turn to find the noise
        return np.count_nonzero(
            cells[::2] <= np.maximum(least, 0.01 * most * cells[1::2])
        )

    def counted(name: str, rows: list[Row]) -> tuple[Value, Value]:
        cells = (cell for row in rows for cell in (row.remainder_mm, row.slip_mm))
        closed = results.value(
            f"{name}closed_count",
            "runs whose remainder is below either bound",
            count_closed,
            least,
            most,
            *cells,
        )
        slips = [row.slip_mm for row in rows]
        return closed, results.value(
            f"{name}kept_count", "runs that keep the cube", cell_count(slips)
        )

    closed, count = counted("", holding)
    far_closed, far = counted(
        "far_",
        [row for row in holding if (row["pads"], row.shake) == ("shipped", "10cm")],
    )
    part = results.value(
        "others_share",
        "of the other runs that keep the cube, those of them",
        PERCENT * (closed - far_closed) / (count - far),
    )
    numbers = {
        "closed": closed,
        "count": count,
        "far_closed": far_closed,
        "far": far,
        "least": least,
        "most": most,
    }
    few = results.value(
        "far_share",
        "of shipped pads in the farther shake, those of them",
        PERCENT * far_closed / far,
    )
    tests = [
        at_least(closed, 8.0, why="not by chance"),
        at_least(part, 90.0, why="nearly all of them"),
    ]
    return Claim(
        "budget_closes",
        all_of(*tests, at_most(few, 60.0, why="no more than some")),
        numbers,
    )


def _budget_table(results: Results) -> Table:
    """Make the table of the parts at 3 cm along the way of the cube, their sum, and how far it went."""

    def along(x: float, z: float, slip_x: float, slip_z: float) -> float:
        return (x * slip_x + z * slip_z) / (
            slip_x**2 + slip_z**2
        ) ** 0.5 + 0.0  # no negative zero

    def part(row: Row, name: str, column: str) -> Value:
        cells = (
            row[f"{column}_x_mm"],
            row[f"{column}_z_mm"],
            row.slip_x_mm,
            row.slip_z_mm,
        )
        return results.value(
            f"{row.case}_{name}",
            f"{column} of {row.case} along the pads, in the direction of its slip",
            along,
            *cells,
            unit="mm",
        )

    shown = {label: (name, name) for name, label in PARTS.items()}
    shown |= {"sum": ("sum", "predicted"), "measured": ("slip", "slip")}
    rows = [results.row[case.format("3cm")] for case in SHOWN]
    columns = {
        label: [part(row, *names) for row in rows] for label, names in shown.items()
    }
    return table_of("what is done", [NAMES[case] for case in SHOWN], columns)
