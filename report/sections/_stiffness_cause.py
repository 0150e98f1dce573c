"""The cause, named: what the drift goes with, and what it does not."""

from collections.abc import Mapping
from statistics import median

from report.claims import FAILS, HOLDS, Claim, Outcome, all_of, at_most, greater
from report.quantities import Value
from report.results import Results
from report.sections._common import noise_floor, other_value, ratio
from report.sections._stiffness import SHIPPED, Runs, drift_without_slide, has_slip, is_held

HARDEST = "solimp-dmax-0.9999"
DRIVEN = (
    "So what drives the slide is not a force that the rows yield to, but the acceleration J̇·q̇ that contact rows "
    "leave out and that was measured above. In the engine's source the rows of equality constraints allow for it. The "
    "pads follow their arcs and the cube is left behind a little in every cycle."
)


def cause(results: Results, proportional: Claim) -> Claim:
    residual = other_value(results, "contacts", "friction_residual", unit="mm")
    departure = other_value(results, "contacts", "slide_departure_as-shipped", unit="%")
    share = other_value(results, "hold", "hold_share", unit="%")
    missing = other_value(results, "contacts", "missing_term_departure", unit="%")
    slip = results.row[SHIPPED].slip_mm
    outcomes = [
        has_slip(results),
        at_most(missing, other_value(results, "contacts", "missing_term_bound", unit="%")),
        at_most(residual, other_value(results, "contacts", "friction_residual_bound", unit="mm")),
        at_most(departure, other_value(results, "contacts", "slide_departure_bound", unit="%")),
        at_most(share, other_value(results, "hold", "hold_share_bound", unit="%")),
        proportional.outcome,
    ]
    fails = (
        "What was found does not make the friction rows the cause of the slip of {slip}: their largest position "
        "residual is {residual}, their velocity is {departure} off the motion measured and {missing} off what a "
        "left-out acceleration gives, and with the arm held still the drift is {share} of that when shaken, in size."
    )
    if outcomes[0] == FAILS:  # then the others need not be known, and a number that is not there is no finding
        fails = "As shipped the slip is {slip}: there is none to explain in this release."
    return Claim(
        "cause",
        all_of(*outcomes),
        holds="The cube walks out because the contact rows leave out an acceleration of the moving arm, and their "
        "friction is a brake and not a spring: it slides until it balances that acceleration. The friction rows carry "
        "no position residual ({residual}), so what has slid is never brought back; how fast it slides goes with the "
        "contact's timeconst, which Newton makes from the pads' kd; and it needs the load cycle: with the arm held "
        "still the drift is {share} of that when shaken, in size.",
        fails=fails,
        unknown="The cause cannot be named from what has been measured.",
        numbers={"slip": slip, "residual": residual, "departure": departure, "share": share, "missing": missing},
    )


def drift_follows_timeconst(results: Results, runs: Runs, least: Value) -> Claim:
    rest = drift_without_slide(results)
    rows = [*runs.held, *(row for row in runs.named if "pad_dmax" in row and is_held(row))]
    times = [
        results.value(
            f"response_{row.case}",
            "dmax times the timeconst of the friction rows, their own where they have one, and two substeps where it "
            "is less than that",
            lambda dmax, normal, own, shortest: dmax * max(own or normal, shortest),
            row.dmax,
            row.timeconst_s,
            row.friction_timeconst_s,
            least,
            unit="s",
        )
        for row in rows
    ]
    rates = [
        results.value(
            f"rate_{row.case}",
            "drift less that with the left-out acceleration put back, over dmax times timeconst",
            lambda drift, still, time: (drift - still) / time,
            row.drift_mm_s,
            rest,
            time,
            unit="mm/s²",
        )
        for row, time in zip(rows, times, strict=True)
    ]
    spread = results.value(
        "rate_spread",
        "largest departure of these rates from their median, of the median",
        lambda *found: 100 * max(abs(rate / median(found) - 1) for rate in found),
        *rates,
        unit="%",
    )
    width = results.value(
        "response_range", "longest over shortest dmax times timeconst", lambda *found: max(found) / min(found), *times
    )
    bound = results.chosen("rate_spread_bound", "one law", 15.0, unit="%")
    wide = results.chosen("response_range_bound", "enough to see a law", 3.0)
    outcome, unknown = at_most(spread, bound), "Whether the drift is proportional to dmax · timeconst cannot be told."
    if None not in (width.value, spread.value) and width.value < wide.value:
        outcome = Outcome("unknown", "to see whether it is proportional would take a wider range")
        unknown = (
            "In all of these runs the friction rows brake alike: their dmax · timeconst changes only {ratio} times. "
            "The drift, less what stays of it when nothing slides, is within {spread} of one common ratio to it."
        )
    return Claim(
        "drift_follows_timeconst",
        outcome,
        holds="The drift is proportional to dmax · timeconst: less what stays of it when nothing slides, no run that "
        "keeps the cube departs by more than {spread} from one common ratio, while dmax · timeconst changes {ratio} "
        "times.",
        fails="The drift is not quite proportional to dmax · timeconst: less what stays of it when nothing slides, "
        "runs depart by up to {spread} from one common ratio, while dmax · timeconst changes {ratio} times.",
        unknown=unknown,
        numbers={"spread": spread, "ratio": width},
        explanation="That is what a brake does. A friction row asks for the acceleration −b·v with b = 2 / (dmax · "
        "timeconst), so a steady disturbance a ends in a steady velocity a / b. What stays when nothing slides is what "
        "was measured above with the left-out acceleration put back.",
    )


def not_creep_under_load(
    results: Results, proportional: Claim, give: Mapping[str, Value], stiffness: Mapping[str, Value]
) -> Claim:
    """``give`` is 1 - dmax and ``stiffness`` [N/m] what is measured, by case."""
    shipped, hardest = results.row[SHIPPED], results.row[HARDEST]
    formula = "measured stiffness with dmax raised, over that as shipped"
    stiffer = ratio(results, "dmax_stiffness_ratio", formula, stiffness[HARDEST], stiffness[SHIPPED])
    return Claim(
        "not_creep_under_load",
        greater(hardest.drift_mm_s, shipped.drift_mm_s, noise=noise_floor(results, "drift_floor")),
        holds="Contacts that give way less slide no less: with 1 − dmax brought down from {soft} to {hard} they are "
        "{stiffer} times as stiff, and the drift does not fall. It goes from {before} to {after}.",
        fails="With 1 − dmax brought down from {soft} to {hard}, which makes the contacts {stiffer} times as stiff, "
        "the drift falls from {before} to {after}.",
        unknown="Whether contacts that give way less slide less cannot be told.",
        numbers={
            "soft": give[SHIPPED],
            "hard": give[HARDEST],
            "stiffer": stiffer,
            "before": shipped.drift_mm_s,
            "after": hardest.drift_mm_s,
        },
        explanation=DRIVEN if proportional.outcome == HOLDS else "",
    )
