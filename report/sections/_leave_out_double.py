"""Whether double precision, in MuJoCo's own loop in C, sees a difference where something is left out."""

from collections.abc import Sequence

import pandas as pd

from report.claims import Claim, at_most
from report.parts import Table
from report.quantities import Value
from report.results import Results, Row
from report.sections._common import in_code, noise_floor
from report.sections._leave_out import REFERENCE


def change_in_double(results: Results, row: Row) -> Value:
    return results.value(
        f"{row.case}_change".replace("-", "_"),
        f"slip of {row.of} less that of {REFERENCE}, both in double precision",
        lambda slip, before: slip - before,
        row.slip_mm,
        results.row[f"double-{REFERENCE}"].slip_mm,
        unit="mm",
    )


def same_in_double(results: Results, rows: Sequence[Row], changes: Sequence[Value]) -> Claim:
    """Whether what is left out is none of the model: then differences in single precision are rounding."""
    formula = "largest change of the slip in double precision, either way"
    largest = results.value("double_largest", formula, lambda *change: max(map(abs, change)), *changes, unit="mm")
    floor = noise_floor(results, "slip_floor")
    others = [row for row in rows if row.of != REFERENCE]
    same, moved = ([row.of for row in others if row.bit_identical == identical] for identical in (True, False))
    return Claim(
        "same_in_double",
        at_most(largest, floor),
        holds="In double precision, through MuJoCo's own loop in C, leaving out what is in the engine's model changes "
        "the slip by at most {largest}: not a bit of the trajectory for {same}, and that little for {moved}.",
        fails="In double precision, through MuJoCo's own loop in C, the slip does change, by up to {largest}, where "
        "single runs of one and the same case differ by up to {floor} in single precision.",
        unknown="Whether double precision shows a difference cannot be told.",
        numbers={"largest": largest, "floor": floor, "same": in_code(same), "moved": in_code(moved)},
        explanation="So it is the same model, and what single precision shows beyond that is rounding.",
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
