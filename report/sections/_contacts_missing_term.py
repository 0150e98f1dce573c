"""The acceleration that contact rows leave out: what it accounts for, and the runs that have it put back."""

import pandas as pd

from report.claims import Claim, at_most, greater
from report.parts import Table
from report.results import Results, Row
from report.sections._common import departure, ratio, size_share

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
        holds="What makes them slide is an acceleration that the contact rows leave out. From the positions and "
        "velocities of a run through MuJoCo C, with nothing fitted, it gives {predicted} of slide as shipped where the "
        "friction rows show {slide}, and with stiff pads {predicted_stiff} where they show {slide_stiff}: never more "
        "than {departure} apart.",
        fails="An acceleration that the contact rows leave out does not account for the slide: it gives {predicted} as "
        "shipped where the friction rows show {slide}, and with stiff pads {predicted_stiff} where they show "
        "{slide_stiff}.",
        unknown="What makes the friction rows slide cannot be told.",
        numbers={
            "predicted": shipped.predicted_slide_mm,
            "slide": shipped.slide_mm,
            "predicted_stiff": stiff.predicted_slide_mm,
            "slide_stiff": stiff.slide_mm,
            "departure": largest,
        },
        explanation="A contact point of the arm accelerates by J·q̈ + J̇·q̇: the second part comes from the joints' "
        "velocities, as when a point moves on a curve. A contact row sets only J·q̈, to −b·v. To follow the arm all "
        "the same the row has to slide at v = J̇·q̇ / b. That goes with the square of the speed, so it does not cancel "
        "over a cycle; no friction coefficient and no iteration changes it, and b = 2 / (dmax · timeconst) is the only "
        "thing that stands against it.",
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
    numbers = {}
    for name, without, put_back in zip(("", "_stiff"), left_out, restored, strict=True):
        numbers |= {f"slide{name}": without.slide_mm, f"restored{name}": put_back.slide_mm}
    return Claim(
        "term_restored",
        at_most(largest, bound),
        holds="Put back into the contact rows, it ends the slide: {restored} in place of {slide} as shipped, "
        "{restored_stiff} in place of {slide_stiff} with stiff pads. So it is the cause.",
        fails="Put back into the contact rows, it does not end the slide: {restored} in place of {slide} as shipped, "
        "{restored_stiff} in place of {slide_stiff} with stiff pads.",
        unknown="Whether the slide ends when the term is put back cannot be told.",
        numbers=numbers,
    )


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
        at_most(largest, bound),
        holds="What the rows' slide and the measured displacement differ by is the motion that stays when nothing "
        "slides: {creep} as shipped, {creep_stiff} with stiff pads. With it the account closes to within {rest}.",
        fails="The rows' slide and the motion that stays when nothing slides, {creep} as shipped and {creep_stiff} "
        "with stiff pads, do not add up to the measured displacement: {rest} are left over.",
        unknown="Whether the rows' slide and the rest add up to the measured displacement cannot be told.",
        numbers={"creep": shipped.along_mm, "creep_stiff": stiff.along_mm, "rest": largest},
    )


def _rest_goes_with_step(results: Results) -> Claim:
    """Whether what moves the cube when nothing slides is proportional to the time step."""
    [shipped, _], double = _in_c(results, "term-restored"), results.row["double-step-term-restored"]
    formula = "displacement with a step twice as long over that with the shipped one, both with the term put back"
    growth = ratio(results, "rest_growth", formula, double.along_mm, shipped.along_mm)
    off = results.value("rest_growth_off", "how far that ratio is from two", lambda found: abs(found - 2.0), growth)
    return Claim(
        "rest_goes_with_step",
        at_most(off, results.chosen("rest_growth_bound", "near two", 0.25)),
        holds="That motion goes with the time step: with steps twice as long it is {double}, {growth} times as much.",
        fails="That motion does not go with the time step: with steps twice as long it is {double}, {growth} times as "
        "much.",
        unknown="Whether that motion goes with the time step cannot be told.",
        numbers={"double": double.along_mm, "growth": growth},
        explanation="So it is an error of the time integration and not of the contacts.",
    )


def _slide_falls_with_timeconst(results: Results) -> Claim:
    """What stiff pads really gain: the displacement also has the creep, which hides a part of what still slides."""
    shipped, stiff = _in_c(results, "missing-term")
    formula = "slide of the friction rows as shipped, over that with stiff pads"
    slide = ratio(results, "slide_gain", formula, shipped.slide_mm, stiff.slide_mm)
    formula = "measured displacement as shipped, over that with stiff pads"
    along = ratio(results, "along_gain", formula, shipped.along_mm, stiff.along_mm)
    return Claim(
        "slide_falls_less_than_displacement",
        greater(along, slide, noise=results.chosen("gain_bound", "the same gain", 1.0)),
        holds="With stiff pads the cube slides {slide} times less, while its displacement falls {along} times.",
        fails="With stiff pads the cube slides {slide} times less, and its displacement falls {along} times.",
        unknown="With stiff pads the cube slides {slide} times less and its displacement falls {along} times; whether "
        "these differ cannot be told.",
        numbers={"slide": slide, "along": along},
        explanation="The motion that stays goes against the slide and hides a part of what is left of it.",
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
    return Table(
        pd.DataFrame(columns, index=pd.Index(CASES, name="case")),
        "Slide along the main axis over the first two periods of the whole motion, which repeats every second cycle, "
        "in runs through MuJoCo C: J̇·q̇ / b at the loaded contacts, with J̇ from MuJoCo's mj_jacDot; the velocity of "
        "the same contacts' friction rows; how far the cube has moved; and the last two again in a run whose contact "
        "rows ask for −b·v − J̇·q̇.",
    )
