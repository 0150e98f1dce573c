"""Whose material counts: the same swing of stiffness on the cube and on the pads, and the pads without priority."""

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import HOLDS, Claim, all_of, at_least, at_most, equal_within, greater, within
from measured_report.parts.figures import SERIES, new_figure
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import SETTLES, by_case, departure, noise_floor, ratio, share, spread
from report.shared.variants import is_small

order = 100
page = "fix"
label = "whose material counts"

CUBE = ("cube-ke-8e3", "cube-ke-8e4", "cube-ke-8e5")
RESOLVED = ("timeconst_s", "dampratio", "friction", "dmin", "dmax")
"""What the contact has after the two sides' materials are combined."""
CHANGED = {"cube_ke": "cube ke", "pad_ke": "pad ke", "pad_kd": "pad kd", "pad_priority": "pad priority"}


def derive(results: Results) -> Section:
    shipped = results.row["cube-ke-8e4"]
    slips = Figure(
        draw=lambda: _draw_slips(results.rows),
        sources=[row.slip_mm for row in results.rows],
        numbers={
            "slips": Markup("; ").join(Markup("{}: {}").format(name_of(row.case), row.slip_mm) for row in results.rows)
        },
    )
    return Section(
        tables={"cases": _table(results.rows)},
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
    spreads = [
        spread(
            results,
            f"cube_{column}_spread",
            f"largest less smallest {column} of the contact, over the three stiffnesses of the cube",
            [row[column] for row in rows],
            unit=rows[0][column].unit,
        )
        for column in RESOLVED
    ]
    largest = results.value("cube_resolved_spread", "largest of these spreads", max, *spreads)
    bound = results.chosen("cube_resolved_bound", "no difference at all", 0.0)
    return Claim(
        "cube_does_not_count",
        at_most(largest, bound),
        numbers={
            "low": rows[0].cube_ke,
            "high": rows[-1].cube_ke,
            "timeconst": rows[1].timeconst_s,
            "dampratio": rows[1].dampratio,
            "friction": rows[1].friction,
        },
    )


def _cube_does_not_move_slip(results: Results) -> Claim:
    low, *_, high = (results.row[case] for case in CUBE)
    slips = [results.row[case].slip_mm for case in CUBE]
    formula = "largest less smallest slip over the three stiffnesses of the cube"
    change = spread(results, "cube_slip_spread", formula, slips, unit="mm")
    shipped = results.row["cube-ke-8e4"].slip_mm
    of_shipped = share(results, "cube_slip_share", "that spread, of the slip as shipped", change, shipped)
    floor = noise_floor(results, "slip_floor")
    bound = results.chosen("cube_slip_bound", "no change to speak of", 2.0, unit="%")
    as_noise, small = within(change, floor), at_most(of_shipped, bound)
    return Claim(
        "cube_does_not_move_slip",
        (small if small == HOLDS else as_noise).having_read(of_shipped, bound, floor),
        numbers={
            "low": low.cube_ke,
            "high": high.cube_ke,
            "spread": change,
            "share": of_shipped,
            "floor": floor,
            "is_noise": as_noise == HOLDS,
        },
    )


def _pads_count(results: Results, shipped: Row) -> Claim:
    stiff = results.row["pad-ke-2.5e5"]
    gain = ratio(results, "pad_gain", "slip as shipped over slip with stiff pads", shipped.slip_mm, stiff.slip_mm)
    bound = results.chosen("pad_gain_bound", *SETTLES)
    return Claim(
        "pads_count",
        at_least(gain, bound),
        numbers={"ke": stiff.pad_ke, "kd": stiff.pad_kd, "slip": stiff.slip_mm, "gain": gain},
    )


def _equal_priorities_mix(results: Results, shipped: Row) -> Claim:
    mixed = results.row["priority-0"]
    drop = results.value(
        "mixed_drop",
        "how much the slip falls when both geoms have the same priority, of the slip as shipped",
        lambda before, after: 100 * (1 - after / before),
        shipped.slip_mm,
        mixed.slip_mm,
        unit="%",
    )
    exact = results.chosen("no_timeconst_noise", "what a material gives is exact", 0.0, unit="s")
    return Claim(
        "equal_priorities_mix",
        all_of(
            greater(shipped.timeconst_s, mixed.timeconst_s, noise=exact),
            greater(shipped.slip_mm, mixed.slip_mm, noise=noise_floor(results, "slip_floor")),
        ),
        numbers={
            "before": shipped.timeconst_s,
            "after": mixed.timeconst_s,
            "drop": drop,
            "slip": mixed.slip_mm,
            "shipped": shipped.slip_mm,
        },
    )


def _cube_stiffness_is_no_lever(results: Results) -> Claim:
    """Whether the cube gets stiffer and sinks in less, and nothing else changes."""
    mixed, stiffer = results.row["priority-0"], results.row["priority-0-cube-ke-8e5"]
    formula = "change of slip with the stiffer cube under equal priorities, of the slip with the cube as authored"
    change = departure(results, "mixed_cube_change", formula, stiffer.slip_mm, mixed.slip_mm)
    formula = "size of that change"
    size = results.value("mixed_cube_size", formula, lambda a, b: abs(a - b), stiffer.slip_mm, mixed.slip_mm, unit="mm")
    bound = results.chosen("mixed_cube_bound", "no lever", 5.0, unit="%")
    formula = "penetration with the cube as authored over that with the stiffer cube"
    shallower = ratio(results, "mixed_cube_shallower", formula, mixed.penetration_mm, stiffer.penetration_mm)
    enough = results.chosen("mixed_cube_shallower_bound", "a cube that is stiffer", 1.5)
    exact = results.derived["no_timeconst_noise"]
    return Claim(
        "cube_stiffness_is_no_lever",
        all_of(
            is_small(results, "mixed_cube", size, bound, mixed.slip_mm, noise_floor(results, "slip_floor")),
            at_least(shallower, enough),
            equal_within([mixed.timeconst_s, stiffer.timeconst_s], noise=exact),
        ),
        numbers={
            "ke": stiffer.cube_ke,
            "change": change,
            "deep": mixed.penetration_mm,
            "shallow": stiffer.penetration_mm,
            "timeconst": stiffer.timeconst_s,
            "timeconst_before": mixed.timeconst_s,
        },
    )


def _table(rows: list[Row]) -> Table:
    columns = {label: [_changed(row, name) for row in rows] for name, label in CHANGED.items()}
    columns |= {
        "timeconst": [row.timeconst_s for row in rows],
        "dampratio": [row.dampratio for row in rows],
        "friction": [row.friction for row in rows],
        "dmin": [row.dmin for row in rows],
        "dmax": [row.dmax for row in rows],
        "slip": [row.slip_mm for row in rows],
        "drift": [row.drift_mm_s for row in rows],
    }
    return by_case(rows, columns)


def _changed(row: Row, name: str) -> Quantity | str:
    return row[name] if name in row else ""  # noqa: SIM401 a row has no get


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
