"""Bodies that wobble, spin, roll or tumble: does the exact term put energy into any?"""

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

# Counts of pairs that differ: with the term more, and less.
DIFFERENCES = {
    "gain": ("exact_alone_count", "plain_alone_count"),
    "rise": ("higher_count", "lower_count"),
}


def derive(results: Results) -> Section:
    rows = rows_with(results, "pair_count")
    plain, exact = (
        results.value(
            f"{name}_gains",
            "worlds that at any time have over 1 % more energy than at the start,"
            " or no number",
            gathered(sum, (row[f"{name}_gain_count"] for row in rows)),
        )
        for name in ("plain", "exact")
    )
    more = results.value(
        "tumble_more",
        "worlds that gain with the term less those without, by the root of their sum",
        combined(_excess, exact, plain),
        is_noise=True,  # chance is in the statistic
    )
    # Whether more of any body gain energy, or rise, with the term than chance has it.
    bodies = dict.fromkeys(row.plain["tumbling"] for row in rows)
    gained, risen = (
        results.value(
            f"tumble_{kind}_excess",
            "of the body with most: pairs with more of it with the term less those"
            " without, by the root of their sum",
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
        "the most energy by that at the start with the term, where the body never has"
        " 1 % more without, by step",
        _surprise,
        *(row[f"{name}_most_energy"] for row in rows for name in ("exact", "plain")),
    )
    pairs = results.value(
        "tumble_count",
        "pairs of worlds",
        gathered(sum, (row.pair_count for row in rows)),
    )
    chance = "three standard deviations: more is hardly chance"
    outcome = all_of(
        *(at_most(value, 3.0, chance) for value in (more, gained, risen)),
        at_most(surprise, 1.05, "more than an error of the step"),
        at_least(pairs, 20_000, "enough to see what is rare"),
    )
    steps = [row.step_ms for row in rows]
    numbers = {
        "pairs": pairs,
        "gain": results.chosen("tumble_gain", "less can be rounding", 1.0, "%"),
        "shortest": results.value(
            "tumble_shortest", "the shortest step", extreme(min, steps)
        ),
        "longest": results.value(
            "tumble_longest", "the longest step", extreme(max, steps)
        ),
        "gained": gained,
        "risen": risen,
        "surprise": surprise,
        "plain": plain,
        "exact": exact,
    }
    return Section(claims=[Claim("tumbling_gains_nothing", outcome, numbers)])


def _excess(*counts: float) -> float:
    """Return how many standard deviations more there are of the first of two kinds.

    The counts of the two kinds are given in turn.
    """
    more = sum(counts[::2])
    fewer = sum(counts[1::2])
    return (more - fewer) / max(1.0, more + fewer) ** 0.5


def _surprise(*energies: float) -> float:
    """Return the most energy with the term where that without stays below 1.01.

    Energies with the term and without are given in turn.
    """
    pairs = zip(energies[::2], energies[1::2], strict=True)
    return max([1.0, *(exact for exact, plain in pairs if plain <= 1.01)])
