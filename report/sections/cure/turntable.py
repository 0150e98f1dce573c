"""A box on a table that turns: does it walk outward as the law says?"""

from dataclasses import replace

from report.shared import (
    FAILS,
    PERCENT,
    Claim,
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
NO_HELP = ("noslip", "impratio", "pyramidal")  # that one would try against sliding
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
    resolution = results.chosen(
        "resolution",
        "a place 200 mm from the axis is rounded to 15 nm in single precision,"
        " half of it in each step of 2 ms",
        0.002,
        "%/s",
    )
    growths: dict[str, Value] = {}
    law: dict[str, Value] = {}
    for case in (f"{variant}-{engine}" for variant in VARIANTS for engine in ENGINES):
        row = results.row[case]
        for cells, column in (
            (growths, "growth_per_s"),
            (law, "predicted_growth_per_s"),
        ):
            cells[case] = results.value(
                f"{case}_{column}",
                f"{column} of {case}, in percent of the distance from the axis",
                PERCENT * row[column],
            )
    plain = growths["plain-c"]

    offs = [
        results.value(
            f"{case}_off",
            "growth less that of the law, in size, of the latter",
            departure(growth, law[case]),
        )
        for case, growth in growths.items()
        if None not in (growth.value, law[case].value)
        and abs(law[case].value) > resolution.value
    ]
    off = results.value(
        "law_off", "largest of the departures from the law", extreme(max, offs)
    )
    count = results.value(
        "fast_count", "runs for which it gives more", cell_count(offs)
    )
    as_law = at_most(off, 0.5, "the same growth")
    follows = all_of(as_law, at_least(growths["plain-warp"], resolution))

    # The law by hand, without the contacts' regularization.
    turn = results.chosen("turn", "given: how fast the table turns", 2.0, "rad/s")
    step = results.chosen("step", "given: the time step", 2.0, "ms")
    dmax = results.chosen("dmax", "given: MuJoCo's default", 0.95)
    row = results.row["plain-c"]
    b = results.value("b", "2 / (dmax · timeconst)", 2 / (row.timeconst_s * dmax))
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
    yielding = results.value(
        "yielding",
        "what the law's growth takes for R m / n, (growth / ω² + h / 2) b − 1",
        lambda growth, turn, ms, b: (growth / turn**2 + 5e-4 * ms) * b - 1,
        row.predicted_growth_per_s,
        turn,
        step,
        b,
    )
    rough_off = results.value(
        "rough_off",
        "how far that is from the growth, of the latter",
        departure(rough, plain),
    )
    contacts = row.loaded_contact_count
    closes = all_of(
        at_most(rough_off, 5.0, "nearly all of it"),
        as_law,
        decided(contacts.value == CORNERS, contacts),
    )

    changes = [
        results.value(
            f"{name}_change",
            "change of the growth, in size, of the growth with nothing done",
            departure(growths[f"{name}-c"], plain),
        )
        for name in NO_HELP
    ]
    change = results.value(
        "setting_change", "largest of these changes", combined(max, *changes)
    )
    grows = at_least(plain, resolution)
    goes_on = all_of(at_most(change, 10.0, "a cure would take more of it away"), grows)
    if grows == FAILS:
        goes_on = replace(goes_on, name="unknown", reason="there is no growth to stop")
    rest = results.value(
        "cured_growth",
        "largest growth, in size, with the term, without the error of the step and with"
        " a high impratio",
        largest_size(growths[f"{way}-{engine}"] for way in CURED for engine in ENGINES),
    )
    columns = {
        "MuJoCo C": [growths[f"{variant}-c"] for variant in VARIANTS],
        "by the law": [law[f"{variant}-c"] for variant in VARIANTS],
        "Warp": [growths[f"{variant}-warp"] for variant in VARIANTS],
    }
    return Section(
        tables={"rates": table_of("what is done", VARIANTS.values(), columns)},
        claims=[
            Claim(
                "follows_law",
                follows,
                {
                    "growth": growths["plain-warp"],
                    "law": law["plain-warp"],
                    "largest": off,
                    "seen": resolution,
                    "count": count,
                },
            ),
            Claim(
                "by_hand",
                closes,
                {
                    "contacts": contacts,
                    "yielding": yielding,
                    "turn": turn,
                    "b": b,
                    "step": step,
                    "braking": braking,
                    "inward": inward,
                    "rough": rough,
                },
            ),
            Claim("no_setting_stops_it", goes_on, {"largest": change}),
            Claim(
                "cured",
                at_most(rest, resolution),
                {"largest": rest, "resolution": resolution},
            ),
        ],
    )
