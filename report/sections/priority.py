"""Test whether a contact has the pads' material, the cube's, or a mix of both."""

import math

from experiments.facts.case import AS_SHIPPED
from report.shared import (
    PERCENT,
    Claim,
    Results,
    Row,
    Section,
    all_of,
    at_most,
    by_case,
    greater,
    negligible,
    spread,
)

order = 100
page = "fix"
label = "contact priority"
labels = {
    "cube-ke-#": "cube's ke {}",
    "pad-ke-2.5e5": "stiff pads",
    "priority-0": "equal priorities",
    "priority-0-cube-ke-8e5": "equal priorities, stiffer cube",
}

CUBE = ("cube-ke-8e3", "cube-ke-8e4", "cube-ke-8e5")


def derive(results: Results) -> Section:
    low, shipped, high = rows = [results.row[case] for case in CUBE]
    mixed = results.row["priority-0"]

    spreads = [
        results.value(
            f"cube_{column}_spread",
            f"largest minus smallest {column} of the contact,"
            " over the three stiffnesses of the cube",
            spread([row[column] for row in rows]),
        )
        for column in ("timeconst_s", "dampratio", "friction", "dmin", "dmax")
    ]
    largest = results.value(
        "cube_resolved_spread", "largest of these spreads", max, *spreads
    )
    change = results.value(
        "cube_slip_spread",
        "largest minus smallest slip over the three stiffnesses of the cube",
        spread([row.slip_mm for row in rows]),
    )
    share = results.value(
        "cube_slip_share",
        "this difference, relative to the slip as shipped",
        PERCENT * change / shipped.slip_mm,
    )
    bound = results.chosen("cube_slip_bound", "a negligible change", 2.0, "%")

    drop = results.value(
        "mixed_drop",
        "reduction of the slip if both geoms have the same priority, relative to the"
        " slip as shipped",
        PERCENT * (1 - mixed.slip_mm / shipped.slip_mm),
    )
    before = shipped.timeconst_s
    after = mixed.timeconst_s
    mixes = all_of(
        greater(before, after),
        greater(shipped.slip_mm, mixed.slip_mm),
    )
    columns = {
        "timeconst": "timeconst_s",
        "dampratio": "dampratio",
        "friction": "friction",
        "slip": "slip_mm",
        "material": map(_material, results.rows),
    }
    return Section(
        tables={"materials": by_case(results.rows, columns)},
        claims=[
            Claim(
                "cube_does_not_count",
                at_most(largest, 0.0, "no difference at all"),
                {
                    "low": low.cube_ke,
                    "high": high.cube_ke,
                    "dampratio": shipped.dampratio,
                },
            ),
            Claim(
                "cube_does_not_move_slip",
                negligible(share, bound),
                {"change": share, "bound": bound},
            ),
            Claim(
                "equal_priorities_mix",
                mixes,
                {
                    "before": before,
                    "after": after,
                    "drop": drop,
                    "slip": mixed.slip_mm,
                    "shipped": shipped.slip_mm,
                },
            ),
        ],
    )


def _material(row: Row) -> str:
    """Return whether the timeconst comes from the pads or from a mix of both materials.

    The pads by themselves would give 2 / kd.
    """
    kd = row.pad_kd.value if "pad_kd" in row else AS_SHIPPED.pad_kd
    timeconst = row.timeconst_s.value
    is_of_pads = timeconst is not None and math.isclose(timeconst, 2 / kd, rel_tol=1e-3)
    return "of the pads" if is_of_pads else "of both"
