"""Compare the outward motion of a box on a rotating table with the law."""

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
NO_HELP = ("noslip", "impratio", "pyramidal")  # usual remedies against sliding
CURED = ("term-rk4-impratio", "term-centred-impratio")
VARIANTS = {  # labels by variant, in the order of the table
    "plain": "unchanged",
    "noslip": "noslip",
    "impratio": "impratio raised",
    "pyramidal": "pyramidal cone",
    "euler": "Euler",
    "rk4": "RK4",
    "half-timeconst": "half the time constant",
    "half-step": "half the step",
    "term": "term restored",
    "term-pyramidal": "term restored, pyramidal cone",
    "term-rk4": "term restored, RK4",
    "term-centred": "term centred",
    "term-rk4-impratio": "term restored, RK4, impratio raised",
    "term-centred-impratio": "term centred, impratio raised",
}


def derive(results: Results) -> Section:
    resolution = results.chosen(
        "resolution",
        "rounding to single precision, which is 7.5 nm in each step of 2 ms at 200 mm"
        " from the axis, gives this rate",
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
                f"{column} of {case}, relative to the distance from the axis",
                PERCENT * row[column],
            )
    plain = growths["plain-c"]

    offs = [
        results.value(
            f"{case}_off",
            "absolute difference between the growth and the law, relative to"
            " the latter",
            departure(growth, law[case]),
        )
        for case, growth in growths.items()
        if None not in (growth.value, law[case].value)
        and abs(law[case].value) > resolution.value
    ]
    off = results.value(
        "law_off", "largest difference from the law", extreme(max, offs)
    )
    count = results.value(
        "fast_count",
        "runs for which the law gives a growth above the resolution",
        cell_count(offs),
    )
    as_law = at_most(off, 0.5, "the same growth")
    follows = all_of(as_law, at_least(growths["plain-warp"], resolution))

    # Compute the law by hand, without the contacts' regularization.
    turn = results.chosen(
        "turn", "given: the angular velocity of the table", 2.0, "rad/s"
    )
    step = results.chosen("step", "given: the time step", 2.0, "ms")
    dmax = results.chosen("dmax", "given: MuJoCo's default", 0.95)
    row = results.row["plain-c"]
    b = results.value("b", "2 / (dmax · timeconst)", 2 / (row.timeconst_s * dmax))
    braking = results.value(
        "braking",
        "ω² / b, relative to the distance from the axis",
        lambda turn, b: 100 * turn**2 / b,
        turn,
        b,
        unit="%/s",
    )
    inward = results.value(
        "inward",
        "ω² h / 2, relative to the distance from the axis",
        lambda turn, ms: 0.1 * turn**2 * ms / 2,
        turn,
        step,
        unit="%/s",
    )
    rough = results.value("rough", "ω² / b minus ω² h / 2", braking - inward)
    yielding = results.value(
        "yielding",
        "R m / n that gives the growth of the law: (growth / ω² + h / 2) b − 1",
        lambda growth, turn, ms, b: (growth / turn**2 + 5e-4 * ms) * b - 1,
        row.predicted_growth_per_s,
        turn,
        step,
        b,
    )
    rough_off = results.value(
        "rough_off",
        "absolute difference between this and the measured growth, relative to the"
        " latter",
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
            "absolute change of the growth, relative to the unchanged scene",
            departure(growths[f"{name}-c"], plain),
        )
        for name in NO_HELP
    ]
    change = results.value(
        "setting_change", "largest of these changes", combined(max, *changes)
    )
    grows = at_least(plain, resolution)
    goes_on = all_of(at_most(change, 10.0, "a remedy would reduce it by more"), grows)
    if grows == FAILS:
        goes_on = replace(
            goes_on, name="unknown", reason="the box does not move outward"
        )
    rest = results.value(
        "cured_growth",
        "largest absolute growth with the term, without the error of the step, and"
        " with a high impratio",
        largest_size(
            growths[f"{variant}-{engine}"] for variant in CURED for engine in ENGINES
        ),
    )
    columns = {
        "MuJoCo C": [growths[f"{variant}-c"] for variant in VARIANTS],
        "predicted by the law": [law[f"{variant}-c"] for variant in VARIANTS],
        "Warp": [growths[f"{variant}-warp"] for variant in VARIANTS],
    }
    return Section(
        tables={"rates": table_of("setup", VARIANTS.values(), columns)},
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
