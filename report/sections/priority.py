"""Whose material counts: the same swing of stiffness on the cube and on the pads, and the pads without priority."""

import math

from experiments.facts.case import AS_SHIPPED
from report.shared import (
    HOLDS,
    PERCENT,
    Claim,
    Column,
    Results,
    Row,
    Section,
    all_of,
    at_most,
    by_case,
    greater,
    noise_floor,
    spread,
    within,
)

order = 100
page = "fix"
reads = ("noise",)
label = "whose material counts"
labels = {
    "cube-ke-#": "cube's ke {}",
    "pad-ke-2.5e5": "stiff pads",
    "priority-0": "equal priorities",
    "priority-0-cube-ke-8e5": "equal priorities, stiffer cube",
}

CUBE = ("cube-ke-8e3", "cube-ke-8e4", "cube-ke-8e5")
COLUMNS: dict[str, Column] = {
    "timeconst": "timeconst_s",
    "dampratio": "dampratio",
    "friction": "friction",
}
COLUMNS |= {
    "slip": "slip_mm",
    "material": lambda row: (
        "the pads' alone" if _has_pads_timeconst(row) else "of both"
    ),
}
EXACT = "what a material gives is exact"


def derive(results: Results) -> Section:
    claims = [
        _cube_does_not_count(results),
        _cube_does_not_move_slip(results),
        _equal_priorities_mix(results),
    ]
    return Section(tables={"materials": by_case(results.rows, COLUMNS)}, claims=claims)


def _has_pads_timeconst(row: Row) -> bool:
    """Tell whether the contact's timeconst is 2 / kd of the pads."""
    kd = row.pad_kd.value if "pad_kd" in row else AS_SHIPPED.pad_kd
    return row.timeconst_s.value is not None and math.isclose(
        row.timeconst_s.value, 2 / kd, rel_tol=1e-3
    )


def _cube_does_not_count(results: Results) -> Claim:
    rows, spreads = [results.row[case] for case in CUBE], []
    for column in ("timeconst_s", "dampratio", "friction", "dmin", "dmax"):
        cells = [row[column] for row in rows]
        spreads.append(
            results.value(
                f"cube_{column}_spread",
                f"largest less smallest {column} of the contact, over the three stiffnesses of the cube",
                spread(cells),
            )
        )
    largest = results.value(
        "cube_resolved_spread", "largest of these spreads", max, *spreads
    )
    numbers = {
        "low": rows[0].cube_ke,
        "high": rows[-1].cube_ke,
        "dampratio": rows[1].dampratio,
    }
    return Claim(
        "cube_does_not_count",
        at_most(largest, 0.0, why="no difference at all"),
        numbers,
    )


def _cube_does_not_move_slip(results: Results) -> Claim:
    low, shipped, high = (results.row[case] for case in CUBE)
    change = results.value(
        "cube_slip_spread",
        "largest less smallest slip over the three stiffnesses of the cube",
        spread([row.slip_mm for row in (low, shipped, high)]),
    )
    share = results.value(
        "cube_slip_share",
        "that spread, of the slip as shipped",
        PERCENT * change / shipped.slip_mm,
    )
    floor = noise_floor(results, "slip_floor")
    small = at_most(share, 2.0, why="no change to speak of")
    outcome = (
        small.having_read(floor)
        if small == HOLDS
        else within(change, floor).having_read(share)
    )
    return Claim("cube_does_not_move_slip", outcome, {"change": change})


def _equal_priorities_mix(results: Results) -> Claim:
    shipped, mixed = results.row["cube-ke-8e4"], results.row["priority-0"]
    before, after = shipped.timeconst_s, mixed.timeconst_s
    drop = results.value(
        "mixed_drop",
        "how much the slip falls when both geoms have the same priority, of the slip as shipped",
        PERCENT * (1 - mixed.slip_mm / shipped.slip_mm),
    )
    falls = greater(
        shipped.slip_mm, mixed.slip_mm, noise=noise_floor(results, "slip_floor")
    )
    numbers = {
        "before": before,
        "after": after,
        "drop": drop,
        "slip": mixed.slip_mm,
        "shipped": shipped.slip_mm,
    }
    return Claim(
        "equal_priorities_mix",
        all_of(greater(before, after, noise=0.0, why=EXACT), falls),
        numbers,
    )
