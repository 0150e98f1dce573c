"""The solver's live contact rows in the middle of the shake: forces, residuals, and what their velocities add up to."""

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, all_of, at_most, decided, greater
from measured_report.parts.figures import INK, SERIES, new_figure
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row, Series
from report.names import name_of
from report.sections.contacts.missing_term import CASES, missing_table, missing_term_claims
from report.shared.arithmetic import by_case, departure, difference, noise_floor, size_share

order = 70
page = "cause"
label = "contact rows"

FINGERS = {"leftfinger": "left finger", "rightfinger": "right finger"}
"""By what the names of their shapes have."""


def derive(results: Results) -> Section:
    runs = {case: results.row[case] for case in CASES} | {row.case: row for row in _of_kind(results, "run")}
    for case, pads in zip(CASES, ("shipped", "stiff"), strict=True):
        formula = f"most of its friction cone that a contact uses through the shake, with {pads} pads"
        results.value(f"grip_used_{pads}", formula, lambda use: 100 * use, runs[case].cone_use_max, unit="%")
    gaps = {case: _gap(results, row) for case, row in runs.items()}
    tables = {case: results.trace(case) for case in CASES}
    rows = Figure(
        draw=lambda: _draw_contacts(tables, runs),
        sources=[*tables.values(), *(row.slide_mm for row in runs.values())],
        numbers={"slide": runs["as-shipped"].slide_mm, "along": runs["as-shipped"].along_mm},
    )
    return Section(
        tables={
            "forces": _force_table(_of_kind(results, "frame")),
            "parameters": _parameter_table(_of_kind(results, "frame")),
            "rows": _row_table(_of_kind(results, "row")),
            "missing": missing_table(results),
        },
        figures={"rows": rows},
        claims=[
            _far_inside_cone(results, runs["as-shipped"]),
            _no_friction_residual(results),
            _own_friction_timeconst(results),
            *_slide_claims(results, runs, gaps),
            _step_closes_account(results, runs["stiff-pads"]),
            *missing_term_claims(results),
        ],
    )


def _of_kind(results: Results, kind: str) -> list[Row]:
    return [row for row in results.rows if row.kind == kind]


def _gap(results: Results, run: Row) -> Value:
    return difference(
        results,
        f"slide_gap_{run.case}",
        "what the velocities of the loaded friction rows add up to, less the motion measured along the same axis",
        run.slide_mm,
        run.along_mm,
    )


def _departure(results: Results, run: Row, gap: Value) -> Value:
    return size_share(
        results, f"slide_departure_{run.case}", "size of that difference, of the motion measured", gap, run.along_mm
    )


def _far_inside_cone(results: Results, run: Row) -> Claim:
    bound = results.chosen("cone_use_bound", "far from the limit, which is 1", 0.1)
    return Claim(
        "far_inside_cone",
        at_most(run.cone_use_max, bound).having_read(results.derived["grip_used_shipped"]),
        numbers={"used": results.derived["grip_used_shipped"]},
    )


def _no_friction_residual(results: Results) -> Claim:
    frames = _of_kind(results, "frame")
    largest = results.value(
        "friction_residual",
        "largest position residual of a loaded contact's friction rows, over all looks",
        max,
        *(row.friction_residual_mm for row in frames),
        unit="mm",
    )
    normal = results.value(
        "normal_residual",
        "largest position residual of a loaded contact's normal row as shipped, over all looks",
        max,
        *(row.normal_residual_mm for row in frames if row.case == "as-shipped"),
        unit="mm",
    )
    bound = results.chosen("friction_residual_bound", "none at all", 0.0, unit="mm")
    carries = greater(normal, largest, noise=noise_floor(results, "slip_floor"))
    return Claim("no_friction_residual", all_of(at_most(largest, bound), carries), numbers={"normal": normal})


def _own_friction_timeconst(results: Results) -> Claim:
    """By the first look; zero stands for none of their own."""
    frame = next(row for row in _of_kind(results, "frame") if row.case == "as-shipped")
    return Claim("own_friction_timeconst", decided(bool(frame.friction_timeconst_s.value), frame.friction_timeconst_s))


def _slide_claims(results: Results, runs: dict[str, Row], gaps: dict[str, Value]) -> list[Claim]:
    """Whether the velocity that is left in the friction rows accounts for the motion, with either pads."""
    shipped, stiff = (runs[case] for case in CASES)
    departure = _departure(results, shipped, gaps[shipped.case])
    bound = results.chosen("slide_departure_bound", "the same motion", 15.0, unit="%")
    departure_stiff = _departure(results, stiff, gaps[stiff.case])
    floor = noise_floor(results, "slip_floor")
    more, more_stiff = (greater(run.slide_mm, run.along_mm, noise=floor) for run in (shipped, stiff))
    return [
        Claim(
            "slide_accounts",
            at_most(departure, bound),
            numbers={
                "slide": shipped.slide_mm,
                "along": shipped.along_mm,
                "duration": shipped.shake_duration_s,
                "bound": bound,
                "is_more": more.said,
            },
        ),
        Claim(
            "slide_accounts_when_stiff",
            at_most(departure_stiff, bound),
            numbers={
                "slide": stiff.slide_mm,
                "along": stiff.along_mm,
                "duration": stiff.shake_duration_s,
                "bound": bound,
                "is_more": more_stiff.said,
            },
        ),
    ]


def _step_closes_account(results: Results, stiff: Row) -> Claim:
    """Whether slide and the drift that is there without any slide add up to the motion, with stiff pads."""
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
    return Claim("step_closes_account_when_stiff", outcome, numbers={"drift": drift, "sum": whole})


def _force_table(frames: list[Row]) -> Table:
    columns = {
        "frame": [row.frame for row in frames],
        "contacts": [row.row_count for row in frames],
        "loaded": [row.loaded_row_count for row in frames],
        "normal": [row.normal_force_n for row in frames],
        "tangential": [row.tangential_force_n for row in frames],
        "friction used": [row.cone_use for row in frames],
        "penetration": [row.penetration_mm for row in frames],
        "sliding": [row.friction_velocity_mm_s for row in frames],
    }
    return by_case(frames, columns)


def _parameter_table(frames: list[Row]) -> Table:
    first = {row.case: row for row in reversed(frames)}
    rows = [first[case] for case in CASES]
    columns = {
        "timeconst": [row.timeconst_s for row in rows],
        "dampratio": [row.dampratio for row in rows],
        "friction rows' own timeconst": [row.friction_timeconst_s for row in rows],
        "dmin": [row.dmin for row in rows],
        "dmax": [row.dmax for row in rows],
        "friction": [row.friction for row in rows],
        "dim": [row.dim for row in rows],
    }
    return by_case(rows, columns)


def _row_table(rows: list[Row]) -> Table:
    columns = {
        "row": [row.row for row in rows],
        "pair": [row.pair for row in rows],
        "position residual": [row.residual_mm for row in rows],
        "velocity": [row.velocity_mm_s for row in rows],
        "force": [row.force_n for row in rows],
    }
    return by_case(rows, columns)


def _draw_contacts(tables: dict[str, Series], runs: dict[str, Row]) -> Drawing:
    drawing, (left, right) = new_figure(7.2, 3.2, ncols=2, width_ratios=(3, 2))
    _draw_sliding(left, tables)
    for number, run in enumerate(runs.values()):
        for place, quantity in ((number - 0.2, run.slide_mm), (number + 0.2, run.along_mm)):
            measured = place > number
            right.bar(
                place,
                quantity.value,
                width=0.36,
                color=SERIES[0 if measured else 4],
                hatch=None if measured else "///",
                label=("measured" if measured else "from the rows") if number == 0 else None,
            )
    right.set_xticks(range(len(runs)), map(name_of, runs))
    right.grid(visible=False, axis="x")
    right.set_ylabel("motion along the main axis [mm]")
    right.legend(loc="upper right")
    right.margins(y=0.35)
    return drawing


def _draw_sliding(axes: Axes, tables: dict[str, Series]) -> None:
    """The loaded contacts of each finger side by side, by their speed."""
    for number, (case, trace) in enumerate(tables.items()):
        if trace.value is not None:
            loaded = trace.value.query("normal_force_n > 0")
            found = [sorted(loaded["slide_mm_s"][loaded["geom_1"].str.contains(finger)]) for finger in FINGERS]
            points = [
                (finger + 0.7 * ((rank + 0.5) / len(speeds) - 0.5), speed)
                for finger, speeds in enumerate(found)
                for rank, speed in enumerate(speeds)
            ]
            style: dict[str, Any] = {"linestyle": "", "marker": "os"[number], "markersize": 6, "markevery": 1}
            axes.plot(*zip(*points, strict=True), **style, label=name_of(case))
    axes.axhline(0.0, color=INK, linewidth=0.8, linestyle="-", marker="")
    axes.set_xticks(range(len(FINGERS)), FINGERS.values())
    axes.set_xlim(-0.5, len(FINGERS) - 0.5)
    axes.grid(visible=False, axis="x")
    axes.set_ylabel("sliding velocity [mm/s]")
    axes.legend(loc="best")
