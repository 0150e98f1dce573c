"""Whether double precision, in MuJoCo's own loop in C, sees a difference where something is left out."""

from collections.abc import Sequence

from measured_report.claims.claim import Claim, at_most
from measured_report.parts.section import Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.names import case_html, cases_html
from report.sections.leave_out.variants import REFERENCE, is_identical
from report.shared.arithmetic import Column, difference, friction_rows_differ, largest_size, noise_floor, table_of


def change_in_double(results: Results, row: Row) -> Value:
    name, formula = f"{row.case}_change", f"slip of {row.of} less that of {REFERENCE}, both in double precision"
    reference = results.row[f"double-{REFERENCE}"]
    return difference(results, name.replace("-", "_"), formula, row.slip_mm, reference.slip_mm)


def same_in_double(results: Results, rows: Sequence[Row], changes: Sequence[Value]) -> Claim:
    """Tell whether what is left out is none of the model, as far as it is in the engine's model at all."""
    formula = "largest change of the slip in double precision, either way"
    largest = largest_size(results, "double_largest", formula, changes, unit="mm")
    others = [row for row in rows if row.of != REFERENCE]
    formula = "largest distance of cube or TCP from where it is in the reference, in double precision"
    results.value("double_apart", formula, max, *(row.pose_difference_mm for row in others), unit="mm")
    numbers = {"largest": largest, "friction_rows_differ": friction_rows_differ(results.others.get("contacts"))}
    for name, identical in (("same", True), ("moved", False)):
        cases = [row.of for row in others if is_identical(row) == identical]
        numbers |= {name: cases_html(cases), f"has_{name}": bool(cases)}
    return Claim("same_in_double", at_most(largest, noise_floor(results, "slip_floor")), numbers)


def double_table(rows: Sequence[Row], changes: Sequence[Value]) -> Table:
    columns: dict[str, Column] = {
        "slip": "slip_mm",
        "change": changes,
        "same bits": lambda row: "reference" if row.of == REFERENCE else is_identical(row),
        "apart": "pose_difference_mm",
    }
    return table_of("case", [case_html(row.of) for row in rows], columns, rows)
