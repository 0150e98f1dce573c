"""What the cure costs: time of a frame with and without it, in one world and in many."""

from collections.abc import Mapping

from measured_report.claims.claim import Claim, all_of, at_least, within
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results
from report.shared.arithmetic import excess
from report.shared.timing import CURE_WORLDS, cell

order = 144
page = "cure"
label = "what the cure costs"

CASES = ("as-shipped", "term", "kept", "best", "term-rk4")
TESTED = ("term", "best")
"""Those that should be no slower."""
Times = Mapping[tuple[str, int], Quantity]
"""What a frame takes more than as shipped [%], by case and number of worlds."""


def derive(results: Results) -> Section:
    rows = {(row.case, row.worlds.value): row for row in results.rows}
    times = {
        (case, count): cell(results, rows.get((case, count)), "frame_ms", f"a batch of {count} worlds")
        for case in CASES
        for count in CURE_WORLDS
    }
    extra = {
        (case, count): excess(
            results,
            f"{case}_extra_{count}",
            f"time of a frame with {case} over that as shipped, less one",
            times[case, count],
            times[CASES[0], count],
        )
        for case in CASES[1:]
        for count in CURE_WORLDS
    }
    return Section(claims=[*(_costs_nothing(results, extra, case) for case in TESTED), _rk4_is_dear(results, extra)])


def _costs_nothing(results: Results, extra: Times, case: str) -> Claim:
    """Tell whether a frame is seen to take longer, by more than the noise, with any number of worlds."""
    found = [extra[case, count] for count in CURE_WORLDS]
    noises = [quantity.noise or 0.0 for quantity in found]

    def beyond(*found: float) -> float:
        return max(0.0, *(more - noise for more, noise in zip(found, noises, strict=True)))

    def worst(*found: float) -> float:
        return max(more if more > noise else 0.0 for more, noise in zip(found, noises, strict=True))

    formula = "by how much a frame takes longer{}, most of all numbers of worlds"
    slower = results.value(f"{case}_beyond", formula.format(" than the noise"), beyond, *found, unit="%", is_noise=True)
    numbers = {"worst": results.value(f"{case}_worst", formula.format(" where it is seen"), worst, *found, unit="%")}
    formula = "largest noise of these: a frame that takes so much longer would be seen"
    numbers["unseen"] = results.value(
        f"{case}_unseen", formula, lambda *_: max(noises), *found, unit="%", is_noise=True
    )
    outcomes = []
    for count, more, noise in zip(CURE_WORLDS, found, noises, strict=True):
        longer = results.value(
            f"{case}_longer_{count}", "this, or none where it is less", lambda a: max(a, 0.0), more, unit="%"
        )
        outcomes.append(within(longer, noise, why="how far apart two measurements of it come out"))
    return Claim(f"{case}_costs_nothing", all_of(*outcomes).having_read(slower), numbers)


def _rk4_is_dear(results: Results, extra: Times) -> Claim:
    costs = [extra["term-rk4", count] for count in CURE_WORLDS]
    formula = "time of a frame with the term and RK4 over that as shipped, {} of all numbers of worlds"
    least = results.value("rk4_least", formula.format("least"), lambda *found: 1 + min(found) / 100, *costs)
    most = results.value("rk4_most", formula.format("most"), lambda *found: 1 + max(found) / 100, *costs)
    return Claim("rk4_is_dear", at_least(least, 2.0, why="a price to think about"), {"least": least, "most": most})
