"""Other bodies and contacts than a grasp, with the term put back."""

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

TABLE = ("carried", "caught")  # on the table: turning with it, and put down at rest
FREE = ("impact", "roll", "slide")  # no acceleration along their friction to leave out


def derive(results: Results) -> Section:
    runs: dict[tuple[str, str, str], dict[str, Row]] = defaultdict(dict)
    for row in rows_with(results, "motion", "body", "variant", "backend"):
        runs[row.motion, row.body, row.backend][row.variant] = row

    def pairs(motions: tuple[str, ...], variant: str) -> list[tuple[str, Row, Row]]:
        """Name the runs of these motions, each with nothing done and in a variant."""
        return [
            ("_".join(run).replace(" ", "_"), rows["plain"], rows[variant])
            for run, rows in runs.items()
            if run[0] in motions and {"plain", variant} <= set(rows)
        ]

    moved = []
    formula = "distance between the places where the body ends with the term and with nothing done"
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
            results.value(f"moved_{name}", f"{formula}, of the way there", share)
        )
    moved_most = results.value("moved_most", "largest of these", extreme(max, moved))
    free_count = results.value("free_count", "runs on the plane", cell_count(moved))

    left = [
        results.value(
            f"left_{name}",
            "growth of the distance from the axis with the exact term, of that with"
            " nothing done, in size",
            PERCENT * abs(exact.growth_per_s / plain.growth_per_s),
        )
        for name, plain, exact in pairs(TABLE, "exact")
    ]
    left_most = results.value("left_most", "largest of these", extreme(max, left))
    table_count = results.value("table_count", "runs on the table", cell_count(left))

    asides, points = (
        [
            results.value(
                f"{key}_{name}",
                "how far the ball ends aside of where it does with nothing done",
                abs(ball.sideways_mm - plain.sideways_mm),
            )
            for name, plain, ball in pairs(("pivot",), variant)
        ]
        for key, variant in (("aside", "exact"), ("points", "term"))
    )
    aside = results.value("aside_most", "largest of these", extreme(max, asides))
    drift = results.value(
        "points_aside", "with the term of material points", extreme(max, points)
    )
    ways = [plain.travel_mm for _, plain, _ in pairs(("pivot",), "exact")]
    travel = results.value("pivot_travel", "way of the ball", extreme(max, ways))
    straight = results.chosen("straight_bound", "a sixtieth of the ball", 0.5, "mm")
    goes_straight = all_of(
        at_most(aside, straight),
        at_least(drift, 10.0, "it is seen"),
        at_least(travel, 500.0, "a way on which it would be seen"),
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
                at_most(left_most, 1.0, "it stands"),
                {"largest": left_most, "count": table_count},
            ),
            Claim(
                "spinning_ball_goes_straight",
                goes_straight,
                {"points": drift, "travel": travel, "straight": straight},
            ),
        ]
    )
