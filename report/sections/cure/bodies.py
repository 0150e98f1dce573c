"""Other bodies and other contacts than a grasp, with the term put back: what moves as it should."""

import math
from collections.abc import Iterable, Mapping

from measured_report.files.root import ROOT
from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Download, Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count, extreme, rows_with, share, size_difference, size_share

PLACE_FILE = ROOT / "experiments/simulation/contact_place.py"
TABLE = ("carried", "caught")
"""Motions on the table: turning with it, and put down at rest."""
FREE = ("impact", "roll", "slide")
"""Motions on a plane whose contacts have no acceleration along their friction that could be left out."""
Found = Mapping[str, Row]
"""By what is done: nothing, the term of material points, that in normal rows too, the exact term; or stiff contacts."""


def derive(results: Results) -> Section:
    runs: dict[tuple[str, str, str], dict[str, Row]] = {}
    for row in rows_with(results, "motion", "body", "variant", "backend"):
        runs.setdefault((row.motion, row.body, row.backend), {})[row.variant] = row
    return Section(
        claims=[
            _stays_as_it_is(results, _of(runs, FREE, "c", "term")),
            _stands_on_any_feet(results, _of(runs, TABLE, "", "exact")),
            _spinning_ball_goes_straight(results, runs),
            _rolls_no_deeper(results, runs),
            _tumbles_as_stiff_bodies_do(results, _of(runs, ("tumble",), "c", "limit")),
        ],
        downloads=[Download(PLACE_FILE.name, PLACE_FILE.read_text(encoding="utf-8"))],
    )


def _of(
    runs: Mapping[tuple[str, str, str], Found], motions: Iterable[str], engine: str, variant: str
) -> list[tuple[str, Found]]:
    """List the runs of these motions, in one engine or in both, with this variant and with nothing done."""
    return [
        (f"{motion}_{body}_{backend}".replace(" ", "_"), found)
        for (motion, body, backend), found in runs.items()
        if motion in motions and engine in ("", backend) and {"plain", variant} <= set(found)
    ]


def _off(results: Results, name: str, formula: str, row: Row, other: Row) -> Value:
    """Derive the distance between the places where two runs end."""
    columns = ("travel_mm", "sideways_mm", "rise_mm")
    cells = [each[column] for each in (row, other) for column in columns]
    return results.value(name, formula, lambda *ends: math.dist(ends[:3], ends[3:]), *cells, unit="mm")


def _stays_as_it_is(results: Results, runs: list[tuple[str, Found]]) -> Claim:
    formula = "distance between the places where the body ends with the term and with nothing done, of the way there"
    shares = [
        share(
            results,
            f"moved_{name}",
            formula,
            _off(results, f"off_{name}", "distance between these places", found["term"], found["plain"]),
            found["plain"].travel_mm,
        )
        for name, found in runs
    ]
    largest = extreme(results, "moved_most", "largest of these", max, shares)
    count = cell_count(results, "free_count", "runs on the plane", shares)
    outcome = at_most(largest, 1.0, why="the same motion")
    return Claim("free_motion_stays", outcome, {"largest": largest, "count": count})


def _stands_on_any_feet(results: Results, runs: list[tuple[str, Found]]) -> Claim:
    formula = "growth of the distance from the axis with the exact term, of that with nothing done, in size"
    left = [
        size_share(results, f"left_{name}", formula, found["exact"].growth_per_s, found["plain"].growth_per_s)
        for name, found in runs
    ]
    largest = extreme(results, "left_most", "largest of these", max, left)
    count = cell_count(results, "table_count", "runs on the table", left)
    return Claim("stands_on_any_feet", at_most(largest, 1.0, why="it stands"), {"largest": largest, "count": count})


def _spinning_ball_goes_straight(results: Results, runs: Mapping[tuple[str, str, str], Found]) -> Claim:
    """Tell how far aside a ball ends that rolls and spins, with the exact term and with that of material points."""
    exact = _of(runs, ("pivot",), "", "exact")
    formula = "how far the ball ends aside with {} of where it does with nothing done"
    aside = [
        size_difference(
            results,
            f"aside_{name}",
            formula.format("the exact term"),
            found["exact"].sideways_mm,
            found["plain"].sideways_mm,
        )
        for name, found in exact
    ]
    points = [
        size_difference(
            results, f"points_{name}", formula.format("the term"), found["term"].sideways_mm, found["plain"].sideways_mm
        )
        for name, found in _of(runs, ("pivot",), "c", "term")
    ]
    most = extreme(results, "aside_most", "largest of these", max, aside)
    drifts = extreme(results, "points_aside", "with the term of material points", max, points)
    travel = extreme(results, "pivot_travel", "way of the ball", max, [found["plain"].travel_mm for _, found in exact])
    straight = results.chosen("straight_bound", "a sixtieth of the ball", 0.5, unit="mm")
    far = at_least(travel, 500.0, why="a way on which it would be seen")
    outcome = all_of(at_most(most, straight), at_least(drifts, 10.0, why="it is seen"), far)
    numbers = {"points": drifts, "travel": travel, "straight": straight}
    return Claim("spinning_ball_goes_straight", outcome, numbers)


def _rolls_no_deeper(results: Results, runs: Mapping[tuple[str, str, str], Found]) -> Claim:
    """Tell how much deeper bodies roll with normal rows too, exact and by material points."""
    formula = "how much deeper the body ends than with nothing done"
    exact, points = (
        [
            size_difference(
                results, f"deeper_{variant}_{name}", formula, found["plain"].rise_mm, found[variant].rise_mm
            )
            for name, found in _of(runs, ("roll",), engine, variant)
        ]
        for variant, engine in (("exact", ""), ("full", "c"))
    )
    most = extreme(results, "deeper_most", "most of these, with the exact term", max, exact)
    sinks = extreme(results, "sinks_least", "least of these, with that of material points", min, points)
    same = results.chosen("depth_bound", "a third of the depth at rest", 0.1, unit="mm")
    outcome = all_of(at_most(most, same), at_least(sinks, 1.0, why="deeper than a contact of this weight is"))
    return Claim("rolls_no_deeper", outcome, {"most": most, "sinks": sinks, "same": same})


def _tumbles_as_stiff_bodies_do(results: Results, runs: list[tuple[str, Found]]) -> Claim:
    """Tell whether tumbling bodies end nearer to where stiff contacts take them."""
    formula = "how far from where stiff contacts take it the body ends with {}"
    shares = [
        share(
            results,
            f"of_stray_{name}",
            "the first of these, of the second",
            _off(results, f"stray_exact_{name}", formula.format("the exact term"), found["exact"], found["limit"]),
            _off(results, f"stray_{name}", formula.format("nothing done"), found["plain"], found["limit"]),
        )
        for name, found in runs
    ]
    largest = extreme(results, "of_stray_most", "largest of these", max, shares)
    count = cell_count(results, "tumble_count", "runs that tumble", shares)
    return Claim("tumbles_truer", at_most(largest, 50.0, why="half as far"), {"largest": largest, "count": count})
