"""Test the restored term with bodies and contacts that do not occur in a grasp."""

import math
from collections import defaultdict

from report.shared import (
    PERCENT,
    Claim,
    Results,
    Row,
    Section,
    all_of,
    at_least,
    at_most,
    cell_count,
    extreme,
    rows_with,
)

# Motions on the table: the body starts with the table, or at rest.
TABLE = ("carried", "caught")
# Motions for which the left-out acceleration has no component along the friction.
FREE = ("impact", "roll", "slide")


def derive(results: Results) -> Section:
    runs: dict[tuple[str, str, str], dict[str, Row]] = defaultdict(dict)
    for row in rows_with(results, "motion", "body", "variant", "backend"):
        runs[row.motion, row.body, row.backend][row.variant] = row

    def pairs(motions: tuple[str, ...], variant: str) -> list[tuple[str, Row, Row]]:
        """Return the name, the unchanged run and the variant of each run with these
        motions.
        """
        return [
            ("_".join(run).replace(" ", "_"), rows["plain"], rows[variant])
            for run, rows in runs.items()
            if run[0] in motions and {"plain", variant} <= set(rows)
        ]

    moved = []
    formula = (
        "distance between the final positions of the body with and without the term"
    )
    for name, plain, term in pairs(FREE, "term"):
        ends = [
            row[column]
            for row in (term, plain)
            for column in ("travel_mm", "sideways_mm", "rise_mm")
        ]
        off = results.value(
            f"off_{name}",
            formula,
            lambda *mm: math.dist(mm[:3], mm[3:]),
            *ends,
            unit="mm",
        )
        share = PERCENT * off / plain.travel_mm
        moved.append(
            results.value(
                f"moved_{name}",
                f"{formula}, relative to the distance that it travels without the term",
                share,
            )
        )
    moved_most = results.value(
        "moved_most", "largest of these shares", extreme(max, moved)
    )
    free_count = results.value("free_count", "runs on the plane", cell_count(moved))

    remainders = [
        results.value(
            f"left_{name}",
            "absolute growth of the distance from the axis with the exact term,"
            " relative to the growth without it",
            PERCENT * abs(exact.growth_per_s / plain.growth_per_s),
        )
        for name, plain, exact in pairs(TABLE, "exact")
    ]
    left_most = results.value(
        "left_most", "largest of these shares", extreme(max, remainders)
    )
    table_count = results.value(
        "table_count", "runs on the table", cell_count(remainders)
    )

    asides, points = (
        [
            results.value(
                f"{key}_{name}",
                "sideways distance between the final positions of the ball with and"
                " without the term",
                abs(ball.sideways_mm - plain.sideways_mm),
            )
            for name, plain, ball in pairs(("pivot",), variant)
        ]
        for key, variant in (("aside", "exact"), ("points", "term"))
    )
    aside = results.value(
        "aside_most", "largest of these distances", extreme(max, asides)
    )
    drift = results.value(
        "points_aside", "largest with the term of material points", extreme(max, points)
    )
    travels = [plain.travel_mm for _, plain, _ in pairs(("pivot",), "exact")]
    travel = results.value(
        "pivot_travel", "distance that the ball travels", extreme(max, travels)
    )
    straight = results.chosen(
        "straight_bound", "a sixtieth of the diameter of the ball", 0.5, "mm"
    )
    goes_straight = all_of(
        at_most(aside, straight),
        at_least(drift, 10.0, "a visible distance"),
        at_least(travel, 500.0, "a path long enough to show it"),
    )
    return Section(
        claims=[
            Claim(
                "free_motion_stays",
                at_most(moved_most, 1.0, "the same motion"),
                {"largest": moved_most, "count": free_count},
            ),
            Claim(
                "stands_on_any_feet",
                at_most(left_most, 1.0, "the box stands still"),
                {"largest": left_most, "count": table_count},
            ),
            Claim(
                "spinning_ball_goes_straight",
                goes_straight,
                {"points": drift, "travel": travel, "straight": straight},
            ),
        ]
    )
