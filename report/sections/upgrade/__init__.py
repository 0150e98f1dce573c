"""What a new release changes: numbers, claims, and the contact rows that say why."""

from collections.abc import Sequence
from itertools import pairwise

from report.chapters import Releases
from report.claims import FAILS, HOLDS, Claim, Outcome
from report.deriving.releases import Ends, TurnList, cell, change, floor, machines_differ, turns, unchanged
from report.parts import Section
from report.quantities import Value
from report.results import Results
from report.sections.upgrade.cause import cause_claims
from report.sections.upgrade.tables import (
    EDGES,
    FLOORS,
    SLIP,
    SPEEDS,
    edge,
    headline_table,
    live_table,
    option_table,
    slip_figure,
    speed_table,
    tried_table,
)

order = 200
page = "releases"


def derive(results: Results, releases: Releases) -> Section:
    floors = {unit: floor(results, releases, name, unit) for unit, name in FLOORS.items()}
    turned = turns(releases, results.record.origin.release)
    ends = Ends(releases)
    tables = {
        "headlines": headline_table(results, releases, floors),
        "turns": TurnList(turned, list(results.others)),
        "live": live_table(releases),
        "tried": tried_table(releases),
        "speed": speed_table(results, releases),
        "options": option_table(releases),
    }
    return Section(
        tables=tables,
        figures={"slips": slip_figure(releases)},
        claims=[
            _slip_is_the_same(results, ends, floors["mm"]),
            _in_one_step(results, releases, floors["mm"]),
            _claims_stand(results, turned, list(releases)),
            *cause_claims(results, ends),
            _same_speed(results, ends),
        ],
    )


def _slip_is_the_same(results: Results, ends: Ends, noise: Value) -> Claim:
    old, new = ends.cells(SLIP)
    moved = change(results, "slip_change", old, new)
    return Claim(
        "slip_is_the_same",
        ends.one or unchanged(old, new, moved, noise),
        numbers={"a": ends.old, "b": ends.new, "before": old, "after": new, "noise": noise},
    )


def _in_one_step(results: Results, releases: Releases, noise: Value) -> Claim:
    """Between which neighbours the slip changes, of the releases that say."""
    cells = {release: cell(releases, release, SLIP) for release in releases}
    there = [release for release in releases if cells[release].value is not None]
    steps = []
    for before, after in pairwise(there):
        moved = change(results, f"slip_step_{after}", cells[before], cells[after])
        if unchanged(cells[before], cells[after], moved, noise) == FAILS:
            steps.append((before, after))
    outcome = HOLDS if len(steps) == 1 else FAILS
    if len(there) < 3:
        outcome = Outcome("unknown", "no release between was measured")
    return Claim("in_one_step", outcome, {"steps": steps})


def _claims_stand(results: Results, turned: Sequence, releases: Sequence[str]) -> Claim:
    count = results.value("turned_count", "claims whose outcome is not the same in all releases", lambda: len(turned))
    outcome = FAILS if turned else HOLDS
    if len(releases) < 2:
        outcome = Outcome("unknown", f"only Newton {releases[0]} has results")
    return Claim("claims_stand", outcome, {"count": count})


def _same_speed(results: Results, ends: Ends) -> Claim:
    """Only what was measured on one machine is compared."""
    headline = SPEEDS[0]
    old, new = ends.cells(headline)
    edges = [cell(ends.releases, release, edge(headline, end)) for release in (ends.old, ends.new) for end in EDGES]
    spread = results.value(
        "frame_spread",
        "larger of the ranges from the 5th to the 95th percentile of a frame's time",
        lambda a, b, c, d: max(b - a, d - c),
        *edges,
        unit="ms",
        across=True,
    )
    moved = change(results, "frame_change", old, new)
    return Claim(
        "same_speed",
        ends.one or machines_differ(ends.releases, headline.section) or unchanged(old, new, moved, spread),
        numbers={"a": ends.old, "b": ends.new, "before": old, "after": new, "spread": spread},
    )
