"""The acceleration that contact rows leave out: what it accounts for, and the runs that have it put back."""

import pandas as pd

from measured_report.claims.claims import OPPOSITE, Claim, Outcome, all_of, at_least, at_most, greater, same_sign
from measured_report.parts.parts import Table
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.names import case_html
from report.shared.arithmetic import departure, noise_floor, ratio, resolved, size_share

CASES = ("as-shipped", "stiff-pads")


def missing_term_claims(results: Results) -> list[Claim]:
    return [
        _missing_term(results),
        _term_restored(results),
        _rest_is_creep(results),
        _rest_goes_with_step(results),
        _slide_falls_with_timeconst(results),
    ]


def _in_c(results: Results, kind: str) -> list[Row]:
    """The runs of one kind through MuJoCo C, one for each of CASES."""
    return [results.row[f"{case}-{kind}"] for case in CASES]


def _missing_term(results: Results) -> Claim:
    rows = _in_c(results, "missing-term")
    departures = [
        departure(
            results,
            f"missing_term_departure_{row.case}",
            "slide that the left-out acceleration gives, less the slide of the friction rows, in size, of the latter",
            row.predicted_slide_mm,
            row.slide_mm,
        )
        for row in rows
    ]
    largest = results.value("missing_term_departure", "larger of both departures", max, *departures, unit="%")
    bound = results.chosen("missing_term_bound", "the same slide", 5.0, unit="%")
    shipped, stiff = rows
    return Claim(
        "missing_term",
        at_most(largest, bound),
        numbers={
            "predicted": shipped.predicted_slide_mm,
            "slide": shipped.slide_mm,
            "predicted_stiff": stiff.predicted_slide_mm,
            "slide_stiff": stiff.slide_mm,
            "departure": largest,
        },
    )


def _term_restored(results: Results) -> Claim:
    """The intervention: the same runs, with the left-out acceleration in the contact rows."""
    left_out, restored = _in_c(results, "missing-term"), _in_c(results, "term-restored")
    shares = [
        size_share(
            results,
            f"restored_share_{case}",
            "size of the slide of the friction rows with the term put back, of that without it",
            put_back.slide_mm,
            without.slide_mm,
        )
        for case, without, put_back in zip(CASES, left_out, restored, strict=True)
    ]
    largest = results.value("restored_share", "larger of both shares", max, *shares, unit="%")
    bound = results.chosen("restored_share_bound", "no slide to speak of", 5.0, unit="%")
    numbers: dict[str, Quantity] = {"bound": bound}
    for name, without, put_back in zip(("", "_stiff"), left_out, restored, strict=True):
        numbers |= {f"slide{name}": without.slide_mm, f"restored{name}": put_back.slide_mm}
    falls = [
        _is_smaller(results, f"restored_{case}", put_back.slide_mm, without.slide_mm)
        for case, without, put_back in zip(CASES, left_out, restored, strict=True)
    ]
    return Claim("term_restored", all_of(at_most(largest, bound), *falls), numbers=numbers)


def _is_smaller(results: Results, name: str, small: Quantity, large: Quantity) -> Outcome:
    """Whether one of two lengths is smaller than the other in size, by more than the noise."""
    sizes = [
        results.value(f"{name}_{which}_size", "its size", abs, found, unit="mm")
        for which, found in (("small", small), ("large", large))
    ]
    return greater(sizes[1], sizes[0], noise=noise_floor(results, "slip_floor"))


def _rest_is_creep(results: Results) -> Claim:
    """What the rows' slide leaves over is the motion that is there without any slide."""
    left_out, restored = _in_c(results, "missing-term"), _in_c(results, "term-restored")
    rests = [
        results.value(
            f"rest_{case}",
            "size of: measured displacement less slide of the rows, less the displacement with the term put back",
            lambda along, slide, creep: abs(along - slide - creep),
            without.along_mm,
            without.slide_mm,
            put_back.along_mm,
            unit="mm",
        )
        for case, without, put_back in zip(CASES, left_out, restored, strict=True)
    ]
    largest = results.value("rest", "larger of both", max, *rests, unit="mm")
    bound = results.chosen("rest_bound", "all accounted for", 0.03, unit="mm")
    shipped, stiff = restored
    return Claim(
        "rest_is_creep",
        all_of(at_most(largest, bound), resolved(noise_floor(results, "slip_floor"), bound)),
        numbers={"creep": shipped.along_mm, "creep_stiff": stiff.along_mm, "rest": largest, "bound": bound},
    )


def _rest_goes_with_step(results: Results) -> Claim:
    """Whether what moves the cube when nothing slides is proportional to the time step."""
    [shipped, _], double = _in_c(results, "term-restored"), results.row["double-step-term-restored"]
    formula = "displacement with a step twice as long over that with the shipped one, both with the term put back"
    growth = ratio(results, "rest_growth", formula, double.along_mm, shipped.along_mm)
    off = results.value("rest_growth_off", "how far that ratio is from two", lambda found: abs(found - 2.0), growth)
    return Claim(
        "rest_goes_with_step",
        all_of(
            at_most(off, results.chosen("rest_growth_bound", "near two", 0.25)),
            _is_smaller(results, "rest_step", shipped.along_mm, double.along_mm),
        ),
        numbers={"double": double.along_mm, "growth": growth},
    )


def _slide_falls_with_timeconst(results: Results) -> Claim:
    """What stiff pads really gain: the displacement also has the creep, which hides a part of what still slides."""
    shipped, stiff = _in_c(results, "missing-term")
    formula = "slide of the friction rows as shipped, over that with stiff pads"
    slide = ratio(results, "slide_gain", formula, shipped.slide_mm, stiff.slide_mm)
    formula = "measured displacement as shipped, over that with stiff pads"
    along = ratio(results, "along_gain", formula, shipped.along_mm, stiff.along_mm)
    same = results.chosen("gain_bound", "the same gain", 1.0)
    falls = at_least(slide, results.chosen("slide_gain_bound", "the slide falls at all", 1.0))
    [_, restored] = _in_c(results, "term-restored")
    directions = same_sign(stiff.slide_mm, restored.along_mm, noise=noise_floor(results, "slip_floor"))
    return Claim(
        "slide_falls_less_than_displacement",
        all_of(greater(along, slide, noise=same), falls),
        numbers={"slide": slide, "along": along, "hides": directions.said == OPPOSITE.said},
    )


def missing_table(results: Results) -> Table:
    left_out, restored = _in_c(results, "missing-term"), _in_c(results, "term-restored")
    columns = {
        "from the left-out term": [row.predicted_slide_mm for row in left_out],
        "from the friction rows": [row.slide_mm for row in left_out],
        "measured displacement": [row.along_mm for row in left_out],
        "friction rows, term put back": [row.slide_mm for row in restored],
        "displacement, term put back": [row.along_mm for row in restored],
    }
    return Table(pd.DataFrame(columns, index=pd.Index(map(case_html, CASES), name="case")))
