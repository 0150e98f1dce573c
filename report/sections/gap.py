"""The contact gap: it makes contacts, but none of those that it adds carries force."""

import numpy as np
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, at_least, at_most, decreases, within
from measured_report.parts.figures import FAINT, INK, SERIES, new_figure, say_value, write
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import by_case, noise_floor, share, spread
from report.shared.variants import is_small

order = 110
label = "contact gap"

CASES = ("cube-gap-default", "cube-gap-0.005", "all-gaps-zero")


def derive(results: Results) -> Section:
    rows = [results.row[case] for case in CASES]
    contacts = Figure(
        draw=lambda: _draw_contacts(rows),
        sources=[column for row in rows for column in (row.mean_row_count, row.mean_loaded_row_count)],
        numbers={"cases": [(name_of(row.case), row.mean_loaded_row_count, row.mean_row_count) for row in rows]},
    )
    return Section(
        tables={"cases": _table(rows)},
        figures={"contacts": contacts},
        claims=[
            *_slip_claims(results, rows),
            _wider_gaps_list_more(rows),
            _same_contacts_carry(results, rows),
            _idle_contacts_are_far(rows[0]),
        ],
    )


def _slip_claims(results: Results, rows: list[Row]) -> list[Claim]:
    """Whether the gap explains the slip, and whether it makes any difference at all."""
    slips = [row.slip_mm for row in rows]
    difference = spread(results, "slip_difference", "largest minus smallest slip of the gaps", slips, unit="mm")
    formula = "difference in slip between the gaps, of the slip with the default gap"
    of_default = share(results, "slip_difference_share", formula, difference, slips[0])
    bound = results.chosen("slip_difference_bound", "too little to explain the slip", 5.0, unit="%")
    floor = noise_floor(results, "slip_floor")
    numbers = {"difference": difference, "share": of_default, "floor": floor}
    return [
        Claim(
            "not_the_cause",
            is_small(results, "slip_difference", difference, bound, slips[0], floor),
            numbers=numbers | {"slip": slips[0]},
        ),
        Claim("within_noise", within(difference, floor), numbers=numbers),
    ]


def _wider_gaps_list_more(rows: list[Row]) -> Claim:
    default, small, zero = (row.mean_row_count for row in rows)
    return Claim(
        "wider_gaps_list_more",
        decreases([default, small, zero], noise=0.5, why="a number of contacts that differs"),
        numbers={"default": default, "small": small, "zero": zero},
    )


def _same_contacts_carry(results: Results, rows: list[Row]) -> Claim:
    default, small, zero = rows
    formula = "largest minus smallest mean number of contacts that carry force"
    difference = spread(results, "loaded_spread", formula, [row.mean_loaded_row_count for row in rows])
    return Claim(
        "same_contacts_carry",
        at_most(difference, 0.5, why="the same number of contacts"),
        numbers={
            "loaded": default.mean_loaded_row_count,
            "loaded_small": small.mean_loaded_row_count,
            "loaded_zero": zero.mean_loaded_row_count,
        },
    )


def _idle_contacts_are_far(default: Row) -> Claim:
    return Claim(
        "idle_contacts_are_far",
        at_least(default.unloaded_near_mm, 0.0, why="surfaces that touch"),
        numbers={"near": default.unloaded_near_mm},
    )


def _table(rows: list[Row]) -> Table:
    columns = {
        "contacts": [row.mean_row_count for row in rows],
        "with force": [row.mean_loaded_row_count for row in rows],
        "without: from": [row.unloaded_near_mm for row in rows],
        "to": [row.unloaded_far_mm for row in rows],
        "most contacts": [row.peak_contact_count for row in rows],
        "slip": [row.slip_mm for row in rows],
        "drift": [row.drift_mm_s for row in rows],
    }
    return by_case(rows, columns)


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
