"""Cost of the cure: time of a frame with and without it, in one world and in many."""

from collections.abc import Mapping

from measured_report.parts.claim import Claim, all_of, within
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import Column, table_of
from report.shared.timing import TIMED_WORLDS, RowsBy, compared, fine_enough, resolution, worlds_name

order = 144
page = "cure"
label = "what the root cure costs"

CASES = {
    "term": "term put back",
    "best": "the root cure",
    "firm": "the root cure on stiff pads",
    "firm-euler": "the root cure on stiff pads, Euler",
    "term-rk4": "term put back, RK4",
}
"""Labels of what is compared with the scene as shipped."""
TESTED = ("best", "firm")
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
            name = f"{case}_extra_{count}"
            more = results.value(name, formula, lambda taken: 100 * (taken - 1), row.frame_ratio, unit="%")
            extra[case, count] = more
            if case in TESTED:
                seen[case, count] = _seen(results, f"{case}_seen_{count}", row, more)
    worst = resolution(results, "resolution", compared(results.rows))
    costs = [_costs_nothing(results, extra, seen, case, worst) for case in TESTED]
    columns: dict[str, Column] = {worlds_name(n): [extra[case, n] for case in CASES] for n in TIMED_WORLDS}
    table = table_of("way", CASES.values(), columns, resolution=worst)
    return Section(tables={"ways": table}, claims=costs)


def _seen(results: Results, name: str, row: Row, extra: Value) -> Value:
    """Derive from how much on a frame is seen to take longer [%]: in one measurement, and in another one."""

    def known(resolution: float, _: float) -> float:
        return max(100 * resolution, extra.noise or 0.0)

    formula = "how well the ratio is known by one measurement, or how far measurements are apart, the larger"
    return results.value(name, formula, known, row.ratio_resolution, extra, unit="%", is_noise=True)


def _costs_nothing(results: Results, extra: Shares, seen: Shares, case: str, known: Value) -> Claim:
    pairs = [(extra[case, count], seen[case, count]) for count in TIMED_WORLDS]
    seen_more = [more for more, noise in pairs if None in (more.value, noise.value) or more.value > noise.value]
    formula = "by how much a frame takes longer where it is seen, most of all numbers of worlds"
    worst = results.value(f"{case}_worst", formula, lambda *more: max(more, default=0.0), *seen_more, unit="%")
    formula = "largest resolution of these: a frame that takes so much longer would be seen"
    unseen = results.value(f"{case}_unseen", formula, max, *(noise for _, noise in pairs), unit="%", is_noise=True)
    slower = (within(more, noise, why="the resolution of the ratio") for more, noise in pairs)
    outcome = all_of(fine_enough(unseen), *slower).having_read(known)
    return Claim(f"{case}_costs_nothing", outcome, {"worst": worst, "unseen": unseen})
