"""Whether double precision, in MuJoCo's own loop in C, sees a difference where something is left out."""

from collections.abc import Sequence

import pandas as pd

from measured_report.claims.claims import Claim, at_most
from measured_report.parts.parts import Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.names import case_html, cases_html
from report.sections.leave_out.variants import REFERENCE, is_identical
from report.shared.arithmetic import difference, friction_rows_differ, noise_floor


def change_in_double(results: Results, row: Row) -> Value:
    name, formula = f"{row.case}_change", f"slip of {row.of} less that of {REFERENCE}, both in double precision"
    reference = results.row[f"double-{REFERENCE}"]
    return difference(results, name.replace("-", "_"), formula, row.slip_mm, reference.slip_mm)


def same_in_double(results: Results, rows: Sequence[Row], changes: Sequence[Value]) -> Claim:
    """Whether what is left out is none of the model, as far as it is in the engine's model at all."""
    formula = "largest change of the slip in double precision, either way"
    largest = results.value("double_largest", formula, lambda *change: max(map(abs, change)), *changes, unit="mm")
    others = [row for row in rows if row.of != REFERENCE]
    same, moved = ([row for row in others if is_identical(row) == identical] for identical in (True, False))
    results.value(
        "double_apart",
        "largest distance of cube or TCP from where it is in the reference, in double precision",
        max,
        *[row.pose_difference_mm for row in others],
        unit="mm",
    )
    floor = noise_floor(results, "slip_floor")
    return Claim(
        "same_in_double",
        at_most(largest, floor),
        numbers={
            "largest": largest,
            "has_same": bool(same),
            "has_moved": bool(moved),
            "same": cases_html(row.of for row in same),
            "moved": cases_html(row.of for row in moved),
            "friction_rows_differ": friction_rows_differ(results.others.get("contacts")),
        },
    )


def double_table(rows: Sequence[Row], changes: Sequence[Value]) -> Table:
    columns = {
        "slip": [row.slip_mm for row in rows],
        "change": changes,
        "same bits": ["reference" if row.of == REFERENCE else is_identical(row) for row in rows],
        "apart": [row.pose_difference_mm for row in rows],
    }
    return Table(pd.DataFrame(columns, index=pd.Index([case_html(row.of) for row in rows], name="case")))
