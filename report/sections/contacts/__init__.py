"""The solver's live contact rows in the middle of the shake: forces, residuals, and what their velocities add up to."""

from collections.abc import Iterator, Mapping

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import Claim, all_of, at_most, decided, greater
from measured_report.parts.figures import INK, SERIES, new_figure
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row, Series
from report.names import name_of
from report.sections.contacts.missing_term import CASES, missing_table, missing_term_claims
from report.shared.arithmetic import by_case, departure, difference, noise_floor, size_share
from report.shared.drawing import mark_points

order = 70
page = "cause"
label = "contact rows"

FINGERS = {"leftfinger": "left finger", "rightfinger": "right finger"}
"""By what the names of their shapes have."""


FORCES = {
    "frame": "frame",
    "contacts": "row_count",
    "loaded": "loaded_row_count",
    "normal": "normal_force_n",
    "tangential": "tangential_force_n",
    "friction used": "cone_use",
    "penetration": "penetration_mm",
    "sliding": "friction_velocity_mm_s",
}
PARAMETERS = {
    "timeconst": "timeconst_s",
    "dampratio": "dampratio",
    "friction rows' own timeconst": "friction_timeconst_s",
    "dmin": "dmin",
    "dmax": "dmax",
    "friction": "friction",
    "dim": "dim",
}
ROWS = {
    "row": "row",
    "pair": "pair",
    "position residual": "residual_mm",
    "velocity": "velocity_mm_s",
    "force": "force_n",
}


def derive(results: Results) -> Section:
    frames, first = _of_kind(results, "frame"), {}
    for row in reversed(frames):
        first[row.case] = row
    runs = {case: results.row[case] for case in CASES} | {row.case: row for row in _of_kind(results, "run")}
    tables = {case: results.trace(case) for case in CASES}
    shipped = runs["as-shipped"]
    rows = Figure(
        draw=lambda: _draw_contacts(tables, runs),
        sources=[*tables.values(), *(row.slide_mm for row in runs.values())],
        numbers={"slide": shipped.slide_mm, "along": shipped.along_mm},
    )
    return Section(
        tables={
            "forces": by_case(frames, FORCES),
            "parameters": by_case([first[case] for case in CASES], PARAMETERS),
            "rows": by_case(_of_kind(results, "row"), ROWS),
            "missing": missing_table(results),
        },
        figures={"rows": rows},
        claims=[
            _far_inside_cone(results, runs),
            *_friction_rows(results, frames, first["as-shipped"].friction_timeconst_s),
            *_slide_claims(results, runs),
            _step_closes_account(results, runs["stiff-pads"]),
            *missing_term_claims(results),
        ],
    )


def _of_kind(results: Results, kind: str) -> list[Row]:
    return [row for row in results.rows if row.kind == kind]


def _far_inside_cone(results: Results, runs: Mapping[str, Row]) -> Claim:
    formula = "most of its friction cone that a contact uses through the shake, with {} pads"
    used, _ = (
        results.value(
            f"grip_used_{pads}", formula.format(pads), lambda use: 100 * use, runs[case].cone_use_max, unit="%"
        )
        for case, pads in zip(CASES, ("shipped", "stiff"), strict=True)
    )
    outcome = at_most(runs["as-shipped"].cone_use_max, 0.1, why="far from the limit, which is 1")
    return Claim("far_inside_cone", outcome.having_read(used), {"used": used})


def _friction_rows(results: Results, frames: list[Row], timeconst: Quantity) -> Iterator[Claim]:
    """Tell whether friction rows have a position residual, and a time constant of their own, which 0 says they lack."""
    formula = "largest position residual of a loaded contact's friction rows, over all looks"
    cells = [row.friction_residual_mm for row in frames]
    largest = results.value("friction_residual", formula, max, *cells, unit="mm")
    formula = "largest position residual of a loaded contact's normal row as shipped, over all looks"
    cells = [row.normal_residual_mm for row in frames if row.case == "as-shipped"]
    normal = results.value("normal_residual", formula, max, *cells, unit="mm")
    bound = results.chosen("friction_residual_bound", "none at all", 0.0, unit="mm")
    carries = greater(normal, largest, noise=noise_floor(results, "slip_floor"))
    yield Claim("no_friction_residual", all_of(at_most(largest, bound), carries), {"normal": normal})
    yield Claim("own_friction_timeconst", decided(bool(timeconst.value), timeconst))


def _slide_claims(results: Results, runs: Mapping[str, Row]) -> Iterator[Claim]:
    """Tell whether the velocity that is left in the friction rows accounts for the motion, with either pads."""
    bound = results.chosen("slide_departure_bound", "the same motion", 15.0, unit="%")
    formula = "what the velocities of the loaded friction rows add up to, less the motion measured along the same axis"
    gaps = {
        case: difference(results, f"slide_gap_{case}", formula, run.slide_mm, run.along_mm)
        for case, run in runs.items()
    }
    formula, floor = "size of that difference, of the motion measured", noise_floor(results, "slip_floor")
    for name, case in (("slide_accounts", "as-shipped"), ("slide_accounts_when_stiff", "stiff-pads")):
        slide, along = runs[case].slide_mm, runs[case].along_mm
        off = size_share(results, f"slide_departure_{case}", formula, gaps[case], along)
        numbers = {"slide": slide, "along": along, "duration": runs[case].shake_duration_s, "bound": bound}
        is_more = greater(slide, along, noise=floor).said
        yield Claim(name, at_most(off, bound), numbers | {"is_more": is_more})


def _step_closes_account(results: Results, stiff: Row) -> Claim:
    """Tell whether slide and the drift that is there without any slide add up to the motion, with stiff pads."""
    drift = results.row[f"{stiff.case}-term-restored"].drift_mm_s
    whole = results.value(
        "slide_and_step",
        "slide of the friction rows, and the drift in MuJoCo C with the left-out acceleration put back over as long",
        lambda slide, drift, seconds: slide + drift * seconds,
        *(stiff.slide_mm, drift, stiff.shake_duration_s),
        unit="mm",
    )
    formula = "size of the difference between that and the motion measured, of the latter"
    left = departure(results, "slide_and_step_departure", formula, whole, stiff.along_mm)
    outcome = at_most(left, results.derived["slide_departure_bound"])
    return Claim("step_closes_account_when_stiff", outcome, {"drift": drift, "sum": whole})


def _draw_contacts(tables: Mapping[str, Series], runs: Mapping[str, Row]) -> Drawing:
    drawing, (left, right) = new_figure(7.2, 3.2, ncols=2, width_ratios=(3, 2))
    _draw_sliding(left, tables)
    for number, run in enumerate(runs.values()):
        label = "" if number else "from the rows", "" if number else "measured"
        right.bar(number - 0.2, run.slide_mm.value, 0.36, color=SERIES[4], hatch="///", label=label[0])
        right.bar(number + 0.2, run.along_mm.value, 0.36, color=SERIES[0], label=label[1])
    right.set_xticks(range(len(runs)), map(name_of, runs))
    right.grid(visible=False, axis="x")
    right.set_ylabel("motion along the main axis [mm]")
    right.legend(loc="upper right")
    right.margins(y=0.35)
    return drawing


def _draw_sliding(axes: Axes, tables: Mapping[str, Series]) -> None:
    """Draw the loaded contacts of each finger side by side, by their speed."""
    for number, (case, trace) in enumerate(tables.items()):
        if trace.value is not None:
            loaded = trace.value.query("normal_force_n > 0")
            found = [sorted(loaded["slide_mm_s"][loaded["geom_1"].str.contains(finger)]) for finger in FINGERS]
            points = [
                (finger + 0.7 * ((rank + 0.5) / len(speeds) - 0.5), speed)
                for finger, speeds in enumerate(found)
                for rank, speed in enumerate(speeds)
            ]
            mark_points(axes, points, marker="os"[number], markersize=6, label=name_of(case))
    axes.axhline(0.0, color=INK, linewidth=0.8, linestyle="-", marker="")
    axes.set_xticks(range(len(FINGERS)), FINGERS.values())
    axes.set(xlim=(-0.5, len(FINGERS) - 0.5), ylabel="sliding velocity [mm/s]")
    axes.grid(visible=False, axis="x")
    axes.legend(loc="best")
