"""Other bodies and other contacts than a grasp, with the term put back: what moves as before, and what does not."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import product

from measured_report.claims.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count, extreme, share, size_difference, size_share

order = 148
page = "cure"
label = "other bodies and the cure"

ENGINES = ("warp", "c")
WAYS = {"plain": "nothing done", "term": "the term", "full": "normal rows too"}
FREE = ("impact", "roll", "slide")
"""Motions on a plane whose contacts have no acceleration along their friction that could be left out."""
TABLE = ("carried", "caught")
"""Motions on the table: turning with it, and put down at rest."""
Runs = Mapping[tuple[str, str], Mapping[tuple[str, str], Row]]
"""By motion and body, and by way and engine."""


def derive(results: Results) -> Section:
    runs: dict[tuple[str, str], dict[tuple[str, str], Row]] = {}
    for row in results.rows:
        runs.setdefault((row.motion, row.body), {})[row.way, row.backend] = row
    whole = {name: found for name, found in runs.items() if set(found) == set(product(WAYS, ENGINES))}
    return Section(
        claims=[
            *_stays_as_it_is(results, whole),
            _spinning_ball_goes_aside(results, whole),
            _rolling_body_sinks(results, whole),
        ]
    )


def _of(runs: Runs, motions: Iterable[str]) -> list[tuple[str, dict[str, Row]]]:
    """List all runs of these motions in either engine: their names, and their rows by what is done."""
    return [
        (f"{motion}_{body}_{engine}", {way: found[way, engine] for way in WAYS})
        for (motion, body), found in runs.items()
        if motion in motions
        for engine in ENGINES
    ]


def _stays_as_it_is(results: Results, runs: Runs) -> Iterator[Claim]:
    """Tell whether bodies move as before on a plane, and stay on the table, whatever they stand on."""
    formula = "distance between the places where the body ends with the term and with nothing done, of the way there"
    shares = [
        results.value(
            f"moved_{name}",
            formula,
            lambda x, y, plain_x, plain_y: (
                100 * ((x - plain_x) ** 2 + (y - plain_y) ** 2) ** 0.5 / (plain_x**2 + plain_y**2) ** 0.5
            ),
            *(found[way][column] for way in ("term", "plain") for column in ("travel_mm", "sideways_mm")),
            unit="%",
        )
        for name, found in _of(runs, FREE)
    ]
    largest = extreme(results, "moved_most", "largest of these", max, shares)
    count = cell_count(results, "free_count", "runs on the plane", shares)
    outcome = at_most(largest, 1.0, why="the same motion")
    yield Claim("free_motion_stays", outcome, {"largest": largest, "count": count})

    formula = "growth of the distance from the axis with the term, of that with nothing done, in size"
    left = [
        size_share(results, f"left_{name}", formula, found["term"].growth_per_s, found["plain"].growth_per_s)
        for name, found in _of(runs, TABLE)
    ]
    largest = extreme(results, "left_most", "largest of these", max, left)
    count = cell_count(results, "table_count", "runs on the table", left)
    outcome = at_most(largest, 20.0, why="most of it is gone")
    yield Claim("stands_on_any_feet", outcome, {"largest": largest, "count": count})


def _spinning_ball_goes_aside(results: Results, runs: Runs) -> Claim:
    formula, spinning = "how far the ball ends aside of where it does with nothing done", _of(runs, ["pivot"])
    gaps = [
        size_difference(results, f"aside_{engine}", formula, found["term"].sideways_mm, found["plain"].sideways_mm)
        for engine, (_, found) in zip(ENGINES, spinning, strict=False)
    ]
    least = extreme(results, "aside_least", "lesser of both engines", min, gaps)
    travels = [found["plain"].travel_mm for _, found in spinning]
    travel = extreme(results, "pivot_travel", "way of the ball with nothing done", max, travels)
    part = share(results, "aside_share", "how far it ends aside, of its way", least, travel)
    outcome = at_least(part, 1.0, why="it is seen")
    return Claim("spinning_ball_goes_aside", outcome, {"aside": least, "travel": travel})


def _rolling_body_sinks(results: Results, runs: Runs) -> Claim:
    """Tell how much deeper it rolls with the term in the normal rows, and whether the friction rows leave its depth."""
    formula = "how much deeper the body ends with {} than with nothing done"
    gaps: dict[str, list[Value]] = {"term": [], "full": []}
    for way, (name, found) in product(gaps, _of(runs, ["roll"])):
        rises, words = (found["plain"].rise_mm, found[way].rise_mm), formula.format(WAYS[way])
        gaps[way].append(size_difference(results, f"sinks_{way}_{name}", words, *rises))
    least = extreme(results, "sinks_least", "least of these, normal rows too", min, gaps["full"])
    most = extreme(results, "sinks_most", "most of these, friction rows alone", max, gaps["term"])
    same = results.chosen("stays_bound", "as deep as before", 0.01, unit="mm")
    outcome = all_of(at_least(least, 1.0, why="deeper than a contact of this weight is"), at_most(most, same))
    return Claim("rolling_body_sinks", outcome, {"least": least, "most": most, "same": same})
