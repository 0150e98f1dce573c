"""What is new in the live contacts of a release, and whether the old number comes back without it."""

from report.claims import FAILS, HOLDS, Claim, Outcome, all_of, at_least, at_most
from report.quantities import Quantity, Value
from report.results import Results
from report.sections._releases import Ends
from report.sections._upgrade_tables import GIVEN, MUJOCO_C, MUJOCO_CONTACTS, PYRAMID, SHIPPED, SWITCHED, TAKEN


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
            holds="The live contacts of Newton {b} have what those of {a} had not: their friction rows have a time "
            "constant of their own, {own}. In Newton {a} they took that of the normal row, {normal}.",
            fails="In this the live contacts of Newton {a} and {b} are alike: the friction rows' own time constant is "
            "{was} in one and {own} in the other (zero: they take that of the normal row).",
            unknown="Whether the friction rows of the live contacts are other than they were cannot be told.",
            numbers=numbers | {"own": own[1], "was": own[0], "normal": normal[0]},
        ),
        Claim(
            "taking_it_away_brings_it_back",
            brings_back,
            holds="Taken out of the live contacts of Newton {b}, and nothing else changed, the old number comes back: "
            "the cube slips {taken}.",
            fails="Taken out of the live contacts of Newton {b}, the cube slips {taken}, where Newton {a} had {before} "
            "and {b} has {after}: that is not what makes the difference.",
            unknown="Whether the old number comes back when it is taken away cannot be told.",
            numbers=numbers,
        ),
        Claim(
            "giving_it_does_the_same",
            ends_it,
            holds="Two substeps, written into those of Newton {a}, do there what the new release does: the cube slips "
            "{given}.",
            fails="Two substeps, written into those of Newton {a}, do not do there what the new release does: the cube "
            "slips {given}.",
            unknown="Whether the older release does the same when it is given cannot be told.",
            numbers=numbers,
        ),
        Claim(
            "release_has_a_switch",
            switches,
            holds="The release has a switch for it: with kf below zero on the pads the cube slips {off} again.",
            fails="With kf below zero on the pads the cube slips {off}.",
            unknown="Whether the release's own parameter switches it off cannot be told.",
            numbers=numbers,
        ),
        Claim(
            "cause",
            ends.one or all_of(is_new, brings_back, ends_it),
            holds="The friction rows' own time constant is the reason for the difference in slip.",
            fails="The friction rows' time constant does not account for the difference between Newton {a} and {b}.",
            unknown="What makes the difference cannot be told.",
            numbers=numbers,
            explanation="Newton makes it from the shapes' kf, which this solver did not read before, for contacts that "
            "its own collision pipeline finds. What comes out below two substeps is clamped to them, as the timeconst "
            "of the stiff pads is.",
        ),
        Claim(
            "mujoco_contacts_as_before",
            ends.one or at_most(elsewhere, same),
            holds="Where MuJoCo finds the contacts nothing has changed, as shipped: with them the cube slips {found} "
            "in Newton {b}, in MuJoCo's C engine {c}.",
            fails="Where MuJoCo finds the contacts the slip has changed as well, by up to {elsewhere}: with them the "
            "cube slips {found} in Newton {b}, in MuJoCo's C engine {c}.",
            unknown="Whether anything has changed where MuJoCo finds the contacts cannot be told.",
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
        holds="With a pyramidal friction cone nothing has changed either: the cube slips {after} in Newton {b}.",
        fails="With a pyramidal friction cone the slip has changed as well: to {after} in Newton {b}, from {before}.",
        unknown="Whether anything has changed with a pyramidal friction cone cannot be told.",
        numbers={"before": before, "after": after, "b": ends.new},
        explanation="Newton gives friction rows a time constant of their own only where the cone is elliptic.",
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
