"""The solver's live contact rows: their residuals, what their velocities add up to, and what makes them slide."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, all_of, at_most, decided, greater
from measured_report.parts.figures import FAINT
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.shared.arithmetic import departure, difference, noise_floor, size_share, table_of
from report.shared.drawing import SHIPPED, STIFF, TERM, draw_bars

order = 70
page = "cause"
reads = ("noise",)
label = "contact rows"

CASES = ("as-shipped", "stiff-pads")
ROWS = {"position residual": "residual_mm", "velocity": "velocity_mm_s", "force": "force_n"}


def derive(results: Results) -> Section:
    frames, rows, more_runs = ([row for row in results.rows if row.kind == kind] for kind in ("frame", "row", "run"))
    first = {row.case: row for row in reversed(frames)}
    # Through MuJoCo C, and the same with the left-out acceleration in the contact rows.
    left_out, restored = (
        [results.row[f"{case}-{kind}"] for case in CASES] for kind in ("missing-term", "term-restored")
    )
    runs = {case: results.row[case] for case in CASES} | {row.case: row for row in more_runs}
    missing, back = _missing_term(results, left_out), _term_restored(results, left_out, restored)
    numbers: dict[str, Any] = {"is_so": all_of(missing.outcome, back.outcome) == HOLDS}
    numbers |= {name: missing.numbers[name] for name in ("predicted", "slide")} | {"restored": restored[0].slide_mm}
    bars = [
        (plain.predicted_slide_mm, plain.slide_mm, back.slide_mm)
        for plain, back in zip(left_out, restored, strict=True)
    ]
    shown = [row for row in rows if row.case == "as-shipped"]
    return Section(
        tables={"rows": table_of("row", [row.row for row in shown], ROWS, shown)},
        figures={"slide": Figure(lambda: draw_slide(bars), [cell for cells in bars for cell in cells], numbers)},
        claims=[
            _far_inside_cone(results, runs),
            *_friction_rows(results, frames, first["as-shipped"].friction_timeconst_s),
            _slide_accounts(results, runs["as-shipped"]),
            missing,
            back,
        ],
    )


def _far_inside_cone(results: Results, runs: Mapping[str, Row]) -> Claim:
    for pads, case in (("stiff", "stiff-pads"), ("shipped", "as-shipped")):
        formula = f"most of its friction cone that a contact uses through the shake, with {pads} pads"
        share = runs[case].cone_use_max
        used = results.value(f"grip_used_{pads}", formula, lambda use: 100 * use, share, unit="%")
    outcome = at_most(share, 0.1, why="far from the limit, which is 1").having_read(used)
    return Claim("far_inside_cone", outcome, {"used": used})


def _friction_rows(results: Results, frames: list[Row], timeconst: Quantity) -> Iterator[Claim]:
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


def _slide_accounts(results: Results, run: Row) -> Claim:
    bound = results.chosen("slide_departure_bound", "the same motion", 15.0, unit="%")
    formula = "what the velocities of the loaded friction rows add up to, less the motion measured along the same axis"
    gap = difference(results, "slide_gap_as-shipped", formula, run.slide_mm, run.along_mm)
    formula = "size of that difference, of the motion measured"
    off = size_share(results, "slide_departure_as-shipped", formula, gap, run.along_mm)
    is_more = greater(run.slide_mm, run.along_mm, noise=noise_floor(results, "slip_floor")).said
    numbers = {"slide": run.slide_mm, "along": run.along_mm, "bound": bound, "is_more": is_more}
    return Claim("slide_accounts", at_most(off, bound), numbers)


def _missing_term(results: Results, rows: list[Row]) -> Claim:
    formula = "slide that the left-out acceleration gives, less the slide of the friction rows, in size, of the latter"
    departures = [
        departure(results, f"missing_term_departure_{row.case}", formula, row.predicted_slide_mm, row.slide_mm)
        for row in rows
    ]
    largest = results.value("missing_term_departure", "larger of both departures", max, *departures, unit="%")
    numbers = {"departure": largest}
    for row, name in zip(rows, ("", "_stiff"), strict=True):
        numbers |= {f"predicted{name}": row.predicted_slide_mm, f"slide{name}": row.slide_mm}
    bound = results.chosen("missing_term_bound", "the same slide", 5.0, unit="%")
    return Claim("missing_term", at_most(largest, bound), numbers)


def _term_restored(results: Results, left_out: list[Row], restored: list[Row]) -> Claim:
    bound = results.chosen("restored_share_bound", "no slide to speak of", 5.0, unit="%")
    formula = "size of the slide of the friction rows with the term put back, of that without it"
    numbers: dict[str, Quantity] = {}
    shares, falls = [], []
    for case, name, plain, back in zip(CASES, ("", "_stiff"), left_out, restored, strict=True):
        shares.append(size_share(results, f"restored_share_{case}", formula, back.slide_mm, plain.slide_mm))
        less, more = (
            results.value(f"restored_{case}_{which}_size", "its size", abs, row.slide_mm, unit="mm")
            for which, row in (("small", back), ("large", plain))
        )
        falls.append(greater(more, less, noise=noise_floor(results, "slip_floor")))
        numbers |= {f"slide{name}": plain.slide_mm, f"restored{name}": back.slide_mm}
    largest = results.value("restored_share", "larger of both shares", max, *shares, unit="%")
    return Claim("term_restored", all_of(at_most(largest, bound), *falls), numbers)


PADS = {"shipped pads": SHIPPED, "stiff pads": STIFF}


def draw_slide(bars: Sequence[tuple[Quantity, Quantity, Quantity]]) -> Drawing:
    """Draw for each pads three bars: slide from the left-out term, slide of the rows, and that with the term put
    back."""
    kinds = ("from the left-out term", "measured in the rows", "with the term put back")
    names = [f"{pads}, {kind}" for pads in PADS for kind in kinds]
    colours = [face for colour in PADS.values() for face in (FAINT, colour, TERM)]
    cells = [cell for each in bars for cell in each]
    return draw_bars(names, cells, colours, "slide of the friction rows along the main axis [mm]")[0]
