"""What a new release changes: numbers, claims, and the contact rows that say why."""

from collections.abc import Sequence
from itertools import pairwise

from measured_report.changes.flips import Flip, FlipList, flips
from measured_report.changes.query import Query
from measured_report.pages.chapters import Releases
from measured_report.parts.claim import FAILS, HOLDS, Claim, Outcome, decided
from measured_report.parts.section import Section
from measured_report.values.noise import EDGES
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results
from report.sections.upgrade import tables
from report.sections.upgrade.cause import cause_claims, nothing_to_explain
from report.sections.upgrade.ends import Ends, change, floor, machines_differ, released, unchanged, up_to

order = 200
page = "releases"
label = "other releases"
labels = {
    "as-shipped": "shipped pads",
    "as-shipped-kf-off": "shipped pads, kf below zero",
    "as-shipped-kf-#": "shipped pads, kf {}",
    "stiff-pads-kf-off": "stiff pads, kf below zero",
    "hold-kf-off": "arm held still, kf below zero",
}


def derive(results: Results, releases: Releases) -> Section:
    shown = results.edition
    releases = released(releases, shown)
    floors = {unit: floor(results, releases, name, unit) for unit, name in tables.FLOORS.items()}
    seen = up_to(releases, shown)
    flipped = list(flips(seen, shown))
    ends, newest = Ends(seen), Ends(releases)
    same_slip = _slip_is_the_same(results, ends, floors["mm"])
    steps = _in_one_step(results, seen, floors["mm"], same_slip.outcome)
    between = shown not in (newest.old, newest.new)
    return Section(
        tables={
            "turns": FlipList([flip for flip in flipped if flip.is_decided], shown, list(results.others)),
            "live": tables.live_table(releases),
            "tried": tables.tried_table(releases),
            "speed": tables.speed_table(results, releases),
            "options": tables.option_table(releases),
        },
        figures={"slips": tables.slip_figure(releases, steps.numbers["steps"] if steps.outcome == HOLDS else [])},
        claims=[
            same_slip,
            steps,
            _claims_stand(results, flipped, list(seen)),
            *cause_claims(results, ends, same_slip.outcome),
            _same_speed(results, ends, "same_speed", "frame", tables.ONE_WORLD),
            _same_speed(results, ends, "same_speed_on_cpu", "cpu_frame", tables.ON_CPU),
            *([_same_as_newest(results, newest, floors["mm"])] if between else []),
        ],
        unmeasured=() if between else ("same_as_newest",),
    )


def _slip_is_the_same(results: Results, ends: Ends, noise: Value) -> Claim:
    old, new = ends.cells(tables.SLIP)
    moved = change(results, "slip_change", old, new)
    grows = (moved.value or 0) > 0
    numbers = {"a": ends.old, "b": ends.new, "before": old, "after": new, "noise": noise, "grows": grows}
    return Claim("slip_is_the_same", ends.one or unchanged(old, new, moved, noise), numbers)


def _same_as_newest(results: Results, ends: Ends, noise: Value) -> Claim:
    own = results.edition
    before, after = tables.SLIP.cell(ends.releases[own], own), tables.SLIP.cell(ends.releases[ends.new], ends.new)
    moved = change(results, "slip_change_from_here", before, after)
    numbers = {"a": own, "b": ends.new, "before": before, "after": after}
    return Claim("same_as_newest", unchanged(before, after, moved, noise), numbers)


def _in_one_step(results: Results, releases: Releases, noise: Value, same: Outcome) -> Claim:
    cells = {release: tables.SLIP.cell(releases[release], release) for release in releases}
    there = [release for release in releases if cells[release].value is not None]
    found = {}
    for before, after in pairwise(there):
        moved = change(results, f"slip_step_{after}", cells[before], cells[after])
        found[before, after] = unchanged(cells[before], cells[after], moved, noise)
    steps = [step for step, outcome in found.items() if outcome == FAILS]
    outcome = decided(len(steps) == 1).having_read(*(cells[release] for release in there), noise)
    outcome = next((step for step in found.values() if step.name == "unknown"), outcome)
    if len(there) < 3:
        outcome = Outcome("unknown", "no release between was measured")
    return Claim("in_one_step", nothing_to_explain(same) or outcome, {"steps": steps})


def _claims_stand(results: Results, flipped: Sequence[Flip], releases: Sequence[str]) -> Claim:
    found = sum(flip.is_decided for flip in flipped)
    count = results.value("turned_count", "claims that one release upholds and another doesn't", lambda: found)
    formula = "other claims that one release can tell and another can't"
    others = results.value("undecided_count", formula, lambda: len(flipped) - found)
    is_one = len(releases) < 2
    outcome = Outcome("unknown", f"only Newton {releases[0]} has results") if is_one else decided(not found)
    return Claim("claims_stand", outcome, {"count": count, "open": others})


def _same_speed(results: Results, ends: Ends, claim: str, name: str, headline: Query) -> Claim:
    old, new = ends.cells(headline)
    formula = "larger of the ranges from the 5th to the 95th percentile of a frame's time"
    low, high = (ends.cells(tables.edge(headline, end)) for end in EDGES)
    edges = low[0], high[0], low[1], high[1]
    spread = results.value(
        f"{name}_spread", formula, lambda a, b, c, d: max(b - a, d - c), *edges, unit="ms", across=True
    )
    moved = change(results, f"{name}_change", old, new)
    times: dict[str, Quantity] = {"before": old, "after": new, "spread": spread}
    outcome = ends.one or unchanged(old, new, moved, spread)
    if differ := machines_differ(ends.releases, headline.section):
        outcome, times = differ, {time: absent("ms", differ.reason) for time in times}
    return Claim(claim, outcome, {"a": ends.old, "b": ends.new, "grows": (moved.value or 0) > 0, **times})
