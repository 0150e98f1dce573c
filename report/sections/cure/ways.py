"""Ways to hold the cube, from the scene as shipped to all remedies, and what each comes to."""

from dataclasses import dataclass

from measured_report.claims.claim import HOLDS, Claim, Outcome, all_of, at_most, greater, within
from measured_report.parts.section import Table
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.names import worlds_name
from report.shared.arithmetic import difference, noise_floor, table_of
from report.shared.timing import CURE_WORLDS

GRASP_MM = 80.0
"""Farther from where it was, a cube is out of the grasp."""


@dataclass(frozen=True)
class Way:
    """One combination of remedies."""

    name: str
    setting: str
    """Kind of contacts, integrator and impratio, and pads."""
    remedies: str
    """What is done about the term, and about positions."""
    timed: str = ""
    """Its case in section cure_cost, where it was timed."""
    may_break: str = ""
    tried: str = ""
    """What it is called in section cure_limits, where it was tried at the limits of the grasp."""

    def case(self, amplitude: str) -> str:
        return f"{self.setting}-{amplitude}-{self.remedies}"

    def row(self, results: Results, amplitude: str) -> Row:
        return results.row[self.case(amplitude)]


BEST = Way(
    "all, in normal rows too", "newton-euler-400-shipped", "full-kept", "best", "as above; bodies that roll", "best"
)
WAYS = (
    Way("shipped pads", "newton-implicitfast-50-shipped", "plain-rounded", "as-shipped", "holds nothing for long"),
    Way("stiff pads", "newton-implicitfast-50-stiff", "plain-rounded", "", "long steps"),
    Way("stiff pads, the term", "newton-implicitfast-50-stiff", "term-rounded", "", "as both"),
    Way("the term", "newton-implicitfast-50-shipped", "term-rounded", "term", "bodies that roll and spin", "term"),
    Way("the term, RK4", "newton-rk4-50-shipped", "term-rounded", "term-rk4", "the same; time"),
    Way("the term centred, Euler", "newton-euler-50-shipped", "centred-rounded", "", "as the term; damped drives"),
    Way("and a high impratio", "newton-euler-400-shipped", "centred-rounded", "", "the same; few iterations"),
    Way("and compensated positions", "newton-euler-400-shipped", "centred-kept", "", "the same"),
    BEST,
)
ADDS = "and "
"""How the name of a way begins that has all that the one above it has."""
KF_OFF = Way(
    "shipped pads, kf off", "newton-implicitfast-50-shipped", "kf-off", may_break="slides as releases before kf"
)
"""Where the release reads ``kf``."""
STEPS = {
    "shipped": "shipped pads",
    "term": "the term",
    "centred": "the term centred, Euler",
    "impratio": "and a high impratio",
    "kept": "and compensated positions",
}
"""One remedy more each time."""


def _with_all(way: Way) -> str:
    """Name a way in a sentence: one that adds to those above it, with them."""
    first = last = WAYS.index(way)
    while WAYS[first].name.startswith(ADDS):
        first -= 1
    *others, added = [found.name.removeprefix(ADDS) for found in WAYS[first : last + 1]]
    return " and ".join([", ".join(others), added] if others else [added])


def use_table(results: Results) -> Table:
    """Make the table of what to use: for each way its slips, and what it breaks or may break."""
    ways = [*WAYS, *([KF_OFF] if KF_OFF.case("3cm") in results.row else [])]
    columns: dict[str, list] = {
        above: ["lost" if row.dropped else row.slip_mm for row in (way.row(results, shake) for way in ways)]
        for above, shake in (("slip, 30 mm", "3cm"), ("slip, 100 mm", "10cm"), ("held still", "held"))
    }
    columns["lost at the limits"] = [_lost(results, way) for way in ways]
    columns["may break"] = [way.may_break for way in ways]
    return table_of("what is done", [way.name for way in ways], columns)


def cost_table(results: Results) -> Table:
    """Make the table of the ways that were timed."""
    ways, timed = [way for way in WAYS if way.timed], results.others.get("cure_cost")
    times = {(row.case, row.worlds.value): row.frame_ms for row in (timed.rows if timed else [])}
    none = absent("ms", "it was not timed")
    columns = {worlds_name(count): [times.get((way.timed, count), none) for way in ways] for count in CURE_WORLDS}
    return table_of("what is done", [way.name for way in ways], columns)


def _lost(results: Results, way: Way) -> Quantity:
    """Look up how many runs keep the cube with shipped pads and lose it this way."""
    limits = results.others.get("cure_limits")
    found = limits.derived.get(f"lost_{way.tried}") if limits else None
    return found or absent("1", "it was not tried there")


def what_to_use(results: Results, amplitude: Value, grasp: Value) -> Claim:
    """Tell whether all remedies together are what the rule finds: the least slip of all ways that hold the cube at
    10 cm as well, for next to no time of a frame, as far as it was timed, and break nothing, as far as it was tried.

    Of ways that slip alike, as far as can be told, they are the one to use.
    """
    bound = results.chosen("use_bound", "next to no time of a frame", 3.0, unit="%")
    fit = {way: _fits(results, way, bound, grasp) for way in WAYS}
    slips = {way: way.row(results, "3cm").slip_mm for way in WAYS}
    left = {way: slips[way].value for way in WAYS if fit[way] == HOLDS and slips[way].value is not None}
    least = min(left, key=lambda way: left[way], default=BEST)
    formula = "slip at 3 cm with all remedies, less the least of the ways that the rule leaves"
    more = difference(results, "use_more", formula, slips[BEST], slips[least])
    noise = noise_floor(results, "slip_floor")
    unknown = [outcome for outcome in fit.values() if outcome.name == "unknown"]
    gains = greater(slips[WAYS[0]], slips[BEST], noise=noise)
    outcome = all_of(fit[BEST], fit[least], within(more, noise), gains, *unknown)
    if not left and not unknown:
        outcome = Outcome("unknown", "no way does all that is asked")
    way = BEST if outcome == HOLDS else least
    numbers = {"way": _with_all(way), "slip": slips[way], "bound": bound, "is_untried": not (way.timed or way.tried)}
    numbers |= {"far": way.row(results, "10cm").slip_mm, "amplitude": amplitude}
    return Claim("what_to_use", outcome, numbers)


def _fits(results: Results, way: Way, bound: Value, grasp: Value) -> Outcome:
    found = [at_most(way.row(results, "10cm").slip_mm, grasp)]
    cost = results.others.get("cure_cost")
    for count in CURE_WORLDS if cost and way.timed else ():
        extra = cost.derived.get(f"{way.timed}_extra_{count}")
        found += [at_most(extra, bound)] if extra and extra.value is not None else []
    lost = _lost(results, way)
    return all_of(*found, *([at_most(lost, 0, why="it breaks nothing")] if lost.value is not None else []))
