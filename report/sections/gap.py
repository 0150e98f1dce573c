"""The contact gap: it makes contacts, but none of those that it adds carries force."""

import numpy as np
from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, all_of, decreases, equal_within
from measured_report.parts.figures import FAINT, INK, new_figure, say_value, write
from measured_report.parts.section import Figure, Section
from measured_report.values.results import Results, Row
from report.shared.arithmetic import noise_floor, share, spread
from report.shared.drawing import SHIPPED
from report.shared.variants import is_small

order = 110
reads = ("noise",)
label = "contact gap"
labels = {"cube-gap-default": "default gap", "cube-gap-#": "cube's gap {} m", "all-gaps-zero": "no contact gap"}

CASES = ("cube-gap-default", "cube-gap-0.005", "all-gaps-zero")


def derive(results: Results) -> Section:
    rows = [results.row[case] for case in CASES]
    listed, carry = _contact_claims(rows)
    there = [row for row in rows if None not in (row.mean_row_count.value, row.mean_loaded_row_count.value)]
    contacts = Figure(
        draw=lambda: _draw_contacts(there),
        sources=[column for row in rows for column in (row.mean_row_count, row.mean_loaded_row_count)],
        numbers={
            "cases": [(row.label, row.mean_loaded_row_count, row.mean_row_count) for row in there],
            "is_so": all_of(listed.outcome, carry.outcome) == HOLDS,
        },
    )
    return Section(figures={"contacts": contacts}, claims=[_not_the_cause(results, rows), listed, carry])


def _not_the_cause(results: Results, rows: list[Row]) -> Claim:
    slips, floor = [row.slip_mm for row in rows], noise_floor(results, "slip_floor")
    difference = spread(results, "slip_difference", "largest minus smallest slip of the gaps", slips, unit="mm")
    formula = "difference in slip between the gaps, of the slip with the default gap"
    of_default = share(results, "slip_difference_share", formula, difference, slips[0])
    bound = results.chosen("slip_difference_bound", "too little to explain the slip", 5.0, unit="%")
    outcome = is_small(results, "slip_difference", difference, bound, slips[0], floor)
    return Claim("not_the_cause", outcome, {"difference": difference, "share": of_default, "slip": slips[0]})


def _contact_claims(rows: list[Row]) -> tuple[Claim, Claim]:
    default, small, zero = listed = [row.mean_row_count for row in rows]
    more = decreases(listed, noise=0.5, why="a number of contacts that differs")
    loaded = [row.mean_loaded_row_count for row in rows]
    same = equal_within(loaded, noise=0.5, why="the same number of contacts")
    names = ("loaded", "loaded_small", "loaded_zero")
    return (
        Claim("wider_gaps_list_more", more, {"default": default, "small": small, "zero": zero}),
        Claim("same_contacts_carry", same, dict(zip(names, loaded, strict=True))),
    )


def _draw_contacts(rows: list[Row]) -> Drawing:
    drawing, axes = new_figure(7.2, 2.2)
    names, loaded = [row.label for row in rows], np.array([row.mean_loaded_row_count.value for row in rows])
    idle = np.array([row.mean_row_count.value for row in rows]) - loaded
    axes.barh(names, loaded, height=0.6, color=SHIPPED, edgecolor=INK, linewidth=0.6, label="carry force")
    axes.barh(names, idle, left=loaded, height=0.6, color=FAINT, edgecolor=INK, linewidth=0.6, label="carry none")
    for place, row in enumerate(rows):
        text = f"{write(row.mean_loaded_row_count)} of {write(row.mean_row_count)}"
        say_value(axes, row.mean_row_count.value, place, text)
    axes.margins(x=0.2)
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("live contacts")
    drawing.legend(loc="outside upper right", ncols=2)
    return drawing
