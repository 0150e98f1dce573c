"""Compare the run times with and without the root cure, in one world and in many."""

from report.shared import (
    PERCENT,
    SLOWER,
    TIMED_WORLDS,
    Claim,
    Results,
    RowsBy,
    Section,
    combined,
    negligible,
    resolution,
    table_of,
    worlds_name,
)

order = 144
page = "cure"
label = "cost of the root cure"

CASES = {  # labels of the cases that are compared with the scene as shipped
    "term": "term restored",
    "best": "the root cure",
    "firm": "the root cure with stiff pads",
    "firm-euler": "the root cure with stiff pads, Euler",
    "term-rk4": "term restored, RK4",
}


def derive(results: Results) -> Section:
    rows = RowsBy(results, results.rows, "case", "worlds")
    extra = {
        (case, count): results.value(
            f"{case}_extra_{count}",
            f"time of a frame with {case} divided by the time as shipped, timed in turn, minus"
            " one",
            PERCENT * (rows[case, count].frame_ratio - 1),
        )
        for case in CASES
        for count in TIMED_WORLDS
    }
    worst = resolution(results, "resolution", results.rows)
    bound = results.chosen("slower", *SLOWER, "%")
    claims = []
    for case in ("best", "firm"):
        worst_case = results.value(
            f"{case}_worst",
            "largest additional time of a frame over all numbers of worlds",
            combined(max, *(extra[case, count] for count in TIMED_WORLDS)),
        )
        outcome = negligible(worst_case, bound)
        numbers = {"worst": worst_case, "bound": bound}
        claims.append(Claim(f"{case}_costs_nothing", outcome, numbers))
    columns = {
        worlds_name(count): [extra[case, count] for case in CASES]
        for count in TIMED_WORLDS
    }
    settings = table_of("setting", CASES.values(), columns, resolution=worst)
    return Section(tables={"ways": settings}, claims=claims)
