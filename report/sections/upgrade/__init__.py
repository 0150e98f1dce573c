"""Show the numbers and claims that change in a new release, and the cause."""

from dataclasses import replace
from itertools import pairwise
from typing import Any

from measured_report.changes.compare import FlipList, flips
from measured_report.findings.chapters import Releases
from report.sections import speed
from report.sections.upgrade import tables
from report.sections.upgrade.ends import Ends, machines_differ, released
from report.shared import (
    DEVICES,
    HOLDS,
    PERCENT,
    Claim,
    Outcome,
    Quantity,
    Results,
    Section,
    Value,
    all_of,
    at_most,
    combined,
    constant,
    decided,
    departure,
    negligible,
    relevance,
)

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
    edition = results.edition
    releases = released(releases, edition)
    names = list(releases)
    # A release is compared with those before it, and the oldest release with all
    # others.
    count = names.index(edition) + 1 if edition in names[1:] else len(names)
    compared = {release: releases[release] for release in names[:count]}
    ends = Ends(compared, names[0], list(compared)[-1])

    before, after = ends.cells(tables.SLIP)
    share = _change(results, "slip_change", before, after, before)
    bound = relevance(results)
    same_slip = ends.alone or negligible(abs(share), bound).having_read(before, after)
    slip_is_the_same = Claim(
        "slip_is_the_same",
        same_slip,
        ends.names
        | {
            "before": before,
            "after": after,
            "change": share,
            "bound": bound,
            "within": _within(results, "slip_within", share),
            "grows": (share.value or 0) > 0,
        },
    )

    in_one_step = _in_one_step(results, compared, bound, same_slip)
    steps = in_one_step.numbers["steps"] if in_one_step.outcome == HOLDS else []

    flipped = list(flips(compared, edition))
    turned = sum(flip.is_decided for flip in flipped)
    turned_count = results.value(
        "turned_count",
        "claims that hold in one release and not in another",
        constant(turned),
    )
    results.value(
        "undecided_count",
        "other claims that can be decided in one release and not in another",
        constant(len(flipped) - turned),
    )
    answers = [claim.outcome.reads for flip in flipped for _, claim in flip.answers]
    outcome = decided(not turned)
    outcome = replace(outcome, reads=outcome.reads.union(*answers))
    claims_stand = Claim("claims_stand", ends.alone or outcome, {"count": turned_count})
    return Section(
        tables={
            "turns": FlipList(list(compared), edition, list(results.others)),
            "tried": tables.side_by_side("slip [mm]", releases, tables.TRIED),
            "speed": tables.side_by_side("", releases, tables.SPEEDS),
            "numbers": tables.number_table(releases),
            "options": tables.option_table(releases),
        },
        figures={"slips": tables.slip_figure(releases, steps)},
        claims=[
            slip_is_the_same,
            in_one_step,
            claims_stand,
            *_cause(results, ends, same_slip),
            *_as_before(results, ends),
            _same_speed(results, ends),
        ],
    )


def _within(results: Results, name: str, change: Quantity) -> Value | str:
    """Derive the largest change within the interval, or an empty text without noise."""
    why = change.reason or "its noise was not measured"
    noise = Quantity(change.noise, change.unit, "", why, noise=0.0)
    formula = "absolute change plus its noise"
    within = results.value(name, formula, abs(change) + noise, is_noise=True)
    return "" if within.value is None else within


def _change(
    results: Results, name: str, before: Quantity, after: Quantity, whole: Quantity
) -> Value:
    return results.value(
        name,
        "slip in the later release minus the slip in the earlier one, relative to the"
        " oldest",
        PERCENT * (after - before) / whole,
        across=True,
    )


def _in_one_step(
    results: Results, releases: Releases, bound: Value, slip_outcome: Outcome
) -> Claim:
    """Test whether the slip changes between two neighbouring releases only."""
    cells = {name: tables.SLIP.cell(releases[name], name) for name in releases}
    cells = {name: cell for name, cell in cells.items() if cell.value is not None}
    oldest = next(iter(cells.values()), None)
    tests = {
        (a, b): negligible(
            abs(_change(results, f"slip_step_{b}", cells[a], cells[b], oldest)), bound
        )
        for a, b in pairwise(cells)
    }
    steps = [step for step, test in tests.items() if test.name == "fails"]
    outcome = decided(len(steps) == 1).having_read(*cells.values(), bound)
    for test in tests.values():
        if test.name == "unknown":
            outcome = test
            break
    if len(cells) < 3:
        reason = "no release between the two was measured"
        outcome = Outcome("unknown", reason).having_read(*cells.values())
    named = [
        [results.columns.settings.name_of(name) for name in step] for step in steps
    ]
    outcome = _nothing_to_explain(slip_outcome) or outcome
    return Claim("in_one_step", outcome, {"steps": named})


def _same_speed(results: Results, ends: Ends) -> Claim:
    """Test whether the frames of all cases with one world take as long as before."""
    frame = tables.SPEEDS["a frame with shipped pads [ms]"]
    frames = [replace(frame, text=f"speed.{case}.frame_ms") for case in speed.labels]
    pairs = [ends.cells(query) for query in frames]
    ratios = [after / before for before, after in pairs]
    numbers: dict[str, Any] = {
        name: results.value(
            f"frame_ratio_{name}",
            f"{name} ratio of the frame time to the time in the older release",
            combined(choose, *ratios),
            across=True,
        )
        for name, choose in (("least", min), ("most", max))
    }
    change = results.value(
        "frame_change",
        "largest absolute change of the frame time, relative to the older time",
        combined(max, *(departure(after, before) for before, after in pairs)),
        across=True,
    )
    numbers["change"] = change
    numbers["within"] = _within(results, "frame_within", change)
    numbers["bound"] = results.chosen("frame_bound", "the same time", 5.0, "%")
    outcome = negligible(change, numbers["bound"])
    outcome = outcome.having_read(numbers["least"], numbers["most"])
    outcome = machines_differ(ends.releases, "speed") or outcome
    timed = [
        chapters["speed"] for chapters in ends.releases.values() if "speed" in chapters
    ]
    devices = [DEVICES[chapter.results.record.machine["device"]] for chapter in timed]
    numbers["device"] = devices[-1] if devices else ""
    return Claim("same_speed", ends.alone or outcome, ends.names | numbers)


def _nothing_to_explain(outcome: Outcome) -> Outcome | None:
    if outcome == HOLDS:
        reason = "the slip is the same in both"
        return Outcome("unknown", reason, reads=outcome.reads)
    return outcome if outcome.name == "unknown" else None


def _cause(results: Results, ends: Ends, same_slip: Outcome) -> list[Claim]:
    old_timeconst, own = ends.live(tables.SHIPPED, "friction_timeconst_s")
    is_new = ends.alone or all_of(
        decided(not old_timeconst.value, old_timeconst),
        decided((own.value or 0) > 0, own),
    )
    old, new = ends.live(tables.SHIPPED, "slip_mm")
    taken = ends.live(tables.TAKEN, "slip_mm")[1]
    given = ends.live(tables.GIVEN, "slip_mm")[0]
    off = ends.live(tables.SWITCHED, "slip_mm")[1]

    def recovers(name: str, start: Quantity, end: Quantity, goal: Quantity) -> Outcome:
        share = results.value(
            f"{name}_share",
            "change of the slip by the switch, relative to the difference between the"
            " releases",
            PERCENT * (end - start) / (goal - start),
            across=True,
        )
        miss = results.value(
            f"{name}_share_miss",
            "absolute deviation from the whole change",
            abs(share - PERCENT),
        )
        is_whole = at_most(miss, 5.0, "nearly all of the change")
        return _nothing_to_explain(same_slip) or is_whole

    brings_back = recovers("taken", new, taken, old)
    does_the_same = recovers("given", old, given, new)
    switches = recovers("off", new, off, old)
    return [
        Claim("friction_timeconst_is_new", is_new, ends.names | {"own": own}),
        Claim(
            "taking_it_away_brings_it_back",
            brings_back,
            ends.names | {"taken": taken, "before": old},
        ),
        Claim("giving_it_does_the_same", does_the_same, ends.names | {"given": given}),
        Claim("release_has_a_switch", switches, {"off": off}),
        Claim("cause", ends.alone or all_of(is_new, brings_back, does_the_same)),
    ]


def _as_before(results: Results, ends: Ends) -> list[Claim]:
    """Test whether the slip is the same in settings that the change does not affect."""
    mujoco_before, mujoco = ends.cells(tables.MUJOCO_CONTACTS)
    c_before, c = ends.cells(tables.MUJOCO_C)
    before, after = ends.cells(tables.PYRAMID)
    elsewhere = results.value(
        "elsewhere_change",
        "larger change in slip if MuJoCo finds the contacts, relative to the older"
        " slip",
        combined(max, departure(mujoco, mujoco_before), departure(c, c_before)),
        across=True,
    )
    moved = results.value(
        "pyramid_change",
        "change in slip with a pyramidal cone, relative to the older slip",
        departure(after, before),
        across=True,
    )
    contacts = {"found": mujoco, "c": c, "elsewhere": elsewhere}
    pyramid = {"before": before, "after": after, "moved": moved}
    return [
        Claim(
            f"{name}_as_before",
            ends.alone or at_most(change, 5.0, "the same slip"),
            ends.names | numbers,
        )
        for name, change, numbers in (
            ("mujoco_contacts", elsewhere, contacts),
            ("pyramid", moved, pyramid),
        )
    ]
