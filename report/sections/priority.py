"""Whose material counts: the same swing of stiffness on the cube and on the pads, and the pads without priority."""

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import HOLDS, Claim, all_of, at_least, at_most, equal_within, greater, within
from measured_report.parts.figures import SERIES, new_figure
from measured_report.parts.section import Figure, Section
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import (
    Column,
    by_case,
    departure,
    noise_floor,
    ratio,
    settles,
    share,
    size_difference,
    spread,
)
from report.shared.variants import is_small

order = 100
page = "fix"
label = "whose material counts"

CUBE = ("cube-ke-8e3", "cube-ke-8e4", "cube-ke-8e5")
RESOLVED = ("timeconst_s", "dampratio", "friction", "dmin", "dmax")
"""What the contact has after the two sides' materials are combined."""
COLUMNS = {"timeconst": "timeconst_s", **{column: column for column in ("dampratio", "friction", "dmin", "dmax")}}
COLUMNS |= {"slip": "slip_mm", "drift": "drift_mm_s"}
EXACT = "what a material gives is exact"


def derive(results: Results) -> Section:
    rows, shipped = results.rows, results.row["cube-ke-8e4"]
    said = Markup("; ").join(Markup("{}: {}").format(name_of(row.case), row.slip_mm) for row in rows)
    slips = Figure(lambda: _draw_slips(rows), [row.slip_mm for row in rows], {"slips": said})
    changed: dict[str, Column] = {
        column.replace("_", " "): [row[column] if column in row else "" for row in rows]  # noqa: SIM401 a row has no get
        for column in ("cube_ke", "pad_ke", "pad_kd", "pad_priority")
    }
    return Section(
        tables={"cases": by_case(rows, {**changed, **COLUMNS})},
        figures={"slips": slips},
        claims=[
            _cube_does_not_count(results),
            _cube_does_not_move_slip(results),
            _pads_count(results, shipped),
            _equal_priorities_mix(results, shipped),
            _cube_stiffness_is_no_lever(results),
        ],
    )


def _cube_does_not_count(results: Results) -> Claim:
    rows = [results.row[case] for case in CUBE]
    spreads = []
    for column in RESOLVED:
        cells = [row[column] for row in rows]
        formula = f"largest less smallest {column} of the contact, over the three stiffnesses of the cube"
        spreads.append(spread(results, f"cube_{column}_spread", formula, cells, unit=cells[0].unit))
    largest = results.value("cube_resolved_spread", "largest of these spreads", max, *spreads)
    numbers = {"low": rows[0].cube_ke, "high": rows[-1].cube_ke, "timeconst": rows[1].timeconst_s}
    numbers |= {"dampratio": rows[1].dampratio, "friction": rows[1].friction}
    return Claim("cube_does_not_count", at_most(largest, 0.0, why="no difference at all"), numbers)


def _cube_does_not_move_slip(results: Results) -> Claim:
    low, shipped, high = (results.row[case] for case in CUBE)
    formula = "largest less smallest slip over the three stiffnesses of the cube"
    change = spread(results, "cube_slip_spread", formula, [row.slip_mm for row in (low, shipped, high)], unit="mm")
    formula = "that spread, of the slip as shipped"
    of_shipped = share(results, "cube_slip_share", formula, change, shipped.slip_mm)
    floor = noise_floor(results, "slip_floor")
    as_noise, small = within(change, floor), at_most(of_shipped, 2.0, why="no change to speak of")
    numbers = {"low": low.cube_ke, "high": high.cube_ke, "spread": change, "share": of_shipped, "floor": floor}
    outcome = small.having_read(floor) if small == HOLDS else as_noise.having_read(of_shipped)
    return Claim("cube_does_not_move_slip", outcome, {**numbers, "is_noise": as_noise == HOLDS})


def _pads_count(results: Results, shipped: Row) -> Claim:
    stiff = results.row["pad-ke-2.5e5"]
    gain = ratio(results, "pad_gain", "slip as shipped over slip with stiff pads", shipped.slip_mm, stiff.slip_mm)
    numbers = {"ke": stiff.pad_ke, "kd": stiff.pad_kd, "slip": stiff.slip_mm, "gain": gain}
    return Claim("pads_count", settles(gain), numbers)


def _equal_priorities_mix(results: Results, shipped: Row) -> Claim:
    mixed = results.row["priority-0"]
    before, after = shipped.timeconst_s, mixed.timeconst_s
    formula = "how much the slip falls when both geoms have the same priority, of the slip as shipped"
    slips = shipped.slip_mm, mixed.slip_mm
    drop = results.value("mixed_drop", formula, lambda then, now: 100 * (1 - now / then), *slips, unit="%")
    falls = greater(shipped.slip_mm, mixed.slip_mm, noise=noise_floor(results, "slip_floor"))
    numbers = {"before": before, "after": after, "drop": drop, "slip": mixed.slip_mm, "shipped": shipped.slip_mm}
    return Claim("equal_priorities_mix", all_of(greater(before, after, noise=0.0, why=EXACT), falls), numbers)


def _cube_stiffness_is_no_lever(results: Results) -> Claim:
    """Tell whether the cube gets stiffer and sinks in less, and nothing else changes."""
    mixed, stiffer = results.row["priority-0"], results.row["priority-0-cube-ke-8e5"]
    formula = "change of slip with the stiffer cube under equal priorities, of the slip with the cube as authored"
    change = departure(results, "mixed_cube_change", formula, stiffer.slip_mm, mixed.slip_mm)
    size = size_difference(results, "mixed_cube_size", "size of that change", stiffer.slip_mm, mixed.slip_mm)
    bound = results.chosen("mixed_cube_bound", "no lever", 5.0, unit="%")
    formula = "penetration with the cube as authored over that with the stiffer cube"
    shallower = ratio(results, "mixed_cube_shallower", formula, mixed.penetration_mm, stiffer.penetration_mm)
    outcome = all_of(
        is_small(results, "mixed_cube", size, bound, mixed.slip_mm, noise_floor(results, "slip_floor")),
        at_least(shallower, 1.5, why="a cube that is stiffer"),
        equal_within([mixed.timeconst_s, stiffer.timeconst_s], noise=0.0, why=EXACT),
    )
    numbers = {"ke": stiffer.cube_ke, "change": change, "deep": mixed.penetration_mm, "shallow": stiffer.penetration_mm}
    numbers |= {"timeconst": stiffer.timeconst_s, "timeconst_before": mixed.timeconst_s}
    return Claim("cube_stiffness_is_no_lever", outcome, numbers)


def _draw_slips(rows: list[Row]) -> Drawing:
    there = [row for row in reversed(rows) if row.slip_mm.value is not None]
    drawing, axes = new_figure(7.2, 2.6)
    for place, row in enumerate(there):
        group = 0 if row.case in CUBE else 1 if "pad_ke" in row else 2
        axes.barh(place, row.slip_mm.value, color=SERIES[group], hatch=(None, "//", "\\\\")[group], height=0.65)
    axes.set_yticks(range(len(there)), [name_of(row.case) for row in there])
    axes.grid(visible=False, axis="y")
    axes.set_xlabel("slip [mm]")
    return drawing
