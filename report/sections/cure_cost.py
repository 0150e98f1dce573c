"""Cost of the cure: time of a frame with and without it, in one world and in many."""

from collections.abc import Sequence
from itertools import product

from report.shared import (
    PERCENT,
    TIMED_WORLDS,
    Claim,
    Column,
    Results,
    Row,
    RowsBy,
    Section,
    Value,
    all_of,
    combined,
    constant,
    fine_enough,
    resolution,
    table_of,
    within,
    worlds_name,
)

order = 144
page = "cure"
label = "what the root cure costs"

CASES = {  # labels of what is compared with the scene as shipped
    "term": "term put back",
    "best": "the root cure",
    "firm": "the root cure on stiff pads",
    "firm-euler": "the root cure on stiff pads, Euler",
    "term-rk4": "term put back, RK4",
}
TESTED = ("best", "firm")  # cases that should be no slower


def derive(results: Results) -> Section:
    rows, extra = RowsBy(results, results.rows, "case", "worlds"), {}
    for case, count in product(CASES, TIMED_WORLDS):
        name, cell = f"{case}_extra_{count}", rows[case, count].frame_ratio
        extra[case, count] = results.value(
            name,
            f"time of a frame with {case} over that as shipped, timed in turn, less one",
            PERCENT * (cell - 1),
        )
    worst = resolution(results, "resolution", results.rows)
    costs = []
    for case in TESTED:
        cells = {
            count: (rows[case, count], extra[case, count]) for count in TIMED_WORLDS
        }
        pairs = [
            (more, _seen(results, f"{case}_seen_{n}", row, more))
            for n, (row, more) in cells.items()
        ]
        costs.append(_costs_nothing(results, case, pairs, worst))
    columns: dict[str, Column] = {
        worlds_name(n): [extra[case, n] for case in CASES] for n in TIMED_WORLDS
    }
    return Section(
        tables={"ways": table_of("way", CASES.values(), columns, resolution=worst)},
        claims=costs,
    )


def _seen(results: Results, name: str, row: Row, extra: Value) -> Value:
    """Derive from how much on a frame is seen to take longer [%]: in one measurement, and in another one."""
    cells, apart = (row.ratio_resolution, extra), extra.noise or 0.0
    return results.value(
        name,
        "how well the ratio is known by one measurement, or how far measurements are apart, the larger",
        lambda known, _: max(100 * known, apart),
        *cells,
        unit="%",
        is_noise=True,
    )


def _costs_nothing(
    results: Results, case: str, pairs: Sequence[tuple[Value, Value]], resolution: Value
) -> Claim:
    seen_more = [
        more
        for more, noise in pairs
        if None in (more.value, noise.value) or more.value > noise.value
    ]
    worst = results.value(
        f"{case}_worst",
        "by how much a frame takes longer where it is seen, most of all numbers of worlds",
        combined(max, constant(0.0, "%"), *seen_more),
    )
    unseen = results.value(
        f"{case}_unseen",
        "largest resolution of these: a frame that takes so much longer would be seen",
        combined(max, *(noise for _, noise in pairs)),
        is_noise=True,
    )
    slower = (
        within(more, noise, why="the resolution of the ratio") for more, noise in pairs
    )
    outcome = all_of(fine_enough(unseen), *slower).having_read(resolution)
    return Claim(f"{case}_costs_nothing", outcome, {"worst": worst, "unseen": unseen})
