"""The slip's causes taken out one by one and together: what is predicted, what is measured, and what to use."""

import numpy as np

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section, Table
from measured_report.values.quantities import PERCENT, Value, combined
from measured_report.values.results import Results, Row
from report.shared.arithmetic import MM_PER_M, cell_count, rows_with
from report.shared.tables import cell_or_lost, table_of

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
PARTS = {"left_out": "the term", "step": "step", "damping": "damping", "creep": "load", "rounding": "rounding"}
"""Columns of the parts of the slip that are predicted from the arm's motion, and what they are called."""
SHOWN = (SHIPPED, STIFF, TERM, BEST)  # variants whose parts are shown
OTHER_CONTACTS = {  # the root cure with other contacts than Newton's and with another cone
    "mujoco": "mujoco-euler-400-shipped-3cm-full-kept",
    "pyramid": "pyramidal-euler-400-shipped-3cm-full-kept",
}


def derive(results: Results) -> Section:
    others, why = [], "as good as with Newton's contacts, or nearly"
    for name, case in OTHER_CONTACTS.items():
        slip = results.row[case].slip_mm
        others.append(Claim(f"with_{name}", at_most(slip, 0.1, why=why), {"slip": slip}))
    tables = {"use": _use_table(results), "budget": _budget_table(results)}
    return Section(tables=tables, claims=[_what_to_use(results), _budget_closes(results), *others])


def _use_table(results: Results) -> Table:
    cases = [case for case in NAMES if case != KF_OFF or results.row[case.format("3cm")]]
    columns = {
        above: [cell_or_lost(results.row[case.format(shake)], "slip_mm") for case in cases]
        for above, shake in (("shaken 30 mm", "3cm"), ("shaken 100 mm", "10cm"), ("held still", "held"))
    }
    return table_of("what is done", [NAMES[case] for case in cases], columns)


def _what_to_use(results: Results) -> Claim:
    """Tell whether the cure on stiff pads loses no cube that they keep, shaken 10 cm as well, and slips less."""
    narrow, wide = (results.row[FIRM.format(shake)] for shake in ("3cm", "10cm"))
    slip, shipped, far = narrow.slip_mm, results.row[SHIPPED.format("3cm")].slip_mm, wide.slip_mm
    amplitude = results.value("amplitude_10cm", "in whole mm", combined(round, MM_PER_M * wide.shake_amplitude_m))
    lost, kept = results.derived["limit_lost_firm"], results.derived["kept_firm"]
    part = results.value("held_share", "of the slip as shipped, that", PERCENT * slip / shipped)
    keeps, near = at_most(lost, 0, why="none of them is lost"), at_most(part, 50.0, why="less by half")
    outcome = all_of(keeps, at_most(far, 0.05, why="hardly more, shaken three times as wide"), near)
    numbers = {"slip": slip, "shipped": shipped, "far": far, "amplitude": amplitude, "lost": lost, "kept": kept}
    return Claim("what_to_use", outcome, numbers)


def _budget_closes(results: Results) -> Claim:
    least = results.chosen("remainder_least", "what a grasp of this kind does not show", 0.02, "mm")
    most = results.chosen("remainder_share", "as good as the law", 5.0, "%")
    runs = [row for row in rows_with(results, "kind", "pads", "shake") if row.kind == "run"]
    holding = [row for row in runs if row.slip_mm.value is not None]

    def count_closed(least: float, most: float, *found: float) -> int:
        cells = np.array(found)  # of a thousand runs, each moved in turn to find the noise
        return np.count_nonzero(cells[::2] <= np.maximum(least, 0.01 * most * cells[1::2]))

    def counted(name: str, rows: list[Row]) -> tuple[Value, Value]:
        cells = (cell for row in rows for cell in (row.remainder_mm, row.slip_mm))
        formula = "runs whose remainder is below either bound"
        closed = results.value(f"{name}closed_count", formula, count_closed, least, most, *cells)
        slips = [row.slip_mm for row in rows]
        return closed, results.value(f"{name}kept_count", "runs that keep the cube", cell_count(slips))

    closed, count = counted("", holding)
    far_closed, far = counted("far_", [row for row in holding if (row["pads"], row.shake) == ("shipped", "10cm")])
    formula = "of the other runs that keep the cube, those of them"
    part = results.value("others_share", formula, PERCENT * (closed - far_closed) / (count - far))
    numbers = {"closed": closed, "count": count, "far_closed": far_closed, "far": far, "least": least, "most": most}
    few = results.value("far_share", "of shipped pads in the farther shake, those of them", PERCENT * far_closed / far)
    tests = [at_least(closed, 8.0, why="not by chance"), at_least(part, 90.0, why="nearly all of them")]
    return Claim("budget_closes", all_of(*tests, at_most(few, 60.0, why="no more than some")), numbers)


def _budget_table(results: Results) -> Table:
    """Make the table of the parts at 3 cm along the way of the cube, their sum, and how far it went."""

    def along(x: float, z: float, slip_x: float, slip_z: float) -> float:
        return (x * slip_x + z * slip_z) / (slip_x**2 + slip_z**2) ** 0.5 + 0.0  # no negative zero

    def part(row: Row, name: str, column: str) -> Value:
        formula = f"{column} of {row.case} along the pads, in the direction of its slip"
        cells = row[f"{column}_x_mm"], row[f"{column}_z_mm"], row.slip_x_mm, row.slip_z_mm
        return results.value(f"{row.case}_{name}", formula, along, *cells, unit="mm")

    shown = {label: (name, name) for name, label in PARTS.items()}
    shown |= {"sum": ("sum", "predicted"), "measured": ("slip", "slip")}
    rows = [results.row[case.format("3cm")] for case in SHOWN]
    columns = {label: [part(row, *names) for row in rows] for label, names in shown.items()}
    return table_of("what is done", [NAMES[case] for case in SHOWN], columns)
