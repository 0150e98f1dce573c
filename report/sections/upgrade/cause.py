"""What is new in the live contacts of a release, and whether the old number comes back without it."""

from report.claims import FAILS, HOLDS, Claim, Outcome, all_of, at_least, at_most
from report.deriving.releases import Ends
from report.quantities import Quantity, Value
from report.results import Results
from report.sections.upgrade.tables import GIVEN, MUJOCO_C, MUJOCO_CONTACTS, PYRAMID, SHIPPED, SWITCHED, TAKEN


def cause_claims(results: Results, ends: Ends) -> list[Claim]:
    """What is new in the live contacts, and whether the old number comes back without it."""
    own = ends.live(SHIPPED, "friction_timeconst_s", "s")
    normal = ends.live(SHIPPED, "timeconst_s", "s")
    is_new = ends.one or _is_new(*own)
    old, new = ends.live(SHIPPED, "slip_mm", "mm")
    taken, given = ends.live(TAKEN, "slip_mm", "mm")[1], ends.live(GIVEN, "slip_mm", "mm")[0]
    off = ends.live(SWITCHED, "slip_mm", "mm")[1]
    bound = results.chosen("recovery_bound", "as good as all of the change", 95.0, unit="%")
    shares = {
        name: _share(results, name, start, end, goal)
        for name, start, end, goal in (
            ("taken_share", new, taken, old),
            ("given_share", old, given, new),
            ("off_share", new, off, old),
        )
    }
    found, engine = ends.cells(MUJOCO_CONTACTS), ends.cells(MUJOCO_C)
    elsewhere = results.value(
        "elsewhere_change",
        "larger change in slip where MuJoCo finds the contacts, of the older slip",
        lambda a, b, c, d: 100 * max(abs(b / a - 1), abs(d / c - 1)),
        *found,
        *engine,
        unit="%",
        across=True,
    )
    same = results.chosen("elsewhere_bound", "the same slip", 2.0, unit="%")
    brings_back, ends_it, switches = (ends.one or at_least(share, bound) for share in shares.values())
    numbers = {"a": ends.old, "b": ends.new, "before": old, "after": new}
    numbers |= {"taken": taken, "given": given, "off": off}
    return [
        Claim(
            "friction_timeconst_is_new",
            is_new,
            numbers=numbers | {"own": own[1], "was": own[0], "normal": normal[0]},
        ),
        Claim("taking_it_away_brings_it_back", brings_back, numbers),
        Claim("giving_it_does_the_same", ends_it, numbers),
        Claim("release_has_a_switch", switches, numbers),
        Claim("cause", ends.one or all_of(is_new, brings_back, ends_it), numbers),
        Claim(
            "mujoco_contacts_as_before",
            ends.one or at_most(elsewhere, same),
            numbers=numbers | {"found": found[1], "c": engine[1], "elsewhere": elsewhere},
        ),
        _pyramid_as_before(results, ends, same),
    ]


def _pyramid_as_before(results: Results, ends: Ends, same: Value) -> Claim:
    before, after = ends.cells(PYRAMID)
    change = results.value(
        "pyramid_change",
        "change in slip with a pyramidal cone, of the older slip",
        lambda a, b: 100 * abs(b / a - 1),
        before,
        after,
        unit="%",
        across=True,
    )
    return Claim(
        "pyramid_as_before",
        ends.one or at_most(change, same),
        numbers={"before": before, "after": after, "b": ends.new},
    )


def _is_new(before: Quantity, after: Quantity) -> Outcome:
    for quantity in (before, after):
        if quantity.value is None:
            return Outcome("unknown", quantity.reason)
    return HOLDS if not before.value and after.value else FAILS


def _share(results: Results, name: str, start: Quantity, end: Quantity, goal: Quantity) -> Value:
    return results.value(
        name,
        "how far the switched case goes from the slip of its own release to that of the other",
        lambda a, b, whole: 100 * (b - a) / (whole - a),
        start,
        end,
        goal,
        unit="%",
        across=True,
    )
