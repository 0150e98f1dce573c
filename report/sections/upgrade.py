"""What a new release changes: numbers, claims, and the contact rows that say why."""

from collections.abc import Sequence
from itertools import pairwise

from report.claims import FAILS, HOLDS, Claim, Outcome
from report.parts import Section
from report.quantities import Value
from report.results import Results
from report.sections._releases import Ends, Releases, TurnList, cell, change, floor, machines_differ, turns, within
from report.sections._upgrade_cause import cause_claims
from report.sections._upgrade_tables import (
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
        ends.one or within(old, new, moved, noise),
        holds="From Newton {a} to {b} the scene as shipped does the same: the cube slips {before} and {after}, and "
        "runs of one release differ by up to {noise}.",
        fails="Newton {b} does not do what Newton {a} did: as shipped the cube slips {after}, where it slipped "
        "{before}. Runs of one release differ by up to {noise}.",
        unknown="Whether the scene as shipped does the same from release to release cannot be told.",
        numbers={"a": ends.old, "b": ends.new, "before": old, "after": new, "noise": noise},
    )


def _in_one_step(results: Results, releases: Releases, noise: Value) -> Claim:
    """Between which neighbours the slip changes, of the releases that say."""
    cells = {release: cell(releases, release, SLIP) for release in releases}
    there = [release for release in releases if cells[release].value is not None]
    steps = []
    for before, after in pairwise(there):
        moved = change(results, f"slip_step_{after}", cells[before], cells[after])
        if within(cells[before], cells[after], moved, noise) == FAILS:
            steps.append(f"from Newton {before} to {after}")
    outcome = HOLDS if len(steps) == 1 else FAILS
    if len(there) < 3:
        outcome = Outcome("unknown", "no release between was measured")
    return Claim(
        "in_one_step",
        outcome,
        holds="All of it comes in one step, {steps}.",
        fails="It does not come in one step: {steps}.",
        unknown="In how many steps it comes cannot be told.",
        numbers={"steps": ", ".join(steps) or "none is beyond the noise"},
    )


def _claims_stand(results: Results, turned: Sequence, releases: Sequence[str]) -> Claim:
    count = results.value("turned_count", "claims whose outcome is not the same in all releases", lambda: len(turned))
    outcome = FAILS if turned else HOLDS
    if len(releases) < 2:
        outcome = Outcome("unknown", f"only Newton {releases[0]} has results")
    return Claim(
        "claims_stand",
        outcome,
        holds="Every claim of this report that can be told has the same outcome in all of them.",
        fails="Claims whose outcome is not the same in all of them: {count}.",
        unknown="Whether the claims of this report stand in other releases cannot be told.",
        numbers={"count": count},
    )


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
        ends.one or machines_differ(ends.releases, headline.section) or within(old, new, moved, spread),
        holds="One world is as fast as it was: a frame as shipped takes {after}, and took {before}; frames of one run "
        "spread over up to {spread}.",
        fails="A frame as shipped takes {after} in Newton {b}, where it took {before} in Newton {a}, on the same "
        "machine; frames of one run spread over up to {spread}.",
        unknown="Whether one world is as fast as it was cannot be told.",
        numbers={"a": ends.old, "b": ends.new, "before": old, "after": new, "spread": spread},
    )
