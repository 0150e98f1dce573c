"""Whether double precision, in MuJoCo's own loop in C, sees a difference where something is left out."""

from collections.abc import Sequence

import pandas as pd

from report.claims import Claim, at_most
from report.parts import Table
from report.quantities import Value
from report.results import Results, Row
from report.sections._common import difference, friction_rows_differ, in_code, noise_floor
from report.sections._leave_out import REFERENCE

C_DIFFERS = " There friction rows have no time constant of their own, so the slip as such is another one."


def change_in_double(results: Results, row: Row) -> Value:
    name, formula = f"{row.case}_change", f"slip of {row.of} less that of {REFERENCE}, both in double precision"
    reference = results.row[f"double-{REFERENCE}"]
    return difference(results, name.replace("-", "_"), formula, row.slip_mm, reference.slip_mm)


def same_in_double(results: Results, rows: Sequence[Row], changes: Sequence[Value]) -> Claim:
    """Whether what is left out is none of the model, as far as it is in the engine's model at all."""
    formula = "largest change of the slip in double precision, either way"
    largest = results.value("double_largest", formula, lambda *change: max(map(abs, change)), *changes, unit="mm")
    others = [row for row in rows if row.of != REFERENCE]
    same, moved = ([row for row in others if row.bit_identical == identical] for identical in (True, False))
    apart = results.value(
        "double_apart",
        "largest distance of cube or TCP from where it is in the reference, in double precision",
        max,
        *[row.pose_difference_mm for row in others],
        unit="mm",
    )
    note = C_DIFFERS if friction_rows_differ(results.others.get("contacts")) else ""
    floor = noise_floor(results, "slip_floor")
    return Claim(
        "same_in_double",
        at_most(largest, floor),
        holds="In double precision, through MuJoCo's own loop in C, leaving out what is in the engine's model changes "
        "the slip by at most {largest}: "
        + ("not a bit of the trajectory for {same}, and " if same else "")
        + "it moves cube or TCP by up to {apart} for {moved}."
        + note,
        fails="In double precision, through MuJoCo's own loop in C, leaving out what is in the engine's model changes "
        "the slip by up to {largest}, more than the noise floor of {floor}." + note,
        unknown="Whether double precision shows a difference cannot be told.",
        numbers={
            "largest": largest,
            "floor": floor,
            "apart": apart,
            "same": in_code(row.of for row in same),
            "moved": in_code(row.of for row in moved),
        },
        explanation="So the change of the model itself makes only that much. What is more shows in single precision "
        "only, or with a change in how the model is run.",
    )


def double_table(rows: Sequence[Row], changes: Sequence[Value]) -> Table:
    columns = {
        "slip": [row.slip_mm for row in rows],
        "change": changes,
        "same bits": ["reference" if row.of == REFERENCE else row.bit_identical for row in rows],
        "apart": [row.pose_difference_mm for row in rows],
    }
    caption = (
        "The shake from one and the same state through MuJoCo's own loop in C, in double precision, for what changes "
        "the engine's model. Apart: as above, of cube and TCP."
    )
    return Table(pd.DataFrame(columns, index=pd.Index([row.of for row in rows], name="case")), caption)
