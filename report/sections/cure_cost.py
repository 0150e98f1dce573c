"""Cost of the cure: time of a frame with and without it, in one world and in many."""

from collections.abc import Mapping

from measured_report.parts.claim import Claim, all_of, at_least, within
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results
from report.shared.arithmetic import Column, table_of
from report.shared.timing import TIMED_WORLDS, RowsBy, compared, fine_enough, resolution, worlds_name

order = 144
page = "cure"
label = "what the cure costs"

CASES = {
    "term": "term put back",
    "best": "the whole cure",
    "firm": "the cure on stiff pads",
    "firm-euler": "the cure on stiff pads, Euler",
    "term-rk4": "term put back, RK4",
}
"""Labels of what is compared with the scene as shipped."""
TESTED = tuple(CASES)[:-1]
"""Cases that should be no slower."""
Shares = Mapping[tuple[str, int], Quantity]
"""Shares [%] by case and number of worlds."""


def derive(results: Results) -> Section:
    rows = RowsBy(results, results.rows, "case", "worlds")
    extra, seen = {}, {}
    for case in CASES:
        for count in TIMED_WORLDS:
            row = rows[case, count]
            formula = f"time of a frame with {case} over that as shipped, timed in turn, less one"
            extra[case, count] = results.value(
                f"{case}_extra_{count}", formula, lambda taken: 100 * (taken - 1), row.frame_ratio, unit="%"
            )
            if case in TESTED:
                seen[case, count] = resolution(results, f"{case}_seen_{count}", [row])
    costs = [_costs_nothing(results, extra, seen, case) for case in TESTED]
    columns: dict[str, Column] = {worlds_name(n): [extra[case, n] for case in CASES] for n in TIMED_WORLDS}
    worst = resolution(results, "resolution", compared(results.rows))
    table = table_of("way", CASES.values(), columns, resolution=worst)
    return Section(tables={"ways": table}, claims=[*costs, _rk4_is_dear(results, extra, worst)])


def _costs_nothing(results: Results, extra: Shares, seen: Shares, case: str) -> Claim:
    name = case.replace("-", "_")
    pairs = [(extra[case, count], seen[case, count]) for count in TIMED_WORLDS]

    def beyond(*cells: float) -> float:
        return max(0.0, *(more - noise for more, noise in zip(cells[::2], cells[1::2], strict=True)))

    formula = "by how much a frame takes longer{}, most of all numbers of worlds"
    both = [quantity for pair in pairs for quantity in pair]
    slower = results.value(
        f"{name}_beyond", formula.format(" than the resolution"), beyond, *both, unit="%", is_noise=True
    )
    seen_more = [more for more, noise in pairs if None in (more.value, noise.value) or more.value > noise.value]
    worst = results.value(
        f"{name}_worst", formula.format(" where it is seen"), lambda *more: max(more, default=0.0), *seen_more, unit="%"
    )
    formula = "largest resolution of these: a frame that takes so much longer would be seen"
    noises = [noise for _, noise in pairs]
    unseen = results.value(f"{name}_unseen", formula, max, *noises, unit="%", is_noise=True)
    outcomes = [fine_enough(unseen)]
    for count, (more, noise) in zip(TIMED_WORLDS, pairs, strict=True):
        formula = "this, or none where it is less"
        longer = results.value(f"{name}_longer_{count}", formula, lambda a: max(a, 0.0), more, unit="%")
        outcomes.append(within(longer, noise, why="the resolution of the ratio"))
    outcome = all_of(*outcomes).having_read(slower)
    return Claim(f"{name}_costs_nothing", outcome, {"worst": worst, "unseen": unseen})


def _rk4_is_dear(results: Results, extra: Shares, worst: Quantity) -> Claim:
    costs = [extra["term-rk4", count] for count in TIMED_WORLDS]
    formula = "time of a frame with the term and RK4 over that as shipped, least of all numbers of worlds"
    least = results.value("rk4_least", formula, lambda *found: 1 + min(found) / 100, *costs)
    outcome = all_of(at_least(least, 2.0, why="a price to think about"), fine_enough(worst))
    return Claim("rk4_is_dear", outcome, {"least": least})
