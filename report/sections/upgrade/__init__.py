"""What a new release changes: numbers, claims, and the contact rows that say why."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from measured_report.changes.compare import Flip, FlipList, flips
from measured_report.files.config import config
from measured_report.findings.chapters import Releases
from report.sections import speed
from report.sections.upgrade import tables
from report.sections.upgrade.ends import Ends, machines_differ, released, unchanged
from report.sections.upgrade.tables import (
    GIVEN,
    MUJOCO_C,
    MUJOCO_CONTACTS,
    PYRAMID,
    SHIPPED,
    SWITCHED,
    TAKEN,
)
from report.shared import (
    DEVICES,
    HOLDS,
    OPPOSITE,
    PERCENT,
    Claim,
    Outcome,
    Quantity,
    Results,
    Section,
    Value,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    constant,
    decided,
    departure,
    greater,
    resolved,
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
    shown = results.edition
    releases = released(releases, shown)
    floors = [
        chapters["noise"].results.derived["slip_floor"]
        for chapters in releases.values()
        if "noise" in chapters
    ]
    noise = results.value(
        "slip_floor",
        "largest of the releases' noise floors",
        combined(max, *floors),
        across=True,
        is_noise=True,
    )
    seen, names = releases, list(releases)
    if shown in names[1:]:  # those before it and itself; the oldest is held against all
        seen = {
            release: releases[release] for release in names[: names.index(shown) + 1]
        }
    flipped, ends = list(flips(seen, shown)), Ends(seen, names[0], list(seen)[-1])
    same_slip = _slip_is_the_same(results, ends, noise)
    steps = _in_one_step(results, seen, noise, same_slip.outcome)
    shown_tables = {
        "turns": FlipList(list(seen), shown, list(results.others)),
        "tried": tables.side_by_side("slip [mm]", releases, tables.TRIED),
        "speed": tables.side_by_side(
            "", releases, {headline.label: headline for headline in tables.SPEEDS}
        ),
        **{
            "numbers": tables.number_table(releases),
            "options": tables.option_table(releases),
        },
    }
    slips = tables.slip_figure(
        releases, steps.numbers["steps"] if steps.outcome == HOLDS else []
    )
    claims = [same_slip, steps, _claims_stand(results, flipped, list(seen))]
    claims += [
        *cause_claims(results, ends, same_slip.outcome),
        _same_speed(results, ends),
    ]
    return Section(tables=shown_tables, figures={"slips": slips}, claims=claims)


def _slip_is_the_same(results: Results, ends: Ends, noise: Value) -> Claim:
    old, new = ends.cells(tables.SLIP)
    same = unchanged(results, "slip_change", old, new, noise)
    least = results.value("slip_change_least", "a tenth of the older slip", old / 10)
    grows = (results.derived["slip_change"].value or 0) > 0
    numbers = ends.names | {"before": old, "after": new, "noise": noise, "grows": grows}
    return Claim(
        "slip_is_the_same", ends.one or all_of(same, resolved(noise, least)), numbers
    )


def _in_one_step(
    results: Results, releases: Releases, noise: Value, same: Outcome
) -> Claim:
    cells = {
        release: tables.SLIP.cell(releases[release], release) for release in releases
    }
    measured = [release for release in releases if cells[release].value is not None]
    outcomes = {}
    for before, after in pairwise(measured):
        outcomes[before, after] = unchanged(
            results, f"slip_step_{after}", cells[before], cells[after], noise
        )
    steps = [step for step, outcome in outcomes.items() if outcome.name == "fails"]
    outcome = decided(len(steps) == 1).having_read(
        *(cells[release] for release in measured), noise
    )
    outcome = next(
        (step for step in outcomes.values() if step.name == "unknown"), outcome
    )
    if len(measured) < 3:
        outcome = Outcome("unknown", "no release between was measured")
    numbers = {"steps": [[*map(config().name_of, step)] for step in steps]}
    return Claim("in_one_step", nothing_to_explain(same) or outcome, numbers)


def _claims_stand(
    results: Results, flipped: Sequence[Flip], releases: Sequence[str]
) -> Claim:
    turned = sum(flip.is_decided for flip in flipped)
    count = results.value(
        "turned_count",
        "claims that one release upholds and another doesn't",
        constant(turned),
    )
    others = results.value(
        "undecided_count",
        "other claims that one release can tell and another can't",
        constant(len(flipped) - turned),
    )
    outcome = (
        Outcome("unknown", f"only Newton {releases[0]} has results")
        if len(releases) < 2
        else decided(not turned)
    )
    return Claim("claims_stand", outcome, {"count": count, "open": others})


def _same_speed(results: Results, ends: Ends) -> Claim:
    """Compare the frames of all cases of one world, which one release may have slowed by little each."""
    frames = [
        replace(tables.SPEEDS[0], text=f"speed.{case}.frame_ms")
        for case in speed.labels
    ]
    pairs = [ends.cells(headline) for headline in frames]
    formula, ratios = (
        "time of a frame over the older one",
        [after / before for before, after in pairs],
    )
    least = results.value(
        "frame_ratio_least", f"least {formula}", combined(min, *ratios), across=True
    )
    most = results.value(
        "frame_ratio_most", f"most {formula}", combined(max, *ratios), across=True
    )
    newer = cell_count(after for _, after in pairs)
    count = results.value(
        "speed_case_count", "cases of one world whose frames were timed", newer
    )
    one, why = Quantity(1.0, "1", "", noise=0.0), "the same time"
    ways = greater(least, one), greater(one, most)  # all take longer, or all less
    mixed = all(way.answer == "the opposite" for way in ways)
    same = all_of(at_least(least, 0.95, why=why), at_most(most, 1.05, why=why))
    outcome = machines_differ(ends.releases, "speed") or (
        OPPOSITE if HOLDS in ways else HOLDS if mixed else same
    )
    numbers = ends.names | {
        "mixed": mixed,
        "least": least,
        "most": most,
        "count": count,
    }
    timed = [
        chapters["speed"].results.record
        for chapters in ends.releases.values()
        if "speed" in chapters
    ]
    numbers["device"] = DEVICES[timed[-1].machine["device"]] if timed else ""
    return Claim("same_speed", ends.one or outcome.having_read(least, most), numbers)


def nothing_to_explain(same: Outcome) -> Outcome | None:
    if same == HOLDS:
        return Outcome("unknown", "the slip is the same in both", reads=same.reads)
    return same if same.name == "unknown" else None


def cause_claims(results: Results, ends: Ends, same_slip: Outcome) -> list[Claim]:
    was, own = ends.live(SHIPPED, "friction_timeconst_s")
    is_new = ends.one or all_of(
        decided(not was.value, was), decided((own.value or 0) > 0, own)
    )
    old, new = ends.live(SHIPPED, "slip_mm")
    taken, given = ends.live(TAKEN, "slip_mm")[1], ends.live(GIVEN, "slip_mm")[0]
    off = ends.live(SWITCHED, "slip_mm")[1]
    bound = results.chosen("recovery_bound", "as good as all of the change", 95.0, "%")
    tolerance = results.value(
        "recovery_tolerance", "what that leaves, either way", PERCENT - bound
    )
    brings_back, ends_it, switches = (
        nothing_to_explain(same_slip)
        or at_most(_miss(results, name, start, end, goal), tolerance)
        for name, start, end, goal in (
            ("taken", new, taken, old),
            ("given", old, given, new),
            ("off", new, off, old),
        )
    )
    return [
        Claim("friction_timeconst_is_new", is_new, ends.names | {"own": own}),
        Claim(
            "taking_it_away_brings_it_back",
            brings_back,
            ends.names | {"taken": taken, "before": old},
        ),
        Claim("giving_it_does_the_same", ends_it, ends.names | {"given": given}),
        Claim("release_has_a_switch", switches, {"off": off}),
        Claim("cause", ends.one or all_of(is_new, brings_back, ends_it)),
        *_as_before(results, ends),
    ]


def _as_before(results: Results, ends: Ends) -> Iterator[Claim]:
    """Tell whether what the change is not about slips as in the older release."""
    contacts, engine, pyramid = (
        ends.cells(headline) for headline in (MUJOCO_CONTACTS, MUJOCO_C, PYRAMID)
    )
    larger = combined(max, departure(*contacts[::-1]), departure(*engine[::-1]))
    elsewhere = results.value(
        "elsewhere_change",
        "larger change in slip where MuJoCo finds the contacts, of the older slip",
        larger,
        across=True,
    )
    moved = results.value(
        "pyramid_change",
        "change in slip with a pyramidal cone, of the older slip",
        departure(*pyramid[::-1]),
        across=True,
    )
    for name, slips, numbers in (
        (
            "mujoco_contacts",
            elsewhere,
            {"found": contacts[1], "c": engine[1], "elsewhere": elsewhere},
        ),
        ("pyramid", moved, {"before": pyramid[0], "after": pyramid[1], "moved": moved}),
    ):
        yield Claim(
            f"{name}_as_before",
            ends.one or at_most(slips, 5.0, why="the same slip"),
            ends.names | numbers,
        )


def _miss(
    results: Results, name: str, start: Quantity, end: Quantity, goal: Quantity
) -> Value:
    share = results.value(
        f"{name}_share",
        "how far the switched case goes from the slip of its own release to that of the other",
        PERCENT * (end - start) / (goal - start),
        across=True,
    )
    return results.value(
        f"{name}_share_miss", "how far that is from all of it", abs(share - PERCENT)
    )
