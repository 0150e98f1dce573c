"""What raising ke does, what raising kd along with it does, and where that ends."""

from collections.abc import Mapping

from measured_report.parts.claim import FAILS, HOLDS, Claim, Outcome, at_least, at_most, within
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results
from report.sections.stiffness.runs import FIX, SHIPPED, Runs, has_slip, is_held
from report.shared.arithmetic import SETTLES, extreme, noise_floor, ratio, share, spread, told

NO_HELP = 80.0
"""Chosen: a slip of so much of that as shipped, in percent, is no help."""
STIFFEST = "pad-ke-2.5e6"

NO_SLIP = "with shipped pads there is no slip to bring down"
NO_GAIN = Outcome("unknown", "raising both gains too little for its end to be seen")


def ke_is_no_spring(results: Results) -> Claim:
    soft, stiff = results.row[SHIPPED], results.row[STIFFEST]
    formula = "largest over smallest authored ke of the named cases"
    authored = ratio(results, "ke_ratio", formula, stiff.pad_ke, soft.pad_ke)
    formula = "measured stiffness at that largest ke over that at the smallest"
    measured = ratio(results, "stiffness_ratio", formula, stiff.stiffness_n_m, soft.stiffness_n_m)
    follows = share(results, "stiffness_follows", "measured ratio, of the authored", measured, authored)
    numbers = {"ke": soft.pad_ke, "k": soft.stiffness_n_m, "times": authored, "more": measured}
    return Claim("ke_is_no_spring", at_most(follows, 50.0, why="does not follow"), numbers)


def _with_slip(name: str, results: Results, outcome: Outcome, numbers: Mapping[str, Quantity]) -> Claim:
    """Return a claim about what brings the slip down; where there is none as shipped, it can't tell and names no
    numbers."""
    slip = has_slip(results)
    if slip != FAILS:
        return Claim(name, outcome, numbers)
    return Claim(name, Outcome("unknown", NO_SLIP, reads=slip.reads), told(absent("mm", NO_SLIP), numbers))


def ke_alone_does_not_help(results: Results, runs: Runs) -> Claim:
    held = list(filter(is_held, runs.ke_alone))
    slips, stiffnesses = [row.slip_mm for row in held], [row.pad_ke for row in held]
    low = extreme(results, "ke_alone_least", "least slip of the runs with kd at its default", min, slips)
    formula = "least slip with kd at its default, of the slip as shipped"
    of_shipped = share(results, "ke_alone_share", formula, low, results.row[SHIPPED].slip_mm)
    first = extreme(results, "ke_alone_first", "least ke of these runs", min, stiffnesses)
    last = extreme(results, "ke_alone_last", "largest ke of these runs", max, stiffnesses)
    numbers = {"kd": results.row[SHIPPED].pad_kd, "share": of_shipped, "low": low, "first": first, "last": last}
    return _with_slip("ke_alone_does_not_help", results, at_least(of_shipped, NO_HELP, why="no help"), numbers)


def together_they_hold(results: Results) -> Claim:
    shipped, fix = results.row[SHIPPED], results.row[FIX]
    gain = ratio(results, "improvement", "slip as shipped over slip with the fix", shipped.slip_mm, fix.slip_mm)
    bound = results.chosen("improvement_bound", *SETTLES)
    numbers = {"ke": fix.pad_ke, "kd": fix.pad_kd, "slipped": shipped.slip_mm, "slip": fix.slip_mm, "gain": gain}
    return Claim("together_they_hold", at_least(gain, bound), numbers)


def flat_below_clamp(results: Results, runs: Runs, clamp: Value) -> Claim:
    """Look beyond kd ``clamp``, where the timeconst is two substeps."""
    slips = [row.slip_mm for row in runs.together if is_held(row) and row.pad_kd.value >= clamp.value]
    formula = "largest less smallest slip of the runs with both raised and kd beyond the clamp"
    difference = spread(results, "clamped_spread", formula, slips, unit="mm")
    floor = noise_floor(results, "slip_floor")
    numbers: Mapping[str, Quantity] = {"spread": difference, "floor": floor}
    outcome = within(difference, floor)
    gain, bound = results.derived["improvement"], results.derived["improvement_bound"]
    if at_least(gain, bound) != HOLDS:
        outcome = NO_GAIN.having_read(gain, bound, difference, floor)
        numbers = told(absent("mm", NO_GAIN.reason), numbers)
    return Claim("flat_below_clamp", outcome, {"clamp": clamp, **numbers})
