"""What is new in the live contacts of a release, and whether the old number comes back without it."""

from measured_report.parts.claim import HOLDS, Claim, Outcome, all_of, at_most, decided
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results
from report.sections.upgrade.ends import Ends
from report.sections.upgrade.tables import GIVEN, MUJOCO_C, MUJOCO_CONTACTS, PYRAMID, SHIPPED, SWITCHED, TAKEN

SAME = 5.0
"""Chosen: a slip that is no farther from another, in percent of that, is the same."""


def nothing_to_explain(same: Outcome) -> Outcome | None:
    """Say why nothing can be told of a change in slip: there is none, or none that can be told."""
    if same == HOLDS:
        return Outcome("unknown", "the slip is the same in both", reads=same.reads)
    return same if same.name == "unknown" else None


def cause_claims(results: Results, ends: Ends, same_slip: Outcome) -> list[Claim]:
    """Return what is new in the live contacts, and whether the old number comes back without it."""
    was, own = ends.live(SHIPPED, "friction_timeconst_s")
    is_new = ends.one or all_of(decided(not was.value, was), decided((own.value or 0) > 0, own))
    old, new = ends.live(SHIPPED, "slip_mm")
    taken, given = ends.live(TAKEN, "slip_mm")[1], ends.live(GIVEN, "slip_mm")[0]
    off = ends.live(SWITCHED, "slip_mm")[1]
    bound = results.chosen("recovery_bound", "as good as all of the change", 95.0, unit="%")
    tolerance = results.value("recovery_tolerance", "what that leaves, either way", lambda a: 100 - a, bound, unit="%")
    brings_back, ends_it, switches = (
        nothing_to_explain(same_slip) or at_most(_miss(results, name, start, end, goal), tolerance)
        for name, start, end, goal in (
            ("taken_share", new, taken, old),
            ("given_share", old, given, new),
            ("off_share", new, off, old),
        )
    )
    numbers = {"a": ends.old, "b": ends.new, "before": old, "taken": taken, "given": given, "off": off}
    return [
        Claim("friction_timeconst_is_new", is_new, numbers | {"own": own}),
        Claim("taking_it_away_brings_it_back", brings_back, numbers),
        Claim("giving_it_does_the_same", ends_it, numbers),
        Claim("release_has_a_switch", switches, numbers),
        Claim("cause", ends.one or all_of(is_new, brings_back, ends_it), numbers),
        _mujoco_contacts_as_before(results, ends),
        _pyramid_as_before(results, ends),
    ]


def _mujoco_contacts_as_before(results: Results, ends: Ends) -> Claim:
    found, engine = ends.cells(MUJOCO_CONTACTS), ends.cells(MUJOCO_C)
    formula = "larger change in slip where MuJoCo finds the contacts, of the older slip"

    def larger(a: float, b: float, c: float, d: float) -> float:
        return 100 * max(abs(b / a - 1), abs(d / c - 1))

    elsewhere = results.value("elsewhere_change", formula, larger, *found, *engine, unit="%", across=True)
    numbers = {"a": ends.old, "b": ends.new, "found": found[1], "c": engine[1], "elsewhere": elsewhere}
    return Claim("mujoco_contacts_as_before", ends.one or at_most(elsewhere, SAME, why="the same slip"), numbers)


def _pyramid_as_before(results: Results, ends: Ends) -> Claim:
    before, after = ends.cells(PYRAMID)
    formula = "change in slip with a pyramidal cone, of the older slip"
    change = results.value(
        "pyramid_change", formula, lambda a, b: 100 * abs(b / a - 1), before, after, unit="%", across=True
    )
    numbers = {"before": before, "after": after, "a": ends.old, "b": ends.new, "moved": change}
    return Claim("pyramid_as_before", ends.one or at_most(change, SAME, why="the same slip"), numbers)


def _miss(results: Results, name: str, start: Quantity, end: Quantity, goal: Quantity) -> Value:
    formula = "how far the switched case goes from the slip of its own release to that of the other"
    share = results.value(
        name, formula, lambda a, b, whole: 100 * (b - a) / (whole - a), start, end, goal, unit="%", across=True
    )
    return results.value(f"{name}_miss", "how far that is from all of it", lambda a: abs(a - 100), share, unit="%")
