"""Other bodies and other contacts than a grasp, with the term put back: what moves as before, and what does not."""

from collections.abc import Mapping
from itertools import product

import pandas as pd

from measured_report.claims.claims import Claim, all_of, at_least, at_most
from measured_report.parts.parts import Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count, extreme, share, size_share

order = 148
page = "cure"
label = "other bodies and the cure"

ENGINES = ("warp", "c")
WAYS = {"plain": "nothing done", "term": "the term", "full": "normal rows too"}
BODIES = {"sphere": "ball", "cylinder": "cylinder", "mesh": "cube as a mesh"}
MOTIONS = {
    "impact": "dropped from above, thrown",
    "roll": "rolling",
    "slide": "sliding",
    "pivot": "rolling and spinning",
}
FREE = ("impact", "roll", "slide")
"""Motions on a plane whose contacts have no acceleration along their friction that could be left out."""
FEET = {"sphere": "balls", "cylinder": "cylinders", "mesh": "meshes"}
TABLE = {"carried": "turning with the table", "caught": "put down at rest"}
Runs = Mapping[tuple[str, str], Mapping[tuple[str, str], Row]]
"""By motion and body, and by way and engine."""


def derive(results: Results) -> Section:
    runs: dict[tuple[str, str], dict[tuple[str, str], Row]] = {}
    for row in results.rows:
        runs.setdefault((row.motion, row.body), {})[row.way, row.backend] = row
    whole = {name: found for name, found in runs.items() if set(found) == set(product(WAYS, ENGINES))}
    return Section(
        tables={"plane": _plane_table(whole), "table": _table_table(results, whole)},
        claims=[
            _free_motion_stays(results, whole),
            _stands_on_any_feet(results, whole),
            _spinning_ball_goes_aside(results, whole),
            _rolling_body_sinks(results, whole),
        ],
    )


def _of(runs: Runs, *motions: str) -> list[tuple[str, Mapping[tuple[str, str], Row], str]]:
    """Name, rows and engine of all runs of these motions."""
    return [
        (f"{motion}_{body}_{engine}", found, engine)
        for (motion, body), found in runs.items()
        if motion in motions
        for engine in ENGINES
    ]


def _free_motion_stays(results: Results, runs: Runs) -> Claim:
    shares = [
        results.value(
            f"moved_{name}",
            "distance between the places where the body ends with the term and with nothing done, of the way there",
            lambda x, y, other_x, other_y: (
                100 * ((x - other_x) ** 2 + (y - other_y) ** 2) ** 0.5 / (other_x**2 + other_y**2) ** 0.5
            ),
            *(found[way, engine][column] for way in ("term", "plain") for column in ("travel_mm", "sideways_mm")),
            unit="%",
        )
        for name, found, engine in _of(runs, *FREE)
    ]
    largest = extreme(results, "moved_most", "largest of these", max, shares)
    count = cell_count(results, "free_count", "runs on the plane", shares)
    bound = results.chosen("moved_bound", "the same motion", 1.0, unit="%")
    return Claim("free_motion_stays", at_most(largest, bound), numbers={"largest": largest, "count": count})


def _stands_on_any_feet(results: Results, runs: Runs) -> Claim:
    """On the table, whatever it stands on, and also where it has slid before."""
    left = [
        size_share(
            results,
            f"left_{name}",
            "growth of the distance from the axis with the term, of that with nothing done, in size",
            found["term", engine].growth_per_s,
            found["plain", engine].growth_per_s,
        )
        for name, found, engine in _of(runs, *TABLE)
    ]
    largest = extreme(results, "left_most", "largest of these", max, left)
    count = cell_count(results, "table_count", "runs on the table", left)
    bound = results.chosen("left_bound", "most of it is gone", 20.0, unit="%")
    return Claim("stands_on_any_feet", at_most(largest, bound), numbers={"largest": largest, "count": count})


def _spinning_ball_goes_aside(results: Results, runs: Runs) -> Claim:
    plain, term = (_cells(runs, "pivot", way, "sideways_mm") for way in ("plain", "term"))
    gaps = [
        results.value(
            f"aside_{engine}",
            "how far the ball ends aside of where it does with nothing done",
            lambda with_it, without: abs(with_it - without),
            *pair,
            unit="mm",
        )
        for engine, pair in zip(ENGINES, zip(term, plain, strict=True), strict=False)
    ]
    least = extreme(results, "aside_least", "lesser of both engines", min, gaps)
    travel = extreme(
        results, "pivot_travel", "way of the ball with nothing done", max, _cells(runs, "pivot", "plain", "travel_mm")
    )
    part = share(results, "aside_share", "how far it ends aside, of its way", least, travel)
    bound = results.chosen("aside_bound", "it is seen", 1.0, unit="%")
    return Claim("spinning_ball_goes_aside", at_least(part, bound), numbers={"aside": least, "travel": travel})


def _cells(runs: Runs, motion: str, way: str, column: str) -> list[Quantity]:
    return [found[way, engine][column] for _, found, engine in _of(runs, motion)]


def _rolling_body_sinks(results: Results, runs: Runs) -> Claim:
    """By how much deeper it rolls with the term in the normal rows, and whether the friction rows leave its depth."""
    depths = {
        way: [
            results.value(
                f"sinks_{way}_{name}",
                f"how much deeper the body ends with {WAYS[way]} than with nothing done",
                lambda without, with_it: abs(without - with_it),
                found["plain", engine].rise_mm,
                found[way, engine].rise_mm,
                unit="mm",
            )
            for name, found, engine in _of(runs, "roll")
        ]
        for way in ("term", "full")
    }
    least = extreme(results, "sinks_least", "least of these, normal rows too", min, depths["full"])
    most = extreme(results, "sinks_most", "most of these, friction rows alone", max, depths["term"])
    deep = results.chosen("sinks_bound", "deeper than a contact of this weight is", 1.0, unit="mm")
    same = results.chosen("stays_bound", "as deep as before", 0.01, unit="mm")
    outcome = all_of(at_least(least, deep), at_most(most, same))
    return Claim("rolling_body_sinks", outcome, numbers={"least": least, "most": most, "same": same})


def _plane_table(runs: Runs) -> Table:
    names = [name for name in product(MOTIONS, BODIES) if name in runs]
    columns = {words: [runs[name][way, "warp"].travel_mm for name in names] for way, words in WAYS.items()}
    index = [f"{BODIES[body]}, {MOTIONS[motion]}" for motion, body in names]
    return Table(pd.DataFrame(columns, index=pd.Index(index, name="body on a plane")))


def _growth(results: Results, runs: Runs, name: tuple[str, str], way: str) -> Value:
    """In percent, as section turntable has it."""
    row = runs[name][way, "warp"]
    formula = "growth of the distance from the axis, of that distance, in MuJoCo Warp"
    return results.value("_".join((way, *name)), formula, lambda rate: 100 * rate, row.growth_per_s, unit="%/s")


def _table_table(results: Results, runs: Runs) -> Table:
    names = [name for name in product(TABLE, FEET) if name in runs]
    columns = {words: [_growth(results, runs, name, way) for name in names] for way, words in WAYS.items()}
    index = [f"feet are {FEET[feet]}, {TABLE[motion]}" for motion, feet in names]
    return Table(pd.DataFrame(columns, index=pd.Index(index, name="box on a turning table")))
