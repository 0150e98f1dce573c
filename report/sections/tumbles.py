"""Compare the energy of bodies that wobble, spin, roll or tumble with and without the term."""

from report.shared import (
    Claim,
    Results,
    Section,
    all_of,
    at_least,
    at_most,
    combined,
    extreme,
    gathered,
    rows_with,
)

order = 142
page = "cure"
label = "bodies that tumble"

# Columns that count the pairs in which a quantity is larger, and smaller, with the
# term.
DIFFERENCES = {
    "gain": ("exact_alone_count", "plain_alone_count"),
    "rise": ("higher_count", "lower_count"),
}


def derive(results: Results) -> Section:
    rows = rows_with(results, "pair_count")
    plain, exact = (
        results.value(
            f"{name}_gains",
            "worlds that at any time have over 1 % more energy than at the start, or"
            " whose energy is not a number",
            gathered(sum, (row[f"{name}_gain_count"] for row in rows)),
        )
        for name in ("plain", "exact")
    )
    more = results.value(
        "tumble_more",
        "worlds that gain energy with the term minus those without, over the root of"
        " their sum",
        combined(_excess, exact, plain),
        is_noise=True,  # the statistic itself accounts for chance
    )
    # Test whether any kind of body gains energy, or rises, more often with the term
    # than by chance.
    bodies = dict.fromkeys(row.plain["tumbling"] for row in rows)
    gained, risen = (
        results.value(
            f"tumble_{kind}_excess",
            "largest excess of a kind of body: pairs with more of it with the term"
            " minus those without, over the root of their sum",
            combined(
                max,
                *(
                    combined(
                        _excess,
                        *(
                            row[column]
                            for row in rows
                            if row.plain["tumbling"] == body
                            for column in columns
                        ),
                    )
                    for body in bodies
                ),
            ),
            is_noise=True,
        )
        for kind, columns in DIFFERENCES.items()
    )
    surprise = results.value(
        "tumble_surprise",
        "largest energy relative to the start with the term, over the time steps at"
        " which the body never gains 1 % without it",
        _surprise,
        *(row[f"{name}_most_energy"] for row in rows for name in ("exact", "plain")),
    )
    pairs = results.value(
        "tumble_count",
        "pairs of worlds",
        gathered(sum, (row.pair_count for row in rows)),
    )
    chance = "three standard deviations, which chance hardly exceeds"
    outcome = all_of(
        *(at_most(value, 3.0, chance) for value in (more, gained, risen)),
        at_most(surprise, 1.05, "an error of the time step causes less"),
        at_least(pairs, 20_000, "enough pairs to see rare events"),
    )
    steps = [row.step_ms for row in rows]
    numbers = {
        "pairs": pairs,
        "gain": results.chosen(
            "tumble_gain", "a smaller gain may be rounding", 1.0, "%"
        ),
        "shortest": results.value(
            "tumble_shortest", "shortest time step", extreme(min, steps)
        ),
        "longest": results.value(
            "tumble_longest", "longest time step", extreme(max, steps)
        ),
        "gained": gained,
        "risen": risen,
        "surprise": surprise,
        "plain": plain,
        "exact": exact,
    }
    return Section(claims=[Claim("tumbling_gains_nothing", outcome, numbers)])


def _excess(*counts: float) -> float:
    """Return the excess of the first count over the second, in standard deviations.

    The arguments alternate between the two counts.
    """
    more = sum(counts[::2])
    fewer = sum(counts[1::2])
    return (more - fewer) / max(1.0, more + fewer) ** 0.5


def _surprise(*energies: float) -> float:
    """Return the largest energy with the term in pairs that gain at most 1 % without it.

    The arguments alternate between energies with and without the term.
    """
    pairs = zip(energies[::2], energies[1::2], strict=True)
    return max([1.0, *(exact for exact, plain in pairs if plain <= 1.01)])
