"""What the cure costs: time of a frame with and without it, in one world and in many."""

from collections.abc import Mapping

from measured_report.parts.claim import Claim, all_of, at_least, within
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results
from report.names import name_of, worlds_name
from report.shared.arithmetic import Column, table_of
from report.shared.timing import TIMED_WORLDS, fine_enough, ratio_cell, resolution, resolutions

order = 144
page = "cure"
label = "what the cure costs"

CASES = ("as-shipped", "term", "best", "firm", "firm-euler", "term-rk4")
TESTED = ("term", "best", "firm", "firm-euler")
"""Those that should be no slower."""
Times = Mapping[tuple[str, int], Quantity]
"""What a frame takes more than as shipped [%], by case and number of worlds."""


def derive(results: Results) -> Section:
    rows = {(row.case, row.worlds.value): row for row in results.rows}
    extra = {
        (case, count): results.value(
            f"{case}_extra_{count}",
            f"time of a frame with {case} over that as shipped, timed in turn, less one",
            lambda taken: 100 * (taken - 1),
            ratio_cell(results, rows.get((case, count))),
            unit="%",
        )
        for case in CASES[1:]
        for count in TIMED_WORLDS
    }
    seen = {
        (case, count): resolution(results, f"{case}_seen_{count}", rows.get((case, count)))
        for case in TESTED
        for count in TIMED_WORLDS
    }
    costs = [_costs_nothing(results, extra, seen, case) for case in TESTED]
    columns: dict[str, Column] = {worlds_name(n): [extra[case, n] for case in CASES[1:]] for n in TIMED_WORLDS}
    worst = resolutions(results, "resolution", results.rows)
    table = table_of("way", map(name_of, CASES[1:]), columns, resolution=worst)
    return Section(tables={"ways": table}, claims=[*costs, _rk4_is_dear(results, extra, worst)])


def _costs_nothing(results: Results, extra: Times, seen: Times, case: str) -> Claim:
    """Tell whether a frame is seen to take longer, by more than the resolution, with any number of worlds."""
    name = case.replace("-", "_")
    found, noises = ([of[case, count] for count in TIMED_WORLDS] for of in (extra, seen))
    both = [quantity for pair in zip(found, noises, strict=True) for quantity in pair]

    def beyond(*cells: float) -> float:
        return max(0.0, *(more - noise for more, noise in zip(cells[::2], cells[1::2], strict=True)))

    formula = "by how much a frame takes longer{}, most of all numbers of worlds"
    slower = results.value(
        f"{name}_beyond", formula.format(" than the resolution"), beyond, *both, unit="%", is_noise=True
    )
    seen_more = [
        more
        for more, noise in zip(found, noises, strict=True)
        if None in (more.value, noise.value) or more.value > noise.value
    ]
    worst = results.value(
        f"{name}_worst", formula.format(" where it is seen"), lambda *more: max(more, default=0.0), *seen_more, unit="%"
    )
    numbers = {"worst": worst}
    formula = "largest resolution of these: a frame that takes so much longer would be seen"
    numbers["unseen"] = results.value(f"{name}_unseen", formula, max, *noises, unit="%", is_noise=True)
    outcomes = []
    for count, more, noise in zip(TIMED_WORLDS, found, noises, strict=True):
        longer = results.value(
            f"{name}_longer_{count}", "this, or none where it is less", lambda a: max(a, 0.0), more, unit="%"
        )
        outcomes.append(within(longer, noise, why="the resolution of the ratio"))
    return Claim(
        f"{name}_costs_nothing", all_of(*outcomes, fine_enough(numbers["unseen"])).having_read(slower), numbers
    )


def _rk4_is_dear(results: Results, extra: Times, worst: Quantity) -> Claim:
    costs = [extra["term-rk4", count] for count in TIMED_WORLDS]
    formula = "time of a frame with the term and RK4 over that as shipped, least of all numbers of worlds"
    least = results.value("rk4_least", formula, lambda *found: 1 + min(found) / 100, *costs)
    return Claim(
        "rk4_is_dear", all_of(at_least(least, 2.0, why="a price to think about"), fine_enough(worst)), {"least": least}
    )
