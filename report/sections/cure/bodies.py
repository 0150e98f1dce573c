"""Other bodies and other contacts than a grasp, with the term put back: what moves as it should."""

import math
from collections.abc import Iterable, Mapping

from report.shared import (
    PERCENT,
    Claim,
    Results,
    Row,
    Section,
    Value,
    all_of,
    at_least,
    at_most,
    cell_count,
    extreme,
    rows_with,
)

TABLE = (
    "carried",
    "caught",
)  # motions on the table: turning with it, and put down at rest
FREE = (
    "impact",
    "roll",
    "slide",
)  # motions on a plane: no acceleration along their friction to leave out
Variants = Mapping[
    str, Row
]  # rows by variant: nothing done, the term of material points, the exact term
Runs = Mapping[tuple[str, str, str], Variants]  # runs by motion, body and engine


def derive(results: Results) -> Section:
    runs: dict[tuple[str, str, str], dict[str, Row]] = {}
    for row in rows_with(results, "motion", "body", "variant", "backend"):
        runs.setdefault((row.motion, row.body, row.backend), {})[row.variant] = row
    claims = [_stays_as_it_is(results, runs), _stands_on_any_feet(results, runs)]
    return Section(claims=[*claims, _spinning_ball_goes_straight(results, runs)])


def _of(runs: Runs, motions: Iterable[str], variant: str) -> list[tuple[str, Row, Row]]:
    """Name the runs of these motions, each with nothing done and in a variant."""
    both = {
        run: rows
        for run, rows in runs.items()
        if run[0] in motions and {"plain", variant} <= set(rows)
    }
    return [
        ("_".join(run).replace(" ", "_"), rows["plain"], rows[variant])
        for run, rows in both.items()
    ]


def _stays_as_it_is(results: Results, runs: Runs) -> Claim:
    formula, shares = (
        "distance between the places where the body ends with the term and with nothing done",
        [],
    )
    for name, plain, term in _of(runs, FREE, "term"):
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
        shares.append(
            results.value(
                f"moved_{name}",
                f"{formula}, of the way there",
                PERCENT * off / plain.travel_mm,
            )
        )
    largest = results.value("moved_most", "largest of these", extreme(max, shares))
    count = results.value("free_count", "runs on the plane", cell_count(shares))
    outcome = at_most(largest, 1.0, why="the same motion")
    return Claim("free_motion_stays", outcome, {"largest": largest, "count": count})


def _stands_on_any_feet(results: Results, runs: Runs) -> Claim:
    pairs = (
        (name, exact.growth_per_s / plain.growth_per_s)
        for name, plain, exact in _of(runs, TABLE, "exact")
    )
    left = [
        results.value(
            f"left_{name}",
            "growth of the distance from the axis with the exact term, of that with nothing done, in size",
            PERCENT * abs(ratio),
        )
        for name, ratio in pairs
    ]
    largest = results.value("left_most", "largest of these", extreme(max, left))
    count = results.value("table_count", "runs on the table", cell_count(left))
    return Claim(
        "stands_on_any_feet",
        at_most(largest, 1.0, why="it stands"),
        {"largest": largest, "count": count},
    )


def _spinning_ball_goes_straight(results: Results, runs: Runs) -> Claim:

    def aside(key: str, name: str, plain: Row, ball: Row) -> Value:
        return results.value(
            f"{key}_{name}",
            "how far the ball ends aside of where it does with nothing done",
            abs(ball.sideways_mm - plain.sideways_mm),
        )

    asides = [aside("aside", *run) for run in _of(runs, ("pivot",), "exact")]
    points = [aside("points", *run) for run in _of(runs, ("pivot",), "term")]
    ways = [plain.travel_mm for _, plain, _ in _of(runs, ("pivot",), "exact")]
    most = results.value("aside_most", "largest of these", extreme(max, asides))
    drifts = results.value(
        "points_aside", "with the term of material points", extreme(max, points)
    )
    travel = results.value("pivot_travel", "way of the ball", extreme(max, ways))
    straight = results.chosen("straight_bound", "a sixtieth of the ball", 0.5, "mm")
    far = at_least(travel, 500.0, why="a way on which it would be seen")
    outcome = all_of(
        at_most(most, straight), at_least(drifts, 10.0, why="it is seen"), far
    )
    return Claim(
        "spinning_ball_goes_straight",
        outcome,
        {"points": drifts, "travel": travel, "straight": straight},
    )
