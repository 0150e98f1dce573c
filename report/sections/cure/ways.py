"""Ways to hold the cube, from the scene as shipped to the cure on stiff pads, and which of them to use."""

from collections.abc import Sequence
from dataclasses import dataclass

from measured_report.parts.claim import Claim, all_of, at_least, at_most, greater
from measured_report.parts.section import Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import cell_count, difference, noise_floor, other_value, table_of

GRASP_MM = 80.0
"""Farther from where it was, a cube is out of the grasp."""


@dataclass(frozen=True)
class Way:
    """One combination of parts of the cure."""

    name: str
    setting: str
    """Kind of contacts, integrator and impratio, and pads."""
    parts: str
    """What is done about the term, and about positions."""
    tested: str = ""
    """What sections cure_cost and cure_limits call it, if both of them have it."""

    def row(self, results: Results, shake: str) -> Row:
        return results.row[f"{self.setting}-{shake}-{self.parts}"]


SHIPPED = Way("as shipped", "newton-implicitfast-50-shipped", "plain-rounded")
STIFF = Way("stiff pads, the fix", "newton-implicitfast-50-stiff", "plain-rounded")
STIFF_TERM = Way("stiff pads and the term", "newton-implicitfast-50-stiff", "term-rounded")
TERM = Way("the term", "newton-implicitfast-50-shipped", "term-rounded", tested="term")
BEST = Way("the whole cure, in normal rows too", "newton-euler-400-shipped", "full-kept", tested="best")
STEPS = {
    "the term": TERM,
    "centring": Way("the term centred, Euler", "newton-euler-50-shipped", "centred-rounded"),
    "impratio": Way("the same, high impratio", "newton-euler-400-shipped", "centred-rounded"),
    "compensated positions": Way("the same, positions compensated", "newton-euler-400-shipped", "centred-kept"),
    "normal rows": BEST,
}
"""One part more each time, by its name."""
FIRM = Way("stiff pads and the cure", "newton-implicitfast-400-stiff", "centred-kept", tested="firm")
FIRM_EULER = Way("the same, Euler", "newton-euler-400-stiff", "centred-kept", tested="firm_euler")
WAYS = (SHIPPED, STIFF, STIFF_TERM, *STEPS.values(), FIRM, FIRM_EULER)
TESTED = [way for way in WAYS if way.tested]
KF_OFF = Way("as shipped, kf off", "newton-implicitfast-50-shipped", "kf-off")
"""Where the release reads ``kf``."""


def use_table(results: Results) -> Table:
    """Make the table of the slips of each way."""
    ways = [*WAYS, *([KF_OFF] if KF_OFF.row(results, "3cm") else [])]
    columns = {
        above: ["lost" if row.dropped else row.slip_mm for row in (way.row(results, shake) for way in ways)]
        for above, shake in (("shaken 30 mm", "3cm"), ("shaken 100 mm", "10cm"), ("held still", "held"))
    }
    return table_of("what is done", [way.name for way in ways], columns)


def what_to_use(results: Results, amplitude: Value) -> Claim:
    """Tell whether the cure on stiff pads loses no cube that they keep, and no other such way slips less.

    Only ways that were timed and tried at the limits of the grasp count. It has to keep the cube in its place at 10 cm
    as well. What it costs, section cure_cost says.
    """
    noise, slips = (
        noise_floor(results, "slip_floor"),
        {way: way.row(results, "3cm").slip_mm for way in (SHIPPED, *TESTED)},
    )
    far = FIRM.row(results, "10cm").slip_mm
    lost = {way: other_value(results, "cure_limits", f"lost_{way.tested}") for way in TESTED}
    more = [
        difference(results, f"use_more_{way.tested}", "its slip less that of this way", slips[FIRM], slips[way])
        for way in TESTED
        if way != FIRM and lost[way].value == 0
    ]
    outcome = all_of(
        at_most(lost[FIRM], 0, why="none of them is lost"),
        at_most(far, 0.05, why="hardly more, shaken three times as wide"),
        *(at_most(each, noise) for each in more),
        greater(slips[SHIPPED], slips[FIRM], noise=noise),
    )
    numbers = {"slip": slips[FIRM], "shipped": slips[SHIPPED], "far": far, "amplitude": amplitude}
    numbers |= {"lost": lost[FIRM], "kept": other_value(results, "cure_limits", f"kept_{FIRM.tested}")}
    return Claim("what_to_use", outcome.having_read(*lost.values()), numbers)


def less_untested(results: Results, runs: Sequence[Row]) -> Claim:
    """Tell how many of all recorded combinations slip less than the cure on stiff pads, and were not tested."""
    noise, best = noise_floor(results, "slip_floor"), FIRM.row(results, "3cm").slip_mm
    shaken = [row for row in runs if row.shake == "3cm"]
    tested = [f"{way.setting}-3cm-{way.parts}" for way in TESTED]
    others = [row for row in shaken if row.slip_mm.value is not None and row.case not in tested]
    there = sorted(others, key=lambda row: row.slip_mm.value)

    def fewer(best: float, noise: float, *slips: float) -> int:
        return sum(slip < best - noise for slip in slips)

    formula = "combinations that were not tested and slip less, by more than the noise"
    numbers = {
        "count": results.value("less_count", formula, fewer, best, noise, *(row.slip_mm for row in there)),
        "total": cell_count(results, "combination_count", "combinations", [row.frame_count for row in shaken]),
        "least": there[0].slip_mm,
    }
    words = {"way": name_of(there[0].case.replace("-3cm", ""))}
    return Claim("less_untested", at_least(numbers["count"], 1, why="one at least"), numbers | words)
