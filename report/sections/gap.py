"""The contact gap: it makes contacts, but none of those that it adds carries force."""

from report.shared import (
    PERCENT,
    Claim,
    Results,
    Section,
    all_of,
    decreases,
    equal_within,
    is_small,
    noise_floor,
    spread,
    unseen_in,
)

order = 110
reads = ("noise",)
label = "contact gap"
labels = {
    "cube-gap-default": "default gap",
    "cube-gap-#": "cube's gap {} m",
    "all-gaps-zero": "no contact gap",
}

CASES = ("cube-gap-default", "cube-gap-0.005", "all-gaps-zero")


def derive(results: Results) -> Section:
    rows = [results.row[case] for case in CASES]
    slips, floor = [row.slip_mm for row in rows], noise_floor(results, "slip_floor")
    difference = results.value(
        "slip_difference", "largest minus smallest slip of the gaps", spread(slips)
    )
    of_default = results.value(
        "slip_difference_share",
        "difference in slip between the gaps, of the slip with the default gap",
        PERCENT * difference / slips[0],
    )
    bound = results.chosen(
        "slip_difference_bound", "too little to explain the slip", 5.0, "%"
    )
    outcome = is_small(results, "slip_difference", difference, bound, slips[0], floor)
    unseen = unseen_in(difference, floor)
    claims = [
        Claim(
            "not_the_cause",
            outcome,
            {"share": of_default, "slip": slips[0], "unseen": unseen},
        )
    ]
    loaded, listed = (
        [row[name] for row in rows]
        for name in ("mean_loaded_row_count", "mean_row_count")
    )
    more = decreases(listed, noise=0.5, why="a number of contacts that differs")
    same = equal_within(loaded, noise=0.5, why="the same number of contacts")
    return Section(claims=[*claims, Claim("same_contacts_carry", all_of(more, same))])
