"""The contact gap: it makes contacts, but none of those that it adds carries force."""

from collections.abc import Iterator

import numpy as np
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import Claim, at_least, at_most, decreases, within
from measured_report.parts.figures import FAINT, INK, SERIES, new_figure, say_value, write
from measured_report.parts.section import Figure, Section
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import by_case, noise_floor, share, spread
from report.shared.variants import is_small

order = 110
label = "contact gap"

CASES = ("cube-gap-default", "cube-gap-0.005", "all-gaps-zero")
COLUMNS = {
    "contacts": "mean_row_count",
    "with force": "mean_loaded_row_count",
    "without: from": "unloaded_near_mm",
    "to": "unloaded_far_mm",
    "most contacts": "peak_contact_count",
    "slip": "slip_mm",
    "drift": "drift_mm_s",
}


def derive(results: Results) -> Section:
    rows = [results.row[case] for case in CASES]
    contacts = Figure(
        draw=lambda: _draw_contacts(rows),
        sources=[column for row in rows for column in (row.mean_row_count, row.mean_loaded_row_count)],
        numbers={"cases": [(name_of(row.case), row.mean_loaded_row_count, row.mean_row_count) for row in rows]},
    )
    return Section(
        tables={"cases": by_case(rows, COLUMNS)},
        figures={"contacts": contacts},
        claims=[*_slip_claims(results, rows), *_contact_claims(results, rows)],
    )


def _slip_claims(results: Results, rows: list[Row]) -> Iterator[Claim]:
    """Tell whether the gap explains the slip, and whether it makes any difference at all."""
    slips, floor = [row.slip_mm for row in rows], noise_floor(results, "slip_floor")
    difference = spread(results, "slip_difference", "largest minus smallest slip of the gaps", slips, unit="mm")
    formula = "difference in slip between the gaps, of the slip with the default gap"
    of_default = share(results, "slip_difference_share", formula, difference, slips[0])
    bound = results.chosen("slip_difference_bound", "too little to explain the slip", 5.0, unit="%")
    numbers = {"difference": difference, "share": of_default, "floor": floor, "slip": slips[0]}
    yield Claim("not_the_cause", is_small(results, "slip_difference", difference, bound, slips[0], floor), numbers)
    yield Claim("within_noise", within(difference, floor), numbers)


def _contact_claims(results: Results, rows: list[Row]) -> Iterator[Claim]:
    """Tell what a gap adds: contacts, but none that carries force, and none that touches."""
    default, small, zero = listed = [row.mean_row_count for row in rows]
    more = decreases(listed, noise=0.5, why="a number of contacts that differs")
    yield Claim("wider_gaps_list_more", more, {"default": default, "small": small, "zero": zero})

    loaded = [row.mean_loaded_row_count for row in rows]
    formula = "largest minus smallest mean number of contacts that carry force"
    same = at_most(spread(results, "loaded_spread", formula, loaded), 0.5, why="the same number of contacts")
    names = ("loaded", "loaded_small", "loaded_zero")
    yield Claim("same_contacts_carry", same, dict(zip(names, loaded, strict=True)))

    near = rows[0].unloaded_near_mm
    yield Claim("idle_contacts_are_far", at_least(near, 0.0, why="surfaces that touch"), {"near": near})


def _draw_contacts(rows: list[Row]) -> Drawing:
    drawing, axes = new_figure(7.2, 2.2)
    there = [row for row in rows if row.mean_row_count.value is not None]
    names, loaded = [name_of(row.case) for row in there], np.array([row.mean_loaded_row_count.value for row in there])
    idle = np.array([row.mean_row_count.value for row in there]) - loaded
    axes.barh(names, loaded, height=0.6, color=SERIES[0], edgecolor=INK, linewidth=0.6, label="carry force")
    axes.barh(names, idle, left=loaded, height=0.6, color=FAINT, edgecolor=INK, linewidth=0.6, label="carry none")
    for place, row in enumerate(there):
        text = write(row.mean_loaded_row_count)
        axes.annotate(text, (loaded[place] / 2, place), fontsize=8.5, ha="center", va="center", color="white")
        say_value(axes, row.mean_row_count.value, place, f"{write(row.mean_row_count)} in all")
    axes.margins(x=0.2)
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("live contacts")
    drawing.legend(loc="outside upper right", ncols=2)
    return drawing
