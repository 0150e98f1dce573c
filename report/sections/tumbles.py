"""Bodies that wobble, spin, roll or tumble, with the exact term and without: does it put energy into any of them?"""

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section
from measured_report.values.quantities import combined
from measured_report.values.results import Results
from report.shared.arithmetic import extreme, gathered, rows_with

order = 142
page = "cure"
label = "bodies that tumble"

# Counts of pairs that differ: with the term more, and less.
DIFFERENCES = {"gain": ("exact_alone_count", "plain_alone_count"), "rise": ("higher_count", "lower_count")}


def derive(results: Results) -> Section:
    """Ask of the pairs that differ whether more of any body gain energy, or rise, with the term than chance has it."""
    rows = rows_with(results, "pair_count")
    formula = "worlds that at any time have over 1 % more energy than at the start, or no number"
    sums = {name: gathered(sum, (row[f"{name}_gain_count"] for row in rows)) for name in ("plain", "exact")}
    gains = {name: results.value(f"{name}_gains", formula, count) for name, count in sums.items()}
    names = dict.fromkeys(row.plain["tumbling"] for row in rows)
    bodies = [[row for row in rows if row.plain["tumbling"] == name] for name in names]
    formula = "of the body with most: pairs with more of it with the term less those without, by the root of their sum"
    excess = {}
    for kind, columns in DIFFERENCES.items():
        excesses = [combined(_excess, *(row[column] for row in body for column in columns)) for body in bodies]
        excess[kind] = results.value(f"tumble_{kind}_excess", formula, extreme(max, excesses))
    cells = [row[f"{name}_most_energy"] for row in rows for name in ("exact", "plain")]
    formula = "the most energy by that at the start with the term, where the body never has 1 % more without, by step"
    surprise = results.value("tumble_surprise", formula, _surprise, *cells)
    pairs = results.value("tumble_count", "pairs of worlds", gathered(sum, (row.pair_count for row in rows)))
    formula = "worlds that gain with the term less those without, by the root of their sum"
    more = results.value("tumble_more", formula, combined(_excess, gains["exact"], gains["plain"]))
    chance = "three standard deviations: more is hardly chance"
    tests = [at_most(value, 3.0, why=chance) for value in (more, *excess.values())]
    tests += [at_most(surprise, 1.05, why="more than an error of the step")]
    outcome = all_of(*tests, at_least(pairs, 20_000, why="enough to see what is rare"))
    steps = [row.step_ms for row in rows]
    shortest = results.value("tumble_shortest", "the shortest step", extreme(min, steps))
    longest = results.value("tumble_longest", "the longest step", extreme(max, steps))
    gain = results.chosen("tumble_gain", "less can be rounding", 1.0, "%")
    numbers = {"pairs": pairs, "gain": gain, "shortest": shortest, "longest": longest}
    numbers |= {"gained": excess["gain"], "risen": excess["rise"], "surprise": surprise}
    return Section(claims=[Claim("tumbling_gains_nothing", outcome, numbers | gains)])


def _excess(*counts: float) -> float:
    """Tell by how many standard deviations the counts of the first kind exceed those of the second, in turn."""
    more, fewer = sum(counts[::2]), sum(counts[1::2])
    return (more - fewer) / max(1.0, more + fewer) ** 0.5


def _surprise(*energies: float) -> float:
    """Return the most of all with the term, in turn with those without it, where the latter stay below 1.01."""
    return max([1.0, *(exact for exact, plain in zip(energies[::2], energies[1::2], strict=True) if plain <= 1.01)])
