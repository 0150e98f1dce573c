"""Cost of the cure: time of a frame with and without it, in one world and in many."""

from report.shared import (
    PERCENT,
    TIMED_WORLDS,
    Claim,
    Results,
    RowsBy,
    Section,
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


def derive(results: Results) -> Section:
    rows = RowsBy(results, results.rows, "case", "worlds")
    extra = {
        (case, count): results.value(
            f"{case}_extra_{count}",
            f"time of a frame with {case} over that as shipped, timed in turn, less one",
            PERCENT * (rows[case, count].frame_ratio - 1),
        )
        for case in CASES
        for count in TIMED_WORLDS
    }
    worst = resolution(results, "resolution", results.rows)
    claims = []
    for case in ("best", "firm"):  # which should be no slower
        noises = []
        slower = []
        tests = []
        for count in TIMED_WORLDS:
            more = extra[case, count]
            apart = more.noise or 0.0
            noise = results.value(
                f"{case}_seen_{count}",
                "how well the ratio is known by one measurement, or how far measurements"
                " are apart, the larger",
                lambda known, _, apart=apart: max(100 * known, apart),
                rows[case, count].ratio_resolution,
                more,
                unit="%",
                is_noise=True,
            )
            noises.append(noise)
            tests.append(within(more, noise, "the resolution of the ratio"))
            if None in (more.value, noise.value) or more.value > noise.value:
                slower.append(more)
        longest = results.value(
            f"{case}_worst",
            "by how much a frame takes longer where it is seen, most of all numbers of"
            " worlds",
            combined(max, constant(0.0, "%"), *slower),
        )
        unseen = results.value(
            f"{case}_unseen",
            "largest resolution of these: a frame that takes so much longer would be seen",
            combined(max, *noises),
            is_noise=True,
        )
        outcome = all_of(fine_enough(unseen), *tests).having_read(worst)
        numbers = {"worst": longest, "unseen": unseen}
        claims.append(Claim(f"{case}_costs_nothing", outcome, numbers))
    columns = {
        worlds_name(count): [extra[case, count] for case in CASES]
        for count in TIMED_WORLDS
    }
    ways = table_of("way", CASES.values(), columns, resolution=worst)
    return Section(tables={"ways": ways}, claims=claims)
