"""The acceleration that contact rows leave out: what it accounts for, and the runs that have it put back."""

from measured_report.claims.claim import OPPOSITE, Claim, Outcome, all_of, at_least, at_most, greater, same_sign
from measured_report.parts.section import Table
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.names import case_html
from report.shared.arithmetic import cells_of, departure, noise_floor, ratio, resolved, size_share, table_of

CASES = ("as-shipped", "stiff-pads")
COLUMNS = {
    "from the left-out term": "predicted_slide_mm",
    "from the friction rows": "slide_mm",
    "measured displacement": "along_mm",
}
RESTORED_COLUMNS = {"friction rows, term put back": "slide_mm", "displacement, term put back": "along_mm"}


def missing_term_claims(results: Results) -> list[Claim]:
    left_out, restored = _left_out(results), _restored(results)
    return [
        _missing_term(results, left_out),
        _term_restored(results, left_out, restored),
        _rest_is_creep(results, left_out, restored),
        _rest_goes_with_step(results, restored[0]),
        _slide_falls_with_timeconst(results, left_out, restored),
    ]


def missing_table(results: Results) -> Table:
    columns = cells_of(_left_out(results), COLUMNS) | cells_of(_restored(results), RESTORED_COLUMNS)
    return table_of("case", map(case_html, CASES), columns)


def _left_out(results: Results) -> list[Row]:
    """Take the runs through MuJoCo C, one for each of CASES."""
    return [results.row[f"{case}-missing-term"] for case in CASES]


def _restored(results: Results) -> list[Row]:
    """Take the intervention: the same runs, with the left-out acceleration in the contact rows."""
    return [results.row[f"{case}-term-restored"] for case in CASES]


def _missing_term(results: Results, rows: list[Row]) -> Claim:
    formula = "slide that the left-out acceleration gives, less the slide of the friction rows, in size, of the latter"
    departures = [
        departure(results, f"missing_term_departure_{row.case}", formula, row.predicted_slide_mm, row.slide_mm)
        for row in rows
    ]
    largest = results.value("missing_term_departure", "larger of both departures", max, *departures, unit="%")
    bound = results.chosen("missing_term_bound", "the same slide", 5.0, unit="%")
    numbers = {"departure": largest}
    for row, name in zip(rows, ("", "_stiff"), strict=True):
        numbers |= {f"predicted{name}": row.predicted_slide_mm, f"slide{name}": row.slide_mm}
    return Claim("missing_term", at_most(largest, bound), numbers)


def _term_restored(results: Results, left_out: list[Row], restored: list[Row]) -> Claim:
    bound = results.chosen("restored_share_bound", "no slide to speak of", 5.0, unit="%")
    formula = "size of the slide of the friction rows with the term put back, of that without it"
    numbers: dict[str, Quantity] = {"bound": bound}
    shares, falls = [], []
    for case, name, plain, back in zip(CASES, ("", "_stiff"), left_out, restored, strict=True):
        shares.append(size_share(results, f"restored_share_{case}", formula, back.slide_mm, plain.slide_mm))
        falls.append(_is_smaller(results, f"restored_{case}", back.slide_mm, plain.slide_mm))
        numbers |= {f"slide{name}": plain.slide_mm, f"restored{name}": back.slide_mm}
    largest = results.value("restored_share", "larger of both shares", max, *shares, unit="%")
    return Claim("term_restored", all_of(at_most(largest, bound), *falls), numbers)


def _is_smaller(results: Results, name: str, small: Quantity, large: Quantity) -> Outcome:
    """Tell whether one of two lengths is smaller than the other in size, by more than the noise."""
    less, more = (
        results.value(f"{name}_{which}_size", "its size", abs, found, unit="mm")
        for which, found in (("small", small), ("large", large))
    )
    return greater(more, less, noise=noise_floor(results, "slip_floor"))


def _rest_is_creep(results: Results, left_out: list[Row], restored: list[Row]) -> Claim:
    """What the rows' slide leaves over is the motion that is there without any slide."""
    formula = "size of: measured displacement less slide of the rows, less the displacement with the term put back"
    rests = [
        results.value(
            f"rest_{case}",
            formula,
            lambda along, slide, creep: abs(along - slide - creep),
            *(plain.along_mm, plain.slide_mm, back.along_mm),
            unit="mm",
        )
        for case, plain, back in zip(CASES, left_out, restored, strict=True)
    ]
    largest = results.value("rest", "larger of both", max, *rests, unit="mm")
    bound = results.chosen("rest_bound", "all accounted for", 0.03, unit="mm")
    outcome = all_of(at_most(largest, bound), resolved(noise_floor(results, "slip_floor"), bound))
    creep, creep_stiff = (row.along_mm for row in restored)
    numbers = {"creep": creep, "creep_stiff": creep_stiff, "rest": largest, "bound": bound}
    return Claim("rest_is_creep", outcome, numbers)


def _rest_goes_with_step(results: Results, shipped: Row) -> Claim:
    """Tell whether what moves the cube when nothing slides is proportional to the time step."""
    single, double = shipped.along_mm, results.row["double-step-term-restored"].along_mm
    formula = "displacement with a step twice as long over that with the shipped one, both with the term put back"
    growth = ratio(results, "rest_growth", formula, double, single)
    off = results.value("rest_growth_off", "how far that ratio is from two", lambda found: abs(found - 2.0), growth)
    outcome = all_of(at_most(off, 0.25, why="near two"), _is_smaller(results, "rest_step", single, double))
    return Claim("rest_goes_with_step", outcome, {"double": double, "growth": growth})


def _slide_falls_with_timeconst(results: Results, left_out: list[Row], restored: list[Row]) -> Claim:
    """What stiff pads really gain: the displacement also has the creep, which hides a part of what still slides."""
    (shipped, stiff), (_, creep) = left_out, restored
    formula = "slide of the friction rows as shipped, over that with stiff pads"
    slide = ratio(results, "slide_gain", formula, shipped.slide_mm, stiff.slide_mm)
    formula = "measured displacement as shipped, over that with stiff pads"
    along = ratio(results, "along_gain", formula, shipped.along_mm, stiff.along_mm)
    falls = at_least(slide, 1.0, why="the slide falls at all")
    directions = same_sign(stiff.slide_mm, creep.along_mm, noise=noise_floor(results, "slip_floor"))
    outcome = all_of(greater(along, slide, noise=1.0, why="the same gain"), falls)
    numbers = {"slide": slide, "along": along, "hides": directions.said == OPPOSITE.said}
    return Claim("slide_falls_less_than_displacement", outcome, numbers)
