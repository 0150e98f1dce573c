"""Bodies that tumble, with the exact term and without: does it put energy into any of them?"""

import math

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section
from measured_report.values.results import Results, Row
from report.shared.arithmetic import extreme, gathered, rows_with

VARIANTS = ("plain", "aside", "exact")  # nothing done, the same started a hair aside, and the exact term


def derive(results: Results) -> Section:
    return Section(claims=[_gains_nothing(results, rows_with(results, "tumbling", "step_ms"))])


def _by_chance(*counts: float) -> float:
    """Bound how many gain where the term does nothing, from the counts of two sets in turn."""
    plain, aside = counts[::2], counts[1::2]
    differ = sum(abs(one - other) for one, other in zip(plain, aside, strict=True))
    return min(sum(plain), sum(aside)) + 3.0 * math.sqrt(1.0 + differ)


def _gains_nothing(results: Results, rows: list[Row]) -> Claim:
    """Hold the worlds that gain with the term and not without it against those that a hair's breadth makes gain."""
    formula = "worlds whose energy ends over 1 % above its start, or as no number"
    counts = {name: gathered(sum, (row[f"{name}_gain_count"] for row in rows)) for name in VARIANTS}
    gains = {name: results.value(f"{name}_gains", formula, count) for name, count in counts.items()}
    formula = "the smaller count of both sets without it, and three times the root of one more than they differ by"
    cells = [row[f"{name}_gain_count"] for row in rows for name in ("plain", "aside")]
    chance = results.value("tumble_chance", formula, _by_chance, *cells)
    total = gathered(sum, (row.world_count for row in rows))
    worlds = results.value("tumble_count", "worlds with the exact term", total)
    outcome = all_of(at_most(gains["exact"], chance), at_least(worlds, 10_000, why="enough to see what is rare"))
    steps = [row.step_ms for row in rows]
    shortest = results.value("tumble_shortest", "the shortest step", extreme(min, steps))
    longest = results.value("tumble_longest", "the longest step", extreme(max, steps))
    gain = results.chosen("tumble_gain", "less can be rounding", 1.0, "%")
    spin = results.chosen("tumble_spin", "given: how fast the fastest spin", 200.0, "rad/s")
    numbers = {"worlds": worlds, "spin": spin, "gain": gain, "shortest": shortest, "longest": longest}
    return Claim("tumbling_gains_nothing", outcome, numbers | gains)
