"""Ways to hold the cube, from the scene as shipped to the whole cure, and which of them to use."""

from collections.abc import Sequence
from dataclasses import dataclass

from measured_report.claims.claim import Claim, all_of, at_least, at_most, greater
from measured_report.parts.section import Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.names import name_of
from report.shared.arithmetic import cell_count, difference, noise_floor, other_value, share, table_of

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
WAYS = (SHIPPED, STIFF, STIFF_TERM, *STEPS.values())
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
    """Tell whether of the ways that were timed and stress-tested the whole cure slips least, or as little as any.

    It has to keep the cube in its place at 10 cm as well, and to lose few of the cubes that are kept with shipped pads
    at the limits of the grasp. What it costs, section cure_cost says.
    """
    noise, slips = noise_floor(results, "slip_floor"), {way: way.row(results, "3cm").slip_mm for way in WAYS}
    far = BEST.row(results, "10cm").slip_mm
    lost, kept = (other_value(results, "cure_limits", f"{name}_{BEST.tested}") for name in ("lost", "kept"))
    part = share(
        results, "lost_share", "runs that lose the cube with the whole cure, of those that keep it", lost, kept
    )
    more = difference(results, "use_more", "slip with the whole cure less that with the term", slips[BEST], slips[TERM])
    outcome = all_of(
        at_most(far, 0.1, why="hardly more, shaken three times as wide"),
        at_most(part, 5.0, why="few"),
        at_most(more, noise),
        greater(slips[SHIPPED], slips[BEST], noise=noise),
    )
    numbers = {"slip": slips[BEST], "shipped": slips[SHIPPED], "term": slips[TERM], "far": far, "amplitude": amplitude}
    is_tied = more.value is not None and noise.value is not None and more.value >= -noise.value
    return Claim("what_to_use", outcome, numbers | {"lost": lost, "kept": kept, "is_tied": is_tied})


def less_untested(results: Results, runs: Sequence[Row]) -> Claim:
    """Tell how many of all recorded combinations slip less than the whole cure, which nobody timed or stress-tested."""
    noise, best = noise_floor(results, "slip_floor"), BEST.row(results, "3cm").slip_mm
    shaken = [row for row in runs if row.shake == "3cm"]
    there = sorted((row for row in shaken if row.slip_mm.value is not None), key=lambda row: row.slip_mm.value)

    def count(name: str, rows: Sequence[Row]) -> Value:
        def fewer(best: float, noise: float, *slips: float) -> int:
            return sum(slip < best - noise for slip in slips)

        formula = f"{name.replace('_', ' ')}: combinations that slip less than the whole cure, by more than the noise"
        return results.value(name, formula, fewer, best, noise, *(row.slip_mm for row in rows))

    numbers = {
        "count": count("less_count", there),
        "stiff": count("less_stiff_count", [row for row in there if row.pads == "stiff"]),
        "total": cell_count(results, "combination_count", "combinations", [row.frame_count for row in shaken]),
        "least": there[0].slip_mm,
    }
    outcome = at_least(numbers["count"], 1, why="one at least")
    words = {"way": name_of(there[0].case.replace("-3cm", ""))}
    return Claim(
        "less_untested", outcome, numbers | words | {"are_stiff": numbers["stiff"].value == numbers["count"].value}
    )
