"""Test whether the contacts that the contact gap adds carry any force."""

from report.shared import (
    PERCENT,
    Claim,
    Results,
    Section,
    all_of,
    decreases,
    negligible,
    spread,
)

order = 62
folded = True
label = "contact gap"
labels = {
    "cube-gap-default": "default gap",
    "cube-gap-#": "cube's gap {} m",
    "all-gaps-zero": "no contact gap",
}

CASES = ("cube-gap-default", "cube-gap-0.005", "all-gaps-zero")


def derive(results: Results) -> Section:
    rows = [results.row[case] for case in CASES]
    slips = [row.slip_mm for row in rows]
    change = results.value(
        "slip_difference", "largest minus smallest slip over the gaps", spread(slips)
    )
    share = results.value(
        "slip_difference_share",
        "this difference, relative to the slip with the default gap",
        PERCENT * change / abs(slips[0]),
    )
    is_small = negligible(share, 5.0, "too little to explain the slip")
    listed = [row.mean_row_count for row in rows]
    loaded = [row.mean_loaded_row_count for row in rows]
    same = all_of(
        decreases(listed, by=0.5, why="a different number of contacts"),
        negligible(spread(loaded), 0.5, why="the same number of contacts"),
    )
    return Section(
        claims=[
            Claim("not_the_cause", is_small, {"share": share, "slip": slips[0]}),
            Claim("same_contacts_carry", same),
        ]
    )
