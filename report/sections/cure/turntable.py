"""A box on a table that turns: does it walk outward as the law says, and what stops it?"""

from collections.abc import Mapping
from dataclasses import replace

from report.shared import (
    FAILS,
    PERCENT,
    Claim,
    Column,
    Results,
    Section,
    Value,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    decided,
    departure,
    extreme,
    largest_size,
    table_of,
)

ENGINES = ("warp", "c")
CORNERS = 4  # contacts of the box
NO_HELP = (
    "noslip",
    "impratio",
    "pyramidal",
)  # variants that one would try against sliding
CURED = ("term-rk4-impratio", "term-centred-impratio")
VARIANTS = {  # labels by variant, in the order of the table: without the term and with it
    "plain": "nothing done",
    "noslip": "noslip",
    "impratio": "impratio raised",
    "pyramidal": "pyramidal cone",
    "euler": "Euler",
    "rk4": "RK4",
    "half-timeconst": "half the time constant",
    "half-step": "half the step",
    "term": "term put back",
    "term-pyramidal": "term put back, pyramidal cone",
    "term-rk4": "term put back, RK4",
    "term-centred": "term centred",
    "term-rk4-impratio": "term put back, RK4, impratio raised",
    "term-centred-impratio": "term centred, impratio raised",
}


def derive(results: Results) -> Section:
    why = "a place 200 mm from the axis is rounded to 15 nm in single precision, half of it in each step of 2 ms"
    resolution = results.chosen("resolution", why, 0.002, "%/s")
    rows = {
        case: results.row[case]
        for case in (
            f"{variant}-{engine}" for variant in VARIANTS for engine in ENGINES
        )
    }
    measured, law = dict[str, Value](), dict[str, Value]()
    for cells, column in ((measured, "growth_per_s"), (law, "predicted_growth_per_s")):
        for case, row in rows.items():
            cells[case] = results.value(
                f"{case}_{column}",
                f"{column} of {case}, in percent of the distance from the axis",
                PERCENT * row[column],
            )
    columns: dict[str, Column] = {
        name: [cells[f"{variant}-{engine}"] for variant in VARIANTS]
        for name, cells, engine in (
            ("MuJoCo C", measured, "c"),
            ("by the law", law, "c"),
            ("Warp", measured, "warp"),
        )
    }
    tables = {"rates": table_of("what is done", VARIANTS.values(), columns)}
    claims = [
        _follows_law(results, measured, law, resolution),
        _by_hand(results, measured["plain-c"]),
    ]
    growths = (
        measured[f"{variant}-{engine}"] for variant in CURED for engine in ENGINES
    )
    claims += [_no_setting_stops_it(results, measured, resolution)]
    largest = results.value(
        "cured_growth",
        "largest growth, in size, with the term, without the error of the step and with a high impratio",
        largest_size(growths),
    )
    claims += [
        Claim(
            "cured",
            at_most(largest, resolution),
            {"largest": largest, "resolution": resolution},
        )
    ]
    return Section(tables=tables, claims=claims)


def _follows_law(
    results: Results,
    measured: Mapping[str, Value],
    law: Mapping[str, Value],
    resolution: Value,
) -> Claim:
    cases = [case for case in measured if measured[case].value is not None]
    fast = [
        case
        for case in cases
        if law[case].value is not None and abs(law[case].value) > resolution.value
    ]
    shares = [
        results.value(
            f"{case}_off",
            "growth less that of the law, in size, of the latter",
            departure(measured[case], law[case]),
        )
        for case in fast
    ]
    largest = results.value(
        "law_off", "largest of the departures from the law", extreme(max, shares)
    )
    numbers = {
        "growth": measured["plain-warp"],
        "law": law["plain-warp"],
        "largest": largest,
        "seen": resolution,
    }
    numbers |= {
        "count": results.value(
            "fast_count", "runs for which it gives more", cell_count(shares)
        )
    }
    outward = at_least(numbers["growth"], resolution)
    return Claim(
        "follows_law",
        all_of(at_most(largest, 0.5, why="the same growth"), outward),
        numbers,
    )


def _by_hand(results: Results, plain: Value) -> Claim:
    """Work the law out of what is given, without the contacts' regularization."""
    turn = results.chosen("turn", "given: how fast the table turns", 2.0, "rad/s")
    step = results.chosen("step", "given: the time step", 2.0, "ms")
    timeconst, dmax = (
        results.row["plain-c"].timeconst_s,
        results.chosen("dmax", "given: MuJoCo's default", 0.95),
    )
    b = results.value("b", "2 / (dmax · timeconst)", 2 / (timeconst * dmax))
    braking = results.value(
        "braking",
        "ω² / b, of the distance from the axis",
        lambda turn, b: 100 * turn**2 / b,
        turn,
        b,
        unit="%/s",
    )
    inward = results.value(
        "inward",
        "ω² h / 2, of the distance from the axis",
        lambda turn, ms: 0.1 * turn**2 * ms / 2,
        turn,
        step,
        unit="%/s",
    )
    rough = results.value("rough", "the first less the second", braking - inward)
    cells = results.row["plain-c"].predicted_growth_per_s, turn, step, b
    yielding = results.value(
        "yielding",
        "what the law's growth takes for R m / n, (growth / ω² + h / 2) b − 1",
        lambda g, w, ms, b: (g / w**2 + 5e-4 * ms) * b - 1,
        *cells,
    )
    off = results.value(
        "rough_off",
        "how far that is from the growth, of the latter",
        departure(rough, plain),
    )
    contacts = results.row["plain-c"].loaded_contact_count
    numbers = {
        "contacts": contacts,
        "yielding": yielding,
        "turn": turn,
        "b": b,
        "step": step,
    }
    numbers |= {"braking": braking, "inward": inward, "rough": rough}
    closes = (
        at_most(off, 5.0, why="nearly all of it"),
        at_most(results.derived["law_off"], 0.5, why="the same growth"),
    )
    return Claim(
        "by_hand",
        all_of(*closes, decided(contacts.value == CORNERS, contacts)),
        numbers,
    )


def _no_setting_stops_it(
    results: Results, measured: Mapping[str, Value], resolution: Value
) -> Claim:
    plain, formula = (
        measured["plain-c"],
        "change of the growth, in size, of the growth with nothing done",
    )
    changes = [
        results.value(
            f"{name}_change", formula, departure(measured[f"{name}-c"], plain)
        )
        for name in NO_HELP
    ]
    largest = results.value(
        "setting_change", "largest of these changes", combined(max, *changes)
    )
    grows = at_least(plain, resolution)
    outcome = all_of(
        at_most(largest, 10.0, why="a cure would take more of it away"), grows
    )
    if grows == FAILS:
        outcome = replace(outcome, name="unknown", reason="there is no growth to stop")
    return Claim("no_setting_stops_it", outcome, {"largest": largest})
